#pragma once
// Parses the command line and calls the command. The only file pair that knows CLI11.

namespace bump {

/// Returns the exit code: 0 ok, 2 bad input or configuration, 3 deadlock, 4 self-check failed, 5 internal error, 130 interrupted. Never
/// throws; error texts go to stderr.
int command_line(int argc, char* argv[]);

}  // namespace bump
