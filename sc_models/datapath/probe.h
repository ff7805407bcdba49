#pragma once
// Looks at every node of a netlist for one fragment, in double precision and in fixed point side by side: where does the hardware leave the
// algorithm? Inputs are in the units of their formats, so angles in turns. No timing.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "datapath/netlist.h"

namespace bump {

struct ProbeRow {
  std::string name, op, equation, format;
  double real = 0;        ///< value in double precision; of a table node: the index
  double fixed = 0;       ///< value of the word; the same as `real` where an edge of the netlist is real
  std::int64_t raw = 0;   ///< the word, of a table node the address; 0 where an edge of the netlist is real
  bool addition = false;  ///< not part of the published design
  bool is_angle = false;  ///< values are in turns
};

/// One row a node, in recorded order. Throws Error(input) unless `inputs` names exactly the inputs of the netlist.
std::vector<ProbeRow> probe(const Netlist& netlist, const std::map<std::string, double>& inputs);

}  // namespace bump
