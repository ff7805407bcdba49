#include <catch2/catch.hpp>
#include <cmath>

#include "datapath/error.h"
#include "datapath/lane_kernels.h"
#include "datapath/table.h"
#include "luts/rom_error.h"
#include "oracle.h"
#include "random_netlist.h"

using namespace bump;
using namespace bump_test;
using Catch::Contains;

namespace {

constexpr double two_pi = 6.283185307179586;

Column column(const std::string& name, std::function<double(double)> function, const Format& format, Symmetry symmetry = {}) {
  Column c;
  c.name = name;
  c.function = std::move(function);
  c.format = format;
  c.symmetry = symmetry;
  return c;
}

Table sine_and_cosine(int angle_bits, int address_bits, int word_bits) {
  Table t;
  t.name = "SC";
  t.index = turns(angle_bits);
  t.folding = Folding::quarter;
  t.address_bits = address_bits;
  t.columns = {column("sin", [](double x) { return std::sin(two_pi * x); }, sfixed(word_bits, word_bits - 2), {true, false}),
               column("cos", [](double x) { return std::cos(two_pi * x); }, sfixed(word_bits, word_bits - 2), {false, true})};
  return t;
}

}  // namespace

TEST_CASE("addresses and words equal an independent definition for random tables and every index") {
  Random random(12);
  for (int i = 0; i < 1500; ++i) {
    const TablePtr table = random_table(random, "T");
    const TableContents contents = tabulate(*table);
    for (const auto& [index, read] : oracle_table(*table)) {
      IndexWords words{};
      std::copy(index.begin(), index.end(), words.begin());
      INFO("table " << i << ", index " << index.front() << " of " << to_string(table->index));
      REQUIRE(address_of(*table, words).address == read.address);
      REQUIRE(read.address < table->entries());
      for (std::size_t j = 0; j < table->columns.size(); ++j) REQUIRE(look_up(*table, contents, j, words) == read.words[j]);
    }
  }
}

TEST_CASE("addresses of many lanes equal those of one index, for indices of any width") {
  Random random(13);
  for (int i = 0; i < 3000; ++i) {
    Table table;
    table.folding = static_cast<Folding>(random.integer(0, 3));
    table.address_bits = random.integer(1, 16);
    table.exponent_bits = random.integer(0, std::min(5, table.address_bits));
    table.min_exponent = random.integer(-40, 20);
    const int width = random.integer(2, 62);
    table.index = table.folding == Folding::quarter     ? turns(width)
                  : table.folding == Folding::magnitude ? sfixed(width, 7)
                                                        : ufixed(width, random.integer(-5, 60));
    std::array<std::int64_t, 16> index{}, address{}, negative{}, beyond{};
    for (std::int64_t& word : index) word = quantise(random_value(random, table.index), table.index);
    lanes::addresses(table, {index.data()}, address.data(), negative.data(), beyond.data(), 16);
    for (std::size_t j = 0; j < index.size(); ++j) {
      const TableAddress place = address_of(table, index[j]);
      INFO(to_string(table.index) << " " << index[j]);
      REQUIRE(address[j] == place.address);
      REQUIRE(negative[j] == (place.negative_index ? -1 : 0));
      REQUIRE(beyond[j] == (place.beyond_quarter ? -1 : 0));
      REQUIRE(place.address >= 0);
      REQUIRE(place.address < table.entries());
    }
  }
}

TEST_CASE("a full quarter-wave table is within half a step of sine and cosine, plus one angle step at the quarter turn") {
  for (int bits = 4; bits <= 14; ++bits) {
    const Table t = sine_and_cosine(bits, bits - 2, bits + 2);
    const RomError error = rom_error(t, tabulate(t));
    CHECK(error.all_codes);
    CHECK(error.codes == std::int64_t{1} << bits);
    const double half_step = t.columns[0].format.step() / 2;
    // The quarter turn itself shares the word of the code below: cosine is steep there, sine flat.
    CHECK(error.columns[0].largest <= half_step + 1 - std::cos(two_pi * t.index.step()) + 1e-12);
    CHECK(error.columns[1].largest <= half_step + std::sin(two_pi * t.index.step()) + 1e-12);
    CHECK(error.columns[1].out_of_range == 0);
  }
}

TEST_CASE("a short quarter-wave table is within half an address step of sine and cosine") {
  for (int address_bits = 2; address_bits <= 8; ++address_bits) {
    const Table t = sine_and_cosine(12, address_bits, 14);
    const RomError error = rom_error(t, tabulate(t));
    const double codes = std::ldexp(1.0, 10 - address_bits);  // that share an address
    const double bound = two_pi * (codes / 2 + 0.5) * t.index.step() + t.columns[0].format.step() / 2;
    CHECK(error.columns[0].largest <= bound);
    CHECK(error.columns[1].largest <= bound);
    CHECK(error.columns[0].largest > bound / 3);
  }
}

TEST_CASE("a mirrored column costs no bits and is off by one angle step at most") {
  Table t = sine_and_cosine(10, 8, 12);
  const std::int64_t both = t.bits();
  t.columns[1].mirrors_first = true;
  CHECK(2 * t.bits() == both);
  CHECK(t.bits() == 256 * 11);
  const TableContents contents = tabulate(t);
  CHECK(contents.words[1] == std::vector<std::int64_t>(contents.words[0].rbegin(), contents.words[0].rend()));
  const RomError error = rom_error(t, contents);
  CHECK(error.columns[1].largest <= std::sin(two_pi * t.index.step()) + t.columns[0].format.step() / 2 + 1e-12);
}

TEST_CASE("odd columns change sign with the index, even columns do not") {
  Table t;
  t.name = "ODD_EVEN";
  t.index = sfixed(9, 7);
  t.folding = Folding::magnitude;
  t.address_bits = 8;
  t.columns = {column("atan", [](double x) { return std::atan(x); }, sfixed(12, 10), {true, false}),
               column(
                   "cos", [](double x) { return std::cos(x); }, sfixed(12, 10))};
  CHECK(t.stored_width(t.columns[0]) == 11);
  CHECK(t.stored_width(t.columns[1]) == 12);
  CHECK(t.bits() == 256 * 23);
  const TableContents contents = tabulate(t);
  for (std::int64_t i = 1; i < 256; ++i) {
    REQUIRE(look_up(t, contents, 0, -i) == -look_up(t, contents, 0, i));
    REQUIRE(look_up(t, contents, 1, -i) == look_up(t, contents, 1, i));
  }
  const RomError error = rom_error(t, contents);
  const double half_step = std::ldexp(1.0, -11);
  // Only the most negative index shares its word with its neighbour.
  CHECK(error.columns[0].largest <= half_step + t.index.step() / (1 + 1.9 * 1.9));
  CHECK(error.columns[1].largest <= half_step + t.index.step());
}

TEST_CASE("a floating index has the same relative error in every binade") {
  Table t;
  t.name = "RSQRT";
  t.index = ufixed(24, 23);
  t.folding = Folding::floating;
  t.address_bits = 9;
  t.exponent_bits = 4;
  t.min_exponent = -15;
  t.columns = {column(
      "y", [](double x) { return x > 0 ? 1 / std::sqrt(x) : 1e6; }, ufixed(30, 22))};
  const TableContents contents = tabulate(t);
  for (int exponent = -15; exponent <= 0; ++exponent)
    for (int i = 0; i < 200; ++i) {
      const double x = std::ldexp(1 + i / 200.0, exponent);
      const std::int64_t index = quantise(x, t.index);
      const double exact = 1 / std::sqrt(to_double(index, t.index));
      const double held = to_double(look_up(t, contents, 0, index), t.columns[0].format);
      REQUIRE(std::fabs(held / exact - 1) < 0.5 / 64 + 1e-4);  // 32 mantissa steps a binade; half a step of the index halves in the root
    }
  CHECK(address_of(t, 0).address == 0);
  CHECK(address_of(t, 1).address == 0);
  CHECK(address_of(t, (std::int64_t{1} << 24) - 1).address == 511);
  const RomError error = rom_error(t, contents);
  CHECK_FALSE(error.all_codes);
  CHECK(error.codes >= 512 * 8);  // the shortest run of codes that share a word has 8
}

TEST_CASE("an index with fewer bits than the address leaves the low address bits zero") {
  Table t;
  t.name = "WIDE";
  t.index = ufixed(3, 3);
  t.address_bits = 5;
  t.columns = {column(
      "x", [](double x) { return x; }, ufixed(8, 8))};
  const TableContents contents = tabulate(t);
  for (std::int64_t i = 0; i < 8; ++i) {
    CHECK(address_of(t, i).address == 4 * i);
    CHECK(look_up(t, contents, 0, i) == 32 * i);
  }
}

TEST_CASE("words saturate, and full-turn angles wrap") {
  Table t;
  t.name = "RECIPROCAL";
  t.index = ufixed(4, 4);
  t.address_bits = 4;
  t.columns = {column(
                   "reciprocal", [](double x) { return 1 / x; }, ufixed(6, 4)),
               column(
                   "half", [](double) { return 0.5; }, turns(8))};
  const TableContents contents = tabulate(t);
  CHECK(look_up(t, contents, 0, 0) == 63);
  CHECK(look_up(t, contents, 0, 8) == 32);
  CHECK(look_up(t, contents, 1, 8) == -128);
  const RomError error = rom_error(t, contents);
  CHECK(error.columns[0].out_of_range == 5);  // 1/0 and 16/1 to 16/4: up to 63/16 fit, and half a step more rounds to it
  CHECK(error.columns[0].largest_in_range <= 1.0 / 32);
  CHECK(std::isinf(error.columns[0].largest));
  CHECK(error.columns[1].largest == 0);
}

TEST_CASE("tables that contradict themselves are refused with their name") {
  const auto broken = [](void (*damage)(Table&)) {
    Table t = sine_and_cosine(10, 8, 12);
    damage(t);
    return t;
  };

  CHECK_THROWS_WITH(tabulate(broken([](Table& t) { t.index = sfixed(10, 9); })), Contains("SC") && Contains("full-turn"));
  CHECK_THROWS_WITH(tabulate(broken([](Table& t) { t.columns.clear(); })), Contains("no columns"));
  CHECK_THROWS_WITH(tabulate(broken([](Table& t) { t.columns[1].name = "sin"; })), Contains("distinct"));
  CHECK_THROWS_WITH(tabulate(broken([](Table& t) { t.columns[0].format = ufixed(12, 10); })), Contains("odd") && Contains("signed"));
  CHECK_THROWS_WITH(tabulate(broken([](Table& t) { t.columns[0].mirrors_first = true; })), Contains("mirror"));
  CHECK_THROWS_WITH(tabulate(broken([](Table& t) {
                      t.columns[1].mirrors_first = true;
                      t.columns[1].format = sfixed(9, 7);
                    })),
                    Contains("stored width"));
  CHECK_THROWS_WITH(tabulate(broken([](Table& t) { t.address_bits = 30; })), Contains("address bits"));
  CHECK_THROWS_WITH(tabulate(broken([](Table& t) { t.index = real(); })), Contains("real"));
  CHECK_THROWS_WITH(tabulate(broken([](Table& t) { t.columns[0].function = [](double x) { return -x; }; })), Contains("negative"));
  CHECK_THROWS_WITH(tabulate(broken([](Table& t) { t.columns[0].function = [](double) { return std::nan(""); }; })),
                    Contains("not a number"));
  CHECK_THROWS_WITH(tabulate(broken([](Table& t) {
                      t.folding = Folding::floating;
                      t.index = sfixed(9, 8);
                    })),
                    Contains("unsigned"));
}

TEST_CASE("a map of three angles holds its function at the centre of the codes that share a word") {
  Table map;
  map.name = "MAP";
  map.index = turns(12);
  map.folding = Folding::magnitude;
  map.address_bits = 5;
  map.fields = {{ufixed(9, 9), 5}, {ufixed(4, 4), 4}};
  Column column;
  column.name = "value";
  column.map_function = [](const double* x) { return std::sin(two_pi * x[0]) * x[1] * (1 - x[2]); };
  column.format = sfixed(9, 8);
  column.symmetry.odd_about_zero = true;
  map.columns = {column};
  CHECK(map.is_map());
  CHECK(map.entries() == 1 << 14);
  CHECK(map.bits() == 8 << 14);  // the sign is folded
  const TableContents contents = tabulate(map);
  Random random(14);
  for (int i = 0; i < 2000; ++i) {
    const std::int64_t phi = random.integer(1, 2047), theta = random.integer(0, 511), tilt = random.integer(0, 15);
    const IndexWords codes{phi, theta, tilt}, reflected{-phi, theta, tilt};
    REQUIRE(address_of(map, codes).address == ((phi / 64 * 32 + theta / 16) * 16 + tilt));
    const double centre[] = {(std::floor(static_cast<double>(phi) / 64) * 64 + 31.5) / 4096,
                             (std::floor(static_cast<double>(theta) / 16) * 16 + 7.5) / 512, static_cast<double>(tilt) / 16};
    const double held = to_double(look_up(map, contents, 0, codes), column.format);
    REQUIRE(std::fabs(held - column.map_function(centre)) <= column.format.step() / 2);
    REQUIRE(look_up(map, contents, 0, reflected) == -look_up(map, contents, 0, codes));
  }
  // Slopes times half a cell, and half a step.
  const RomError error = rom_error(map, contents);
  CHECK_FALSE(error.all_codes);
  CHECK(error.columns[0].largest <= two_pi / 128 + 1.0 / 64 + column.format.step());
  CHECK(error.columns[0].largest > 1.0 / 64);
}

TEST_CASE("a map must have a function of all its index words and at most three of them") {
  Table map;
  map.name = "MAP";
  map.index = ufixed(4, 4);
  map.address_bits = 4;
  map.fields = {{ufixed(4, 4), 4}};
  Column column;
  column.name = "value";
  column.function = [](double x) { return x; };
  column.format = ufixed(8, 8);
  map.columns = {column};
  CHECK_THROWS_WITH(tabulate(map), Contains("all its index words"));
  map.columns.front().map_function = [](const double* x) { return x[0] * x[1]; };
  CHECK_THROWS_WITH(tabulate(map), Contains("all its index words"));
  map.columns.front().function = nullptr;
  CHECK_NOTHROW(tabulate(map));
  map.fields.resize(3, {ufixed(4, 4), 4});
  CHECK_THROWS_WITH(tabulate(map), Contains("two or three index words"));
}
