#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "luts/rom_image.h"
#include "rtl/table_module.h"
#include "testbench/program/configure.h"
#include "testbench/program/rom_sources.h"
#include "verilog_tools.h"

using namespace bump;
using namespace bump_test;
using Catch::Contains;

namespace {

Format random_format(std::mt19937_64& random, int low, int high) {
  const int width = integer(random, low, high), fraction = integer(random, -2, width);
  return integer(random, 0, 1) == 0 ? sfixed(width, fraction) : ufixed(width, fraction);
}

/// Some function of all index values that uses the whole range of the words; not negative where folding supplies the sign.
double some_function(const double* x, int words, bool is_odd, int salt) {
  double sum = salt;
  for (int i = 0; i < words; ++i) sum += (3.7 + i) * x[i];
  return is_odd ? std::fabs(std::sin(sum)) * 40 : std::sin(sum) * 40;
}

Table random_table(std::mt19937_64& random, Folding folding, int widest) {
  Table table;
  table.name = "T";
  table.formula = "some function";
  table.folding = folding;
  const int fields = folding == Folding::floating || integer(random, 0, 2) > 0 ? 0 : integer(random, 1, 2);
  const int width = integer(random, folding == Folding::magnitude || folding == Folding::quarter ? 2 : 1, widest);
  table.address_bits = integer(random, 1, fields == 0 ? 8 : 4);
  table.index = folding == Folding::quarter     ? turns(width)
                : folding == Folding::magnitude ? sfixed(width, integer(random, 0, width))
                : folding == Folding::floating  ? ufixed(width, integer(random, -4, width + 6))
                                                : random_format(random, width, width);
  if (folding == Folding::floating) {
    table.exponent_bits = integer(random, 0, std::min(5, table.address_bits));
    table.min_exponent = integer(random, -14, 6);
  }
  for (int i = 0; i < fields; ++i) table.fields.push_back({random_format(random, 1, widest / 2), integer(random, 1, 3)});
  const bool folds = folding == Folding::magnitude || folding == Folding::quarter;
  for (int i = 0; i < integer(random, 1, 4); ++i) {
    Column column;
    column.name = "column" + std::to_string(i);
    column.symmetry = {integer(random, 0, 1) == 1, integer(random, 0, 1) == 1};
    const bool is_odd = folds && (column.symmetry.odd_about_zero || (folding == Folding::quarter && column.symmetry.odd_about_quarter));
    column.format = is_odd ? sfixed(integer(random, 2, 12), 3) : random_format(random, 1, 12);
    if (i > 0 && fields == 0 && folding != Folding::floating && integer(random, 0, 2) == 0) {
      const Symmetry symmetry = column.symmetry;
      column = table.columns.front();
      column.name = "mirrored" + std::to_string(i);
      column.mirrors_first = true;
      // Another sign, if the first column's word has none of its own.
      const bool first_is_odd = table.stored_width(column) < column.format.width;
      if (first_is_odd && is_odd) column.symmetry = symmetry;
    } else if (fields == 0) {
      column.function = [is_odd, i](double x) { return some_function(&x, 1, is_odd, i); };
    } else {
      column.map_function = [is_odd, i, fields](const double* x) { return some_function(x, fields + 1, is_odd, i); };
    }
    table.columns.push_back(column);
  }
  return table;
}

/// A reader with its ROM; expected words of each port are those of look_up.
void add(IcarusBench& bench, const std::string& scheme, const Table& table, int ports, int stages, std::size_t most,
         std::mt19937_64& random) {
  const TableContents contents = tabulate(table);
  const TableModules modules = table_modules(scheme, table, contents, ports, stages);
  bench.add(modules.reader);
  bench.add(modules.rom);
  bench.add_file(modules.rom_file, modules.rom_text);
  Device device;
  device.name = modules.reader.name;
  device.stages = stages;
  const auto words = static_cast<std::size_t>(table.index_words());
  for (int port = 0; port < ports; ++port) {
    for (std::size_t i = 0; i < words; ++i)
      device.inputs.push_back({"i" + std::to_string(i) + "_" + std::to_string(port), i == 0 ? table.index : table.fields[i - 1].index});
    for (std::size_t k = 0; k < table.columns.size(); ++k)
      device.outputs.push_back({"c" + std::to_string(k) + "_" + std::to_string(port), table.columns[k].format});
  }
  device.vectors = words_for(device.inputs, most, random);
  for (const PortWords& vector : device.vectors) {
    PortWords expected;
    for (std::size_t port = 0; port < static_cast<std::size_t>(ports); ++port) {
      IndexWords index{};
      std::copy_n(vector.begin() + static_cast<std::ptrdiff_t>(port * words), words, index.begin());
      for (std::size_t k = 0; k < table.columns.size(); ++k) expected.push_back(look_up(table, contents, k, index));
    }
    device.expected.push_back(std::move(expected));
  }
  bench.add(std::move(device));
}

}  // namespace

TEST_CASE("a table's Verilog reads the words of the evaluator, for every index of narrow formats and all foldings") {
  if (!is_there("iverilog")) return;
  std::mt19937_64 random(7);
  IcarusBench bench;
  for (int i = 0; i < 120; ++i) {
    const Table table = random_table(random, static_cast<Folding>(i % 4), 10);
    add(bench, "random" + std::to_string(i), table, 1, i % 5 == 0 ? integer(random, 1, 4) : 0, 1024, random);
  }
  CHECK(bench.mismatches() == "");
  if (is_there("verilator")) CHECK(lint(bench.modules()) == "");
}

TEST_CASE("a table's Verilog reads the words of the evaluator by two ports, for wide indices and any number of stages") {
  if (!is_there("iverilog")) return;
  std::mt19937_64 random(8);
  IcarusBench bench;
  for (int i = 0; i < 80; ++i) {
    const Table table = random_table(random, static_cast<Folding>(i % 4), i % 8 < 4 ? 24 : 40);
    add(bench, "random" + std::to_string(i), table, 2, integer(random, 0, 4), 200, random);
  }
  CHECK(bench.mismatches() == "");
  if (is_there("verilator")) CHECK(lint(bench.modules()) == "");
}

TEST_CASE("the tables of all schemes read the words of the evaluator and pass lint") {
  if (!is_there("iverilog")) return;
  std::mt19937_64 random(9);
  IcarusBench bench;
  std::set<std::string> known;
  for (const RomSource& source : rom_sources(configure({}, {}))) {
    const bool is_real = source.table->index.is_real || source.table->columns.front().format.is_real;
    if (is_real || !known.insert(source.scheme + "_" + source.table->name).second) continue;
    const int number = static_cast<int>(known.size());
    add(bench, source.scheme, *source.table, 1 + number % 2, number % 3, 100, random);
  }
  CHECK(known.size() > 20);
  CHECK(bench.mismatches() == "");
  if (is_there("verilator")) CHECK(lint(bench.modules()) == "");
}

TEST_CASE("a ROM has a read for each port and another for each port's mirrored columns") {
  Table table;
  table.name = "SC";
  table.index = turns(8);
  table.folding = Folding::quarter;
  table.address_bits = 6;
  Column sine;
  sine.name = "sin";
  sine.format = sfixed(8, 6);
  sine.function = [](double x) { return std::sin(6.283185307179586 * x); };
  sine.symmetry.odd_about_zero = true;
  Column cosine = sine;
  cosine.name = "cos";
  cosine.symmetry = {false, true};
  cosine.mirrors_first = true;
  table.columns = {sine, cosine};
  const TableContents contents = tabulate(table);
  const TableModules one = table_modules("demo", table, contents, 1, 0), two = table_modules("demo", table, contents, 2, 2);
  CHECK(one.reader.name == "table_demo_SC");
  CHECK(one.rom.name == "rom_demo_SC");
  CHECK(two.reader.name == "table_demo_SC_p2_n2");
  CHECK(two.rom.name == "rom_demo_SC_p2");
  CHECK(one.rom_file == "rom/demo_SC.hex");
  CHECK(two.rom_file == one.rom_file);
  CHECK(two.rom_text == rom_image(table, contents));
  CHECK_THAT(one.rom.text, Contains("address_1") && !Contains("address_2"));
  CHECK_THAT(two.rom.text, Contains("address_3") && !Contains("address_4"));
  CHECK_THAT(one.reader.text, !Contains("clk"));
}
