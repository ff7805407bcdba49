#include "testbench/program/interrupt.h"

#include <csignal>
#include <cstdlib>

#include "datapath/error.h"
#include "testbench/results/pending_folder.h"

namespace bump {

namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

void on_signal(int signal_number) {
  if (interrupted.exchange(true)) {
    remove_partial_result();
    std::_Exit(static_cast<int>(ErrorKind::cancelled));
  }
  std::signal(signal_number, on_signal);
}

}  // namespace

const std::atomic<bool>& watch_interrupts() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  return interrupted;
}

void stop_if_interrupted() {
  if (interrupted) throw Error(ErrorKind::cancelled, {"interrupted", {}, "", "nothing was written"});
}

}  // namespace bump
