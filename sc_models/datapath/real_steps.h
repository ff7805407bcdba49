#pragma once
// A step of double-precision evaluation: one operator, or all columns that a table read gives, over the lanes of a block. The evaluator
// (real_evaluator.cpp) plans the steps and says where their values live; this runs them. Timing: none, this is host arithmetic.

#include <array>
#include <vector>

#include "datapath/netlist.h"

namespace bump {

struct RealStep {
  const Node* node = nullptr;  ///< of a table that has a block function: its first column that is needed
  std::vector<int> made;       ///< nodes: one, or the table's columns in order
  std::array<int, 3> operands{-1, -1, -1};
  std::array<const double*, 3> in{};
  std::vector<double*> out;      ///< as `made`
  std::vector<bool> wraps;       ///< as `made`: the result may be any number and is brought to one turn
  bool of_turns = false;         ///< add, sub, negate, half_turn: operands are within one turn, and the result shall be
  double factor = 1;             ///< shift
  const Table* table = nullptr;  ///< column
  /// Column of a map: real index values that a field takes in turns; the first index value turns where the table node does.
  std::array<bool, 3> wraps_index{};
};

void run_real_step(const RealStep& step, int lanes);

}  // namespace bump
