#pragma once
// The pipeline registers of a scheduled netlist: which word is held over which clock edge. A word is held from the cycle after it was made
// until its last reader; with an initiation interval of several cycles a register holds its word that long. Wiring and sign logic that take
// no time are no words of their own but views of the operand: they are formed again where they are read, unless the views that are still
// needed have fewer bits than the operand, which then goes on as those parts. Left out: the state inside operators of several cycles
// (array_registers.h). What is priced (price_registers.h) and what is emitted (rtl/datapath_module.h) follow this one plan.

#include <vector>

#include "datapath/netlist.h"
#include "datapath/schedule.h"

namespace bump {

/// Where a word is found in a cycle.
struct WordPlace {
  enum class From {
    fixed,  ///< it never changes
    made,   ///< out of its operator, in the cycle before the first edge that could hold it
    held,   ///< in a register of its own
    view    ///< formed from its one operand, which is at the same place
  } from = From::fixed;
  int cycle = 0;  ///< made: that cycle; held, view: the cycle behind the edge at which the register was written
};

/// A register: the word of `node` written at the edge in front of cycle `cycle`.
struct HeldWord {
  int node;
  int cycle;
};

class RegisterPlan {
 public:
  /// `interval`: cycles for which a register keeps a word; the initiation interval for the hardware that is built, 1 for every edge.
  RegisterPlan(const Netlist& netlist, const Schedule& schedule, int interval);

  /// Constants, and what is computed from nothing else.
  bool is_fixed(int node) const { return fixed_[at(node)]; }
  bool is_view(int node) const;
  /// `cycle` from the one in which the word is made up to its last use.
  WordPlace place(int node, int cycle) const;
  /// All registers, in order of the nodes, then of cycles.
  const std::vector<HeldWord>& registers() const { return registers_; }
  /// Bits of the registers that begin with `node`: its own and those of its views.
  std::int64_t bits_of(int node) const { return bits_[at(node)]; }

 private:
  static std::size_t at(int node) { return static_cast<std::size_t>(node); }
  void find_fixed();
  void find_last_uses();
  void use(int node, int cycle);
  int first_edge(int node) const;
  void plan(int root);

  const Netlist& netlist_;
  const Schedule& schedule_;
  int interval_;
  std::vector<bool> fixed_;
  std::vector<int> last_;        ///< by node: last cycle in which it is read as itself, -1 if never
  std::vector<int> root_;        ///< by node: what it is a view of
  std::vector<int> parts_from_;  ///< by root: from this cycle on its views are held in its place
  std::vector<std::int64_t> bits_;
  std::vector<HeldWord> registers_;
};

}  // namespace bump
