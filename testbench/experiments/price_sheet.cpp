#include "testbench/experiments/price_sheet.h"

namespace bump {

CostSheet price_items(const std::vector<PriceItem>& items, const PriceTable& table, Quantity quantity, const std::string& who) {
  CostSheet sheet;
  for (const PriceItem& item : items) {
    PricedItem priced;
    priced.item = item;
    priced.entry = &table.at(quantity, item.component, who + " (" + item.node + ")");
    priced.each = priced.entry->at(item.size);
    if (!priced.entry->is_excluded() && !(priced.each >= 0))
      throw Error({"price table '" + table.name() + "' gives a negative price for " + name_of(item.component), priced.entry->where,
                   "needed by " + who + " (" + item.node + "): " + formula(*priced.entry, item.component), "another form or coefficient"});
    sheet.items.push_back(priced);
  }
  return sheet;
}

double CostSheet::total() const {
  double sum = 0;
  for (const PricedItem& item : items) sum += item.total();
  return sum;
}

double CostSheet::additions() const {
  double sum = 0;
  for (const PricedItem& item : items)
    if (item.item.addition) sum += item.total();
  return sum;
}

double CostSheet::of(CostGroup group) const {
  double sum = 0;
  for (const PricedItem& item : items)
    if (group_of(item.item.component) == group) sum += item.total();
  return sum;
}

double CostSheet::table_bits() const {
  double bits = 0;
  for (const PricedItem& item : items)
    if (group_of(item.item.component) == CostGroup::tables && item.item.component != Component::second_port)
      bits += item.item.count * item.item.size[0] * item.item.size[1];
  return bits;
}

double CostSheet::port_prices() const {
  double sum = 0;
  for (const PricedItem& item : items)
    if (item.item.component == Component::second_port) sum += item.total();
  return sum;
}

double CostSheet::table_reads() const {
  double reads = 0;
  for (const PricedItem& item : items)
    if (group_of(item.item.component) == CostGroup::tables) reads += item.item.count;
  return reads;
}

}  // namespace bump
