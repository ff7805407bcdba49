#pragma once
// Units that need no scheme: an adder of two words, as a netlist and as a datapath written by hand, for any latency and initiation
// interval. For tests only.

#include <filesystem>
#include <string>

#include "datapath/netlist.h"
#include "rtl/unit_module.h"

namespace bump_test {

/// sum = a + b, difference = a - b, of 8 and 5 bits.
bump::Netlist small_netlist();

/// The same sums, `latency` cycles behind the operands and for `interval` cycles.
bump::DatapathModule small_datapath(const std::string& name, int latency, int interval);

/// A folder with everything that `make` needs to check the unit "sums" of scheme "tiny", 200 vectors; removed in the end.
class SmallFolder {
 public:
  SmallFolder(int latency, int interval);
  ~SmallFolder();
  SmallFolder(const SmallFolder&) = delete;
  SmallFolder& operator=(const SmallFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  void write(const std::string& name, const std::string& text) const;
  std::string read(const std::string& name) const;
  /// Replaces `from`, which occurs, in a file; all files are as they were after restore().
  void change(const std::string& name, const std::string& from, const std::string& to) const;
  void restore() const;

  struct Outcome {
    bool passed = false;
    std::string said;
  };
  Outcome make(const std::string& arguments) const;

 private:
  std::filesystem::path path_;
  bump::DatapathModule datapath_;
  bump::RtlUnit unit_;
};

}  // namespace bump_test
