// Dates alone, over recorded traces and a long chain: the clocked engine fed with the records (a), the recurrence written by hand as one
// loop (b), and the timeline of the dated engine (c), at several FIFO depths. No value is computed, so these are the costs of the timing
// planes by themselves. Markdown on stdout.
//   bench_dates TRACE... [--rounds N] [--depths 1,4]

#include <chrono>
#include <cstring>
#include <random>
#include <systemc>

#include "channels/stepped_engine.h"
#include "channels/timeline.h"
#include "datapath/invariant.h"
#include "retiming/retimer.h"
#include "retiming/trace_feeder.h"
#include "retiming/trace_file.h"
#include "testbench/bench/help_option.h"
#include "testbench/bench/interleaved.h"
#include "testbench/bench/list_option.h"
#include "testbench/bench/recurrence_by_hand.h"
#include "testbench/scene/input_files.h"

namespace {

using namespace bump;

constexpr int long_chain_stages = 32;
constexpr std::size_t long_chain_tokens = 200'000;

struct Row {
  std::string name, depth;
  Cycle cycles = 0;
  std::int64_t tokens = 0;
  double stepped_s = 0, by_hand_s = 0, timeline_s = 0;  ///< by_hand_s 0: not measured
};

template <class Work>
bench::Variant timed(const std::string& name, Work work) {
  return {name, [work] {
            const auto begin = std::chrono::steady_clock::now();
            work();
            return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
          }};
}

/// Runs the clocked engine to its end; `refill` as SteppedEngine wants it, with the engine.
template <class Refill>
Cycle stepped_cycles(const TimingGraph& graph, Refill refill) {
  SteppedEngine* plane = nullptr;
  SteppedEngine engine("engine", graph, sc_core::sc_time(10, sc_core::SC_NS), [&] { return refill(*plane); });
  plane = &engine;
  sc_core::sc_start();
  return engine.result().cycles;
}

Row measure(const TimingTrace& trace, const TokenProgram& program, const PipelineTiming& timing, const std::string& depth, int rounds) {
  const Cycle cycles = replay(trace, timing).timing.cycles;
  const auto stepped = [&] {
    TraceFeeder feeder(trace, timing);
    BUMP_ASSERT(cycles == stepped_cycles(timing.graph, [&feeder](SteppedEngine& engine) {
                  if (feeder.at_end()) return false;
                  feeder.append_slice(engine);
                  return true;
                }));
  };
  const auto by_hand = [&] { BUMP_ASSERT(cycles == bench::RecurrenceByHand(timing).run(program)); };
  const auto timeline = [&] { BUMP_ASSERT(cycles == replay(trace, timing).timing.cycles); };
  const bench::Interleaved taken =
      bench::interleaved({timed("stepped", stepped), timed("by hand", by_hand), timed("timeline", timeline)}, rounds);
  return {trace.scene + ", " + trace.scheme, depth, cycles, trace.fragments(), taken.of(0), taken.of(1), taken.of(2)};
}

/// A chain with random latencies, whose tokens take one cycle in most stages and now and then two.
TimingGraph long_chain(std::int64_t depth) {
  std::mt19937 random(1);
  TimingGraph graph;
  for (int i = 0; i < long_chain_stages; ++i) {
    StageSpec stage;
    stage.name = "stage" + std::to_string(i);
    stage.latency = 1 + static_cast<Cycle>(random() % 8);
    stage.capacity = stage.latency + 2;
    graph.stages.push_back(stage);
    if (i > 0) graph.fifos.push_back({"fifo" + std::to_string(i), i - 1, i, depth});
  }
  return graph;
}

/// Now and then a token takes two cycles in one of the stages, as one with a cache miss or at the end of a triangle does.
using Records = std::vector<std::vector<TokenRecord>>;
Records long_chain_records() {
  std::mt19937 random(2);
  Records records(long_chain_stages, std::vector<TokenRecord>(long_chain_tokens));
  for (std::size_t token = 0; token < long_chain_tokens; token += 1 + random() % 16)
    records[random() % long_chain_stages][token].interval = 2;
  return records;
}

void append(TimingPlane& plane, const Records& records) {
  for (std::size_t i = 0; i < records.size(); ++i) plane.append(static_cast<int>(i), records[i].data(), records[i].size());
}

Row measure_long_chain(const std::string& depth, int rounds) {
  const TimingGraph graph = long_chain(std::atoll(depth.c_str()));
  const Records records = long_chain_records();
  const auto date = [&] {
    Timeline timeline(graph);
    append(timeline, records);
    return timeline.finish().cycles;
  };
  const Cycle cycles = date();
  const auto stepped = [&] {
    bool given = false;
    BUMP_ASSERT(cycles == stepped_cycles(graph, [&](SteppedEngine& engine) {
                  if (given) return false;
                  append(engine, records);
                  return given = true;
                }));
  };
  const bench::Interleaved taken =
      bench::interleaved({timed("stepped", stepped), timed("timeline", [&] { BUMP_ASSERT(date() == cycles); })}, rounds);
  return {"chain of " + std::to_string(long_chain_stages), depth, cycles, long_chain_tokens, taken.of(0), 0, taken.of(1)};
}

std::string markdown(const std::vector<Row>& rows) {
  std::string text =
      "| tokens | FIFO depth | cycles per token | stepped, ns a token | by hand | timeline | stepped / timeline | timeline / by hand |\n";
  text += "|--|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const Row& row : rows) {
    const auto tokens = static_cast<double>(row.tokens);
    const auto ns = [tokens](double seconds) { return 1e9 * seconds / tokens; };
    const bool by_hand = row.by_hand_s > 0;
    text += fmt::format("| {} | {} | {:.2f} | {:.0f} | {} | {:.1f} | {:.1f} | {} |\n", row.name, row.depth,
                        static_cast<double>(row.cycles) / tokens, ns(row.stepped_s),
                        by_hand ? fmt::format("{:.1f}", ns(row.by_hand_s)) : "", ns(row.timeline_s), row.stepped_s / row.timeline_s,
                        by_hand ? fmt::format("{:.2f}", row.timeline_s / row.by_hand_s) : "");
  }
  return text;
}

int run(int argc, char* argv[]) {
  int rounds = 5;
  std::vector<std::string> paths, depths = {"1", "2", "4", "16", "256"};
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--rounds") == 0 && i + 1 < argc)
      rounds = std::max(1, std::atoi(argv[++i]));
    else if (std::strcmp(argv[i], "--depths") == 0 && i + 1 < argc)
      depths = bench::list_option(argv[++i]);
    else
      paths.emplace_back(argv[i]);
  }
  std::vector<Row> rows;
  for (const std::string& path : paths) {
    Retimer retimer(decode_trace(read_bytes(path, "timing trace"), path), all_parameters(), path);
    const TokenProgram program = make_token_program(retimer.trace());
    for (const std::string& depth : depths) {
      Configuration configuration = retimer.recorded();
      configuration.set("fifos.depth", static_cast<std::int64_t>(std::atoll(depth.c_str())), {"bench", 0, 0});
      rows.push_back(measure(retimer.trace(), program, retimer.timing_of(configuration), depth, rounds));
    }
  }
  for (const std::string& depth : depths) rows.push_back(measure_long_chain(depth, rounds));
  fmt::print("{}", markdown(rows));
  return 0;
}

}  // namespace

int sc_main(int argc, char* argv[]) {
  if (bench::gave_help(argc, argv, "nanoseconds a fragment of the timing planes alone, over traces that bumpsim run --record wrote", "bench_dates TRACE... [--rounds N] [--depths 1,4]")) return 0;
  sc_core::sc_report_handler::set_actions(sc_core::SC_INFO, sc_core::SC_DO_NOTHING);
  try {
    return run(argc, argv);
  } catch (const Error& error) {
    fmt::print(stderr, "bench_dates: {}\n", error.what());
    return static_cast<int>(error.kind());
  }
}
