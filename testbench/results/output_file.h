#pragma once
// One text file that a command writes where the user said: complete or not at all, and never over something that is there unless told to.
// No model of hardware.

#include <string>

namespace bump {

/// Throws Error(input) if `path` cannot become a file: something is there and `force` is not set, or it is no regular file, or the folder
/// it belongs in is none or may not be written to (missing folders will be made). Creates nothing; call it before long work. `option` is
/// the one that named the path, for messages.
void check_output_file(const std::string& path, bool force, const std::string& option = "--out");

/// Before a file is replaced: throws Error(input) unless it is empty or begins as a file of its kind does, so that no scene or picture is
/// lost to a slip. Files that do not exist are no concern of this.
void check_replaced_file(const std::string& path, const std::string& beginning, const std::string& kind, const std::string& option);

/// Checks as above, writes the text to a file beside it and renames that into place. Throws Error(input) with the system's reason when the
/// disk is full or anything else goes wrong; then nothing new is left, and an earlier file is as it was.
void write_output_file(const std::string& path, const std::string& text, bool force, const std::string& option = "--out");

}  // namespace bump
