#include "datapath/netlist.h"

#include <algorithm>
#include <utility>

#include "datapath/checks.h"

namespace bump {

namespace {

Node make(Op op, const std::string& name, std::vector<int> operands, const Format& format, const std::string& equation = "") {
  Node node;
  node.op = op;
  node.name = name;
  node.equation = equation;
  node.operands = std::move(operands);
  node.format = format;
  return node;
}

/// Two tables of one name must be one ROM.
bool same_structure(const Table& a, const Table& b) {
  return a.index == b.index && a.folding == b.folding && a.address_bits == b.address_bits && a.min_exponent == b.min_exponent &&
         a.exponent_bits == b.exponent_bits && a.field_bits() == b.field_bits() && a.columns.size() == b.columns.size() &&
         a.bits() == b.bits();
}

}  // namespace

const char* name_of(Op op) {
  switch (op) {
    case Op::input:
      return "input";
    case Op::constant:
      return "constant";
    case Op::add:
      return "add";
    case Op::sub:
      return "sub";
    case Op::add_sub:
      return "add_sub";
    case Op::mul:
      return "mul";
    case Op::div:
      return "div";
    case Op::sqrt:
      return "sqrt";
    case Op::table:
      return "table";
    case Op::column:
      return "column";
    case Op::join:
      return "join";
    case Op::shift:
      return "shift";
    case Op::shift_by:
      return "shift_by";
    case Op::negate:
      return "negate";
    case Op::absolute:
      return "absolute";
    case Op::half_turn:
      return "half_turn";
    case Op::clamp:
      return "clamp";
    case Op::select:
      return "select";
    case Op::is_negative:
      return "is_negative";
    case Op::is_beyond_quarter:
      return "is_beyond_quarter";
    case Op::exclusive_or:
      return "exclusive_or";
  }
  return "";
}

Netlist::Netlist(std::string name) : name_(std::move(name)) {}

Netlist::Scope::Scope(Netlist& netlist, const std::string& name) : netlist_(netlist), outer_(netlist.prefix_) {
  netlist_.prefix_ += name + ".";
}
Netlist::Scope::~Scope() {
  netlist_.prefix_ = outer_;
}

Netlist::Label::Label(Netlist& netlist, const std::string& equation) : netlist_(netlist), outer_(netlist.label_) {
  next(equation);
}
Netlist::Label::~Label() {
  netlist_.label_ = outer_;
}
void Netlist::Label::next(const std::string& equation) {
  netlist_.label_ = equation.empty() ? outer_ : equation;
}

Wire Netlist::append(Node node) {
  node.name = prefix_ + node.name;
  node.addition = addition_;
  if (node.equation.empty() && node.op != Op::input) node.equation = label_;
  const std::string whose = "netlist '" + name_ + "', node '" + node.name + "'";
  require(find(node.name) < 0, whose + ": the name is taken");
  std::vector<Format> operands;
  for (const int operand : node.operands) {
    require(operand >= 0 && operand < static_cast<int>(nodes_.size()), whose + ": an operand is not a wire of this netlist");
    require(nodes_[static_cast<std::size_t>(operand)].op != Op::table || node.op == Op::column,
            whose + ": a table is read through its columns");
    operands.push_back(nodes_[static_cast<std::size_t>(operand)].format);
  }
  check_operator(node, operands, whose);
  nodes_.push_back(std::move(node));
  return Wire{static_cast<int>(nodes_.size()) - 1};
}

Wire Netlist::input(const std::string& name, Format format) {
  const Wire wire = append(make(Op::input, name, {}, format));
  inputs_.push_back({nodes_.back().name, wire.node});
  return wire;
}

Wire Netlist::constant(const std::string& name, double value, Format format) {
  Node node = make(Op::constant, name, {}, format);
  node.value = value;
  return append(std::move(node));
}

Wire Netlist::add(const std::string& name, Wire a, Wire b, Format format, const std::string& equation) {
  return append(make(Op::add, name, {a.node, b.node}, format, equation));
}

Wire Netlist::sub(const std::string& name, Wire a, Wire b, Format format, const std::string& equation) {
  return append(make(Op::sub, name, {a.node, b.node}, format, equation));
}

Wire Netlist::add_sub(const std::string& name, Wire flag, Wire a, Wire b, Format format, const std::string& equation) {
  return append(make(Op::add_sub, name, {flag.node, a.node, b.node}, format, equation));
}

Wire Netlist::mul(const std::string& name, Wire a, Wire b, Format format, const std::string& equation) {
  return append(make(Op::mul, name, {a.node, b.node}, format, equation));
}

Wire Netlist::div(const std::string& name, Wire a, Wire b, Format format, const std::string& equation) {
  return append(make(Op::div, name, {a.node, b.node}, format, equation));
}

Wire Netlist::sqrt(const std::string& name, Wire a, Format format, const std::string& equation) {
  return append(make(Op::sqrt, name, {a.node}, format, equation));
}

std::vector<Wire> Netlist::table(const std::string& name, const TablePtr& table, Wire index, const std::string& equation) {
  return read(name, table, {index}, equation, false);
}

std::vector<Wire> Netlist::table(const std::string& name, const TablePtr& table, const std::vector<Wire>& index,
                                 const std::string& equation) {
  return read(name, table, index, equation, false);
}

std::vector<Wire> Netlist::second_port(const std::string& name, const TablePtr& table, Wire index, const std::string& equation) {
  return read(name, table, {index}, equation, true);
}

std::vector<Wire> Netlist::read(const std::string& name, const TablePtr& table, const std::vector<Wire>& index, const std::string& equation,
                                bool second_port) {
  const std::string whose = "netlist '" + name_ + "', node '" + prefix_ + name + "'";
  require(table != nullptr, whose + ": there is no table");
  check_table(*table);
  require(static_cast<int>(index.size()) == table->index_words(),
          whose + ": table '" + table->name + "' has " + std::to_string(table->index_words()) + " index words");
  std::vector<int> operands;
  for (std::size_t i = 0; i < index.size(); ++i) {
    require(index[i].node >= 0 && index[i].node < static_cast<int>(nodes_.size()), whose + ": the index is not a wire of this netlist");
    const Format &given = format(index[i]), &taken = i == 0 ? table->index : table->fields[i - 1].index;
    require(given.is_real || given == taken,
            whose + ": table '" + table->name + "' is indexed by " + to_string(taken) + ", not by " + to_string(given));
    operands.push_back(index[i].node);
  }
  for (const TablePtr& known : tables_)
    require(known->name != table->name || same_structure(*known, *table), whose + ": another table is called '" + table->name + "'");
  auto place = std::find(tables_.begin(), tables_.end(), table);
  if (place == tables_.end()) place = tables_.insert(tables_.end(), table);
  Node node = make(Op::table, name, std::move(operands), format(index.front()), equation);
  node.table = static_cast<int>(place - tables_.begin());
  node.second_port = second_port;
  if (second_port) {
    const auto reads = [&](bool second) {
      return std::count_if(nodes_.begin(), nodes_.end(),
                           [&](const Node& n) { return n.op == Op::table && n.table == node.table && n.second_port == second; });
    };
    require(reads(true) < reads(false), whose + ": table '" + table->name + "' has no first port that lacks a second");
  }
  const Wire address = append(std::move(node));
  std::vector<Wire> wires;
  for (std::size_t i = 0; i < table->columns.size(); ++i) {
    Node column = make(Op::column, name + "." + table->columns[i].name, {address.node}, table->columns[i].format, equation);
    column.amount = static_cast<int>(i);
    wires.push_back(append(std::move(column)));
  }
  return wires;
}

Wire Netlist::join(const std::string& name, Wire high, Wire low, Format format, const std::string& equation) {
  return append(make(Op::join, name, {high.node, low.node}, format, equation));
}

Wire Netlist::shift(const std::string& name, Wire a, int k, Format format, const std::string& equation) {
  Node node = make(Op::shift, name, {a.node}, format, equation);
  node.amount = k;
  return append(std::move(node));
}

Wire Netlist::shift_by(const std::string& name, Wire a, Wire k, Format format, const std::string& equation) {
  return append(make(Op::shift_by, name, {a.node, k.node}, format, equation));
}

Wire Netlist::negate(const std::string& name, Wire a, Format format, const std::string& equation) {
  return append(make(Op::negate, name, {a.node}, format, equation));
}

Wire Netlist::absolute(const std::string& name, Wire a, Format format, const std::string& equation) {
  return append(make(Op::absolute, name, {a.node}, format, equation));
}

Wire Netlist::half_turn(const std::string& name, Wire a, const std::string& equation) {
  const bool known = a.node >= 0 && a.node < static_cast<int>(nodes_.size());
  return append(make(Op::half_turn, name, {a.node}, known ? format(a) : Format{}, equation));
}

Wire Netlist::clamp(const std::string& name, Wire a, double low, double high, Format format, const std::string& equation) {
  Node node = make(Op::clamp, name, {a.node}, format, equation);
  node.low = low;
  node.high = high;
  return append(std::move(node));
}

Wire Netlist::select(const std::string& name, Wire flag, Wire if_set, Wire if_clear, Format format, const std::string& equation) {
  return append(make(Op::select, name, {flag.node, if_set.node, if_clear.node}, format, equation));
}

Wire Netlist::is_negative(const std::string& name, Wire a) {
  return append(make(Op::is_negative, name, {a.node}, flag()));
}

Wire Netlist::is_beyond_quarter(const std::string& name, Wire a) {
  return append(make(Op::is_beyond_quarter, name, {a.node}, flag()));
}

Wire Netlist::exclusive_or(const std::string& name, Wire a, Wire b) {
  return append(make(Op::exclusive_or, name, {a.node, b.node}, flag()));
}

void Netlist::output(const std::string& name, Wire a) {
  const std::string full = prefix_ + name;
  const std::string whose = "netlist '" + name_ + "', output '" + full + "'";
  require(a.node >= 0 && a.node < static_cast<int>(nodes_.size()), whose + ": is not a wire of this netlist");
  require(nodes_[static_cast<std::size_t>(a.node)].op != Op::table, whose + ": a table is read through its columns");
  require(std::none_of(outputs_.begin(), outputs_.end(), [&](const Port& port) { return port.name == full; }),
          whose + ": the name is taken");
  outputs_.push_back({full, a.node});
}

int Netlist::find(const std::string& name) const {
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (nodes_[i].name == name) return static_cast<int>(i);
  return -1;
}

}  // namespace bump
