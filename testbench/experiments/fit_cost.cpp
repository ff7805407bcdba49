#include "testbench/experiments/fit_cost.h"

#include <array>

#include "datapath/invariant.h"
#include "datapath/inventory.h"
#include "testbench/experiments/price.h"
#include "testbench/experiments/table1_netlists.h"

namespace bump {

namespace {

constexpr std::array<const char*, 5> kind_names = {"multipliers", "adders", "table_bits", "area", "energy"};

void add_cells(const Netlist& netlist, DesignSize& size) {
  for (const Node& node : netlist.nodes()) {
    const auto operand = [&](std::size_t i) {
      return std::int64_t{netlist.nodes()[static_cast<std::size_t>(node.operands[i])].format.width};
    };
    const std::int64_t width = node.format.width;
    if (node.op == Op::mul) size.multiplier_cells += operand(0) * operand(1);
    if (node.op == Op::add || node.op == Op::sub || node.op == Op::add_sub) size.other_cells += width;
    if (node.op == Op::div) size.other_cells += width * operand(1);
    if (node.op == Op::sqrt) size.other_cells += width * width;
  }
}

void add(const Netlist& netlist, DesignSize& size) {
  const Inventory all = count(netlist);
  size.multipliers += all.multipliers;
  size.adders += all.adders;
  size.dividers += all.dividers;
  size.square_roots += all.square_roots;
  size.tables += all.tables;
  size.maps += all.maps;
  size.table_bits += all.table_bits;
  add_cells(netlist, size);
}

}  // namespace

FitCostKind cost_kind_of(const std::string& name) {
  for (std::size_t i = 0; i < kind_names.size(); ++i)
    if (name == kind_names[i]) return static_cast<FitCostKind>(i);
  throw Error({"'" + name + "' is no cost", {}, "the costs are: multipliers, adders, table_bits, area, energy", "--cost table_bits"});
}

const char* name_of(FitCostKind kind) {
  return kind_names[static_cast<std::size_t>(kind)];
}

DesignSize design_size(const Scheme& scheme, const Configuration& configuration, const PriceBook& book) {
  const Design design = scheme.design(configuration, Material{});
  DesignSize size;
  if (design.conversion) add(*design.conversion, size);
  add(design.environment, size);
  if (design.light_maps) {
    add(design.light_maps->address, size);
    size.maps += static_cast<std::int64_t>(design.light_maps->maps.size());
    size.light_map_bytes = light_map_bytes(design);
  }
  add(design.illumination, size);
  for (const BumpEncoding::Channel& channel : design.map.channels) size.texel_bits += channel.format.width;
  if (book.area == nullptr && book.energy == nullptr) return size;
  const SchemePrice price = price_scheme(scheme, configuration, book);
  size.area = price.total(Quantity::area, false);
  size.energy = price.total(Quantity::energy, false);
  return size;
}

FitCost cost_of(const DesignSize& size, FitCostKind kind) {
  const auto number = [](std::int64_t count) { return static_cast<double>(count); };
  const double cells = number(size.multiplier_cells + size.other_cells), bits = number(size.table_bits), texel = number(size.texel_bits);
  // What no table prices: maps in memory, and widths that only the interpolators see.
  const std::array<double, 3> rest = {size.light_map_bytes, texel, number(size.width_sum)};
  FitCost cost;
  if (kind == FitCostKind::multipliers) cost = {number(size.multipliers), number(size.multiplier_cells), bits, number(size.other_cells)};
  if (kind == FitCostKind::adders) cost = {number(size.adders), number(size.other_cells), bits, number(size.multiplier_cells)};
  if (kind == FitCostKind::table_bits) cost = {bits, cells};
  if (kind == FitCostKind::area) {
    BUMP_ASSERT(size.area);
    cost = {*size.area};
  }
  if (kind == FitCostKind::energy) {
    BUMP_ASSERT(size.energy);
    cost = {*size.energy};
  }
  cost.insert(cost.end(), rest.begin(), rest.end());
  return cost;
}

}  // namespace bump
