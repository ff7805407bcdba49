#pragma once
// How a command that failed says so: a text on stderr for people, and with --json one document on stdout for programs:
// {"status", "error": {"what", "file", "line", "column", "why", "try"}}, parts that are unknown null.

#include "datapath/error.h"

namespace bump {

/// Prints both and returns the exit code. What cannot be printed is lost; never throws.
int report_failure(ErrorKind kind, const ErrorText& text, bool json) noexcept;

}  // namespace bump
