#pragma once
// Writes a set of files to a folder so that a failure leaves the folder as it was: everything is written elsewhere on the same disk first,
// every write is checked, and only then is it moved into place; what was moved before a failure is moved back.

#include <map>
#include <string>

namespace bump {

/// A new folder appears as a whole. In a folder that exists, files of other names are left alone, and `last` is moved after all others.
/// Throws Error(input) with the path and the system's reason.
void write_rom_folder(const std::map<std::string, std::string>& files, const std::string& last, const std::string& folder);

}  // namespace bump
