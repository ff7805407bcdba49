#include "testbench/program/warning.h"

#include <csignal>
#include <cstdio>

namespace bump {

void write_to_stderr(std::string_view text) noexcept {
  const auto handler = std::signal(SIGPIPE, SIG_IGN);
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
  std::signal(SIGPIPE, handler);
}

void warn(std::string_view text) noexcept {
  write_to_stderr("bumpsim: warning: ");
  write_to_stderr(text);
  write_to_stderr("\n");
}

}  // namespace bump
