#include "testbench/program/progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>

#include "testbench/program/warning.h"

namespace bump {

Progress::Progress(std::string what) : what_(std::move(what)), begin_(Clock::now()), drawn_(begin_), terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (visible_) write_to_stderr("\r\033[K");
}

void Progress::update(double share) {
  const Clock::time_point now = Clock::now();
  using std::chrono::milliseconds;
  if (!terminal_ || now - begin_ < milliseconds(1000) || now - drawn_ < milliseconds(100)) return;
  drawn_ = now;
  visible_ = true;
  const double elapsed = std::chrono::duration<double>(now - begin_).count();
  const double done = std::clamp(share, 0.0, 1.0);
  const int width = 30;
  const int filled = static_cast<int>(done * width);
  const std::string left = done > 0.01 ? fmt::format("{:.0f} s left", elapsed * (1 - done) / done) : "";
  write_to_stderr(fmt::format("\r\033[K{} [{:#<{}}{:.<{}}] {:3.0f} % {}", what_, "", filled, "", width - filled, 100 * done, left));
}

}  // namespace bump
