#include "testbench/program/interrupt.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>

#include "datapath/error.h"
#include "testbench/program/trace_file.h"
#include "testbench/results/pending_folder.h"

namespace bump {

namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

void on_signal(int) {
  if (!interrupted.exchange(true)) return;
  remove_partial_result();
  remove_partial_trace();
  std::_Exit(static_cast<int>(ErrorKind::cancelled));
}

void watch(int signal_number) {
  struct sigaction action {};
  if (sigaction(signal_number, nullptr, &action) == 0 && action.sa_handler == SIG_IGN) return;
  action = {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(signal_number, &action, nullptr);
}

/// A stand-in that fails every use, as the closed stream would.
void occupy(int stream, int mode) {
  if (fcntl(stream, F_GETFD) != -1 || errno != EBADF) return;
  const int file = ::open("/dev/null", mode);
  if (file < 0 || file == stream) return;
  ::dup2(file, stream);
  ::close(file);
}

}  // namespace

const std::atomic<bool>& watch_interrupts() {
  for (const int signal_number : {SIGINT, SIGTERM, SIGHUP}) watch(signal_number);
  return interrupted;
}

void stop_if_interrupted() {
  if (interrupted) throw Error(ErrorKind::cancelled, {"interrupted", {}, "", "nothing was written"});
}

void guard_process() {
  std::signal(SIGXFSZ, SIG_IGN);
  occupy(STDIN_FILENO, O_WRONLY);
  occupy(STDOUT_FILENO, O_RDONLY);
  occupy(STDERR_FILENO, O_RDONLY);
}

}  // namespace bump
