// Records kept as runs read like the sequence of records that was put in.

#include <catch2/catch.hpp>
#include <random>

#include "units/token_records.h"

namespace bump {
namespace {

TokenRecord some_record(std::mt19937& random) {
  TokenRecord record;
  record.interval = 1 + random() % 2;
  record.misses = static_cast<std::uint16_t>(random() % 2);
  return record;
}

TEST_CASE("runs of records read like the records, whichever way they were put in") {
  std::mt19937 random(7);
  for (int trial = 0; trial < 300; ++trial) {
    TokenRecords records, others;
    std::vector<TokenRecord> expected, expected_others;
    for (int step = 0; step < 30; ++step) {
      const TokenRecord record = some_record(random);
      switch (random() % 5) {
        case 0:
          records.push_back(record);
          expected.push_back(record);
          break;
        case 1: {
          const std::size_t count = random() % 4;
          records.append(record, static_cast<std::int64_t>(count));
          expected.insert(expected.end(), count, record);
          break;
        }
        case 2:
          if (expected.empty()) break;
          records.replace_back(record);
          expected.back() = record;
          break;
        case 3:
          others.push_back(record);
          expected_others.push_back(record);
          break;
        default:
          records.append(others);
          expected.insert(expected.end(), expected_others.begin(), expected_others.end());
      }
    }
    REQUIRE(records.size() == expected.size());
    REQUIRE(records.empty() == expected.empty());
    std::size_t at = 0;
    bool same = true;
    for (const TokenRecord& record : records) {
      same = same && same_record(record, expected[at]) && same_record(records[at], expected[at]);
      ++at;
    }
    CHECK(same);
    CHECK(at == expected.size());
    CHECK(std::vector<TokenRecord>(records).size() == expected.size());
    if (!expected.empty()) CHECK(same_record(records.back(), expected.back()));
    for (std::size_t run = 1; run < records.runs().size(); ++run)
      CHECK(!same_record(records.runs()[run - 1].record, records.runs()[run].record));
    records.clear();
    CHECK(records.empty());
    CHECK(records.begin() == records.end());
  }
}

}  // namespace
}  // namespace bump
