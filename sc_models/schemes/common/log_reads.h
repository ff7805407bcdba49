#pragma once
// Products of sines and cosines in the logarithmic number system: a table gives -log2 |sin| and -log2 |cos| of an angle, both positive,
// sums of them stand for products, and an antilogarithm, a table of 2^-x for the fraction and a barrel shifter for the whole part, brings a
// product back. Signs go beside, by exclusive or. So a product of any number of factors costs adders and one shifter, no multiplier, and
// errs relatively: small products are as precise as large ones. The logarithm of 0 is the largest word, which the shifter shifts out.
// This project's use of it; number system: Kingsbury and Rayner 1971. Timing: that of the operators recorded.

#include <string>
#include <vector>

#include "channels/parameters.h"
#include "schemes/common/rom_ports.h"

namespace bump {

struct LogWidths {
  Format index{};         ///< full-turn angle
  int table_bits = 10;    ///< k: address bits of a quarter turn
  int log_bits = 12;      ///< f: fraction bits of a logarithm
  int antilog_bits = 10;  ///< m: address bits of the antilogarithm's table, for a fraction in [0, 1)
  int word_bits = 12;     ///< w: bits of its words
  int whole_bits = 4;     ///< W: bits before the point of a table's logarithm: factors below 2^-2^W count as that
  int ports = 1;          ///< of a ROM: 1 or 2
};

/// A factor or a product: its logarithm, and whether it is negative.
struct LogValue {
  Wire log;       ///< -log2 |value|, unsigned
  Wire negative;  ///< flag
};

struct LogSineCosine {
  LogValue sine, cosine;
};

class LogReads {
 public:
  LogReads(Netlist& netlist, const LogWidths& widths);

  /// Both of one angle: 1 table "LSC" of two columns.
  LogSineCosine both(const std::string& name, Wire angle, const std::string& equation = "");
  /// a b: 1 adder.
  LogValue product(const std::string& name, const LogValue& a, const LogValue& b, const std::string& equation = "");
  /// |value|: 1 table "ANTILOG", 1 shifter.
  Wire magnitude(const std::string& name, const LogValue& value, const std::string& equation = "");
  /// Sum of two or more products, "<name>.dot": for each a table and a shifter, and one adder less than terms.
  Wire sum(const std::string& name, const std::vector<LogValue>& terms, const std::string& equation = "");

  /// Products and sums have w fraction bits and two guard bits.
  int fraction() const { return widths_.word_bits + guard_bits; }

 private:
  static constexpr int guard_bits = 2;

  Netlist& netlist_;
  LogWidths widths_;
  RomPorts logarithm_, antilogarithm_;
};

/// Format of a logarithm with `whole` bits before the point.
Format log_format(const LogWidths& widths, int whole);
constexpr int log_whole_bits = 4;  ///< of a table's word, if not chosen: factors below 2^-16 count as 0

/// Declares "<id>.log_whole_bits", 2 to 4.
void declare_log_whole_bits(Parameters& parameters, const std::string& id);

/// -log2 |sin|, -log2 |cos| of a full-turn angle, folded to a quarter turn.
TablePtr log_sine_cosine_table(const std::string& name, const LogWidths& widths);
/// 2^-x of the fraction of x.
TablePtr antilogarithm_table(const std::string& name, const LogWidths& widths);

/// Passes a logarithm and its sign from one unit to the next, under "<name>.log" and "<name>.negative".
void output_log(Netlist& netlist, const std::string& name, const LogValue& value);
LogValue input_log(Netlist& netlist, const std::string& name, const LogWidths& widths, int whole);

}  // namespace bump
