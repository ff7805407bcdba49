#pragma once
// The vector kernel of the dated timing plane: one SIMD lane per stage of a chain, skewed so that lane i dates token n-1-i in step n, while
// the stage in front of the lanes, the head, dates token n. Each step so dates one token in every stage, by the recurrences of
// timing_graph.h. The skew is what makes every date that a lane needs the result of an earlier step, and for that every FIFO has to hold
// two tokens or more. Bookkeeping of the simulator, no hardware.

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "channels/dated_stage.h"

namespace bump {

class DatedLanes {
 public:
  static constexpr std::size_t widest = 8;  ///< stages behind the head

  /// Head and the stages behind it.
  explicit DatedLanes(std::vector<DatedStage*> stages);
  ~DatedLanes();

  /// Whether the kernel can date these stages: 2 to 9 of them, depths of 2 and more, no more tokens in flight than are worth keeping at
  /// hand.
  static bool serves(const std::vector<DatedStage*>& stages);

  /// Takes tokens through all stages, as many as there are records and input for; none may be in flight. `refill` is called when the head's
  /// input is empty and says whether anything came. Stops in front of a token of the head that gives nothing. Returns the number of tokens.
  std::int64_t pass(const std::function<bool()>& refill);

 private:
  struct State;

  std::int64_t records_left() const;
  void load();
  void load_lane(std::size_t lane);
  void store(std::int64_t tokens);
  void store_lane(std::size_t lane, std::int64_t tokens);
  /// Steps until the head has to look at its records or its input again; 0 when it can do nothing more.
  std::int64_t prepare_head(std::int64_t limit, const std::function<bool()>& refill);
  /// Steps until a lane has to look at its records again, or begins or ends.
  std::int64_t prepare_lanes();

  std::vector<DatedStage*> stages_;
  std::size_t lanes_;
  std::int64_t history_ = 0;  ///< rows in front of step 0
  std::int64_t step_ = 0, entered_ = 0;
  std::unique_ptr<State> state_;
};

}  // namespace bump
