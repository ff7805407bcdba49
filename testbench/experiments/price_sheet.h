#pragma once
// Components with their prices in one quantity, as a sum and by group: the sheet of a unit, of an execution, or of a fragment's memory
// traffic. No hardware of its own, no time.

#include <string>
#include <vector>

#include "testbench/experiments/price_items.h"

namespace bump {

struct PricedItem {
  PriceItem item;
  const PriceEntry* entry = nullptr;
  double each = 0;  ///< 0 if excluded

  double total() const { return each * item.count; }
};

/// Items of a unit with their prices in one quantity.
struct CostSheet {
  std::vector<PricedItem> items;

  double total() const;
  double additions() const;  ///< part of it that is not in the published design; registers count as published
  double of(CostGroup group) const;
  double table_bits() const;   ///< of built items: bits stored, each once; a second port stores none
  double port_prices() const;  ///< of second ports: a part of the tables' price that no stored bit explains
  double table_reads() const;  ///< of executed items: reads through any port
};

/// Prices the items one by one. Throws Error(input) for a missing entry, naming table, component, `who` and a node.
CostSheet price_items(const std::vector<PriceItem>& items, const PriceTable& table, Quantity quantity, const std::string& who);

}  // namespace bump
