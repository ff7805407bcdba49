#include "datapath/inventory.h"

#include "datapath/vertex_program.h"

namespace bump {

Inventory& Inventory::operator+=(const Inventory& other) {
  multipliers += other.multipliers;
  adders += other.adders;
  dividers += other.dividers;
  square_roots += other.square_roots;
  tables += other.tables;
  maps += other.maps;
  second_ports += other.second_ports;
  shifters += other.shifters;
  shifts += other.shifts;
  sign_logic += other.sign_logic;
  clamps += other.clamps;
  selects += other.selects;
  index_encoders += other.index_encoders;
  table_bits += other.table_bits;
  distinct_table_bits += other.distinct_table_bits;
  return *this;
}

Inventory count(const Netlist& netlist, Portion portion) {
  std::vector<bool> which;
  for (const Node& node : netlist.nodes()) which.push_back(portion == Portion::all || node.addition == (portion == Portion::addition));
  return count_nodes(netlist, which);
}

}  // namespace bump
