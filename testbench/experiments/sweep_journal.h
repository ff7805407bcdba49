#pragma once
// Where a sweep keeps what is finished: a file of lines, one JSON object each, only ever appended to. A line is on the disk before the
// sweep goes on, and several processes append side by side. Every line ends with a sum over what is in front of it: what a process that
// was killed left of a line, and what was changed in one, does not count, and is named. One sweep at a time has the file. No model of
// hardware.
//
//   {"journal": "bumpsim-sweep", "version": 2}
//   {"id":"...","status":"ok","reason":null,"values":[...],"warnings":[...],"sum":"..."}    a point, values as sweep_columns.h says
//   {"checked":"...","sum":"..."}                                                           a re-timed point that a full run confirmed

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <vector>

namespace bump {

/// The line of a journal for a JSON object in one line (no line feed): the object with its sum, and a line feed.
std::string journal_line(const std::string& object);
/// Whether a line of a journal (with or without its line feed) is as it was written.
bool is_sound_journal_line(const std::string& line);

class SweepJournal {
 public:
  static constexpr const char* file_name = "journal.jsonl";

  /// Creates the folder and the file, or opens an earlier one; with `anew` what an earlier one holds is dropped. Throws Error(input) if the
  /// folder holds other files but no journal, if another process works on it, if another version of the program wrote it (not with
  /// `anew`), or if it cannot be written.
  SweepJournal(const std::string& folder, bool anew);
  ~SweepJournal();
  SweepJournal(const SweepJournal&) = delete;
  SweepJournal& operator=(const SweepJournal&) = delete;

  /// Appends whole lines, each with its end (journal_line), and waits until the disk has them. Throws Error(input).
  void append(const std::string& lines) const;
  /// What is wrong with lines that do not count, in their order: "journal.jsonl, line 7, is damaged". Their points are not in it.
  std::vector<std::string> damages() const;

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
  void begin(const std::string& folder, bool anew);
  void note(const std::string& line, std::int64_t offset);

  std::string path_;
  int file_ = -1;
  std::int64_t known_ = 0;          ///< bytes that were taken notice of
  std::int64_t lines_known_ = 0;    ///< line ends among them
  std::set<std::int64_t> damaged_;  ///< line numbers from 1
  std::map<std::string, Place> lines_;
  std::set<std::string> checked_;
};

/// Whether the folder holds a journal.
bool has_sweep_journal(const std::string& folder);

}  // namespace bump
