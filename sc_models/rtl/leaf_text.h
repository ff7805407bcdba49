#pragma once
// Writes the text of a leaf module of the emitted Verilog (divider, square root, table, adder-subtractor): ports, named words, one bank of
// registers at each segment's end, and the few expressions that all of them need. No timing of its own. Bits that a module drops by intent
// are marked for Verilator's lint, which otherwise takes them for mistakes.

#include <string>
#include <vector>

#include "datapath/format.h"
#include "rtl/verilog.h"

namespace bump {

/// What matters of a format, as part of a name: "s15_13", "u8_m2" for a last place of 2^2.
std::string format_name(const Format& format);

/// Words side by side, the first highest; empty parts are left out.
std::string concatenation(const std::vector<std::string>& parts);
/// `count` copies of a bit, "{3{1'b0}}"; empty for none.
std::string copies(const std::string& bit, int count);
/// Bits high..low of a vector; empty if high < low.
std::string bits_of(const std::string& word, int high, int low);
/// A word of an unsigned expression, widened with zeros in front.
std::string zero_extended(const std::string& word, int from, int to);

class LeafText {
 public:
  enum class Read { whole, partly };  ///< partly: some bits are dropped by intent

  struct Register {
    std::string name;
    int width = 1;
    std::string next;  ///< what it takes at each clock edge
  };

  explicit LeafText(std::string name) : name_(std::move(name)) {}

  /// A line of the comment in front of the module.
  void comment(const std::string& line) { comments_.push_back(line); }
  void clock(Read read = Read::whole);
  void input(const std::string& name, int width, Read read = Read::whole);
  void output(const std::string& name, int width);

  /// A comment inside the module.
  void remark(const std::string& text) { body_ += "\n  // " + text + "\n"; }
  void line(const std::string& text) { body_ += "  " + text + "\n"; }
  /// A named bit.
  void bit(const std::string& name, const std::string& expression) { line("wire " + name + " = " + expression + ";"); }
  /// A named word, a vector even if it is one bit wide.
  void word(const std::string& name, int width, const std::string& expression, Read read = Read::whole);
  void assign(const std::string& name, const std::string& expression) { line("assign " + name + " = " + expression + ";"); }
  /// Registers that take their next words at every rising edge. Width 0 makes a single bit.
  void registers(const std::vector<Register>& bank);

  VerilogModule module() const;

 private:
  std::string name_, body_;
  std::vector<std::string> comments_, ports_;
  std::int64_t register_bits_ = 0;
};

}  // namespace bump
