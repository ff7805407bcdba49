// Dating traces again: bytes a fragment, and fragments times configurations a second on one core, one configuration at a time by the
// timeline and eight at once by the vector kernel. Of traces with addresses also what the caches cost: fragments times caches a second, and
// the same for caches of light maps. One JSON document on stdout.
//   bench_retime TRACE... [--rounds N]

#include <chrono>
#include <cstring>
#include <nlohmann/json.hpp>
#include <systemc>

#include "datapath/invariant.h"
#include "retiming/lane_dates.h"
#include "retiming/trace_file.h"
#include "testbench/bench/help_option.h"
#include "testbench/bench/interleaved.h"
#include "testbench/experiments/retime.h"
#include "testbench/scene/input_files.h"

namespace {

using namespace bump;
using Json = nlohmann::ordered_json;

double seconds_of(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Eight configurations that agree in depths and capacities, or of which no two do.
std::vector<PipelineTiming> machines(Retimer& retimer, bool alike) {
  std::vector<PipelineTiming> timings;
  for (int i = 0; i < static_cast<int>(LaneDates::width); ++i) {
    Configuration configuration = retimer.recorded();
    const auto set = [&](const char* key, std::int64_t value) { configuration.set(key, value, {"bench", 0, 0}); };
    set("memory.latency", 20 + 10 * i);
    if (!alike) {
      set("fifos.depth", 2 + 3 * i);
      set("texture_fetch.capacity", 16 + 8 * i);
      set("datapath.latency.adder", 1 + i);
      set("memory.outstanding", 1 + i);
    }
    timings.push_back(retimer.timing_of(configuration));
  }
  return timings;
}

/// Texture caches of one size of line, from 1 to 128 sets.
std::vector<TextureFetchConfig> texture_caches(const Retimer& retimer, std::size_t count) {
  std::vector<TextureFetchConfig> units(count, retimer.fetch_settings(retimer.recorded()).texture);
  for (std::size_t i = 0; i < count; ++i) units[i].cache.sets = count == 1 ? 32 : 1 << i;
  return units;
}

/// How many fragments a second go through caches, times the number of caches.
Json measure_caches(const Retimer& retimer, int rounds) {
  const RecordedAccesses& accesses = retimer.trace().accesses;
  std::vector<bench::Variant> variants;
  std::vector<double> caches;
  for (const std::size_t count : {std::size_t{1}, std::size_t{8}}) {
    const std::vector<TextureFetchConfig> units = texture_caches(retimer, count);
    variants.push_back({count == 1 ? "texture cache" : "texture caches, eight at once",
                        [&accesses, units] { return seconds_of([&] { fetch_texels(accesses, units, nullptr); }); }});
    caches.push_back(static_cast<double>(count));
  }
  if (const LightMaps* maps = retimer.light_maps()) {
    const LightMapFetchConfig unit = retimer.fetch_settings(retimer.recorded()).light_maps;
    variants.push_back(
        {"light-map cache", [&accesses, maps, unit] { return seconds_of([&] { fetch_words(accesses, *maps, {unit}, nullptr); }); }});
    caches.push_back(1);
  }
  const bench::Interleaved taken = bench::interleaved(variants, rounds);
  Json json;
  for (std::size_t i = 0; i < variants.size(); ++i)
    json[variants[i].name] = static_cast<double>(retimer.trace().fragments()) * caches[i] / taken.of(i) / 1e6;
  return json;
}

Json measure(const std::string& path, int rounds) {
  const std::string bytes = read_bytes(path, "timing trace");
  Retimer retimer(decode_trace(bytes, path), all_parameters(), path);
  const TimingTrace& trace = retimer.trace();
  const TokenProgram program = make_token_program(trace);
  std::vector<bench::Variant> variants;
  for (const bool alike : {true, false}) {
    const std::string suffix = alike ? ", depths alike" : ", all depths different";
    const std::vector<PipelineTiming> timings = machines(retimer, alike);
    variants.push_back({"timeline" + suffix, [&trace, timings] {
                          return seconds_of([&] {
                            for (const PipelineTiming& timing : timings) replay(trace, timing);
                          });
                        }});
    variants.push_back({"vectors" + suffix, [&program, timings] {
                          std::vector<const PipelineTiming*> pointers;
                          for (const PipelineTiming& timing : timings) pointers.push_back(&timing);
                          return seconds_of([&] {
                            LaneDates lanes(program, pointers);
                            BUMP_ASSERT(lanes.run(nullptr));
                          });
                        }});
  }
  const bench::Interleaved taken = bench::interleaved(variants, rounds);
  Json json = {{"scene", trace.scene}, {"scheme", trace.scheme}, {"fragments", trace.fragments()}, {"triangles", trace.triangles()}};
  TimingTrace bare = trace;
  bare.accesses = {};
  const std::size_t bare_bytes = encode_trace(bare).size();
  const auto per_fragment = [&trace](std::size_t size) {
    return static_cast<double>(size) / static_cast<double>(std::max<std::int64_t>(1, trace.fragments()));
  };
  json["bytes"] = bare_bytes;
  json["bytes_per_fragment"] = per_fragment(bare_bytes);
  if (trace.has_addresses()) json["bytes_per_fragment_with_addresses"] = per_fragment(bytes.size());
  const double work = static_cast<double>(trace.fragments()) * static_cast<double>(LaneDates::width);
  for (std::size_t i = 0; i < variants.size(); ++i)
    json["million_fragment_configurations_per_s"][variants[i].name] = work / taken.of(i) / 1e6;
  if (trace.has_addresses()) json["million_fragment_caches_per_s"] = measure_caches(retimer, rounds);
  return json;
}

}  // namespace

int sc_main(int argc, char* argv[]) {
  if (bench::gave_help(argc, argv, "fragments times configurations a second of dating traces again", "bench_retime TRACE... [--rounds N]")) return 0;
  try {
    int rounds = 9;
    Json all = Json::array();
    std::vector<std::string> paths;
    for (int i = 1; i < argc; ++i) {
      if (std::strcmp(argv[i], "--rounds") == 0 && i + 1 < argc)
        rounds = std::max(1, std::atoi(argv[++i]));
      else
        paths.emplace_back(argv[i]);
    }
    for (const std::string& path : paths) all.push_back(measure(path, rounds));
    fmt::print("{}\n", all.dump(2));
    return 0;
  } catch (const Error& error) {
    fmt::print(stderr, "bench_retime: {}\n", error.what());
    return static_cast<int>(error.kind());
  }
}
