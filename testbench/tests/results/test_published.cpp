#include <catch2/catch.hpp>
#include <cmath>

#include "testbench/published/lee2007_table1.h"
#include "testbench/published/lee2007_table2.h"

using namespace bump::published;

TEST_CASE("Table 1 has two cells a column, and its totals are those of the paper's comparison") {
  for (const char* scheme : {"peercy1997", "kugler1998", "kim2001", "ernst1998", "lee2007"}) {
    INFO(scheme);
    REQUIRE(table1_cell(scheme, "environment"));
    REQUIRE(table1_cell(scheme, "illumination"));
    CHECK_FALSE(table1_cell(scheme, "environment")->source.empty());
  }
  CHECK(table1_cell("lee2007", "vertex") == nullptr);
  const auto multipliers = [](const char* scheme) {
    return table1_cell(scheme, "environment")->counts.multipliers + table1_cell(scheme, "illumination")->counts.multipliers;
  };
  // "reduces up to maximum 78 %": against Kim, the largest of the four.
  CHECK(100 * (1 - static_cast<double>(multipliers("lee2007")) / multipliers("kim2001")) == Approx(78.4).margin(0.05));
}

TEST_CASE("Table 2's root measures are the roots of its other measures to four digits") {
  for (const Table2Row& row : table2) {
    for (std::size_t c = 0; c < 3; ++c) {
      INFO(row.scene << " " << row.reference << " " << c);
      CHECK(std::abs(row.rnmse[c] * row.rnmse[c] - row.nmse[c]) < 0.00007);
      CHECK(std::abs(row.rpmse[c] * row.rpmse[c] - row.pmse[c]) < 0.00007);
    }
  }
  CHECK(table2_row("sphere", "kim")->nmse[2] == 0.0157);
  CHECK(table2_row("torus", "kim") == nullptr);
}
