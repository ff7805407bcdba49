#include "system/pipeline_timing.h"

#include <algorithm>

namespace bump {

namespace {

constexpr std::array<const char*, stage::count> names = {"vertex_processor", "triangle_setup", "rasterizer",
                                                         "interpolators",    "texture_fetch",  "environment",
                                                         "light_map_fetch",  "illumination",   "frame_sink"};

std::string fifo_name(int from, int to) {
  return std::string(stage_name(from)) + "_to_" + stage_name(to);
}

void declare_fifo(Parameters& p, int from, int to) {
  p.integer("fifos." + fifo_name(from, to), 0, 0, 1 << 20, "tokens", "slots of this FIFO; 0 means fifos.depth").timing_only = true;
}

/// A unit that runs its netlist `passes` times, one execution after another.
Cycle serial_latency(const Schedule& schedule, int passes) {
  return schedule.unit_latency() + Cycle{passes - 1} * schedule.initiation_interval;
}

/// The port whose parameters begin with `name`; `address_latency` cycles pass before the look-up that asks it.
MemorySpec memory_port(const std::string& name, Cycle address_latency, const Configuration& c) {
  MemorySpec memory;
  memory.name = name;
  memory.tag_latency = address_latency + c.integer(name + ".tag_latency");
  memory.latency = c.integer(name + ".latency");
  memory.cycles_per_line = c.integer(name + ".cycles_per_line");
  memory.outstanding = static_cast<int>(c.integer(name + ".outstanding"));
  return memory;
}

}  // namespace

OperatorLatencies operator_latencies(const Configuration& c) {
  OperatorLatencies latencies;
  latencies.adder = static_cast<int>(c.integer("datapath.latency.adder"));
  latencies.multiplier = static_cast<int>(c.integer("datapath.latency.multiplier"));
  latencies.table = static_cast<int>(c.integer("datapath.latency.table"));
  latencies.clamp = static_cast<int>(c.integer("datapath.latency.clamp"));
  latencies.shifter = static_cast<int>(c.integer("datapath.latency.shifter"));
  latencies.divider_bits_per_cycle = static_cast<int>(c.integer("datapath.latency.divider_bits_per_cycle"));
  latencies.square_root_bits_per_cycle = static_cast<int>(c.integer("datapath.latency.square_root_bits_per_cycle"));
  return latencies;
}

const char* stage_name(int index) {
  return names[static_cast<std::size_t>(index)];
}

void declare_pipeline_parameters(Parameters& p) {
  p.choice("numeric", "fixed", {"fixed", "double"}, "arithmetic of the per-pixel datapaths: bit-accurate fixed point, or double precision");
  p.number("clock.megahertz", 100, 0.001, 100000, "MHz", "clock of the whole pipeline; only turns cycles into frames per second")
      .timing_only = true;
  p.integer("fifos.depth", 4, 1, 1 << 20, "tokens", "slots of every FIFO whose own depth is 0").timing_only = true;
  for (int from = 0; from + 1 < stage::count; ++from) declare_fifo(p, from, from + 1);
  declare_fifo(p, stage::environment, stage::illumination);  // without light maps
  p.integer("datapath.latency.adder", 1, 0, 64, "cycles", "an addition or subtraction").timing_only = true;
  p.integer("datapath.latency.multiplier", 1, 0, 64, "cycles", "a multiplication").timing_only = true;
  p.integer("datapath.latency.table", 1, 0, 64, "cycles", "a table read").timing_only = true;
  p.integer("datapath.latency.clamp", 1, 0, 64, "cycles", "a saturation").timing_only = true;
  p.integer("datapath.latency.shifter", 1, 0, 64, "cycles", "a barrel shift").timing_only = true;
  p.integer("datapath.latency.divider_bits_per_cycle", 1, 1, 64, "bits", "quotient bits that a divider resolves each cycle").timing_only =
      true;
  p.integer("datapath.latency.square_root_bits_per_cycle", 1, 1, 64, "bits", "root bits that a square rooter resolves each cycle")
      .timing_only = true;
  for (const char* unit : {"conversion", "environment", "illumination"})
    p.integer(std::string(unit) + ".multipliers", 0, 0, 4096, "multipliers", "built and time-shared; 0 builds one for every product")
        .timing_only = true;
  for (int i = 0; i < stage::count; ++i) {
    if (i == stage::texture_fetch || i == stage::light_map_fetch) continue;  // they declare their own: waiting for memory takes more
    p.integer(std::string(names[i]) + ".capacity", 0, 0, 1 << 20, "tokens", "tokens in flight; 0 means latency + 1, enough for one a cycle")
        .timing_only = true;
  }
  p.integer("frame_sink.latency", 1, 1, 1024, "cycles", "write of a pixel").timing_only = true;
}

DatapathSchedules make_schedules(const Design& design, const Netlist& colour, const Configuration& c) {
  const OperatorLatencies latencies = operator_latencies(c);
  DatapathSchedules schedules;
  if (design.conversion)
    schedules.conversion = schedule(*design.conversion, latencies, static_cast<int>(c.integer("conversion.multipliers")));
  schedules.environment = schedule(design.environment, latencies, static_cast<int>(c.integer("environment.multipliers")));
  if (design.light_maps)
    schedules.light_map_address =
        schedule(design.light_maps->address, latencies, static_cast<int>(c.integer("light_map_fetch.multipliers")));
  schedules.illumination = schedule(design.illumination, latencies, static_cast<int>(c.integer("illumination.multipliers")));
  schedules.colour = schedule(colour, latencies);
  return schedules;
}

PipelineTiming make_pipeline_timing(const DatapathSchedules& s, int passes, const Configuration& c) {
  PipelineTiming timing;
  timing.schedules = s;
  timing.interval.fill(1);
  const auto serial_interval = [&](const Schedule& one) { return static_cast<std::uint32_t>(passes * one.initiation_interval); };
  const bool converts = !s.conversion.start.empty(), has_light_maps = !s.light_map_address.start.empty();
  if (converts) timing.interval[stage::interpolators] = serial_interval(s.conversion);
  timing.interval[stage::environment] = serial_interval(s.environment);
  timing.interval[stage::light_map_fetch] = serial_interval(s.light_map_address);
  timing.interval[stage::illumination] =
      std::max(serial_interval(s.illumination), static_cast<std::uint32_t>(s.colour.initiation_interval));

  std::array<Cycle, stage::count> latency{};
  latency[stage::vertex_processor] = c.integer("vertex_processor.latency");
  latency[stage::triangle_setup] = c.integer("triangle_setup.latency");
  latency[stage::rasterizer] = c.integer("rasterizer.latency");
  latency[stage::interpolators] = c.integer("interpolators.latency") + (converts ? serial_latency(s.conversion, passes) : 0);
  latency[stage::texture_fetch] = c.integer("texture_fetch.latency");
  latency[stage::environment] = serial_latency(s.environment, passes);
  latency[stage::light_map_fetch] = s.light_map_address.unit_latency() + c.integer("light_map_fetch.latency");
  latency[stage::illumination] = serial_latency(s.illumination, passes) + s.colour.latency;
  latency[stage::frame_sink] = c.integer("frame_sink.latency");

  timing.graph.memories.push_back(memory_port("memory", 0, c));
  if (has_light_maps) timing.graph.memories.push_back(memory_port("light_memory", s.light_map_address.unit_latency(), c));

  int before = -1;
  for (int i = 0; i < stage::count; ++i) {
    timing.place[i] = -1;
    if (i == stage::light_map_fetch && !has_light_maps) continue;
    timing.place[i] = static_cast<int>(timing.graph.stages.size());
    StageSpec spec;
    spec.name = stage_name(i);
    spec.latency = std::max<Cycle>(1, latency[i]);
    const std::int64_t capacity = c.integer(spec.name + ".capacity");
    spec.capacity = capacity > 0 ? capacity : spec.latency + 1;
    if (i == stage::texture_fetch) {
      spec.batch = static_cast<int>(c.integer("texture_fetch.batch"));
      spec.memory = 0;
    }
    if (i == stage::light_map_fetch) spec.memory = 1;
    timing.graph.stages.push_back(spec);
    if (before >= 0) {
      const std::string name = fifo_name(before, i);
      const std::int64_t own = c.integer("fifos." + name);
      timing.graph.fifos.push_back({name, timing.place[before], timing.place[i], own > 0 ? own : c.integer("fifos.depth")});
    }
    before = i;
  }
  timing.graph.validate();
  return timing;
}

}  // namespace bump
