#include "testbench/program/failure_report.h"

#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>
#include <string>

#include "testbench/program/warning.h"
#include "testbench/results/error_json.h"

namespace bump {

namespace {

using Json = nlohmann::ordered_json;

Json document(ErrorKind kind, const ErrorText& text) {
  Json json;
  json["status"] = status_of(kind);
  json["error"] = to_json(text);
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
