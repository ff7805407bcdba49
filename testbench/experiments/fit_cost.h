#pragma once
// What a fit makes small: the size of a design's per-pixel datapaths (conversion, environment, light-map address, illumination; additions
// to the published design included) in operators, full-adder cells and table bits, or their price. Widths change how large operators are,
// seldom how many there are, so every kind of cost is a list: the first number decides, later ones between equals. No time.

#include <cstdint>
#include <optional>
#include <string>

#include "channels/parameters.h"
#include "schemes/scheme.h"
#include "testbench/experiments/fit_search.h"
#include "testbench/experiments/price_table.h"

namespace bump {

struct DesignSize {
  std::int64_t multipliers = 0, adders = 0, dividers = 0, square_roots = 0, tables = 0, maps = 0;
  std::int64_t multiplier_cells = 0;  ///< partial products: factor widths multiplied
  std::int64_t other_cells = 0;       ///< bits of adders, cells of restoring dividers and square roots
  std::int64_t table_bits = 0;        ///< of all ROMs, one for every read
  std::int64_t texel_bits = 0;        ///< of the bump map
  double light_map_bytes = 0;         ///< of one object
  std::int64_t width_sum = 0;         ///< of the widths chosen
  std::optional<double> area;         ///< NAND2, without the colour unit; with a price table of areas
  std::optional<double> energy;       ///< pJ a fragment, without colour unit and memory traffic; with a price table of energies
};

enum class FitCostKind { multipliers, adders, table_bits, area, energy };
/// "multipliers" ... Throws Error(input) for another word.
FitCostKind cost_kind_of(const std::string& name);
const char* name_of(FitCostKind kind);

/// For one light of intensity 1 and one material. Throws Error(input): settings that contradict one another, a missing price.
DesignSize design_size(const Scheme& scheme, const Configuration& configuration, const PriceBook& book);

FitCost cost_of(const DesignSize& size, FitCostKind kind);

}  // namespace bump
