#include <catch2/catch.hpp>
#include <cmath>

#include "datapath/evaluate.h"
#include "datapath/table.h"
#include "random_netlist.h"

using namespace bump;
using namespace bump_test;

namespace {

/// Any folding, with an index of up to 34 bits and two columns of about half a 32-bit word. Contents change with every address.
Table table_of_two_columns(Random& random) {
  Table table;
  table.name = "ROM";
  table.folding = static_cast<Folding>(random.integer(0, 3));
  table.address_bits = random.integer(2, 9);
  const int width = random.integer(0, 1) == 0 ? random.integer(2, 20) : random.integer(21, 34);
  table.index = table.folding == Folding::quarter     ? turns(width)
                : table.folding == Folding::magnitude ? sfixed(width, width - 1)
                : table.folding == Folding::floating  ? ufixed(width, random.integer(0, width))
                : random.coin()                       ? sfixed(width, width - 1)
                                                      : ufixed(width, width);
  if (table.folding == Folding::floating) {
    table.exponent_bits = random.integer(0, std::min(5, table.address_bits));
    table.min_exponent = random.integer(-12, 3);
  }
  for (const char* name : {"first", "second"}) {
    Column column;
    column.name = name;
    const int bits = random.integer(14, 18);
    column.format = random.coin() ? sfixed(bits, bits - 1) : ufixed(bits, bits);
    const bool odd = random.coin() && column.format.is_signed;
    column.symmetry.odd_about_zero = odd && (table.folding == Folding::magnitude || (table.folding == Folding::quarter && random.coin()));
    column.symmetry.odd_about_quarter = odd && table.folding == Folding::quarter && !column.symmetry.odd_about_zero;
    const double phase = random.real(0, 100);
    column.function = [phase, odd](double x) {
      const double noise = 43758.5453 * std::sin(phase + 1234.5 * x);
      return odd ? noise - std::floor(noise) : 2 * (noise - std::floor(noise)) - 1;
    };
    table.columns.push_back(column);
  }
  return table;
}

}  // namespace

TEST_CASE("ROM reads by words of any width give what a single look-up gives") {
  Random random(16);
  int packed = 0, saturated = 0;
  for (int round = 0; round < 2000; ++round) {
    const auto table = std::make_shared<const Table>(table_of_two_columns(random));
    const TableContents contents = tabulate(*table);
    Netlist n("reads");
    const std::vector<Wire> columns = n.table("ROM", table, n.input("index", table->index));
    const bool both = random.integer(0, 3) != 0;
    n.output("first", columns[0]);
    if (both) n.output("second", columns[1]);
    packed += both && table->stored_width(table->columns[0]) <= 16 && table->stored_width(table->columns[1]) <= 16 ? 1 : 0;
    constexpr int lanes = 33;
    std::vector<double> index, first(lanes), second(lanes);
    for (int i = 0; i < lanes; ++i) {
      // All magnitudes alike: a leading one anywhere, and words just below a power of two.
      const std::int64_t low = table->index.is_signed ? -(std::int64_t{1} << (table->index.width - 1)) : 0;
      const int bits = random.integer(0, table->index.width - (table->index.is_signed ? 1 : 0));
      std::int64_t word = static_cast<std::int64_t>(random.bits() >> 1) & ((std::int64_t{1} << bits) - 1);
      if (random.integer(0, 3) == 0) word = ((std::int64_t{1} << bits) - 1) & ~std::int64_t{random.integer(0, 3)};
      if (table->index.is_signed && random.coin()) word = -1 - word;
      if (random.integer(0, 9) == 0) word = low;
      index.push_back(to_double(word, table->index));
    }
    const double* in[] = {index.data()};
    double* out[] = {first.data(), second.data()};
    const auto evaluator = make_evaluator(n, Arithmetic::fixed);
    evaluator->evaluate(in, lanes, out);
    for (int i = 0; i < lanes; ++i) {
      const IndexWords word{quantise(index[static_cast<std::size_t>(i)], table->index)};
      const double expected[] = {to_double(look_up(*table, contents, 0, word), table->columns[0].format),
                                 to_double(look_up(*table, contents, 1, word), table->columns[1].format)};
      INFO("folding " << static_cast<int>(table->folding) << ", index " << to_string(table->index) << " word " << word[0] << ", columns "
                      << to_string(table->columns[0].format) << " and " << to_string(table->columns[1].format));
      REQUIRE(first[static_cast<std::size_t>(i)] == expected[0]);
      if (both) REQUIRE(second[static_cast<std::size_t>(i)] == expected[1]);
      saturated += address_of(*table, word).address == table->entries() - 1 ? 1 : 0;
    }
  }
  CHECK(packed > 200);
  CHECK(saturated > 1000);
}
