#pragma once
// What a scheme costs by a table of prices: area of what its netlists build, energy of what they execute for a fragment. Units of the
// bump-mapping datapath make the total; the colour unit, which every scheme shares, is added in a second one; interpolators, vertex
// work and the filling of light maps stand apart, and so does memory traffic, which is known for a scene only. Every total names its
// table. What a table excludes by a reason of its own is counted and named; what it does not have is an error. Left out: clock trees,
// wires, control, FIFOs and caches as area, leakage, and texels that wait for the memory.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "channels/parameters.h"
#include "schemes/scheme.h"
#include "testbench/experiments/price_registers.h"
#include "testbench/experiments/price_sheet.h"
#include "testbench/experiments/price_work.h"

namespace bump {

struct UnitPrice {
  enum class Role { bump_mapping, colour, apart } role = Role::bump_mapping;
  std::string name;
  /// Missing without a table of that quantity, or (apart only) for `unpriced`.
  std::optional<CostSheet> area, energy;     ///< energy: of one execution
  std::optional<double> executions;          ///< for each fragment; missing without a scene where it is not 1
  std::array<std::string, 2> unpriced;       ///< by quantity: why a unit that stands apart has no price
  std::optional<RegisterBits> registers;     ///< of pipelines
  int latency = 0, initiation_interval = 1;  ///< of pipelines

  /// For each fragment; missing if the price or the number of executions is.
  std::optional<double> energy_of_fragment() const;
};

/// What a table leaves out of a total, by a reason of its own.
struct LeftOut {
  Component component = Component::adder;
  double amount = 0;  ///< built, or executed for a fragment: bits of components that have a width, and of registers; else pieces
};

struct SchemePrice {
  const SchemePage* page = nullptr;
  std::optional<Error> error;  ///< why there are no prices
  std::vector<UnitPrice> units;
  std::optional<CostSheet> traffic;  ///< energy of a fragment's look-ups and bytes; with a scene and a table of energies
  std::optional<ExecutedWork> work;  ///< what was executed; with a scene

  /// Of bump mapping, with or without the colour unit; missing without a table of that quantity. Energy: for each fragment.
  std::optional<double> total(Quantity quantity, bool with_colour) const;
  std::optional<double> of(Quantity quantity, CostGroup group) const;  ///< of bump mapping
  std::optional<double> additions(Quantity quantity) const;            ///< of bump mapping
  std::optional<double> table_bits() const;                            ///< of bump mapping: bits stored, a second port has none
  std::optional<double> port_prices() const;                           ///< of bump mapping, area: of second ports
  std::optional<double> table_reads() const;                           ///< of bump mapping, for each fragment, through any port
  /// In order of component; empty if the table excludes nothing that bump mapping, or the colour unit, needs.
  std::vector<LeftOut> left_out(Quantity quantity, bool with_colour) const;
};

struct PriceOptions {
  int real_bits = 0;                   ///< width of interpolators and vertex work in fixed point; 0: floating point
  const Scene* scene = nullptr;        ///< lights, materials; null: one light of intensity 1, one material
  const ExecutedWork* work = nullptr;  ///< what a run of the scene executed; null: every pixel netlist once for a fragment
};

/// Throws Error(input): a missing price, or settings that contradict one another. The book's tables must outlive the result.
SchemePrice price_scheme(const Scheme& scheme, const Configuration& configuration, const PriceBook& book, const PriceOptions& options = {});

}  // namespace bump
