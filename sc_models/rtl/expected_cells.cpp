#include "rtl/expected_cells.h"

#include "datapath/inventory.h"

namespace bump {

ExpectedCells expected_cells(const Netlist& netlist, const Schedule& schedule, const DatapathModule& datapath) {
  Inventory built = count(netlist);
  int multipliers = schedule.multipliers_built;
  for (const std::string& name : datapath.folded) {
    const Op op = netlist.nodes()[static_cast<std::size_t>(netlist.find(name))].op;
    if (op == Op::mul && schedule.initiation_interval == 1) --multipliers;  // a shared one serves others, too
    if (op == Op::add || op == Op::sub || op == Op::add_sub) --built.adders;
    if (op == Op::div) --built.dividers;
    if (op == Op::sqrt) --built.square_roots;
  }
  ExpectedCells cells;
  cells.module = datapath.name;
  cells.kinds = {{"multipliers", {"$mul"}, multipliers},
                 {"adders", {"$add", "$sub", "addsub_*"}, built.adders},
                 {"dividers", {"div_*"}, built.dividers},
                 {"square_roots", {"sqrt_*"}, built.square_roots},
                 {"tables", {"table_*"}, built.tables + built.maps}};
  return cells;
}

}  // namespace bump
