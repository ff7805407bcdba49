#pragma once
// Multipliers that several products share, each in a cycle of its own modulo the initiation interval. Products of one such cycle are sorted
// by size; the largest of all cycles share one multiplier, the next largest the next. A multiplier is as wide as its widest factors, and
// signed if any of them is.

#include <string>
#include <vector>

#include "datapath/netlist.h"
#include "datapath/schedule.h"
#include "rtl/word_text.h"

namespace bump {

struct SharedMultiplier {
  std::vector<int> products;  ///< nodes, at most one for each cycle of the interval
  int width_a = 0, width_b = 0;
  bool is_signed = false;

  struct Turn {
    std::string product;  ///< its name, for the comment
    int phase;
    std::vector<WordText> factors;
  };

  static std::string product_name(int index);
  std::string declaration(int index) const;
  /// The factors of the phase: wires multiplier<index>_a_steered and _b_steered.
  std::string steering(int index, const std::vector<Turn>& turns, int bits_of_phase) const;
  /// From multiplier<index>_a and _b.
  std::string product(int index) const;
};

std::vector<SharedMultiplier> shared_multipliers(const Netlist& netlist, const Schedule& schedule);

}  // namespace bump
