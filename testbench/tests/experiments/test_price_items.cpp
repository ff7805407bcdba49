// Netlists as components, and their pipeline registers, against counts by hand.

#include <catch2/catch.hpp>

#include "datapath/schedule.h"
#include "price_bench.h"
#include "testbench/experiments/price.h"

namespace bump {
namespace {

struct Expected {
  Component component;
  PriceSizes size;
  double count;
};

void check(const std::vector<PriceItem>& items, const std::vector<Expected>& expected) {
  const std::vector<PriceItem> found = merged(items);
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    INFO(name_of(found[i].component) << " of " << found[i].node);
    CHECK(found[i].component == expected[i].component);
    PriceSizes size = found[i].size;
    if (group_of(found[i].component) == CostGroup::tables) size[3] = 0;  // what is in the words has tests of its own
    CHECK(size == expected[i].size);
    CHECK(found[i].count == expected[i].count);
  }
}

TablePtr table(Folding folding, const Format& index, int address_bits, const std::vector<Column>& columns) {
  Table t;
  t.name = "T";
  t.index = index;
  t.folding = folding;
  t.address_bits = address_bits;
  t.columns = columns;
  return std::make_shared<const Table>(t);
}

Column column(const std::string& name, const Format& format) {
  Column c;
  c.name = name;
  c.function = [](double x) { return x * x; };
  c.format = format;
  return c;
}

}  // namespace

TEST_CASE("a product and a sum cost what the sum by hand says") {
  Netlist n("unit");
  const Wire a = n.input("a", sfixed(8, 6)), b = n.input("b", sfixed(10, 6)), c = n.input("c", sfixed(18, 12));
  n.output("y", n.add("y", n.mul("m", a, b, sfixed(18, 12)), c, sfixed(19, 12)));
  check(built_items(n, nullptr), {{Component::adder, {19}, 1}, {Component::multiplier, {8, 10}, 1}});

  const Schedule s = schedule(n, {});
  REQUIRE(s.latency == 2);
  const RegisterBits bits = pipeline_registers(n, s);
  CHECK(bits.between == 18 + 18 + 19);  // the product and c at the first boundary, the sum at the second
  CHECK(bits.inside == 0);

  std::vector<PriceItem> items = built_items(n, &s);
  items.push_back({Component::register_bits, {}, static_cast<double>(bits.total()), false, ""});
  const PriceTable prices = round_table();
  const CostSheet sheet = price_items(items, prices, Quantity::area, "unit");
  CHECK(sheet.total() == 10 * 19 + 10 * 8 * 10 + 4 * 55);
  CHECK(sheet.of(CostGroup::adders) == 190);
  CHECK(sheet.of(CostGroup::registers) == 220);
  CHECK(sheet.additions() == 0);
}

TEST_CASE("an adder is as wide as the columns in which it has work") {
  struct Case {
    Format a, b, result;
    bool sub;
    int width;
  };
  const Case cases[] = {
      {sfixed(12, 10), sfixed(12, 10), sfixed(13, 10), false, 13},
      {sfixed(12, 10), sfixed(12, 10), sfixed(12, 10), false, 12},  // the carry is dropped
      {sfixed(12, 10), sfixed(12, 10), sfixed(20, 10), false, 13},  // above, the sign is repeated
      {sfixed(12, 10), sfixed(8, 6), sfixed(13, 10), false, 9},     // four low bits pass
      {sfixed(12, 10), sfixed(8, 6), sfixed(13, 10), true, 9},      // of the minuend, too
      {sfixed(8, 6), sfixed(12, 10), sfixed(13, 10), true, 13},     // but not of the subtrahend
      {sfixed(12, 10), sfixed(12, 10), sfixed(7, 4), false, 13},    // bits that are cut off carry
      {turns(10), turns(10), turns(10), false, 10},
  };
  for (const Case& one : cases) {
    Netlist n("unit");
    const Wire a = n.input("a", one.a), b = n.input("b", one.b);
    n.output("y", one.sub ? n.sub("y", a, b, one.result) : n.add("y", a, b, one.result));
    INFO(to_string(one.a) << " " << to_string(one.b) << " " << to_string(one.result) << " " << one.sub);
    check(built_items(n, nullptr), {{Component::adder, {static_cast<double>(one.width)}, 1}});
  }
}

TEST_CASE("squarers and constants of the structure are cases of their own, constants of the material are not") {
  Netlist n("unit");
  const Wire x = n.input("x", sfixed(9, 7)), k = n.constant("k", 0.25, sfixed(6, 4));
  n.output("square", n.mul("square", x, x, sfixed(18, 14)));
  n.output("scaled", n.mul("scaled", x, n.shift("k_shifted", k, 1, sfixed(7, 4)), sfixed(16, 11)));
  n.output("raised", n.add("raised", x, k, sfixed(10, 7)));
  n.output("turned", n.add_sub("turned", n.is_negative("sign", x), x, k, sfixed(10, 7)));
  check(built_items(n, nullptr), {{Component::constant_adder, {7}, 1},
                                  {Component::constant_adder_subtractor, {7}, 1},
                                  {Component::squarer, {9, 9}, 1},
                                  {Component::constant_multiplier, {9, 7}, 1}});
  Netlist other("unit");
  const Wire y = other.input("x", sfixed(9, 7)), l = other.constant("k", 0.5, sfixed(6, 4));
  other.output("square", other.mul("square", y, y, sfixed(18, 14)));
  other.output("scaled", other.mul("scaled", y, other.shift("k_shifted", l, 1, sfixed(7, 4)), sfixed(16, 11)));
  other.output("raised", other.add("raised", y, l, sfixed(10, 7)));
  other.output("turned", other.add_sub("turned", other.is_negative("sign", y), y, l, sfixed(10, 7)));
  ItemOptions options;
  options.settable = differing_constants(n, other);
  check(built_items(n, nullptr, options), {{Component::adder, {7}, 1},
                                           {Component::adder_subtractor, {7}, 1},
                                           {Component::multiplier, {9, 7}, 1},
                                           {Component::squarer, {9, 9}, 1}});
}

TEST_CASE("divisions, roots, selections, shifters and clamps have the sizes of their arrays") {
  Netlist n("unit");
  const Wire a = n.input("a", sfixed(12, 10)), b = n.input("b", ufixed(11, 10)), k = n.input("k", ufixed(3, 0));
  n.output("quotient", n.div("quotient", a, b, sfixed(9, 8)));
  n.output("root", n.sqrt("root", b, ufixed(7, 6)));
  n.output("clamped", n.clamp("clamped", a, -1, 1, sfixed(12, 10)));
  n.output("chosen", n.select("chosen", n.is_negative("sign", a), n.negate("minus", a, sfixed(13, 10)), a, sfixed(13, 10)));
  n.output("shifted", n.shift_by("shifted", a, k, sfixed(12, 10)));
  n.output("either", n.add_sub("either", n.is_negative("sign2", a), a, a, sfixed(13, 10)));
  check(built_items(n, nullptr), {{Component::adder_subtractor, {13}, 1},
                                  {Component::divider, {8, 11}, 1},
                                  {Component::square_root, {7, 7}, 1},
                                  {Component::clamp, {12}, 1},
                                  {Component::select, {13}, 1},
                                  {Component::negate, {13}, 1},
                                  {Component::shifter, {12, 3}, 1}});
}

TEST_CASE("a table is its stored bits, further ports and the sign work of its folding") {
  Column sine = column("sin", sfixed(9, 8)), cosine = column("cos", sfixed(9, 8));
  sine.symmetry.odd_about_zero = true;
  cosine.symmetry.odd_about_quarter = true;
  {
    Netlist n("unit");
    const TablePtr folded = table(Folding::quarter, turns(10), 6, {sine, cosine});
    for (const Wire& wire : n.table("T", folded, n.input("x", turns(10)))) n.output("y" + std::to_string(wire.node), wire);
    for (const Wire& wire : n.second_port("again", folded, n.input("x2", turns(10)))) n.output("y" + std::to_string(wire.node), wire);
    check(built_items(n, nullptr), {{Component::negate, {8}, 2 + 4},  // both indices and four columns
                                    {Component::table, {64, 16, 2}, 1},
                                    {Component::second_port, {64, 16, 2}, 1}});
  }
  {
    Netlist n("unit");
    cosine.mirrors_first = true;
    n.output("y", n.table("T", table(Folding::quarter, turns(10), 6, {sine, cosine}), n.input("x", turns(10))).front());
    check(built_items(n, nullptr),
          {{Component::negate, {8}, 3}, {Component::table, {64, 8, 1}, 1}, {Component::second_port, {64, 8, 1}, 1}});
  }
  {
    Netlist n("unit");
    Table floating = *table(Folding::floating, ufixed(16, 14), 7, {column("y", ufixed(10, 8))});
    floating.exponent_bits = 3;
    floating.min_exponent = -7;
    floating.per_material = true;
    n.output("y", n.table("T", std::make_shared<const Table>(floating), n.input("x", ufixed(16, 14))).front());
    ItemOptions options;
    options.materials = 3;
    check(built_items(n, nullptr, options), {{Component::index_encoder, {8, 4}, 1}, {Component::table, {128, 10, 1}, 3}});
  }
}

TEST_CASE("shared multipliers are as wide as their widest products, with selects in front") {
  Netlist n("unit");
  const Wire a = n.input("a", sfixed(8, 6)), b = n.input("b", sfixed(12, 6)), c = n.input("c", sfixed(10, 6));
  n.output("x", n.mul("x", a, a, sfixed(16, 12)));
  n.output("y", n.mul("y", a, b, sfixed(20, 12)));
  n.output("z", n.mul("z", c, c, sfixed(20, 12)));
  const Schedule s = schedule(n, {}, 1);
  REQUIRE(s.initiation_interval == 3);
  check(built_items(n, &s), {{Component::multiplier, {10, 12}, 1}, {Component::select, {10}, 2}, {Component::select, {12}, 2}});
  check(executed_items(n), {{Component::multiplier, {8, 12}, 1}, {Component::squarer, {8, 8}, 1}, {Component::squarer, {10, 10}, 1}});
}

TEST_CASE("sharing never takes more area in multipliers than building all") {
  Netlist n("unit");
  std::vector<Wire> inputs;
  for (int i = 0; i < 7; ++i) inputs.push_back(n.input("i" + std::to_string(i), sfixed(6 + i, 4)));
  for (std::size_t i = 0; i < 6; ++i)
    n.output("o" + std::to_string(i), n.mul("m" + std::to_string(i), inputs[i], inputs[i + 1], sfixed(20, 8)));
  const PriceTable prices = round_table();
  double last = 0;
  for (int limit = 1; limit <= 6; ++limit) {
    const Schedule s = schedule(n, {}, limit);
    const CostSheet sheet = price_items(built_items(n, &s), prices, Quantity::area, "unit");
    double built = 0;
    for (const PricedItem& item : sheet.items)
      if (group_of(item.item.component) == CostGroup::multipliers) built += item.item.count;
    CHECK(built == s.multipliers_built);
    CHECK(sheet.of(CostGroup::multipliers) >= last);
    last = sheet.of(CostGroup::multipliers);
  }
}

TEST_CASE("edges without a format are floating point, or fixed-point words of a width") {
  Netlist n("vertex");
  const Wire a = n.input("a", real()), b = n.input("b", real());
  const Wire sum = n.add("sum", n.mul("m", a, b, real()), b, real());
  n.output("y", n.div("y", sum, n.clamp("c", n.sqrt("r", sum, real()), 0.1, 2, real()), real()));
  check(executed_items(n), {{Component::float_adder, {}, 2},  // the clamp compares
                            {Component::float_multiplier, {}, 1},
                            {Component::float_divider, {}, 1},
                            {Component::float_square_root, {}, 1}});
  ItemOptions options;
  options.real_bits = 16;
  check(executed_items(n, options), {{Component::adder, {16}, 1},
                                     {Component::multiplier, {16, 16}, 1},
                                     {Component::divider, {16, 16}, 1},
                                     {Component::square_root, {16, 16}, 1},
                                     {Component::clamp, {16}, 1}});
}

TEST_CASE("values are held from where they are available to where they are last read") {
  Netlist n("unit");
  const Wire a = n.input("a", sfixed(8, 6)), b = n.input("b", sfixed(8, 6));
  Wire chain = n.add("s0", a, b, sfixed(8, 6));
  for (int i = 1; i < 4; ++i) chain = n.add("s" + std::to_string(i), chain, chain, sfixed(8, 6));  // each doubles
  n.output("y", n.add("y", chain, b, sfixed(8, 6)));
  n.output("flag", n.is_negative("flag", a));
  const Schedule s = schedule(n, {});
  REQUIRE(s.latency == 5);
  // s0 .. s3 and y at one boundary each, b at the four in front of y, of a the sign at all five.
  CHECK(pipeline_registers(n, s).between == 5 * 8 + 4 * 8 + 5 * 1);
  // Two cycles for each token: a register serves two boundaries.
  Schedule slow = s;
  slow.initiation_interval = 2;
  CHECK(pipeline_registers(n, slow).between == 5 * 8 + 2 * 8 + 3 * 1);
  CHECK(clocked_registers(n, slow).between == 5 * 8 + 4 * 8 + 5 * 1);
}

TEST_CASE("parts of a value are never more than the value, and views of it are not held twice") {
  Netlist n("unit");
  const Wire a = n.input("a", sfixed(12, 10)), b = n.input("b", sfixed(12, 10));
  const Wire late = n.add("late", n.add("early", b, b, sfixed(12, 10)), b, sfixed(12, 10));
  n.output("y", n.add("y", late, n.negate("minus", a, sfixed(12, 10)), sfixed(12, 10)));
  n.output("z", n.add("z", late, n.shift("high", a, 0, sfixed(6, 4)), sfixed(12, 10)));
  const Schedule s = schedule(n, {});
  REQUIRE(s.latency == 3);
  // a at two boundaries as a whole (12, not 12 + 6), b at one, early, late, y, z at one each.
  CHECK(pipeline_registers(n, s).between == 2 * 12 + 12 + 12 + 12 + 12 + 12);
}

TEST_CASE("operators of several cycles hold their state, and words may be carried past") {
  Netlist n("unit");
  const Wire a = n.input("a", sfixed(12, 10)), b = n.input("b", ufixed(11, 10));
  n.output("q", n.div("q", a, b, sfixed(9, 8)));
  const Schedule s = schedule(n, {});
  REQUIRE(s.latency == 8);
  const RegisterBits bits = pipeline_registers(n, s);
  // Sign, one too large, divisor, remainder, and the quotient bits found so far; |a| is shifted past all rows at once.
  CHECK(bits.inside == 7 * (1 + 1 + 11 + 11) + (1 + 2 + 3 + 4 + 5 + 6 + 7));
  CHECK(bits.between == 9);
  CHECK(pipeline_registers(n, s, {{"tag", 5}}).carried == 8 * 5);
  CHECK(pipeline_registers(n, s, {{"b", 11}}).carried == 8 * 11);  // read at once, so nothing is held for the unit itself
  OperatorLatencies quick;
  quick.divider_bits_per_cycle = 8;
  CHECK(pipeline_registers(n, schedule(n, quick)).inside == 0);
}

TEST_CASE("constants and wiring take no registers, nor does a unit without latency") {
  Netlist n("unit");
  const Wire a = n.input("a", sfixed(8, 6));
  const Wire x = n.add("x", a, n.constant("one", 1, sfixed(8, 6)), sfixed(9, 6));
  n.output("y", n.add("y", n.shift("half", x, -1, sfixed(9, 7)), n.constant("two", 1, sfixed(8, 6)), sfixed(10, 7)));
  CHECK(pipeline_registers(n, schedule(n, {})).total() == 9 + 10);
  OperatorLatencies none;
  none.adder = 0;
  CHECK(pipeline_registers(n, schedule(n, none)).total() == 0);
}

}  // namespace bump
