#pragma once
// What time is made of, shared by both engines: stages with latency, initiation interval and in-flight capacity, bounded FIFOs between them, and
// memory ports. Integer cycles of one clock. The semantics, for stage i, token k (absent terms have a negative index):
//
//   s(k) = max( s(k-1) + ii(k-1), w_in(k) + 1 for every input it takes, w(k - C) + 1 )                       start
//   d(k) = max( s(k) + lead(k) + L, fill of its last miss + 1, w(k-1) + 1 )                                  result ready, in order, one out a cycle
//   w(k) = max( d(k), s_next(item - D) + 1 for every output it gives )                                       delivered
//
// A token delivered in cycle t can be taken in t+1; a slot freed in cycle t (the consumer's start) can be refilled in t+1. A token that gives
// nothing (a triangle without fragments) passes the stage in order and is dropped at its end: w(k) = d(k).
// A stage with batch b > 1 starts token k, k a multiple of b, only when its inputs hold b items or the last item of the stream.
// Miss m of a memory port, asked by a token that starts at s: grant g = max(s + tag, bus free, fill of miss m-M + 1), bus free = g + b,
// fill = g + latency; misses of one token are granted in order. Every edge of the graph runs from an earlier to a later stage.

#include <cstdint>
#include <string>
#include <vector>

namespace bump {

using Cycle = std::int64_t;

struct StageSpec {
  std::string name;
  Cycle latency = 1;         ///< L >= 1
  std::int64_t capacity = 2; ///< C >= 1: tokens started and not yet delivered
  int batch = 1;             ///< tokens gathered before the first of them starts
  int memory = -1;           ///< index of its memory port, -1 for none
};

struct FifoSpec {
  std::string name;
  int from = 0, to = 0;  ///< stages, from < to
  std::int64_t depth = 2;  ///< D >= 1 tokens
};

struct MemorySpec {
  std::string name;
  Cycle tag_latency = 1;      ///< cycles from start to the request, >= 1
  Cycle latency = 40;         ///< cycles from grant to fill, >= 1
  Cycle cycles_per_line = 4;  ///< bus occupation of a line, >= 1
  int outstanding = 4;        ///< misses in flight, >= 1
};

struct TimingGraph {
  std::vector<StageSpec> stages;
  std::vector<FifoSpec> fifos;
  std::vector<MemorySpec> memories;

  /// Indices of the FIFOs into and out of a stage, in the order of `fifos`.
  std::vector<int> inputs_of(int stage) const;
  std::vector<int> outputs_of(int stage) const;
  /// Throws Error(input) naming the stage or FIFO when a number is out of range or an edge points backwards.
  void validate() const;
};

/// What one token does in one stage. Bit j of a mask is the j-th input (or output) of the stage.
struct TokenRecord {
  std::uint32_t interval = 1;    ///< ii(k) >= 1
  std::uint32_t lead = 0;        ///< extra cycles before the result (positions scanned in vain)
  std::uint16_t misses = 0;      ///< lines asked from the memory port
  std::uint8_t take = 0xff;      ///< inputs whose item the token needs
  std::uint8_t release = 0xff;   ///< inputs whose item it removes at its start (a subset of `take`)
  std::uint8_t give = 0xff;      ///< outputs it delivers an item to
};

struct StageStatistics {
  std::string name;
  std::int64_t tokens = 0;
  Cycle busy = 0;            ///< sum of ii(k)
  Cycle starved = 0;         ///< unit free, input empty
  Cycle blocked_room = 0;    ///< unit free, input there, no room in flight
  Cycle blocked_output = 0;  ///< result ready, output full
  Cycle last_delivery = -1;  ///< w of the last token
};

struct FifoStatistics {
  std::string name;
  std::int64_t depth = 0;
  std::int64_t items = 0;
  std::int64_t max_occupancy = 0;
  Cycle full_cycles = 0;   ///< cycles [0, total) in which all slots are taken: item j-th oldest written before and not removed before the cycle
  Cycle empty_cycles = 0;  ///< cycles [0, total) in which nothing can be taken
};

struct MemoryStatistics {
  std::string name;
  std::int64_t requests = 0;
  Cycle busy = 0;  ///< requests times cycles per line
};

struct TimingResult {
  Cycle cycles = 0;  ///< last delivery of any stage + 1; 0 without tokens
  std::vector<StageStatistics> stages;
  std::vector<FifoStatistics> fifos;
  std::vector<MemoryStatistics> memories;
};

bool operator==(const StageStatistics& a, const StageStatistics& b);
bool operator==(const FifoStatistics& a, const FifoStatistics& b);
bool operator==(const MemoryStatistics& a, const MemoryStatistics& b);
bool operator==(const TimingResult& a, const TimingResult& b);

/// The deadlock report: who waits for which FIFO, depths and occupancies, and the smallest change that frees it.
struct Deadlock {
  Cycle cycle = 0;  ///< last cycle in which anything moved
  struct Wait {
    std::string stage;  ///< who waits
    std::string fifo;   ///< for which FIFO ("" when it waits for room in flight)
    std::string reason; ///< "needs 8 items, holds 4 of 4"
    std::string on;     ///< the stage that would have to act
  };
  std::vector<Wait> chain;
  std::string remedy;  ///< "depth of fifos.interpolators_to_texture_fetch at least 8"
};

/// Throws Error(deadlock) with the chain as text.
[[noreturn]] void report_deadlock(const Deadlock& deadlock);

}  // namespace bump
