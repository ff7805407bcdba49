#pragma once
// What a child process (child_processes.h) sends to its parent: any number of shares, then one outcome, which ends with the stream. Both
// ends are the same program on the same machine, so numbers travel as they lie in memory. No model of hardware.

#include <string>

#include "datapath/error.h"
#include "testbench/experiments/child_processes.h"

namespace bump {

/// The share of the work done.
std::string share_message(double share);
/// What the work returned.
std::string result_message(std::string bytes);
/// What it threw.
std::string error_message(const Error& error);

/// Removes the shares that stand whole at the front of what was received; `share` becomes the last of them.
void take_shares(std::string& received, double& share);
/// Reads the outcome that is left at the end of the stream; false if there is none.
bool take_outcome(std::string received, ChildOutcome& outcome);

}  // namespace bump
