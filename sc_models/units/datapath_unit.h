#pragma once
// What the per-pixel datapath units have in common: a netlist of the design, evaluated for every light over a block of fragments, in the
// hardware's arithmetic and, beside it, in double precision. With several lights a fragment passes the same hardware once per light, one
// after another; where light maps hold the sum of the lights, once altogether. Latency and initiation interval follow from the netlist's
// schedule.

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "datapath/evaluate.h"
#include "units/pipeline_context.h"

namespace bump {

class DatapathUnit {
 public:
  /// Picks the unit's netlist out of a design; null if the design has none, and the unit then does nothing.
  using Select = const Netlist* (*)(const Design&);

  /// `mark`: fill in FragmentBlock::diverged from the design's `jumps` and `least`, which name nodes of this netlist.
  DatapathUnit(std::shared_ptr<const PipelineContext> context, Select select, bool mark = false);
  void process(FragmentBlock& block);

  /// Times the whole netlist was executed: fragments times lights (fragments, with light maps).
  std::int64_t executions() const { return executions_; }

 private:
  void mark_diverged(FragmentBlock& block, std::size_t design) const;

  /// The planes of one pass, in the order of the netlist's ports.
  struct Ports {
    std::vector<int> inputs, outputs;
  };

  std::shared_ptr<const PipelineContext> context_;
  std::vector<std::unique_ptr<Evaluator>> hardware_, exact_;  ///< one per design; none if the design has no such netlist
  std::vector<Ports> ports_;                                  ///< one per pass
  std::vector<const double*> inputs_;
  std::vector<double*> outputs_;
  std::vector<int> jumps_;                      ///< nodes
  std::vector<std::pair<int, double>> least_;  ///< nodes and their least values
  std::int64_t executions_ = 0;
};

}  // namespace bump
