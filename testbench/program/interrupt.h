#pragma once
// Ctrl-C and termination: the first signal asks the running command to stop and clean up after itself, a second one ends the process.

#include <atomic>

namespace bump {

/// Installs the handlers; returns the flag that they set.
const std::atomic<bool>& watch_interrupts();
/// Throws Error(cancelled) if the flag is set.
void stop_if_interrupted();

}  // namespace bump
