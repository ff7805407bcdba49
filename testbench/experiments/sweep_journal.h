#pragma once
// Where a sweep keeps what is finished: a file of lines, one JSON object each, only ever appended to. A line is on the disk before the
// sweep goes on, and several processes append side by side. What a process that was killed left of a line is passed over. One sweep at a
// time has the file. No model of hardware.
//
//   {"journal": "bumpsim-sweep", "version": 1}
//   {"id": "...", "status": "ok", "reason": null, "values": [...], "warnings": [...]}       a point, values as sweep_columns.h says
//   {"checked": "..."}                                                                      a re-timed point that a full run confirmed

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>

namespace bump {

class SweepJournal {
 public:
  static constexpr const char* file_name = "journal.jsonl";

  /// Creates the folder and the file, or opens an earlier one; with `anew` what an earlier one holds is dropped. Throws Error(input) if the
  /// folder holds other files but no journal, if another process works on it, or if it cannot be written.
  SweepJournal(const std::string& folder, bool anew);
  ~SweepJournal();
  SweepJournal(const SweepJournal&) = delete;
  SweepJournal& operator=(const SweepJournal&) = delete;

  /// Appends whole lines, each with its end, and waits until the disk has them. Throws Error(input).
  void append(const std::string& lines) const;

  /// Takes notice of what was appended since, by whichever process.
  void refresh();
  bool has(const std::string& id) const { return lines_.count(id) > 0; }
  bool is_checked(const std::string& id) const { return checked_.count(id) > 0; }
  /// The line of a point that it has, parsed.
  nlohmann::ordered_json point(const std::string& id) const;

 private:
  struct Place {
    std::int64_t offset = 0;
    std::size_t size = 0;
  };
  std::string read(std::int64_t offset, std::size_t size) const;
  void note(const std::string& line, std::int64_t offset);

  std::string path_;
  int file_ = -1;
  std::int64_t known_ = 0;  ///< bytes that were taken notice of
  std::map<std::string, Place> lines_;
  std::set<std::string> checked_;
};

/// Whether the folder holds a journal.
bool has_sweep_journal(const std::string& folder);

}  // namespace bump
