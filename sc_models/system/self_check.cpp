#include "system/self_check.h"

#include "system/pipeline_timing.h"

namespace bump {

namespace {

void require_equal(std::int64_t a, std::int64_t b, const std::string& what) {
  if (a == b) return;
  throw Error(ErrorKind::self_check,
              {"self-check failed: " + what, {}, std::to_string(a) + " is not " + std::to_string(b), "report this with the command that led to it"});
}

void require(bool holds, const std::string& what) { require_equal(holds ? 1 : 0, 1, what); }

void check_light_maps(const SimulationResult& r) {
  std::int64_t misses = 0;
  for (const LightMapUse& map : r.light_maps) {
    require_equal(map.counters.reads, r.geometry.fragments, "reads of light map " + map.name + " = fragments");
    require_equal(map.counters.hits + map.counters.misses, map.counters.reads, "hits + misses of light map " + map.name + " = reads");
    misses += map.counters.misses;
  }
  if (!r.light_maps.empty())
    require_equal(r.timing.memories.size() > 1 ? r.timing.memories[1].requests : -1, misses, "requests for light maps = misses");
}

}  // namespace

void check_conservation(const SimulationResult& r, const TimingGraph& graph, const std::vector<Cycle>& last_interval) {
  const GeometryCounters& g = r.geometry;
  const TimingResult& t = r.timing;
  require_equal(g.triangles, g.triangles_culled + g.triangles_empty + g.triangles_hidden + g.triangles_drawn, "triangles = culled + empty + hidden + drawn");
  require_equal(g.fragments_generated, g.fragments_hidden + g.fragments, "covered positions = hidden + shaded");
  require_equal(g.fragments, g.fragments_retired, "fragments shaded = fragments retired");
  require_equal(t.stages[stage::vertex_processor].tokens, g.triangles, "triangle tokens = triangles that entered");
  require_equal(t.stages[stage::triangle_setup].tokens, g.triangles, "triangles set up = triangles that entered");
  for (std::size_t i = stage::interpolators; i < t.stages.size(); ++i)  // all stages from there on, whichever the design has
    require_equal(t.stages[i].tokens, g.fragments, "tokens of " + t.stages[i].name + " = fragments");
  for (std::size_t i = 0; i < t.stages.size(); ++i) {
    const StageStatistics& s = t.stages[i];
    require(s.busy - last_interval[i] + s.starved + s.blocked_room <= t.cycles, "cycles of " + s.name + " fit into the run");
  }
  for (std::size_t i = 0; i < t.fifos.size(); ++i) {
    const FifoStatistics& fifo = t.fifos[i];
    require_equal(fifo.items, graph.fifos[i].to <= stage::rasterizer ? g.triangles : g.fragments, "items through " + fifo.name);
    require(fifo.max_occupancy <= fifo.depth, fifo.name + " never holds more than its depth");
    require(fifo.full_cycles + fifo.empty_cycles <= t.cycles, fifo.name + " is full and empty in different cycles");
  }
  require_equal(r.texture.hits + r.texture.misses, r.texture.accesses, "cache hits + misses = look-ups");
  require_equal(t.memories.front().requests, r.texture.misses, "memory requests = cache misses");
  check_light_maps(r);
  require(r.bound.cycles <= static_cast<double>(t.cycles), "cycles reach the closed-form bound");
}

}  // namespace bump
