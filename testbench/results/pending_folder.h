#pragma once
// A result folder that appears all at once or not at all: files are written to `<out>.partial-<pid>` beside it, every write is checked, and
// the folder is renamed into place when it is complete. Whatever happens before, an earlier result stays untouched and the partial folder
// goes away: by the destructor, or from a signal handler by remove_partial_result().

#include <array>
#include <string>
#include <string_view>

namespace bump {

/// What a folder of the program holds, and by which it is told from a folder of the user.
struct FolderKind {
  std::string_view name;    ///< for messages: "result"
  std::string_view schema;  ///< the value of "schema" in the first file, a JSON document
  std::array<std::string_view, 32> files;  ///< every file that it may consist of; unused places at the end empty
};

inline constexpr FolderKind result_folder_kind = {
    "result", "bumpsim-result", {"result.json", "config.resolved.toml", "stats.csv", "frame.png", "frame.exr", "error.png"}};

/// Throws Error(input) if such a folder cannot be written to `out`: something else than a folder is in the way, the folder holds anything but
/// the files of an earlier one of its kind, or it holds just these and `force` is not set; or the folder it would be made in is none or may
/// not be written to. Creates nothing; call it before a long run.
void check_output_folder(const std::string& out, bool force, const FolderKind& kind = result_folder_kind);

class PendingFolder {
 public:
  /// Checks as above, creates missing parent folders and the partial folder. One at a time in a process.
  PendingFolder(const std::string& out, bool force, const FolderKind& kind = result_folder_kind);
  ~PendingFolder();
  PendingFolder(const PendingFolder&) = delete;
  PendingFolder& operator=(const PendingFolder&) = delete;

  /// Writes a new file, one of the files of its kind. Throws Error(input) naming the file and the system's reason when the disk is full or
  /// anything else goes wrong.
  void write(const std::string& name, std::string_view bytes);
  /// Moves the folder into place; an earlier result is removed only after that, and only if still nothing else has come into its folder.
  void commit();
  const std::string& partial_path() const { return partial_; }

 private:
  FolderKind kind_;
  std::string out_, partial_, replaced_;
  bool force_, committed_ = false;
};

/// Removes the partial folder of a write in progress, and puts back an earlier result that was about to be replaced. Does nothing when no
/// write is in progress. Async-signal-safe: for handlers that end the process.
void remove_partial_result() noexcept;

}  // namespace bump
