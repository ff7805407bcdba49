#include <array>
#include <catch2/catch.hpp>

#include "datapath/evaluate.h"
#include "datapath/real_power.h"
#include "datapath/real_tables.h"
#include "datapath/real_turns.h"
#include "ulp.h"

using namespace bump;
using namespace bump_test;

namespace {

using Plane = std::array<double, block_lanes>;
constexpr double two_pi = 6.283185307179586476925;

struct Known {
  const char* name;
  BlockFunction block;
  std::vector<double (*)(double)> columns;  ///< by the C library
  double lowest, highest;
};

std::vector<Known> all_tables() {
  using namespace real_tables;
  constexpr auto sin_of = [](double x) { return std::sin(two_pi * x); };
  constexpr auto cos_of = [](double x) { return std::cos(two_pi * x); };
  constexpr auto atan_of = [](double x) { return std::atan(x) / two_pi; };
  return {{"sine_cosine", sine_cosine(), {sin_of, cos_of}, -2, 2},
          {"sine", sine(), {sin_of}, -2, 2},
          {"cosine", cosine(), {cos_of}, -2, 2},
          {"cosine_half_squared", cosine_half_squared(), {[](double x) { return 0.5 + 0.5 * std::cos(two_pi * x); }}, -2, 2},
          {"arc_sine", arc_sine(), {[](double x) { return std::asin(std::fmax(-1, std::fmin(1, x))) / two_pi; }}, -1.5, 1.5},
          {"arc_sine, scaled", arc_sine(4, 0), {[](double x) { return std::asin(std::fmax(0, std::fmin(1, x))) * 4 / two_pi; }}, -1.5, 1.5},
          {"arc_cosine", arc_cosine(), {[](double x) { return std::acos(std::fmin(1, std::fabs(x))) / two_pi; }}, -1.5, 1.5},
          {"arc_tangent", arc_tangent(), {atan_of}, -8, 8},
          {"arc_tangent_and_code", arc_tangent_and_code(60), {atan_of, [](double x) { return 60 * std::atan(x) / two_pi; }}, -8, 8},
          {"proportion", proportion(0.7), {[](double x) { return 0.7 * x; }}, -2, 2},
          {"scaled_power", scaled_power(0.5, 30.5), {[](double x) { return x > 0 ? 0.5 * std::pow(x, 30.5) : 0; }}, -0.5, 1},
          {"reciprocal", reciprocal(0x1p-10), {[](double x) { return 1 / std::fmax(x, 0x1p-10); }}, -1, 2},
          {"reciprocal_root", reciprocal_root(0x1p-7), {[](double x) { return 1 / std::sqrt(std::fmax(x, 0x1p-7)); }}, -1, 2}};
}

std::vector<std::int64_t> bits_of(const double* values, int lanes) {
  std::vector<std::int64_t> bits;
  for (int i = 0; i < lanes; ++i) bits.push_back(bits_from_double(values[i]));
  return bits;
}

#define BUMP_TEST_WIDTH(attribute, suffix)                                                              \
  attribute void every_function_##suffix(const double* __restrict x, double* __restrict y, int count) { \
    for (int i = 0; i < count; ++i) y[i] = sine_cosine_of_turns(x[i]).sine;                             \
    for (int i = 0; i < count; ++i) y[count + i] = sine_cosine_of_turns(x[i]).cosine;                   \
    for (int i = 0; i < count; ++i) y[2 * count + i] = arc_sine_in_turns(x[i]);                         \
    for (int i = 0; i < count; ++i) y[3 * count + i] = arc_cosine_of_magnitude_in_turns(x[i]);          \
    for (int i = 0; i < count; ++i) y[4 * count + i] = arc_tangent_in_turns(x[i]);                      \
    for (int i = 0; i < count; ++i) y[5 * count + i] = arc_tangent_in_turns(x[i], x[count - 1 - i]);    \
    for (int i = 0; i < count; ++i) y[6 * count + i] = power(std::fabs(x[i]), 30);                      \
    for (int i = 0; i < count; ++i) y[7 * count + i] = power(std::fabs(x[i]), -x[count - 1 - i]);       \
  }
BUMP_TEST_WIDTH(, of_baseline)
#if defined(__x86_64__)
BUMP_TEST_WIDTH(__attribute__((target("avx2"))), of_avx2)
bool has_avx2() {
  return __builtin_cpu_supports("avx2") != 0;
}
#else
BUMP_TEST_WIDTH(, of_avx2)
bool has_avx2() {
  return false;
}
#endif

}  // namespace

TEST_CASE("the block functions of tables agree with the C library") {
  Random random(1);
  for (const Known& table : all_tables()) {
    Plane x{}, first{}, second{};
    for (int turn = 0; turn < 20; ++turn) {
      for (double& value : x) value = random.real(table.lowest, table.highest);
      const double* in[] = {x.data()};
      double* out[] = {first.data(), second.data()};
      table.block(in, out, block_lanes);
      for (int i = 0; i < block_lanes; ++i)
        for (std::size_t column = 0; column < table.columns.size(); ++column) {
          INFO(table.name << " of " << x[i]);
          REQUIRE(out[column][i] == Approx(table.columns[column](x[i])).epsilon(1e-14).margin(1e-14));
        }
    }
  }
}

TEST_CASE("a lane's bits depend neither on its place in a block nor on the length of the block") {
  Random random(2);
  for (const Known& table : all_tables()) {
    INFO(table.name);
    const std::size_t columns = table.columns.size();
    Plane x{}, first{}, second{};
    for (double& value : x) value = random.real(table.lowest, table.highest);
    const double* in[] = {x.data()};
    double* out[] = {first.data(), second.data()};
    table.block(in, out, block_lanes);
    for (int start = 0; start < block_lanes; start += random.integer(1, 9))
      for (const int lanes : {1, 2, 3, 5, 8, 13}) {
        if (start + lanes > block_lanes) continue;
        Plane a{}, b{};
        const double* in_part[] = {x.data() + start};
        double* out_part[] = {a.data(), b.data()};
        table.block(in_part, out_part, lanes);
        for (std::size_t column = 0; column < columns; ++column)
          REQUIRE(bits_of(out_part[column], lanes) == bits_of(out[column] + start, lanes));
      }
  }
}

TEST_CASE("loops for AVX2 and for any machine of the architecture give the same bits, as does a lane by itself") {
  Random random(3);
  const std::vector<double> x = delicate_values(random, 0x1p47, 8000);
  const int count = static_cast<int>(x.size());
  std::vector<double> baseline(8 * x.size()), other(8 * x.size());
  every_function_of_baseline(x.data(), baseline.data(), count);
  if (has_avx2()) {
    every_function_of_avx2(x.data(), other.data(), count);
    CHECK(bits_of(other.data(), 8 * count) == bits_of(baseline.data(), 8 * count));
  }
  bool same = true;
  for (int i = 0; i < count; ++i) {
    double one[8];
    every_function_of_baseline(&x[i], one, 1);
    for (const int function : {0, 1, 2, 3, 4, 6})
      same = same && bits_from_double(one[function]) == bits_from_double(baseline[function * count + i]);
  }
  CHECK(same);
}

TEST_CASE("tables with a block function give its values in every lane, and their columns wrap as others do") {
  Table table;
  table.name = "TURN";
  table.index = turns(10);
  table.address_bits = 8;
  Column once, twice;
  once.name = "once";
  once.function = [](double x) { return x + 0.75; };
  once.format = turns(12);
  twice.name = "twice";
  twice.function = [](double x) { return 2 * x; };
  twice.format = sfixed(14, 10);
  table.columns = {once, twice};
  table.block = [](const double* const* x, double* const* y, int lanes) {
    for (int i = 0; i < lanes; ++i) {
      y[0][i] = x[0][i] + 0.75;
      y[1][i] = 2 * x[0][i];
    }
  };
  Netlist n("unit");
  const auto wires = n.table("t", std::make_shared<const Table>(table), n.input("x", real()));
  n.output("half", n.shift("half", wires[1], -1, sfixed(16, 12)));  // the first column is read by nobody
  const auto evaluator = make_evaluator(n, Arithmetic::real);
  Plane x{}, half{};
  for (int i = 0; i < block_lanes; ++i) x[i] = (i - 100) / 64.0;
  const double* in[] = {x.data()};
  double* out[] = {half.data()};
  evaluator->evaluate(in, block_lanes, out);
  for (int i = 0; i < block_lanes; ++i) {
    const double wrapped = x[i] - std::floor(x[i] + 0.5), sum = wrapped + 0.75;
    REQUIRE(half[i] == wrapped);
    REQUIRE(evaluator->value(wires[0].node, i) == sum - std::floor(sum + 0.5));
    REQUIRE(evaluator->value(wires[1].node, i) == 2 * wrapped);
  }
}

TEST_CASE("a map's index values reach its block function brought to one turn, as its columns' functions") {
  Table map;
  map.name = "MAP";
  map.index = turns(6);
  map.address_bits = 4;
  map.fields = {{turns(6), 3}, {sfixed(8, 6), 2}};
  Column column;
  column.name = "sum";
  column.map_function = [](const double* x) { return x[0] + 10 * x[1] + 100 * x[2]; };
  column.format = sfixed(16, 6);
  map.columns = {column};
  Table with_block = map;
  with_block.block = [](const double* const* x, double* const* y, int lanes) {
    for (int i = 0; i < lanes; ++i) y[0][i] = x[0][i] + 10 * x[1][i] + 100 * x[2][i];
  };
  Random random(5);
  Plane a{}, b{}, c{};
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = random.real(-3, 3), b[i] = random.real(-3, 3), c[i] = random.real(-1, 1);
  std::vector<Plane> results;
  for (const Table& table : {map, with_block}) {
    Netlist n("unit");
    const std::vector<Wire> index{n.input("a", real()), n.input("b", real()), n.input("c", sfixed(8, 6))};
    n.output("sum", n.table("m", std::make_shared<const Table>(table), index).front());
    Plane sum{};
    const double* in[] = {a.data(), b.data(), c.data()};
    double* out[] = {sum.data()};
    make_evaluator(n, Arithmetic::real)->evaluate(in, block_lanes, out);
    results.push_back(sum);
  }
  CHECK(results[0] == results[1]);
}
