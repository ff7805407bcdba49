#pragma once
// A progress line on stderr for work that takes longer than a second. Silent when stderr is not a terminal.

#include <chrono>
#include <string>

namespace bump {

class Progress {
 public:
  explicit Progress(std::string what);
  /// Erases the line.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `share` of the work done, 0 to 1; draws at most ten times a second.
  void update(double share);

 private:
  using Clock = std::chrono::steady_clock;
  std::string what_;
  Clock::time_point begin_, drawn_;
  bool terminal_, visible_ = false;
};

}  // namespace bump
