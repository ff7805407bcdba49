#pragma once
// The quick way through a pipeline: takes tokens through a whole chain of stages, all stages of one token before the next token, so that
// every date stays in a register from stage to stage. It dates with the same recurrences as DatedStage and on the same state, so the two
// may take turns. A chain is the end of a graph in which each stage feeds nothing but the next, without batches; behind its first stage
// every token takes and removes one item and gives one. A stage that turns out not to do so becomes the first.

#include <functional>
#include <memory>
#include <vector>

#include "channels/dated_lanes.h"
#include "channels/dated_stage.h"

namespace bump {

class DatedChain {
 public:
  /// Stages and their graph, in order; finds the chain at its end by itself (it may be empty, and then nothing is ever passed).
  DatedChain(const TimingGraph& graph, std::vector<DatedStage*> stages);

  /// Passes what can be passed whole. `refill` is called when the input of the chain is empty and says whether anything came. True if any
  /// token moved.
  bool pass(const std::function<bool()>& refill);
  /// The stage whose input the chain takes; as many stages as there are when there is no chain.
  std::size_t first() const { return first_; }

 private:
  static constexpr std::size_t longest = 12;

  bool can_pass() const;
  /// The vector kernel for the chain as it is now, null if that does not serve it.
  DatedLanes* lanes();
  /// Tokens whose records are alike in every stage, 0 if there are none to pass; sets first_ anew where a stage is not ordinary.
  std::int64_t alike();
  std::int64_t startable(const TokenRecord& record) const;
  template <std::size_t Stages>
  void run(std::int64_t count);
  void run(std::size_t stages, std::int64_t count);

  std::vector<DatedStage*> stages_;
  std::size_t first_ = 0;
  std::unique_ptr<DatedLanes> lanes_;
  std::size_t lanes_first_ = 0;  ///< the first_ that lanes_ was made for
};

}  // namespace bump
