// Light maps in the pipeline: the stage that only some designs have, its memory port, both engines, and what a run reports.

#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <random>
#include <set>
#include <sstream>

#include "channels/timeline.h"
#include "system/bound.h"
#include "system/pipeline_timing.h"
#include "system/simulation.h"
#include "testbench/tests/units/light_map_sample.h"
#include "units/colour_unit.h"

using namespace bump;

namespace {

/// Known to this test only.
class MappedScheme : public Scheme {
 public:
  /// Maps of 2^bits rows and columns.
  explicit MappedScheme(int bits = 10) : bits_(bits) {}
  const SchemePage& page() const override { return page_; }
  void declare(Parameters&) const override {}
  Design design(const Configuration&, const Material&) const override {
    Design design = samples::light_map_design(bits_);
    design.quantisation_floor_db = 40;
    return design;
  }

 private:
  int bits_;
  SchemePage page_{"mapped", "Light maps", "", "", "", {}};
};

Configuration configured(const std::vector<std::pair<std::string, std::int64_t>>& settings) {
  Configuration configuration(all_parameters());
  for (const auto& [key, value] : settings) configuration.set(key, value, {"test", 0, 0});
  return configuration;
}

PipelineTiming plan(const Design& design, const Configuration& configuration, int passes) {
  const Scene scene = samples::light_map_scene();
  const Netlist colour = colour_netlist(scene, Material{}, ColourUnitConfig(configuration), LightSum::in_light_maps);
  return make_pipeline_timing(make_schedules(design, colour, configuration), passes, configuration);
}

std::string text_of(const SimulationResult& r) {
  std::ostringstream text;
  text.precision(17);
  text << r.timing.cycles << ' ' << r.bound.cycles << ' ' << r.bound.by << '\n';
  for (const StageStatistics& s : r.timing.stages)
    text << s.name << ' ' << s.tokens << ' ' << s.busy << ' ' << s.starved << ' ' << s.blocked_room << ' ' << s.blocked_output << ' '
         << s.last_delivery << '\n';
  for (const FifoStatistics& f : r.timing.fifos)
    text << f.name << ' ' << f.depth << ' ' << f.items << ' ' << f.max_occupancy << ' ' << f.full_cycles << ' ' << f.empty_cycles << '\n';
  for (const MemoryStatistics& m : r.timing.memories) text << m.name << ' ' << m.requests << ' ' << m.busy << '\n';
  for (const LightMapUse& m : r.light_maps) text << m.name << ' ' << m.counters.hits << ' ' << m.counters.misses << '\n';
  double sum = 0;
  for (const double value : r.hardware.colour) sum += value;
  text << sum << '\n';
  return text.str();
}

/// Simulates in a process of its own, since SystemC elaborates once in each.
std::string simulated(const Configuration& configuration, Engine engine) {
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    ::close(ends[0]);
    std::string text;
    try {
      SimulationOptions options;
      options.engine = engine;
      options.measure = false;
      text = text_of(simulate(samples::light_map_scene(40, 30), MappedScheme(7), configuration, options));
    } catch (const std::exception& error) {
      text = std::string("error: ") + error.what();
    }
    const bool written = ::write(ends[1], text.data(), text.size()) == static_cast<ssize_t>(text.size());
    ::_exit(written ? 0 : 1);
  }
  ::close(ends[1]);
  std::string text;
  char buffer[4096];
  for (ssize_t got = 0; (got = ::read(ends[0], buffer, sizeof buffer)) > 0;) text.append(buffer, static_cast<std::size_t>(got));
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  CHECK(status == 0);
  return text;
}

const UnitCost& unit(const SimulationResult& result, const std::string& name) {
  for (const UnitCost& cost : result.units)
    if (cost.name == name) return cost;
  FAIL("no unit " << name);
  return result.units.front();
}

}  // namespace

TEST_CASE("only designs with light maps have the stage that fetches them") {
  const Configuration configuration = configured({{"fifos.environment_to_light_map_fetch", 9}, {"fifos.environment_to_illumination", 7}});
  const PipelineTiming with = plan(samples::light_map_design(), configuration, 1);
  Design plain = samples::light_map_design();
  plain.light_maps.reset();
  const PipelineTiming without = plan(plain, configuration, 3);

  REQUIRE(with.graph.stages.size() == 9);
  REQUIRE(without.graph.stages.size() == 8);
  CHECK(with.graph.stages[6].name == "light_map_fetch");
  CHECK(with.graph.stages[6].memory == 1);
  CHECK(with.graph.memories[1].name == "light_memory");
  CHECK(with.graph.fifos[5].name == "environment_to_light_map_fetch");
  CHECK(with.graph.fifos[5].depth == 9);
  CHECK(with.graph.fifos[6].name == "light_map_fetch_to_illumination");
  CHECK(with.at(stage::illumination).name == "illumination");
  CHECK(without.at(stage::illumination).name == "illumination");
  CHECK(without.place[stage::light_map_fetch] == -1);
  CHECK(without.graph.memories.size() == 1);
  CHECK(without.graph.fifos[5].name == "environment_to_illumination");
  CHECK(without.graph.fifos[5].depth == 7);
  for (const FifoSpec& fifo : with.graph.fifos) CHECK(fifo.to == fifo.from + 1);
}

TEST_CASE("a request for a light map leaves when its address is known") {
  const Design design = samples::light_map_design();
  for (const int multipliers : {0, 1}) {
    const Configuration configuration = configured({{"light_map_fetch.multipliers", multipliers},
                                                    {"light_map_fetch.latency", 5},
                                                    {"light_memory.tag_latency", 3},
                                                    {"datapath.latency.multiplier", 4}});
    const PipelineTiming timing = plan(design, configuration, 1);
    const Schedule& address = timing.schedules.light_map_address;
    CHECK(address.latency > 4);
    CHECK(timing.at(stage::light_map_fetch).latency == address.unit_latency() + 5);
    CHECK(timing.graph.memories[1].tag_latency == address.unit_latency() + 3);
    CHECK(timing.graph.memories[0].tag_latency == 1);
    CHECK(timing.interval[stage::light_map_fetch] == (multipliers == 1 ? 2 : 1));
  }
}

TEST_CASE("both engines agree on every cycle and statistic of pipelines with light maps") {
  std::mt19937 random(1998);
  const auto between = [&](int low, int high) {
    return static_cast<std::int64_t>(low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1)));
  };
  std::set<std::string> seen;
  for (int i = 0; i < 14; ++i) {
    const Configuration configuration = configured({{"fifos.depth", between(1, 5)},
                                                    {"fifos.environment_to_light_map_fetch", between(0, 3)},
                                                    {"fifos.light_map_fetch_to_illumination", between(0, 3)},
                                                    {"light_map_fetch.capacity", between(1, 30)},
                                                    {"light_map_fetch.latency", between(1, 9)},
                                                    {"light_map_fetch.multipliers", between(0, 1)},
                                                    {"light_map_fetch.reads_per_cycle", between(1, 2)},
                                                    {"light_map_fetch.cache.sets", 1 << between(0, 5)},
                                                    {"light_map_fetch.cache.ways", between(1, 4)},
                                                    {"light_map_fetch.cache.line_bytes", 1 << between(3, 7)},
                                                    {"light_memory.tag_latency", between(1, 4)},
                                                    {"light_memory.latency", between(1, 40)},
                                                    {"light_memory.cycles_per_line", between(1, 6)},
                                                    {"light_memory.outstanding", between(1, 6)},
                                                    {"memory.outstanding", between(1, 8)},
                                                    {"illumination.capacity", between(0, 3)}});
    const std::string dated = simulated(configuration, Engine::dated);
    CHECK(dated.find("light_map_fetch") != std::string::npos);
    CHECK(dated == simulated(configuration, Engine::stepped));
    seen.insert(dated.substr(0, dated.find(' ')));
  }
  CHECK(seen.size() > 7);  // the settings do change the cycles
}

TEST_CASE("slow memory of light maps binds, and the bound says so") {
  const std::string wide = simulated(configured({}), Engine::dated);
  CHECK(wide.find("light_memory") != std::string::npos);
  const std::string narrow =
      simulated(configured({{"light_memory.cycles_per_line", 64}, {"light_map_fetch.cache.sets", 1}, {"light_map_fetch.cache.ways", 1}}),
                Engine::dated);
  CHECK_THAT(narrow, Catch::Contains("light_memory: bandwidth"));
}

TEST_CASE("a run counts what fills the light maps, what addresses them, and what was read") {
  const Scene scene = samples::light_map_scene();
  const SimulationResult r = simulate(scene, MappedScheme(), configured({}), {});
  REQUIRE(r.light_maps.size() == 2);
  std::int64_t misses = 0;
  for (const LightMapUse& map : r.light_maps) {
    CHECK(map.entries == 1 << 20);
    CHECK(map.words_written == 2 << 20);
    CHECK(map.bits == 18 * (2 << 20));
    CHECK(map.bytes_written == 4 * (2 << 20));
    CHECK(map.counters.reads == r.fragments);
    CHECK(map.counters.hits + map.counters.misses == r.fragments);
    CHECK(map.counters.bytes == 64 * map.counters.misses);
    misses += map.counters.misses;
  }
  CHECK(r.light_maps[0].name == "diffuse");
  CHECK(r.timing.memories[1].requests == misses);

  // Three lights, but one pass.
  CHECK(unit(r, "environment").executions == r.fragments);
  CHECK(unit(r, "illumination").executions == r.fragments);
  CHECK(unit(r, "light_map_address").executions == r.fragments);
  CHECK(unit(r, "light_map_address").published.maps == 2);
  CHECK(unit(r, "light_map_address").published.multipliers == 2);
  CHECK(unit(r, "light_map_address").published.adders == 4);
  CHECK(unit(r, "light_map_address").pipeline.has_value());
  CHECK(unit(r, "frame").executions == 2 << 20);
  CHECK(unit(r, "frame").lights == 3);
  CHECK(unit(r, "frame").per_light.adders == unit(r, "frame").published.adders + 2);
  CHECK(unit(r, "frame").published.multipliers == 10 + 2);  // times the light's intensity
  CHECK_FALSE(unit(r, "frame").pipeline.has_value());
  CHECK(unit(r, "colour").published.multipliers == 3);

  // Intensities sum to 1.75: the bound that the design states for one light is that much wider, and the colour unit's rounding.
  CHECK(r.quantisation_floor_db < 40 - 20 * std::log10(1.75));
  CHECK(r.quantisation_floor_db > 30);
  double worst = 0;
  for (std::size_t i = 0; i < r.hardware.colour.size(); ++i) worst = std::max(worst, std::fabs(r.hardware.colour[i] - r.exact.colour[i]));
  CHECK(worst > 0);
  CHECK(worst < 0.1);
}

TEST_CASE("waveforms show the FIFOs around the light-map fetch unit") {
  const std::string stem = (std::filesystem::temp_directory_path() / ("bump_light_maps_" + std::to_string(::getpid()))).string();
  SimulationOptions options;
  options.engine = Engine::stepped;
  options.measure = false;
  options.trace = stem;
  simulate(samples::light_map_scene(16, 12), MappedScheme(5), configured({}), options);
  std::ifstream file(stem + ".vcd");
  std::stringstream header;
  for (std::string line; std::getline(file, line) && line.find("$enddefinitions") == std::string::npos;) header << line << '\n';
  std::filesystem::remove(stem + ".vcd");
  CHECK_THAT(header.str(), Catch::Contains("environment_to_light_map_fetch") && Catch::Contains("light_map_fetch_to_illumination"));
}
