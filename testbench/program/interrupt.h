#pragma once
// Ctrl-C, termination and hang-up: the first signal asks the running command to stop and clean up after itself, a second one ends the
// process. Signals that the process was told to ignore (nohup, a background job) stay ignored.

#include <atomic>

namespace bump {

/// Installs the handlers; returns the flag that they set.
const std::atomic<bool>& watch_interrupts();
/// Throws Error(cancelled) if the flag is set.
void stop_if_interrupted();
/// For all commands, before anything is opened: a file that grows beyond the limit of the process then is an error of the write (EFBIG)
/// instead of its end, and standard streams that are closed keep their numbers, so that no file of the user takes their place.
void guard_process();

}  // namespace bump
