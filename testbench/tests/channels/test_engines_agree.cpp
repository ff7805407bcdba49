// The dated timeline, the clocked engine and the formulas themselves give the same cycles and the same statistics, or the same deadlock.

#include <catch2/catch.hpp>

#include "direct_evaluation.h"
#include "run_engines.h"

using namespace bump;
using namespace bump::test;

namespace {

void require_agreement(std::uint64_t first_seed, int count) {
  std::vector<TimingCase> cases;
  for (int i = 0; i < count; ++i) cases.push_back(random_case(first_seed + static_cast<std::uint64_t>(i)));
  const std::vector<Outcome> stepped = run_stepped(cases);
  int completed = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    INFO("seed " << first_seed + i);
    const Outcome dated = run_dated(cases[i]);
    REQUIRE(dated.error == stepped[i].error);
    REQUIRE(dated.result == stepped[i].result);
    const auto direct = DirectEvaluation(cases[i]).result();
    REQUIRE(direct.has_value() == dated.error.empty());
    if (direct) {
      ++completed;
      REQUIRE(*direct == dated.result);
    }
  }
  REQUIRE(completed > count / 2);  // deadlocks are the exception, or little was compared
}

}  // namespace

TEST_CASE("both engines and the formulas agree on random pipelines, first part") {
  require_agreement(1000, 300);
}
TEST_CASE("both engines and the formulas agree on random pipelines, second part") {
  require_agreement(2000, 300);
}
TEST_CASE("both engines and the formulas agree on random pipelines, third part") {
  require_agreement(3000, 300);
}
TEST_CASE("both engines and the formulas agree on random pipelines, fourth part") {
  require_agreement(4000, 300);
}

TEST_CASE("the quick ways through a chain agree with the formulas, however the records arrive") {
  for (std::uint64_t seed = 20000; seed < 20400; ++seed) {
    const TimingCase timing_case = random_chain(seed);
    INFO("seed " << seed);
    const auto direct = DirectEvaluation(timing_case).result();
    REQUIRE(direct.has_value());
    REQUIRE(run_dated(timing_case).result == *direct);
    REQUIRE(run_dated(timing_case, seed).result == *direct);
  }
}

TEST_CASE("the timeline agrees with the formulas on thousands of random pipelines, however the records arrive") {
  int completed = 0;
  for (std::uint64_t seed = 10000; seed < 13000; ++seed) {
    const TimingCase timing_case = random_case(seed);
    INFO("seed " << seed);
    const Outcome whole = run_dated(timing_case);
    const Outcome blocks = run_dated(timing_case, seed);
    REQUIRE(blocks.error == whole.error);
    REQUIRE(blocks.result == whole.result);
    const auto direct = DirectEvaluation(timing_case).result();
    REQUIRE(direct.has_value() == whole.error.empty());
    if (!direct) continue;
    ++completed;
    REQUIRE(*direct == whole.result);
  }
  REQUIRE(completed > 1500);
}
