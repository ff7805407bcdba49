// What of a table's contents decides its price in gates.

#include <catch2/catch.hpp>
#include <cmath>

#include "testbench/experiments/price_contents.h"
#include "testbench/experiments/price_table.h"

namespace bump {
namespace {

/// 2^bits words of a function of the address, in words of `width` bits.
Table table_of(int bits, int width, const std::function<double(double)>& word) {
  Table table;
  table.name = "T";
  table.index = ufixed(bits, 0);
  table.address_bits = bits;
  Column column;
  column.name = "y";
  column.function = word;
  column.format = ufixed(width, 0);
  table.columns = {column};
  return table;
}

PriceTable shipped_areas() {
  return read_price_table(std::string(BUMP_SOURCE_DIR) + "/testbench/prices/osu018_model.toml");
}

}  // namespace

TEST_CASE("changes are the bits that differ between neighbouring words, summed over a column") {
  CHECK(contents_of(table_of(3, 4, [](double) { return 5; })).changes == std::vector<double>{0});
  // 0 15 0 15 ...: every bit at every step.
  CHECK(contents_of(table_of(3, 4, [](double x) { return std::fmod(x, 2) * 15; })).changes == std::vector<double>{7 * 4});
  for (const int bits : {3, 6, 10}) {
    // Counting: address a + 1 differs from a in as many bits as a ends in ones, and one.
    const double words = std::ldexp(1, bits);
    const RomContents counting = contents_of(table_of(bits, bits, [](double x) { return x; }));
    CHECK(counting.changes.front() == 2 * words - bits - 2);
    CHECK(counting.is_line);
  }
}

TEST_CASE("a straight line is told from what is almost one") {
  for (const double slope : {0.37, 1.0, 5.3, 23.61}) {
    INFO(slope);
    CHECK(contents_of(table_of(8, 16, [slope](double x) { return slope * x + 3; })).is_line);
    CHECK_FALSE(contents_of(table_of(8, 16, [slope](double x) { return slope * x + (x == 100 ? 8 : 0); })).is_line);
    CHECK_FALSE(contents_of(table_of(8, 16, [slope](double x) { return slope * x + 0.01 * x * x; })).is_line);
  }
  CHECK_FALSE(contents_of(table_of(8, 16, [](double) { return 7; })).is_line);
}

TEST_CASE("columns without words of their own have no changes") {
  Table table = table_of(6, 8, [](double x) { return 255 * std::sin(x / 41); });
  table.columns.push_back(table.columns.front());
  table.columns.back().name = "mirrored";
  table.columns.back().mirrors_first = true;
  const RomContents contents = contents_of(table);
  CHECK(contents.changes[0] > 0);
  CHECK(contents.changes[1] == 0);
  table.columns.back().format = real();
  CHECK(contents_of(table).changes == std::vector<double>{0, 0});
}

TEST_CASE("the shipped areas of tables are those that were synthesised, within what the table states") {
  // NAND2 equivalents by Yosys 0.23 and ABC onto osu018; sizes as of the images: words, bits, columns, changes.
  const struct {
    const char* what;
    PriceSizes sizes;
    double synthesised;
  } images[] = {
      {"sine, 12 bits", {1024, 12, 1, 2661}, 1206},
      {"sine and cosine, 12 bits", {1024, 24, 2, 5322}, 2035},
      {"sine and cosine, 16 bits", {256, 32, 2, 2852}, 1306},
      {"sine and cosine, 4096 words", {4096, 24, 2, 12907}, 4633},
      {"arc cosine", {1024, 12, 1, 2804}, 1233},
      {"20th power", {1024, 16, 1, 934}, 567},
      {"antilogarithm", {1024, 12, 1, 2212}, 1032},
      {"sine and cosine, 64 words", {64, 20, 2, 435}, 250},
  };
  const PriceTable areas = shipped_areas();
  for (const auto& image : images) {
    INFO(image.what);
    CHECK(areas.at(Quantity::area, Component::table, "a test").at(image.sizes) == Approx(image.synthesised).epsilon(0.25));
    CHECK(areas.at(Quantity::area, Component::second_port, "a test").at(image.sizes) ==
          areas.at(Quantity::area, Component::table, "a test").at(image.sizes));
  }
  CHECK(areas.at(Quantity::area, Component::line_table, "a test").at({1024, 16, 1, 4495}) == Approx(557).epsilon(0.35));
}

}  // namespace bump
