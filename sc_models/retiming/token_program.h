#pragma once
// A trace as the vector kernel reads it: the streams of all stages merged into steps, each a number of tokens that are alike in every
// stage, in the order in which dates can be computed: a triangle in front of its fragments. Bookkeeping of the simulator, no hardware.

#include <array>
#include <cstdint>
#include <vector>

#include "retiming/timing_trace.h"

namespace bump {

struct TokenStep {
  enum class Kind : std::uint8_t {
    triangle,   ///< enters the vertex processor and is set up
    dropped,    ///< a triangle without fragments, in the rasterizer
    fragments,  ///< from the rasterizer to the end
  };
  struct Work {
    std::int32_t interval = 1, lead = 0;
  };
  Kind kind = Kind::fragments;
  bool releases = false;     ///< each of these tokens is the last of its triangle
  std::uint16_t misses = 0;  ///< texture
  std::uint16_t light_misses = 0;
  std::uint32_t count = 1;
  Work first;   ///< vertex processor, or rasterizer
  Work second;  ///< triangle setup, or texture fetch
  Work third;   ///< light-map fetch
};

struct TokenProgram {
  std::vector<TokenStep> steps;
  bool complete = false;  ///< the steps are there
  std::int64_t triangles = 0, fragments = 0, raster_tokens = 0;
  std::array<std::int64_t, traced::count> busy{};  ///< sum of the intervals of a stream; of light maps as recorded, without their address
  std::array<Cycle, traced::count> last_interval{};
  std::int64_t requests = 0, light_requests = 0;
  /// The most that one token can add to any date by what is recorded, apart from misses; and its misses.
  std::int64_t most_work = 0, most_misses = 0;
};

/// check_trace() holds. Intervals and leads of 2^24 and more are not for the kernel: `complete` then says so.
TokenProgram make_token_program(const TimingTrace& trace);

}  // namespace bump
