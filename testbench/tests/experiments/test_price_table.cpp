// Tables of prices: what a file may say, and where a mistake in it is.

#include <catch2/catch.hpp>
#include <filesystem>

#include "price_bench.h"

namespace bump {
namespace {

/// What reading the text complains of.
ErrorText complaint(const std::string& text) {
  try {
    PriceTable(text, "t.toml", "t");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::input);
    return error.text();
  }
  return {};
}

std::string area(const std::string& body) {
  return head() + "[area]\nunit = \"NAND2\"\naccuracy = \"exact\"\n" + body;
}

std::string shipped(const std::string& name) {
  return std::string(BUMP_SOURCE_DIR) + "/testbench/prices/" + name + ".toml";
}

}  // namespace

TEST_CASE("every form of a price is the function that it says") {
  const PriceTable table = round_table();
  const auto price = [&](Component component, PriceSizes sizes) { return table.at(Quantity::area, component, "a test").at(sizes); };
  CHECK(price(Component::register_bits, {}) == 4);
  CHECK(price(Component::adder, {12}) == 120);
  CHECK(price(Component::multiplier, {8, 12}) == 960);
  CHECK(price(Component::divider, {11, 12}) == 5 + 10 * 11 * 12 + 11);
  CHECK(price(Component::squarer, {9, 9}) == Approx(7 * 81));
  CHECK(price(Component::table, {256, 24, 2}) == 0.5 * 256 * 24);
}

TEST_CASE("a power takes each size by its reference and exponent") {
  const PriceTable table(
      area(entry("area.table", "form = \"power\"\ncoefficient = 3\nreference_entries = 64\nexponent_entries = 0.5\nexponent_word = 1")),
      "t.toml", "t");
  CHECK(table.find(Quantity::area, Component::table)->at({256, 10, 1}) == Approx(3 * 2 * 10));
  CHECK(formula(*table.find(Quantity::area, Component::table), Component::table) == "3 (entries/64)^0.5 word");
}

TEST_CASE("energies may be written in other units") {
  const auto energy = [](const std::string& unit) {
    const PriceTable table(head() + "[energy]\nunit = \"" + unit + "\"\naccuracy = \"exact\"\n" +
                               entry("energy.adder", "form = \"linear\"\nbase = 2\nper_width = 3"),
                           "t.toml", "t");
    return table.find(Quantity::energy, Component::adder)->at({10});
  };
  CHECK(energy("pJ") == 32);
  CHECK(energy("fJ") == Approx(0.032));
  CHECK(energy("nJ") == Approx(32000));
}

TEST_CASE("a special case without an entry is priced as the general one") {
  const PriceTable table = round_table();
  CHECK(table.find(Quantity::area, Component::map) == table.find(Quantity::area, Component::table));
  CHECK(table.find(Quantity::area, Component::line_table) == table.find(Quantity::area, Component::table));
  CHECK(table.find(Quantity::area, Component::second_port) != table.find(Quantity::area, Component::table));
  CHECK(table.find(Quantity::area, Component::squarer) != table.find(Quantity::area, Component::multiplier));
  CHECK(table.entry_component(Quantity::area, Component::constant_multiplier) == Component::multiplier);
  CHECK(table.find(Quantity::area, Component::adder_subtractor) == nullptr);  // it costs more than an adder
  for (int i = 0; i < static_cast<int>(Component::count); ++i) {
    const auto component = static_cast<Component>(i);
    CHECK(sizes_of(component).size() <= PriceSizes{}.size());
    CHECK(general(general(component)) == general(component));
    CHECK(group_of(general(component)) == group_of(component));
  }
}

TEST_CASE("a missing price is an error that names table, component and who needs it") {
  const PriceTable table = round_table();
  try {
    table.at(Quantity::area, Component::float_divider, "lee2007, interpolators");
    FAIL("no error");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::input);
    CHECK(error.text().what == "price table 'round' has no area.float_divider");
    CHECK(error.text().where.file == "round.toml");
    CHECK(error.text().why.find("lee2007, interpolators") != std::string::npos);
  }
  CHECK_THROWS_AS(table.at(Quantity::energy, Component::adder, "a test"), Error);
}

TEST_CASE("mistakes in a table have a file, a line and a column") {
  struct Case {
    std::string text;
    int line;
    const char* says;
  };
  const std::string adder = "[area.adder]\nform = \"linear\"\nper_width = 7\nsource = \"s\"\naccuracy = \"a\"\n";
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = area(adder);
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
  };
  REQUIRE(complaint(area(adder)).what.empty());
  const Case cases[] = {
      {with("[area.adder]", "[area.adder"), 7, "not valid TOML"},
      {with("[area.adder]", "[area.ader]"), 7, "adder"},
      {with("[area.adder]", "[area.memory_byte]"), 7, "area.memory_byte"},
      {with("\"NAND2\"", "\"NAND3\""), 5, "NAND2"},
      {with("unit = \"NAND2\"\n", ""), 4, "unit"},
      {with("\"linear\"", "\"lineal\""), 8, "linear"},
      {with("\"linear\"", "\"product\""), 8, "two sizes"},
      {with("form = \"linear\"\n", ""), 7, "form"},
      {with("per_width", "per_with"), 9, "per_width"},
      {with("per_width = 7", "per_width = \"7\""), 9, "per_width"},
      {with("per_width = 7", "per_width = nan"), 9, "per_width"},
      {with("per_width = 7", "coefficient = 7"), 9, "coefficient"},
      {with("per_width = 7", ""), 7, "nothing"},
      {with("per_width = 7", "per_width = 0"), 7, "nothing"},
      {with("source = \"s\"", ""), 7, "source"},
      {with("accuracy = \"a\"", "accuracy = \"\""), 11, "accuracy"},
      {with("title", "titel"), 1, "title"},
      {with("[area]\nunit = \"NAND2\"\naccuracy = \"exact\"\n", "[area]\nunit = \"NAND2\"\n"), 4, "accuracy"},
      {with(adder, ""), 0, "prices nothing"},
      {area("[area.adder]\nform = \"excluded\"\n"), 7, "reason"},
      {area("adder = 7.9\n"), 7, "area.adder"},
      {head() + "energy = 3\n", 4, "energy"},
  };
  for (const Case& wrong : cases) {
    const ErrorText text = complaint(wrong.text);
    INFO(wrong.text << "\n" << text.what << " / " << text.why << " / " << text.try_this);
    CHECK(text.where.file == "t.toml");
    CHECK(text.where.line == wrong.line);
    CHECK((wrong.line == 0 || text.where.column > 0));
    CHECK((text.what + text.why + text.try_this).find(wrong.says) != std::string::npos);
  }
}

TEST_CASE("the shipped tables state source, technology and accuracy of every entry") {
  const PriceTable areas = read_price_table(shipped("osu018_model")), energies = read_price_table(shipped("horowitz45"));
  CHECK(areas.prices(Quantity::area));
  CHECK_FALSE(areas.prices(Quantity::energy));
  CHECK(energies.prices(Quantity::energy));
  CHECK_FALSE(energies.prices(Quantity::area));
  for (int i = 0; i < static_cast<int>(Component::count); ++i) {
    for (const Quantity quantity : {Quantity::area, Quantity::energy}) {
      const PriceEntry* entry = (quantity == Quantity::area ? areas : energies).find(quantity, static_cast<Component>(i));
      if (entry == nullptr) continue;
      INFO(name_of(static_cast<Component>(i)));
      if (entry->is_excluded()) {
        CHECK_FALSE(entry->reason.empty());
        continue;
      }
      CHECK_FALSE(entry->source.empty());
      CHECK_FALSE(entry->technology.empty());
      CHECK_FALSE(entry->accuracy.empty());
      CHECK(entry->at({12, 12, 1, 12}) > 0);
    }
  }
}

TEST_CASE("the shipped tables say what their sources say") {
  const PriceTable areas = read_price_table(shipped("osu018_model")), energies = read_price_table(shipped("horowitz45"));
  const auto area_of = [&](Component component, PriceSizes sizes) { return areas.find(Quantity::area, component)->at(sizes); };
  const auto energy_of = [&](Component component, PriceSizes sizes) { return energies.find(Quantity::energy, component)->at(sizes); };
  CHECK(area_of(Component::multiplier, {12, 12}) == Approx(1357).epsilon(0.005));
  CHECK(area_of(Component::multiplier, {16, 16}) == Approx(2400).epsilon(0.005));
  CHECK(area_of(Component::multiplier, {8, 8}) == Approx(594).epsilon(0.02));
  CHECK(area_of(Component::divider, {12, 12}) == Approx(10.4 * 144));
  CHECK(area_of(Component::table, {1024, 12, 1, 2661}) == Approx(1206).epsilon(0.11));
  CHECK(energy_of(Component::adder, {8}) == Approx(0.03).epsilon(1e-4));
  CHECK(energy_of(Component::adder, {32}) == Approx(0.1).epsilon(1e-4));
  CHECK(energy_of(Component::multiplier, {8, 8}) == Approx(0.2));
  CHECK(energy_of(Component::multiplier, {32, 32}) == Approx(3.1).epsilon(1e-4));
  CHECK(energy_of(Component::table, {1024, 64, 1}) == Approx(10));
  CHECK(energy_of(Component::table, {256, 16, 1}) == Approx(10 * 0.25 * 0.25));  // 512 bytes, a quarter of the word
  CHECK(energy_of(Component::cache_read, {32768}) == Approx(20));
}

TEST_CASE("each quantity comes from the first table that prices it") {
  std::vector<PriceTable> tables;
  for (const char* name : {"horowitz45", "osu018_model"}) tables.push_back(read_price_table(shipped(name)));
  tables.push_back(round_table());
  const PriceBook book = make_price_book(tables);
  REQUIRE(book.area == &tables[1]);
  REQUIRE(book.energy == &tables[0]);
  tables.pop_back();
  tables.pop_back();
  CHECK(make_price_book(tables).area == nullptr);
}

}  // namespace bump
