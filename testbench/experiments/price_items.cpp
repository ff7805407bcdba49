#include "testbench/experiments/price_items.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "datapath/arithmetic.h"
#include "datapath/invariant.h"
#include "testbench/experiments/price_contents.h"

namespace bump {

namespace {

constexpr int float_bits = 32;

bool moves_no_information(Op op) {
  return op == Op::shift || op == Op::negate || op == Op::absolute;
}

class Items {
 public:
  Items(const Netlist& netlist, const ItemOptions& options) : netlist_(netlist), options_(options) {}

  std::vector<PriceItem> list(bool with_multipliers) {
    for (std::size_t i = 0; i < netlist_.nodes().size(); ++i) {
      node_ = static_cast<int>(i);
      if (with_multipliers || node().op != Op::mul) add_node();
    }
    return std::move(items_);
  }
  PriceItem multiplier(int at) {
    node_ = at;
    items_.clear();
    add_node();
    BUMP_ASSERT(items_.size() == 1);
    return items_.front();
  }
  PriceItem item(int at, Component component, PriceSizes size, double count) {
    node_ = at;
    return {component, size, count, node().addition, node().name};
  }

 private:
  const Node& node() const { return netlist_.nodes()[static_cast<std::size_t>(node_)]; }
  const Node& operand(std::size_t i) const { return netlist_.nodes()[static_cast<std::size_t>(node().operands[i])]; }
  /// Whether the operation is done in floating point.
  bool is_float() const {
    bool real = node().format.is_real;
    for (std::size_t i = 0; i < node().operands.size(); ++i) real = real || operand(i).format.is_real;
    return real && options_.real_bits == 0;
  }
  int bits(const Format& format) const {
    if (!format.is_real) return format.width;
    return options_.real_bits > 0 ? options_.real_bits : float_bits;
  }
  void add(Component component, PriceSizes size = {}, double count = 1) {
    items_.push_back({component, size, count, node().addition, node().name});
  }

  /// A constant of the structure: hard-wired.
  bool is_wired(int at) const {
    const Node& n = netlist_.nodes()[static_cast<std::size_t>(at)];
    if (n.op == Op::constant) return options_.settable.empty() || !options_.settable[static_cast<std::size_t>(at)];
    return moves_no_information(n.op) && is_wired(n.operands[0]);
  }

  void add_node() {
    switch (node().op) {
      case Op::add:
      case Op::sub:
        add_adder(operand(0), operand(1),
                  is_wired(node().operands[0]) || is_wired(node().operands[1]) ? Component::constant_adder : Component::adder);
        break;
      case Op::add_sub:
        add_adder(operand(1), operand(2),
                  is_wired(node().operands[2]) ? Component::constant_adder_subtractor : Component::adder_subtractor);
        break;
      case Op::mul:
        add_multiplier();
        break;
      case Op::div:
        if (is_float()) return add(Component::float_divider);
        add(Component::divider, {double(rows(node().format)), double(bits(operand(1).format))});
        break;
      case Op::sqrt:
        if (is_float()) return add(Component::float_square_root);
        add(Component::square_root, {double(rows(node().format)), double(rows(node().format))});
        break;
      case Op::clamp:
        if (is_float()) return add(Component::float_adder);
        add(Component::clamp, {double(bits(operand(0).format))});
        break;
      case Op::select:
        if (is_float()) return add(Component::float_select);
        add(Component::select, {double(bits(node().format))});
        break;
      case Op::negate:
      case Op::absolute:
        if (!is_float()) add(Component::negate, {double(bits(node().format))});  // a floating-point sign is a bit of its own
        break;
      case Op::shift_by:
        if (is_float()) return add(Component::float_adder);  // of the exponent
        add(Component::shifter, {double(bits(operand(0).format)), double(bits(operand(1).format))});
        break;
      case Op::table:
        add_table();
        break;
      case Op::input:
      case Op::constant:
      case Op::column:
      case Op::join:
      case Op::shift:
      case Op::half_turn:
      case Op::is_negative:
      case Op::is_beyond_quarter:
      case Op::exclusive_or:
        break;
    }
  }

  int rows(const Format& format) const { return format.is_real ? options_.real_bits : magnitude_bits(format); }

  /// Columns in which an adder has work: below, only one operand has bits; above, the sum has none or the result drops them.
  int adder_columns(const Node& a, const Node& b) const {
    const Format &fa = a.format, &fb = b.format, &result = node().format;
    if (fa.is_real || fb.is_real || result.is_real) return bits(result);
    const int lowest = node().op == Op::add ? std::min(fa.fraction, fb.fraction) : fb.fraction;  // a subtrahend's low bits borrow
    const int sum_top = std::max(fa.width - fa.fraction, fb.width - fb.fraction) + 1;
    return std::max(1, std::min(result.width - result.fraction, sum_top) + lowest);
  }
  void add_adder(const Node& a, const Node& b, Component component) {
    if (is_float()) return add(Component::float_adder);
    add(component, {double(adder_columns(a, b))});
  }

  void add_multiplier() {
    if (is_float()) return add(Component::float_multiplier);
    const int a = node().operands[0], b = node().operands[1];
    const PriceSizes widths = {double(bits(operand(0).format)), double(bits(operand(1).format))};
    const bool wired = is_wired(a) || is_wired(b);
    add(a == b ? Component::squarer : wired ? Component::constant_multiplier : Component::multiplier, widths);
  }

  void add_table() {
    const Table& table = *netlist_.tables()[static_cast<std::size_t>(node().table)];
    const double copies = table.per_material && !node().second_port ? options_.materials : 1;
    const auto entries = static_cast<double>(table.entries());
    const auto width = [&](const Column& column) {
      return double(column.format.is_real ? bits(column.format) : table.stored_width(column));
    };
    const RomContents& contents = contents_once(table);
    double word = 0, columns = 0, mirrored = 0, changes = 0;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      const Column& column = table.columns[i];
      (column.mirrors_first ? mirrored : columns) += 1;
      if (column.mirrors_first) continue;
      word += width(column);
      changes += contents.changes[i];
    }
    const Component component = node().second_port ? Component::second_port
                                : table.is_map()   ? Component::map
                                : contents.is_line ? Component::line_table
                                                   : Component::table;
    add(component, {entries, word, columns, changes}, copies);
    if (mirrored > 0) add(Component::second_port, {entries, width(table.columns.front()), 1, contents.changes.front()}, mirrored * copies);
    if (table.folding == Folding::floating)
      add(Component::index_encoder, {std::ldexp(1.0, table.exponent_bits), double(table.address_bits - table.exponent_bits)});
    add_folding(table, width);
  }

  const RomContents& contents_once(const Table& table) {
    const auto [place, added] = contents_.try_emplace(&table);
    if (added) place->second = contents_of(table);
    return place->second;
  }

  template <class Width>
  void add_folding(const Table& table, const Width& width) {
    const bool quarter = table.folding == Folding::quarter;
    if (!quarter && (table.folding != Folding::magnitude || !table.index.is_signed)) return;
    if (table.index.is_real) return;
    add(Component::negate, {double(table.index.width - (quarter ? 2 : 1))});
    for (const Column& column : table.columns)
      if (column.symmetry.odd_about_zero || (quarter && column.symmetry.odd_about_quarter)) add(Component::negate, {width(column)});
  }

  const Netlist& netlist_;
  const ItemOptions& options_;
  int node_ = 0;
  std::vector<PriceItem> items_;
  std::map<const Table*, RomContents> contents_;  ///< only looked up
};

/// Products by the cycle, modulo the interval, in which they start.
std::vector<std::vector<int>> products_by_slot(const Netlist& netlist, const Schedule& schedule) {
  std::vector<std::vector<int>> slots(static_cast<std::size_t>(schedule.initiation_interval));
  for (std::size_t i = 0; i < netlist.nodes().size(); ++i)
    if (netlist.nodes()[i].op == Op::mul)
      slots[static_cast<std::size_t>(schedule.start[i] % schedule.initiation_interval)].push_back(static_cast<int>(i));
  return slots;
}

/// Multipliers that take one product of each slot: the largest products of all slots share one, the next largest the next.
void add_shared_multipliers(const Netlist& netlist, const Schedule& schedule, const ItemOptions& options, std::vector<PriceItem>& items) {
  Items of(netlist, options);
  std::vector<std::vector<int>> slots = products_by_slot(netlist, schedule);
  const auto area = [&](int node) {
    const PriceSizes size = of.multiplier(node).size;
    return size[0] * size[1];
  };
  for (std::vector<int>& slot : slots) std::stable_sort(slot.begin(), slot.end(), [&](int a, int b) { return area(a) > area(b); });
  for (int m = 0; m < schedule.multipliers_built; ++m) {
    std::vector<int> sharing;
    for (const std::vector<int>& slot : slots)
      if (static_cast<std::size_t>(m) < slot.size()) sharing.push_back(slot[static_cast<std::size_t>(m)]);
    BUMP_ASSERT(!sharing.empty());
    PriceItem shared = of.multiplier(sharing.front());
    for (const int node : sharing) {
      const PriceItem one = of.multiplier(node);
      shared.size = {std::max(shared.size[0], one.size[0]), std::max(shared.size[1], one.size[1]), 0};
      shared.addition = shared.addition && one.addition;
      if (one.component != shared.component) shared.component = Component::multiplier;
    }
    if (sharing.size() > 1) {
      if (shared.component == Component::constant_multiplier) shared.component = Component::multiplier;
      for (const double width : {shared.size[0], shared.size[1]})
        items.push_back(of.item(sharing.front(), Component::select, {width}, double(sharing.size() - 1)));
    }
    items.push_back(shared);
  }
}

}  // namespace

std::vector<PriceItem> executed_items(const Netlist& netlist, const ItemOptions& options) {
  return Items(netlist, options).list(true);
}

std::vector<PriceItem> built_items(const Netlist& netlist, const Schedule* schedule, const ItemOptions& options) {
  if (schedule == nullptr || schedule->initiation_interval == 1) return executed_items(netlist, options);
  std::vector<PriceItem> items = Items(netlist, options).list(false);
  add_shared_multipliers(netlist, *schedule, options, items);
  return items;
}

std::vector<bool> differing_constants(const Netlist& netlist, const Netlist& other) {
  BUMP_ASSERT(netlist.nodes().size() == other.nodes().size());
  std::vector<bool> differs;
  for (std::size_t i = 0; i < netlist.nodes().size(); ++i)
    differs.push_back(netlist.nodes()[i].op == Op::constant && netlist.nodes()[i].value != other.nodes()[i].value);
  return differs;
}

std::vector<PriceItem> merged(const std::vector<PriceItem>& items) {
  std::vector<PriceItem> result;
  for (const PriceItem& item : items) {
    const auto same = std::find_if(result.begin(), result.end(), [&](const PriceItem& known) {
      return known.component == item.component && known.size == item.size && known.addition == item.addition;
    });
    if (same == result.end())
      result.push_back(item);
    else
      same->count += item.count;
  }
  std::stable_sort(result.begin(), result.end(), [](const PriceItem& a, const PriceItem& b) { return a.component < b.component; });
  return result;
}

}  // namespace bump
