#pragma once
// The recorded datapath of one unit: a typed, acyclic graph of operators, written once and then evaluated, counted, scheduled and
// emitted. A scheme builds it with the functions of Netlist, each of which appends one node and returns its wire, so that the code reads
// like the equations of the paper.
//
// Operators and what they mean (fixed point; the double evaluation computes the same without truncation, and wraps full turns):
//   input       a named port; real numbers that arrive are rounded to nearest once, here
//   constant    a named constant, rounded to nearest
//   add, sub    exact sum, then the rounding rule of format.h
//   add_sub     an adder whose second summand a flag inverts: a - b if the flag is set, else a + b, then the rounding rule
//   mul         exact product, then the rounding rule
//   div         sign-magnitude restoring division: floor(|a| 2^s / b) in the magnitude bits of the result, sign of a; b unsigned. s makes
//               the quotient's fraction. A quotient that needs more bits, and any by b = 0, gives all ones (of the magnitude)
//   sqrt        floor(sqrt(a)) of an unsigned word, to the result's fraction
//   table       turns an index, of a map several, into a ROM address; `column` nodes are its outputs. A ROM may be read by a second port
//   join        wiring: the sum of two words whose bits do not overlap, the second unsigned and below the first
//   shift       wiring: a * 2^k, then the rounding rule; k = 0 only changes the format
//   shift_by    barrel shifter: a * 2^-k by an unsigned whole k, then the rounding rule. In double precision k may lie between whole
//               numbers, as nothing truncates it: its floor counts, so that 2^-(n + f) is `shift_by` n of a table of 2^-f, each given n + f
//   negate      two's complement; absolute: negate if negative (both then wrap to the format)
//   half_turn   adds half a turn to a full-turn angle: inverts the top bit
//   clamp       saturates to constant bounds [low, high]
//   select      first operand is a flag: second if set, else third
//   is_negative sign bit as a flag
//   is_beyond_quarter  flag: the cosine of a full-turn angle is negative: it lies in (1/4, 1/2) or [-1/2, -1/4). Exclusive or of its two
//               top bits, unless the word is exactly a quarter turn
//   exclusive_or  of two flags: the sign of a product whose factors' signs are at hand; with a constant flag of 1, the opposite
// Multipliers, adders (a subtractor and an adder-subtractor are adders), dividers, square roots and tables are what Table 1 of Lee 2007
// lists; everything else is listed apart, barrel shifters among it.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "datapath/format.h"
#include "datapath/table.h"

namespace bump {

enum class Op : std::uint8_t {
  input,
  constant,
  add,
  sub,
  add_sub,
  mul,
  div,
  sqrt,
  table,
  column,
  join,
  shift,
  shift_by,
  negate,
  absolute,
  half_turn,
  clamp,
  select,
  is_negative,
  is_beyond_quarter,
  exclusive_or
};

const char* name_of(Op op);

/// A wire is the output of a node; valid only with the netlist that made it.
struct Wire {
  int node = -1;
};

struct Node {
  Op op = Op::input;
  std::string name;           ///< unique within the netlist, e.g. "L.theta_x"
  std::string equation;       ///< source or step, e.g. "Eq 7"; may be empty
  std::vector<int> operands;  ///< nodes, earlier in the list
  Format format{};
  int amount = 0;            ///< shift: k; column: index of the column
  int table = -1;            ///< table: index into Netlist::tables()
  bool second_port = false;  ///< table: reads the ROM of an earlier table node
  double value = 0;          ///< constant
  double low = 0, high = 0;  ///< clamp
  bool addition = false;     ///< not part of the published count: see Netlist::begin_addition
};

class Netlist {
 public:
  explicit Netlist(std::string name = "");

  Wire input(const std::string& name, Format format);
  Wire constant(const std::string& name, double value, Format format);
  Wire add(const std::string& name, Wire a, Wire b, Format format, const std::string& equation = "");
  Wire sub(const std::string& name, Wire a, Wire b, Format format, const std::string& equation = "");
  Wire add_sub(const std::string& name, Wire flag, Wire a, Wire b, Format format, const std::string& equation = "");
  Wire mul(const std::string& name, Wire a, Wire b, Format format, const std::string& equation = "");
  Wire div(const std::string& name, Wire a, Wire b, Format format, const std::string& equation = "");
  Wire sqrt(const std::string& name, Wire a, Format format, const std::string& equation = "");
  /// One wire per column, in the table's order. The node is called `name`, its columns `name.column`.
  std::vector<Wire> table(const std::string& name, const TablePtr& table, Wire index, const std::string& equation = "");
  /// A map, by all its index words in order.
  std::vector<Wire> table(const std::string& name, const TablePtr& table, const std::vector<Wire>& index, const std::string& equation = "");
  /// The second port of a ROM that table() reads in this netlist: a second index in the same cycle, no table of its own.
  std::vector<Wire> second_port(const std::string& name, const TablePtr& table, Wire index, const std::string& equation = "");
  /// high + low.
  Wire join(const std::string& name, Wire high, Wire low, Format format, const std::string& equation = "");
  Wire shift(const std::string& name, Wire a, int k, Format format, const std::string& equation = "");
  Wire shift_by(const std::string& name, Wire a, Wire k, Format format, const std::string& equation = "");
  Wire negate(const std::string& name, Wire a, Format format, const std::string& equation = "");
  Wire absolute(const std::string& name, Wire a, Format format, const std::string& equation = "");
  Wire half_turn(const std::string& name, Wire a, const std::string& equation = "");
  Wire clamp(const std::string& name, Wire a, double low, double high, Format format, const std::string& equation = "");
  Wire select(const std::string& name, Wire flag, Wire if_set, Wire if_clear, Format format, const std::string& equation = "");
  Wire is_negative(const std::string& name, Wire a);
  Wire is_beyond_quarter(const std::string& name, Wire a);
  Wire exclusive_or(const std::string& name, Wire a, Wire b);
  void output(const std::string& name, Wire a);

  /// Nodes recorded between these calls are additions to the published design (an in-plane angle, say): counted apart.
  void begin_addition() { addition_ = true; }
  void end_addition() { addition_ = false; }
  /// Prefix "scope." for the names of nodes recorded while the Scope lives.
  class Scope {
   public:
    Scope(Netlist& netlist, const std::string& name);
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    Netlist& netlist_;
    std::string outer_;
  };

  /// The step that operators recorded without an equation of their own belong to, while the Label lives. The innermost Label counts; an
  /// empty one leaves the outer one in force. Inputs have none, as they are no operators.
  class Label {
   public:
    Label(Netlist& netlist, const std::string& equation);
    ~Label();
    Label(const Label&) = delete;
    Label& operator=(const Label&) = delete;
    /// For the operators that follow, in place of the step before.
    void next(const std::string& equation);

   private:
    Netlist& netlist_;
    std::string outer_;
  };

  struct Port {
    std::string name;
    int node;
  };

  const std::string& name() const { return name_; }
  const std::vector<Node>& nodes() const { return nodes_; }
  const std::vector<Port>& inputs() const { return inputs_; }
  const std::vector<Port>& outputs() const { return outputs_; }
  const std::vector<TablePtr>& tables() const { return tables_; }
  const Format& format(Wire wire) const { return nodes_[static_cast<std::size_t>(wire.node)].format; }
  /// The node called `name`, or -1.
  int find(const std::string& name) const;

 private:
  Wire append(Node node);
  std::vector<Wire> read(const std::string& name, const TablePtr& table, const std::vector<Wire>& index, const std::string& equation,
                         bool second_port);

  std::string name_;
  std::string prefix_;
  std::string label_;
  bool addition_ = false;
  std::vector<Node> nodes_;
  std::vector<Port> inputs_, outputs_;
  std::vector<TablePtr> tables_;
};

}  // namespace bump
