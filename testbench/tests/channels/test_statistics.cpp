#include <catch2/catch.hpp>
#include <set>

#include "channels/statistics.h"

using namespace bump;

TEST_CASE("every numeric field of a timing result has a meaning and a unit, once") {
  const std::set<std::pair<std::string, std::string>> fields = {
      {"run", "cycles"},           {"stage", "tokens"},        {"stage", "busy"},      {"stage", "starved"}, {"stage", "blocked_room"},
      {"stage", "blocked_output"}, {"stage", "last_delivery"}, {"fifo", "depth"},      {"fifo", "items"},    {"fifo", "max_occupancy"},
      {"fifo", "full_cycles"},     {"fifo", "empty_cycles"},   {"memory", "requests"}, {"memory", "busy"},
  };
  std::set<std::pair<std::string, std::string>> described;
  for (const StatisticMeaning& entry : statistic_meanings()) {
    INFO(entry.module_kind << "." << entry.statistic);
    REQUIRE(described.insert({entry.module_kind, entry.statistic}).second);
    REQUIRE(!entry.meaning.empty());
    REQUIRE(entry.meaning.find('\n') == std::string::npos);
    REQUIRE((entry.unit == "cycles" || entry.unit == "tokens" || entry.unit == "requests"));
  }
  REQUIRE(described == fields);
}
