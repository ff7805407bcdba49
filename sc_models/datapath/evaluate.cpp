#include "datapath/evaluate.h"

#include "datapath/checks.h"
#include "datapath/evaluators.h"

namespace bump {

std::unique_ptr<Evaluator> make_evaluator(const Netlist& netlist, Arithmetic arithmetic) {
  if (arithmetic == Arithmetic::real) return make_real_evaluator(netlist);
  for (const Node& node : netlist.nodes())
    require(!node.format.is_real, "netlist '" + netlist.name() + "', node '" + node.name + "': a real value has no fixed-point evaluation");
  return make_fixed_evaluator(netlist);
}

}  // namespace bump
