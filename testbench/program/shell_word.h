#pragma once
// Text as a shell takes it for one word, for commands that are printed to be typed again.

#include <string>

namespace bump {

/// In single quotes, unless no character has a meaning to a shell.
std::string shell_word(const std::string& text);

}  // namespace bump
