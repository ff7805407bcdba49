#include <catch2/catch.hpp>
#include <sstream>

#include "sample_report.h"
#include "testbench/results/summary.h"

using namespace bump;
using bump::made_up::Sample;
using Catch::Contains;

TEST_CASE("the summary shows what was counted, what was published, and what binds") {
  Sample sample;
  sample.report.out = "out/plane";
  const std::string text = summary(sample.report);
  CHECK_THAT(text, Contains("lee2007 on wooden plane"));
  CHECK_THAT(text, Contains("1,000") && Contains("0.2500"));
  CHECK_THAT(text, Contains("rasterizer: initiation interval") && Contains("80.0 %"));
  CHECK_THAT(text, Contains("6 | 6") && Contains("16 |16") && Contains("13 |11"));
  CHECK_THAT(text, Contains("section 5.2 says 13"));
  CHECK_THAT(text, Contains("96.67 %"));
  CHECK_THAT(text, Contains("out/plane") && Contains("error.png"));
}

TEST_CASE("no line of the summary is wider than 100 columns or ends in blanks") {
  Sample sample(128);
  sample.result.timing.cycles = 1234567890;
  sample.result.fragments = 987654321;
  sample.result.timing.stages[0].tokens = 987654321;
  sample.scene.warnings.clear();
  std::istringstream text(summary(sample.report));
  std::string line;
  int lines = 0;
  while (std::getline(text, line)) {
    ++lines;
    INFO(line);
    CHECK(line.size() <= 100);
    CHECK((line.empty() || line.back() != ' '));
  }
  CHECK(lines > 20);
}

TEST_CASE("the summary has a column for barrel shifters where a unit has any") {
  Sample sample;
  CHECK_THAT(summary(sample.report), !Contains("shifter"));
  REQUIRE(!sample.result.units.empty());
  sample.result.units.front().published.shifters = 6;
  const std::string text = summary(sample.report);
  CHECK_THAT(text, Contains("map    shifter") && Contains("   6    "));
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) CHECK(line.size() <= 100);
}

TEST_CASE("a run without fragments, tables or references still has a summary") {
  Sample sample;
  sample.result = SimulationResult{};
  sample.report.against_reference.reset();
  sample.report.against_double.reset();
  sample.report.double_against_reference.reset();
  const std::string text = summary(sample.report);
  CHECK_THAT(text, Contains("cycles"));
  CHECK_THAT(text, !Contains("nan") && !Contains("inf"));
}

TEST_CASE("angles of a run in which no vector lights the surface are dashes") {
  Sample sample;
  AngularError nothing;
  nothing.vector = "L'";
  sample.result.angular_errors = sample.result.angular_errors_exact = {nothing};
  const std::string text = summary(sample.report);
  CHECK_THAT(text, Contains("L', hardware" + std::string(22 + 9, ' ') + "-        -        -\n"));
  CHECK_THAT(text, !Contains("nan"));
}

TEST_CASE("identical images are called identical") {
  Sample sample;
  sample.result.exact = sample.result.hardware;
  measure_quality(sample.report, nullptr, nullptr);
  CHECK_THAT(summary(sample.report), Contains("identical"));
}

TEST_CASE("the summary tells of light maps only where there are any") {
  Sample sample;
  CHECK_THAT(summary(sample.report), !Contains("light map"));
  sample.result.light_maps = {{"diffuse", 1 << 20, 1 << 23, 1 << 20, 1 << 20, {250, 200, 50, 3200, 0}}};
  const std::string text = summary(sample.report);
  CHECK_THAT(text, Contains("light maps, filled once a frame") && Contains("80.00 % hits of 250 reads, 3.1 KB from memory"));
  CHECK_THAT(text, Contains("1,048,576 words, 1024.00 KB written each frame") && !Contains("cut off"));
  sample.result.light_maps[0].counters.clipped = 7;
  CHECK_THAT(summary(sample.report), Contains("7 reads of words that were cut off"));
}
