#pragma once
// Token counts without dates: which tokens can move at all. Whether a graph with bounded FIFOs gets stuck does not depend on latencies or
// on the order of moves (each stage is deterministic and waits on its own FIFOs only, so the final state is unique), and more slots never
// hinder. Hence a deadlocked state can be replayed with other depths, to find the change that frees it. Bookkeeping of the simulator, no
// hardware.

#include <vector>

#include "channels/token_runs.h"

namespace bump {

/// How far each stage and FIFO has come.
struct UntimedState {
  struct Stage {
    std::int64_t started = 0, delivered = 0;
    std::vector<TokenRun> runs;  ///< records from token `delivered` on; all that will ever come
  };
  struct Fifo {
    std::int64_t written = 0, released = 0;
  };
  std::vector<Stage> stages;
  std::vector<Fifo> fifos;
};

class UntimedReplay {
 public:
  UntimedReplay(const TimingGraph& graph, const UntimedState& state);

  /// Moves tokens until nothing moves. True if every token was delivered.
  bool run();
  /// Items that each FIFO will have seen when every token has been delivered.
  const std::vector<std::int64_t>& totals() const { return totals_; }

 private:
  struct Stage {
    std::vector<int> inputs, outputs;
    std::int64_t started = 0, delivered = 0;
    TokenRuns runs;
    TokenRuns::Cursor start, deliver;
  };
  std::int64_t held(int fifo) const;
  std::int64_t startable(const StageSpec& spec, Stage& stage) const;
  std::int64_t deliverable(Stage& stage) const;
  bool move(const StageSpec& spec, Stage& stage);

  TimingGraph graph_;
  std::vector<Stage> stages_;
  std::vector<UntimedState::Fifo> fifos_;
  std::vector<std::int64_t> totals_;
};

}  // namespace bump
