#pragma once
// The cells that a synthesis tool must find in an emitted datapath, before it maps them to a technology: what the netlist was counted to be
// built of, with shared multipliers once each, and without operators of constants alone. Yosys calls them as said in cell_patterns().

#include <string>
#include <vector>

#include "datapath/netlist.h"
#include "datapath/schedule.h"
#include "rtl/datapath_module.h"

namespace bump {

struct ExpectedCells {
  struct Kind {
    std::string name;                   ///< "multipliers"
    std::vector<std::string> patterns;  ///< types of cells, as Yosys's `select t:` takes them
    int count = 0;                      ///< in all together
  };
  std::string module;  ///< of the datapath
  std::vector<Kind> kinds;
};

ExpectedCells expected_cells(const Netlist& netlist, const Schedule& schedule, const DatapathModule& datapath);

}  // namespace bump
