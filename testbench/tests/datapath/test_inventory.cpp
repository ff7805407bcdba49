#include <catch2/catch.hpp>

#include "datapath/duplicates.h"
#include "datapath/inventory.h"
#include "datapath/vertex_program.h"
#include "random_netlist.h"

using namespace bump;
using namespace bump_test;

namespace {

TablePtr rom(const std::string& name, Folding folding) {
  Table t;
  t.name = name;
  t.folding = folding;
  t.index = ufixed(8, 8);
  t.address_bits = 5;
  t.exponent_bits = 2;
  Column c;
  c.name = "y";
  c.function = [](double x) { return x; };
  c.format = sfixed(10, 8);
  t.columns.push_back(c);
  return std::make_shared<const Table>(t);
}

TablePtr map_of(const Format& second) {
  Table t = *rom("M", Folding::none);
  t.fields = {{second, 3}};
  t.columns.front().function = nullptr;
  t.columns.front().map_function = [](const double* x) { return x[0] * x[1]; };
  return std::make_shared<const Table>(t);
}

}  // namespace

TEST_CASE("an inventory counts what was recorded, published design and addition apart") {
  Netlist n("unit");
  const Wire a = n.input("a", ufixed(8, 8)), b = n.input("b", ufixed(8, 8)), t = n.input("t", turns(8));
  const Format s = sfixed(12, 8);
  const TablePtr shared = rom("T", Folding::none);
  n.constant("c", 0.5, s);
  const Wire difference_word = n.input("d", ufixed(8, 8));
  const Wire sum = n.add("sum", a, b, s), difference = n.sub("difference", a, b, s);
  n.mul("product", sum, difference, s);
  n.div("ratio", a, b, s);
  n.sqrt("root", a, ufixed(8, 8));
  n.table("read", shared, a);
  n.table("read_again", shared, b);
  n.table("floating", rom("F", Folding::floating), b);
  n.second_port("read_by_second_port", shared, difference_word);
  n.table("map", map_of(ufixed(8, 8)), {a, b});
  n.join("both", n.input("high", ufixed(4, 0)), b, ufixed(12, 8));
  n.shift("half", a, -1, s);
  n.negate("minus", sum, s);
  n.absolute("size", sum, s);
  n.shift_by("moved", sum, n.input("places", ufixed(3, 0)), s);
  n.half_turn("opposite", t);
  n.is_beyond_quarter("far", t);
  const Wire below = n.is_negative("below", sum);
  n.select("either", below, a, b, s);
  n.add_sub("sum_or_difference", n.exclusive_or("signs", below, below), a, b, s);
  n.begin_addition();
  n.clamp("clamped", n.add("offset", a, b, s), 0, 1, s);
  n.end_addition();

  const Inventory published = count(n, Portion::published), addition = count(n, Portion::addition), all = count(n);
  CHECK(published.adders == 3);
  CHECK(published.multipliers == 1);
  CHECK(published.dividers == 1);
  CHECK(published.square_roots == 1);
  CHECK(published.tables == 3);
  CHECK(published.maps == 1);
  CHECK(published.index_encoders == 1);
  CHECK(published.second_ports == 1);
  CHECK(published.shifters == 1);
  CHECK(published.shifts == 2);
  CHECK(published.sign_logic == 6);
  CHECK(published.selects == 1);
  CHECK(published.clamps == 0);
  CHECK(published.table_bits == (3 * 32 + 256) * 10);
  CHECK(published.distinct_table_bits == (2 * 32 + 256) * 10);
  CHECK(addition.adders == 1);
  CHECK(addition.clamps == 1);
  CHECK(addition.tables == 0);
  CHECK(all.adders == 4);
  CHECK(all.clamps == 1);
}

TEST_CASE("published design and addition add up to the whole for random netlists") {
  Random random(20);
  for (int i = 0; i < 200; ++i) {
    Netlist n = random_netlist(random, 15);
    Inventory sum = count(n, Portion::published);
    sum += count(n, Portion::addition);
    const Inventory all = count(n);
    CHECK(sum.adders == all.adders);
    CHECK(sum.multipliers == all.multipliers);
    CHECK(sum.table_bits == all.table_bits);
    int operators = 0;
    for (const Node& node : n.nodes())
      if (node.op != Op::input && node.op != Op::constant && node.op != Op::column) ++operators;
    CHECK(operators == all.multipliers + all.adders + all.dividers + all.square_roots + all.tables + all.maps + all.second_ports +
                           all.shifters + all.shifts + all.sign_logic + all.clamps + all.selects);
  }
}

TEST_CASE("what depends on the light is told apart from what does not") {
  Netlist n("vertex");
  const Wire light = n.input("L.x", real()), normal = n.input("N.x", real()), eye = n.input("V.x", real());
  const Wire dot = n.mul("dot", light, normal, real());
  const Wire square = n.mul("square", normal, normal, real());
  const Wire sum = n.add("sum", square, eye, real());
  const Wire both = n.add("both", dot, sum, real());
  const auto is_set = [](const std::vector<bool>& which, Wire wire) { return which[static_cast<std::size_t>(wire.node)]; };
  const std::vector<bool> on_light = depends_on(n, {"L."}), on_eye = depends_on(n, {"V."}), on_either = depends_on(n, {"L.", "V."});
  CHECK(is_set(on_light, light));
  CHECK(is_set(on_light, dot));
  CHECK(is_set(on_light, both));
  CHECK_FALSE(is_set(on_light, square));
  CHECK_FALSE(is_set(on_light, sum));
  CHECK(is_set(on_eye, sum));
  CHECK_FALSE(is_set(on_eye, dot));
  CHECK(is_set(on_either, dot));
  CHECK_FALSE(is_set(on_either, square));
  CHECK(count_nodes(n, on_light).multipliers == 1);
  CHECK(count_nodes(n, on_light).adders == 1);
  CHECK(count_nodes(n, std::vector<bool>(n.nodes().size(), false)).multipliers == 0);
  for (const bool none : depends_on(n, {"LX."})) CHECK_FALSE(none);
}

TEST_CASE("operators that are recorded twice are found, through others too") {
  Netlist n("unit");
  const Wire a = n.input("a", sfixed(8, 4)), b = n.input("b", sfixed(8, 4));
  const Format s = sfixed(12, 6);
  const Wire first = n.add("first", a, b, s), second = n.add("second", b, a, s);
  const Wire narrow = n.add("narrow", a, b, sfixed(10, 6));
  n.sub("forward", a, b, s);
  n.sub("backward", b, a, s);
  const Wire square = n.mul("square", first, first, s), other_square = n.mul("other_square", first, second, s);
  n.shift("half", a, -1, s);
  n.shift("quarter", a, -2, s);
  n.clamp("unit", a, 0, 1, s);
  n.clamp("double", a, 0, 2, s);
  n.mul("distinct", narrow, first, s);
  const Wire sign = n.is_negative("sign", first), other = n.is_negative("other", square);
  const Wire signs = n.exclusive_or("signs", sign, other), same_signs = n.exclusive_or("same_signs", other, sign);
  n.add_sub("a_and_b", sign, a, b, s);
  n.add_sub("b_and_a", sign, b, a, s);
  n.add_sub("by_the_other", other, a, b, s);
  n.constant("one", 1, s);
  n.constant("also_one", 1, s);
  CHECK(equal_nodes(n) ==
        std::vector<std::pair<int, int>>{{first.node, second.node}, {square.node, other_square.node}, {signs.node, same_signs.node}});
}

TEST_CASE("reads of one table by one index are duplicates, reads of different tables are not") {
  Netlist n("unit");
  const TablePtr shared = rom("T", Folding::none);
  const Wire a = n.input("a", ufixed(8, 8)), b = n.input("b", ufixed(8, 8));
  n.table("one", shared, a);
  n.table("two", shared, a);
  n.table("three", shared, b);
  n.table("four", rom("U", Folding::none), a);
  n.second_port("five", shared, b);
  const TablePtr map = map_of(ufixed(8, 8));
  n.table("six", map, {a, b});
  n.table("seven", map, {b, a});
  CHECK(equal_nodes(n) == std::vector<std::pair<int, int>>{{n.find("one"), n.find("two")}, {n.find("three"), n.find("five")}});
}
