#pragma once
// Evaluates a netlist over a block of fragments (structure of arrays), either in double precision (the algorithm itself) or bit-accurately
// in fixed point (what the hardware computes). Node by node, each a loop over the lanes that the compiler vectorises. An evaluator belongs
// to one thread, also while it is only looked at.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "datapath/netlist.h"

namespace bump {

/// Lanes of a block: one block of fragments fits.
constexpr int block_lanes = 256;

enum class Arithmetic { real, fixed };

class Evaluator {
 public:
  virtual ~Evaluator() = default;

  /// Evaluates lanes [0, lanes). inputs[i] and outputs[j] are arrays of `lanes` doubles in the order of Netlist::inputs() and outputs();
  /// fixed-point words enter by quantise() and leave by their exact value. 0 <= lanes <= block_lanes.
  virtual void evaluate(const double* const* inputs, int lanes, double* const* outputs) = 0;

  /// After evaluate(): the value of a node in a lane (for `table` nodes: the index value, of a map the first), as a double. The first time
  /// a node is asked for, the block is evaluated once more; from then on every evaluation keeps the node.
  virtual double value(int node, int lane) const = 0;
  /// After evaluate(), fixed point only: the raw word of a node in a lane (for `table` nodes: the address).
  virtual std::int64_t raw(int node, int lane) const = 0;
};

/// The netlist must outlive the evaluator. Arithmetic::fixed throws Error(internal) for netlists with `real` edges.
std::unique_ptr<Evaluator> make_evaluator(const Netlist& netlist, Arithmetic arithmetic);

}  // namespace bump
