// Deadlocks are reported alike by both engines: who waits for whom, and a smallest change that really frees it.

#include <catch2/catch.hpp>
#include <sstream>

#include "run_engines.h"
#include "small_pipelines.h"

using namespace bump;
using namespace bump::test;

namespace {

/// The numbers of a remedy: "depth of fifos.F at least 8", "capacity of S at least 3", joined by "and".
std::vector<std::pair<std::int64_t*, std::int64_t>> changes_in(const std::string& remedy, TimingGraph& graph) {
  std::vector<std::pair<std::int64_t*, std::int64_t>> changes;
  std::istringstream words(remedy);
  std::string kind, of, name, at, least, value, joined;
  while (words >> kind >> of >> name >> at >> least >> value) {
    for (FifoSpec& fifo : graph.fifos)
      if (kind == "depth" && "fifos." + fifo.name == name) changes.push_back({&fifo.depth, std::stoll(value)});
    for (StageSpec& stage : graph.stages)
      if (kind == "capacity" && stage.name == name) changes.push_back({&stage.capacity, std::stoll(value)});
    words >> joined;
  }
  return changes;
}

void require_smallest_remedy(const TimingCase& timing_case, const std::string& remedy) {
  INFO(remedy);
  TimingCase mended = timing_case;
  const auto changes = changes_in(remedy, mended.graph);
  REQUIRE(!changes.empty());
  for (const auto& [number, value] : changes) {
    REQUIRE(value > *number);
    *number = value;
  }
  REQUIRE(run_dated(mended).error.empty());
  for (const auto& [number, value] : changes) {
    *number = value - 1;
    REQUIRE(!run_dated(mended).error.empty());
    *number = value;
  }
}

std::vector<TimingCase> deadlocked_cases(std::uint64_t first_seed, std::size_t count) {
  std::vector<TimingCase> cases;
  for (std::uint64_t seed = first_seed; cases.size() < count; ++seed) {
    TimingCase timing_case = random_case(seed);
    if (!run_dated(timing_case).error.empty()) cases.push_back(std::move(timing_case));
  }
  return cases;
}

}  // namespace

TEST_CASE("a batch that does not fit its FIFO is a deadlock with a remedy") {
  TimingCase timing_case = pair_of_stages(4, 20);
  timing_case.graph.stages[1].batch = 8;
  Timeline timeline(timing_case.graph);
  for (int i = 0; i < 2; ++i) timeline.append_uniform(i, TokenRecord(), 20);
  try {
    timeline.finish();
    FAIL("no deadlock");
  } catch (const Error& error) {
    REQUIRE(error.kind() == ErrorKind::deadlock);
    REQUIRE(error.text().what == "deadlock: nothing moves after cycle 5");  // four in the FIFO by cycle 4, two more in flight
    REQUIRE(error.text().why ==
            "second waits for first at FIFO between (needs 8 items, holds 4 of 4); "
            "first waits for second at FIFO between (needs a free slot, holds 4 of 4)");
    REQUIRE(error.text().try_this == "depth of fifos.between at least 8");
  }
  require_smallest_remedy(timing_case, "depth of fifos.between at least 8");
}

TEST_CASE("branches that meet again deadlock when one gathers more than the other holds") {
  const TimingCase timing_case = uneven_branches(4, 12);
  const Outcome outcome = run_dated(timing_case);
  REQUIRE(!outcome.error.empty());
  REQUIRE(outcome.remedy == "depth of fifos.direct at least 12");
  require_smallest_remedy(timing_case, outcome.remedy);
}

TEST_CASE("two FIFOs that are both too shallow are both named") {
  TimingCase timing_case = uneven_branches(4, 12);
  timing_case.graph.fifos[0].depth = 6;
  const Outcome outcome = run_dated(timing_case);
  REQUIRE(outcome.remedy == "depth of fifos.to_gather at least 12 and depth of fifos.direct at least 12");
  require_smallest_remedy(timing_case, outcome.remedy);
}

TEST_CASE("the remedy of every random deadlock works, and one less does not") {
  for (const TimingCase& timing_case : deadlocked_cases(20000, 300)) require_smallest_remedy(timing_case, run_dated(timing_case).remedy);
}

TEST_CASE("the clocked engine reports the same deadlocks in the same words") {
  std::vector<TimingCase> cases = deadlocked_cases(30000, 100);
  cases.push_back(uneven_branches(4, 12));
  const std::vector<Outcome> stepped = run_stepped(cases);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    REQUIRE(!stepped[i].error.empty());
    REQUIRE(stepped[i].error == run_dated(cases[i]).error);
  }
}
