// Dating again under other caches says what a run with those caches says: cycles, statistics, hits, misses, bytes.

#include <catch2/catch.hpp>

#include "retime_bench.h"
#include "testbench/experiments/retime.h"

using namespace bump;
using namespace bump::test;

namespace {

/// Textures of different sizes, repeated and clamped, some without levels, much smaller and larger than their pixels.
Scene fetch_scene() {
  Scene scene = retime_scene();
  SceneObject& sphere = scene.objects[0];
  auto colour = samples::texture(64, 16, 3, 3);
  colour->wrap_u = WrapMode::clamp;
  sphere.colour = colour;
  auto normals = samples::normals(256, 128, 4);
  normals->wrap_v = WrapMode::clamp;
  sphere.normals = normals;
  auto single = samples::texture(5, 7, 3, 9);
  single->levels.resize(1);
  scene.objects.push_back(samples::object(samples::plane(2), glm::translate(glm::dmat4(1), glm::dvec3(-0.5, 0, 0.3))));
  scene.objects.back().colour = single;
  return scene;
}

std::string text_of(const FetchTraffic& traffic) {
  const TextureCounters& t = traffic.texture;
  std::string text;
  for (const std::int64_t number : {t.reads, t.accesses, t.hits, t.misses, t.bytes}) text += " " + std::to_string(number);
  for (const LightMapCounters& m : traffic.light_maps)
    for (const std::int64_t number : {m.reads, m.hits, m.misses, m.bytes}) text += " " + std::to_string(number);
  return text;
}

FetchTraffic traffic_of(const SimulationResult& result) {
  FetchTraffic traffic{result.texture, {}};
  for (const LightMapUse& map : result.light_maps) traffic.light_maps.push_back(map.counters);
  return traffic;
}

/// The trace with addresses, or what the run says.
ChildTask run_of(const std::string& scheme, const Configuration& configuration, bool recorded, Engine engine = Engine::dated) {
  return {scheme, [=](const ReportShare&) {
            const Scene scene = fetch_scene();
            TraceRecorder recorder;
            SimulationOptions options;
            options.measure = false;
            options.engine = engine;
            options.record = [&recorder](const TimingRecords& records) { recorder.add(records); };
            if (recorded) options.accesses = &recorder.accesses();
            const SimulationResult result = simulate(scene, find_scheme(scheme), configuration, options);
            if (recorded) return encode_trace(recorder.finish(scene, find_scheme(scheme), configuration, result.timing.cycles));
            return test::text_of(result.timing, result.bound) + text_of(traffic_of(result));
          }};
}

Settings random_caches(std::mt19937_64& random) {
  Settings settings;
  const auto set = [&](const std::string& key, std::uint64_t value) { settings.values.emplace_back(key, std::to_string(value)); };
  for (const std::string unit : {"texture_fetch", "light_map_fetch"}) {
    set(unit + ".cache.sets", std::uint64_t{1} << random() % 7);
    set(unit + ".cache.ways", 1 + random() % 9);
    set(unit + ".cache.line_bytes", std::uint64_t{unit == "texture_fetch" ? 1U : 4U} << random() % 9);
  }
  set("texture_fetch.footprints_per_cycle", 1 + random() % 4);
  set("light_map_fetch.reads_per_cycle", 1 + random() % 3);
  return settings;
}

TimingTrace recorded(const std::string& scheme, const Settings& settings = {}) {
  const Configuration configuration = settings.applied_to(Configuration(all_parameters()));
  return decode_trace(outcomes_of({run_of(scheme, configuration, true)}).front(), "test.trace");
}

const Settings small_light_maps{{{"kugler1998.light_map_bits", "11"}}};

}  // namespace

TEST_CASE("a trace with addresses that is dated under other caches says what a run with them says") {
  std::mt19937_64 random(1998);
  std::size_t number = 0;
  for (const Scheme* scheme : all_schemes()) {
    const std::string& id = scheme->page().id;
    INFO(id);
    Settings values = id == "kugler1998" ? small_light_maps : Settings{};
    const std::string filters[] = {"nearest", "bilinear", "trilinear"};
    values.values.emplace_back("texture_fetch.filter", filters[number++ % 3]);
    if (random() % 2 == 0) values.values.emplace_back("numeric", "double");
    if (random() % 2 == 0) values.values.emplace_back("rasterizer.order", "tiled");
    const Configuration base = values.applied_to(random_caches(random).applied_to(Configuration(all_parameters())));
    std::vector<Configuration> configurations{base};
    for (int i = 0; i < 4; ++i)
      configurations.push_back(random_timing_settings(random, base.parameters(), false).applied_to(random_caches(random).applied_to(base)));
    std::vector<ChildTask> tasks{run_of(id, base, true)};
    for (const Configuration& configuration : configurations) tasks.push_back(run_of(id, configuration, false));
    const std::vector<std::string> said = outcomes_of(tasks);
    Retimer retimer(decode_trace(said[0], "test"), all_parameters(), "test");
    for (std::size_t i = 0; i < configurations.size(); ++i) {
      CHECK_NOTHROW(retimer.check(configurations[i]));
      const RetimedRun run = retimer.retime(configurations[i]);
      REQUIRE(run.traffic.has_value());
      CHECK(test::text_of(run.timing, run.bound) + text_of(*run.traffic) == said[i + 1]);
    }
  }
}

TEST_CASE("addresses are the same for any cache, engine and memory") {
  std::mt19937_64 random(3);
  const Configuration base =
      Settings{{{"kugler1998.light_map_bits", "11"}, {"texture_fetch.filter", "trilinear"}}}.applied_to(Configuration(all_parameters()));
  std::vector<ChildTask> tasks{run_of("kugler1998", base, true), run_of("kugler1998", base, true, Engine::stepped)};
  for (int i = 0; i < 3; ++i) tasks.push_back(run_of("kugler1998", random_caches(random).applied_to(base), true));
  const std::vector<std::string> traces = outcomes_of(tasks);
  CHECK((traces[0] == traces[1]));
  const TimingTrace first = decode_trace(traces[0], "test");
  REQUIRE(first.has_addresses());
  for (const std::string& bytes : traces) {
    const TimingTrace other = decode_trace(bytes, "test");
    CHECK((other.accesses.texels.bytes == first.accesses.texels.bytes));
    CHECK((other.accesses.words.bytes == first.accesses.words.bytes));
  }
}

TEST_CASE("addresses survive the file, and a damaged file does not") {
  const TimingTrace trace = recorded("kugler1998", small_light_maps);
  const std::string bytes = encode_trace(trace);
  CHECK((encode_trace(decode_trace(bytes, "test")) == bytes));
  TimingTrace other = trace;
  SECTION("a fragment without addresses") {
    --other.accesses.texels.fragments;
  }
  SECTION("words without a fragment") {
    other.accesses.words.fragments = 0;
    other.accesses.words.bytes.clear();
  }
  SECTION("a texture too few") {
    other.accesses.textures.pop_back();
  }
  SECTION("a texture too small") {
    for (TextureLevel& level : other.accesses.textures.front().levels) level.width = level.height = 1;
  }
  SECTION("a texel of no bytes") {
    other.accesses.textures.front().bytes_per_texel = 0;
  }
  CHECK_THROWS_WITH(decode_trace(encode_trace(other), "some.trace"), Catch::Contains("damaged"));
}

TEST_CASE("a sweep over caches has the rows of its points, with and without vectors, for any number of threads") {
  for (const std::string id : {"peercy1997", "kugler1998"}) {
    INFO(id);
    Retimer retimer(recorded(id, id == "kugler1998" ? small_light_maps : Settings{}), all_parameters(), "test");
    const SweepGrid grid({"fifos.depth=1,9", "texture_fetch.cache.sets=1,4,32", "texture_fetch.cache.line_bytes=8,64",
                          "light_map_fetch.cache.ways=1,4", "memory.latency=1,40,99", "texture_fetch.batch=1,2"},
                         retimer.recorded().parameters());
    REQUIRE(sweeps_caches(retimer, retimer.recorded(), grid) == true);
    SweepOptions options;
    options.jobs = 1;
    const std::vector<SweepRow> rows = sweep(retimer, retimer.recorded(), grid, options);
    options.jobs = 3;
    double share = 0;
    options.progress = [&share](double now) { share = now; };
    const std::vector<SweepRow> with_threads = sweep(retimer, retimer.recorded(), grid, options);
    options.vectors = false;
    const std::vector<SweepRow> one_by_one = sweep(retimer, retimer.recorded(), grid, options);
    CHECK(share <= 1);
    REQUIRE(rows.size() == grid.points());
    const auto said = [](const SweepRow& row) {
      REQUIRE(row.traffic.has_value());
      if (row.error) return row.error->what() + text_of(*row.traffic);
      TimingResult timing;
      timing.cycles = row.cycles;
      timing.stages = row.stages;
      return test::text_of(timing, row.bound) + text_of(*row.traffic);
    };
    std::size_t deadlocks = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      INFO("point " << i);
      CHECK(said(rows[i]) == said(with_threads[i]));
      CHECK(said(rows[i]) == said(one_by_one[i]));
      deadlocks += rows[i].error ? 1U : 0U;
      if (i % 7 != 0 || rows[i].error) continue;
      Configuration point = retimer.recorded();
      grid.apply(i, point);
      const RetimedRun run = retimer.retime(point);
      CHECK(run.timing.cycles == rows[i].cycles);
      CHECK(run.timing.stages == rows[i].stages);
      CHECK(text_of(*run.traffic) == text_of(*rows[i].traffic));
    }
    CHECK(deadlocks == grid.points() / 4);  // depth 1 with batch 2
  }
}

TEST_CASE("a sweep over time alone has no traffic, whatever was recorded") {
  Retimer retimer(recorded("phong1975"), all_parameters(), "test");
  const SweepGrid grid({"memory.latency=1,40"}, retimer.recorded().parameters());
  CHECK_FALSE(sweeps_caches(retimer, retimer.recorded(), grid));
  for (const SweepRow& row : sweep(retimer, retimer.recorded(), grid, {})) CHECK_FALSE(row.traffic.has_value());
}

TEST_CASE("a sweep over caches that is interrupted says so") {
  Retimer retimer(recorded("phong1975"), all_parameters(), "test");
  const SweepGrid grid({"texture_fetch.cache.sets=1,2,4"}, retimer.recorded().parameters());
  const std::atomic<bool> cancelled{true};
  SweepOptions options;
  options.cancelled = &cancelled;
  CHECK_THROWS_WITH(sweep(retimer, retimer.recorded(), grid, options), Catch::Contains("interrupted"));
}

TEST_CASE("without addresses other caches are refused, and it is said how to record them") {
  const Retimer bare(record("kugler1998", small_light_maps), all_parameters(), "test");
  const Retimer full(recorded("kugler1998", small_light_maps), all_parameters(), "test");
  for (const std::string key : {"texture_fetch.cache.sets", "texture_fetch.cache.ways", "texture_fetch.cache.line_bytes",
                                "texture_fetch.footprints_per_cycle", "light_map_fetch.cache.sets", "light_map_fetch.cache.ways",
                                "light_map_fetch.cache.line_bytes", "light_map_fetch.reads_per_cycle"}) {
    INFO(key);
    CHECK(bare.is_fetch_key(key));
    Configuration other = bare.recorded();
    other.set(key, std::int64_t{8}, {"test", 0, 0});
    CHECK_THROWS_WITH(bare.check(other), Catch::Contains(key) && Catch::Contains("--addresses"));
    CHECK_NOTHROW(full.check(other));
  }
  Configuration other = full.recorded();
  other.set("texture_fetch.filter", std::string("nearest"), {"test", 0, 0});
  CHECK_THROWS_WITH(full.check(other), Catch::Contains("texture_fetch.filter") && Catch::Contains("record again"));
}

TEST_CASE("caches that cannot be built are refused as a run refuses them") {
  const Retimer retimer(recorded("kugler1998", small_light_maps), all_parameters(), "test");
  const auto refusal = [&](const std::string& key, std::int64_t value) {
    Configuration other = retimer.recorded();
    other.set(key, value, {"test", 0, 0});
    try {
      retimer.check(other);
      return std::string();
    } catch (const Error& error) {
      CHECK(error.kind() == ErrorKind::input);
      return std::string(error.what());
    }
  };
  CHECK_THAT(refusal("texture_fetch.cache.sets", 3), Catch::Contains("power of two"));
  CHECK_THAT(refusal("texture_fetch.cache.line_bytes", 48), Catch::Contains("power of two"));
  CHECK_THAT(refusal("light_map_fetch.cache.sets", 5), Catch::Contains("light-map cache"));
  CHECK_THAT(refusal("texture_fetch.cache.line_bytes", 1), Catch::Equals(""));
}

TEST_CASE("light-map caches of a scheme without light maps may be anything, as in a run") {
  Retimer retimer(record("phong1975"), all_parameters(), "test");
  Configuration other = retimer.recorded();
  other.set("light_map_fetch.cache.sets", std::int64_t{3}, {"test", 0, 0});
  CHECK_NOTHROW(retimer.check(other));
  CHECK_FALSE(retimer.fetches_anew(other));
  CHECK(retimer.retime(other).timing.cycles == retimer.trace().cycles);
}

TEST_CASE("addresses that do not give the recorded hits fail the self-check") {
  TimingTrace trace = recorded("phong1975");
  std::swap(trace.streams[traced::texture].kinds.front().misses, trace.streams[traced::texture].kinds.back().misses);
  Retimer retimer(trace, all_parameters(), "test");
  try {
    retimer.retime(retimer.recorded());
    FAIL("no error");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::self_check);
  }
}
