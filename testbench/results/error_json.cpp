#include "testbench/results/error_json.h"

#include <nlohmann/json.hpp>
#include <string>

namespace bump {

namespace {

using Json = nlohmann::ordered_json;

Json known(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}
Json known(int number) {
  return number > 0 ? Json(number) : Json(nullptr);
}

}  // namespace

const char* status_of(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::input:
      return "error";
    case ErrorKind::deadlock:
      return "deadlock";
    case ErrorKind::self_check:
      return "self_check_failed";
    case ErrorKind::internal:
      return "internal_error";
    case ErrorKind::cancelled:
      return "interrupted";
  }
  return "error";
}

Json to_json(const ErrorText& text) {
  return {
      {"what", text.what},      {"file", known(text.where.file)}, {"line", known(text.where.line)}, {"column", known(text.where.column)},
      {"why", known(text.why)}, {"try", known(text.try_this)}};
}

}  // namespace bump
