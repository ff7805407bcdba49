#pragma once
// The formulas of timing_graph.h evaluated as they stand, by memoised recursion from the last token, and statistics counted cycle by cycle
// from the dates. Shares nothing with either engine. A date that depends on itself is a deadlock.

#include <optional>

#include "random_timing.h"

namespace bump::test {

class DirectEvaluation {
 public:
  explicit DirectEvaluation(const TimingCase& timing_case);
  /// Nothing when a date depends on itself.
  std::optional<TimingResult> result();

 private:
  struct Cyclic {};
  struct Token {
    TokenRecord record;
    std::vector<std::pair<int, std::int64_t>> takes, gives;  ///< FIFO and item
    std::int64_t first_miss = 0;
    Cycle start = unknown, delivery = unknown;
  };
  struct Fifo {
    std::vector<std::int64_t> givers, removers;  ///< token of each item
  };
  static constexpr Cycle unknown = -100, in_progress = -200;

  template <class Compute>
  Cycle memoised(Cycle& date, Compute compute);
  Token& token(int stage, std::int64_t k) { return tokens_[static_cast<std::size_t>(stage)][static_cast<std::size_t>(k)]; }
  const FifoSpec& spec(int fifo) const { return case_.graph.fifos[static_cast<std::size_t>(fifo)]; }
  const StageSpec& spec_of_stage(int stage) const { return case_.graph.stages[static_cast<std::size_t>(stage)]; }
  Cycle free(int stage, std::int64_t k);
  Cycle arrived(int stage, std::int64_t k);
  Cycle start(int stage, std::int64_t k);
  Cycle ready(int stage, std::int64_t k);
  Cycle delivery(int stage, std::int64_t k);
  Cycle written(int fifo, std::int64_t item) {
    return delivery(spec(fifo).from, fifos_[static_cast<std::size_t>(fifo)].givers[static_cast<std::size_t>(item)]);
  }
  Cycle removed(int fifo, std::int64_t item) {
    return start(spec(fifo).to, fifos_[static_cast<std::size_t>(fifo)].removers[static_cast<std::size_t>(item)]);
  }
  Cycle grant(int stage, std::int64_t miss);
  TimingResult evaluate();
  FifoStatistics count(int fifo, Cycle cycles);

  TimingCase case_;
  std::vector<std::vector<Token>> tokens_;
  std::vector<Fifo> fifos_;
  std::vector<std::vector<std::int64_t>> missers_;  ///< by stage: token of each miss
  std::vector<std::vector<Cycle>> grants_;
};

}  // namespace bump::test
