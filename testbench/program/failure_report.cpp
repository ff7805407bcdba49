#include "testbench/program/failure_report.h"

#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>
#include <string>

#include "testbench/program/warning.h"

namespace bump {

namespace {

using Json = nlohmann::ordered_json;

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

Json known(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}
Json known(int number) {
  return number > 0 ? Json(number) : Json(nullptr);
}

Json document(ErrorKind kind, const ErrorText& text) {
  Json json;
  json["status"] = status_of(kind);
  Json& error = json["error"];
  error["what"] = text.what;
  error["file"] = known(text.where.file);
  error["line"] = known(text.where.line);
  error["column"] = known(text.where.column);
  error["why"] = known(text.why);
  error["try"] = known(text.try_this);
  return json;
}

}  // namespace

int report_failure(ErrorKind kind, const ErrorText& text, bool json) noexcept {
  try {
    write_to_stderr("bumpsim: " + std::string(Error(kind, text).what()) + "\n");
    if (json) {
      // A path need not be UTF-8.
      const std::string line = document(kind, text).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
      std::fwrite(line.data(), 1, line.size(), stdout);
      std::fflush(stdout);
    }
  } catch (const std::exception&) {
    write_to_stderr("bumpsim: out of memory\n");
  }
  return static_cast<int>(kind);
}

}  // namespace bump
