#pragma once
// The VCD of a clocked run, which appears whole or not at all: the kernel writes `<FILE>.partial-<pid>.vcd` beside FILE, the file is read
// through when the kernel has closed it, and is renamed into place at the very end. The kernel takes no notice of failed writes, so a full
// disk shows only in what the file lacks. Whatever happens before, the partial file goes away: by the destructor, or from a signal handler
// by remove_partial_trace().

#include <cstdint>
#include <string>

namespace bump {

class TraceFile {
 public:
  /// `given` is the path that the user named; ".vcd" is appended where it is missing; empty: no trace, and nothing below does anything.
  /// Creates the partial file. Throws Error(input) if the place is a folder, lies in the result folder `out`, cannot be written, or holds a
  /// file already and `force` is not set. One at a time in a process.
  TraceFile(const std::string& given, const std::string& out, bool force);
  ~TraceFile();
  TraceFile(const TraceFile&) = delete;
  TraceFile& operator=(const TraceFile&) = delete;

  /// What SystemC is to be given: the partial file without ".vcd", which it appends itself. Empty without a trace.
  const std::string& stem() const { return stem_; }
  /// Call when the engine is gone, and with it the kernel's handle. A clock that is traced puts two time stamps into the file each cycle;
  /// throws Error(input) if any of them is missing or the last line is cut off.
  void check(std::int64_t cycles) const;
  /// Moves the file into place.
  void commit();

 private:
  void check_target() const;

  std::string path_, stem_, partial_;
  bool force_ = false;
};

/// Removes the partial file of a run in progress, if there is one. Async-signal-safe: for handlers that end the process.
void remove_partial_trace() noexcept;

}  // namespace bump
