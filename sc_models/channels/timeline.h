#pragma once
// The dated timing plane: exact dates by the recurrences of timing_graph.h, for any graph. The chain at the end of a graph is dated token
// by token through all its stages (dated_chain.h: quick); elsewhere stages run ahead of one another as far as dates are known (a stage
// stops when an input item or the release of an output slot is not dated yet), so records may arrive in blocks of any size. No SystemC:
// the engine that owns a Timeline lets kernel time follow its dates.

#include <memory>

#include "channels/timing_plane.h"

namespace bump {

class Timeline : public TimingPlane {
 public:
  /// The graph is validated and copied.
  explicit Timeline(const TimingGraph& graph);
  ~Timeline() override;

  void append(int stage, const TokenRecord* records, std::size_t count) override;
  void append_uniform(int stage, const TokenRecord& record, std::size_t count) override;

  /// Dates everything that can be dated now.
  void advance();
  /// Last delivery dated so far, -1 before the first.
  Cycle latest() const;
  /// No more records will come: dates the rest and returns the totals. Throws Error(deadlock) if tokens remain that can never move.
  TimingResult finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bump
