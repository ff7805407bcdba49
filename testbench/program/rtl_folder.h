#pragma once
// The folder that `bumpsim rtl` writes: files in folders of their own, which appear all at once or not at all. They are written to
// `<out>.partial-<pid>` beside it, every write is checked, and that is renamed into place. An earlier folder is replaced only with `force`,
// and only if it holds what its manifest, rtl.json, lists and what the Makefile made (build/), and nothing else.

#include <map>
#include <string>

namespace bump {

/// "schema" in rtl.json, by which a folder is known.
inline constexpr const char* rtl_schema = "bumpsim-rtl";

/// Throws Error(input) if such a folder cannot be written to `out`. Creates nothing; call it before long work.
void check_rtl_folder(const std::string& out, bool force);

/// `files`: path in the folder to text, rtl.json among them. Throws Error(input) as above, or with the system's reason; then nothing new is
/// left, and an earlier folder is as it was.
void write_rtl_folder(const std::map<std::string, std::string>& files, const std::string& out, bool force);

}  // namespace bump
