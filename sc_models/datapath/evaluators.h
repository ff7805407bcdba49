#pragma once
// The two evaluators behind make_evaluator (evaluate.h).

#include <memory>

#include "datapath/evaluate.h"

namespace bump {

std::unique_ptr<Evaluator> make_real_evaluator(const Netlist& netlist);
/// The netlist has no `real` edges.
std::unique_ptr<Evaluator> make_fixed_evaluator(const Netlist& netlist);

}  // namespace bump
