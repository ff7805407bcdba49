#pragma once
// Sine and cosine ROMs of datapaths that put sums of angles in place of products: every term is one read of a table folded to a quarter
// turn. With one port a ROM answers one index a cycle, which is how tables are counted everywhere else. With two ports, as block memories
// have, every second read of a table goes to the second port of the ROM before it: half the words, the same results. Reads of both
// vectors and of the normal share ROMs in this way. This project's. Timing: that of a table read.

#include <string>
#include <vector>

#include "datapath/netlist.h"
#include "schemes/common/rom_ports.h"

namespace bump {

struct SumWidths {
  Format index{};        ///< full-turn angle
  int table_bits = 10;   ///< k: address bits of a quarter turn
  int word_bits = 12;    ///< w: bits of a word, the sign apart
  int ports = 1;         ///< of a ROM: 1 or 2
  std::string suffix{};  ///< of the tables' names, where a scheme reads sines of two formats
};

/// Of half the sum of two words: one fraction bit more.
Format half_sum_format(int word_bits);

struct SineCosine {
  Wire sine, cosine;
};

class SineReads {
 public:
  SineReads(Netlist& netlist, const SumWidths& widths);

  /// Both of one angle, one table "SC" + suffix.
  SineCosine both(const std::string& name, Wire angle, const std::string& equation = "");
  /// One alone, tables "SIN" and "COS" + suffix.
  Wire sine(const std::string& name, Wire angle, const std::string& equation = "");
  Wire cosine(const std::string& name, Wire angle, const std::string& equation = "");

  /// (a + b)/2 and (a - b)/2 of two words read: 1 adder.
  Wire half_sum(const std::string& name, Wire a, Wire b, const std::string& equation = "");
  Wire half_difference(const std::string& name, Wire a, Wire b, const std::string& equation = "");
  /// Sum of words read, those behind `added` subtracted, divided by 2^halvings and exact: one adder less than words. At most 16 words.
  Wire sum(const std::string& name, const std::vector<Wire>& added, const std::vector<Wire>& subtracted, int halvings,
           const std::string& equation = "");
  /// a + b and a - b of angles: 1 adder.
  Wire plus(const std::string& name, Wire a, Wire b, const std::string& equation = "");
  Wire minus(const std::string& name, Wire a, Wire b, const std::string& equation = "");

  Format word() const;       ///< as read: sign and w fraction bits
  Format half_word() const;  ///< half sums: one fraction bit more
  const SumWidths& widths() const { return widths_; }

 private:
  Netlist& netlist_;
  SumWidths widths_;
  RomPorts both_, sine_, cosine_;
};

}  // namespace bump
