#include "channels/statistics.h"

namespace bump {

std::vector<StatisticMeaning> statistic_meanings() {
  // free(k) = s(k-1) + ii(k-1), 0 for the first token; arrived(k): the first cycle in which every input the token takes can be read.
  return {
      {"run", "cycles", "cycles", "clock cycles from the first cycle to the last delivery of any stage, inclusive", "max w + 1"},

      {"stage", "tokens", "tokens", "tokens that passed the stage", ""},
      {"stage", "busy", "cycles", "inside the initiation interval of a token", "sum ii(k)"},
      {"stage", "starved", "cycles", "unit free, an input empty (or a batch not gathered)", "sum max(free(k), arrived(k)) - free(k)"},
      {"stage", "blocked_room", "cycles", "unit free, inputs there, but all in-flight slots taken", "sum s(k) - max(free(k), arrived(k))"},
      {"stage", "blocked_output", "cycles", "oldest result ready, but an output FIFO full", "sum w(k) - d(k)"},
      {"stage", "last_delivery", "cycles", "cycle in which the last token left; absent without tokens", "w(last)"},

      {"fifo", "depth", "tokens", "slots", ""},
      {"fifo", "items", "tokens", "items that passed the FIFO", ""},
      {"fifo", "max_occupancy", "tokens", "most slots taken in any one cycle",
       "max over cycles c of #{w < c} - #{s < c}, w writes and s removals"},
      {"fifo", "full_cycles", "cycles", "cycles of the run in which every slot is taken", "#{c : #{w < c} - #{s < c} = depth}"},
      {"fifo", "empty_cycles", "cycles", "cycles of the run in which nothing can be taken", "#{c : #{w < c} = #{s < c}}"},

      {"memory", "requests", "requests", "lines asked from the memory port", "sum misses(k)"},
      {"memory", "busy", "cycles", "cycles in which the bus carries a line", "requests * cycles_per_line"},
  };
}

}  // namespace bump
