#pragma once
// Remarks on stderr that the work does not depend on: a stderr that is closed, full or a broken pipe must not fail a run.

#include <string_view>

namespace bump {

/// "bumpsim: warning: TEXT" and a line feed.
void warn(std::string_view text) noexcept;
/// Writes to stderr what it can; never throws, and is not ended by SIGPIPE.
void write_to_stderr(std::string_view text) noexcept;

}  // namespace bump
