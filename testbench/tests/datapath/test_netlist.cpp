#include <catch2/catch.hpp>

#include "datapath/error.h"
#include "datapath/netlist.h"

using namespace bump;
using Catch::Contains;

namespace {

TablePtr small_table(const std::string& name, const Format& index, int word_bits = 8) {
  Table t;
  t.name = name;
  t.index = index;
  t.address_bits = 4;
  for (const char* column_name : {"a", "b"}) {
    Column c;
    c.name = column_name;
    c.function = [](double x) { return x; };
    c.format = sfixed(word_bits, 4);
    t.columns.push_back(c);
  }
  return std::make_shared<const Table>(t);
}

}  // namespace

TEST_CASE("a netlist lists nodes in the order of recording, with their sources") {
  Netlist n("environment");
  const Wire a = n.input("a", sfixed(8, 4)), b = n.input("b", sfixed(8, 4));
  const Wire sum = n.add("sum", a, b, sfixed(9, 4), "Eq 7");
  n.output("result", sum);
  REQUIRE(n.nodes().size() == 3);
  CHECK(n.nodes()[2].op == Op::add);
  CHECK(n.nodes()[2].equation == "Eq 7");
  CHECK(n.nodes()[2].operands == std::vector<int>{0, 1});
  CHECK(n.find("sum") == sum.node);
  CHECK(n.find("difference") == -1);
  CHECK(n.format(sum) == sfixed(9, 4));
  REQUIRE(n.inputs().size() == 2);
  CHECK(n.inputs()[1].name == "b");
  REQUIRE(n.outputs().size() == 1);
  CHECK(n.outputs()[0].node == sum.node);
}

TEST_CASE("scopes prefix the names of nodes and ports and end where they end") {
  Netlist n("unit");
  {
    const Netlist::Scope light(n, "L");
    {
      const Netlist::Scope rotation(n, "rotation");
      n.output("x", n.negate("x", n.input("a", sfixed(8, 4)), sfixed(8, 4)));
    }
    n.input("a", sfixed(8, 4));
  }
  n.input("a", sfixed(8, 4));
  CHECK(n.nodes()[0].name == "L.rotation.a");
  CHECK(n.nodes()[1].name == "L.rotation.x");
  CHECK(n.outputs()[0].name == "L.rotation.x");
  CHECK(n.inputs()[1].name == "L.a");
  CHECK(n.inputs()[2].name == "a");
}

TEST_CASE("a label names the step of operators that are recorded without one, the innermost first, and ends where it ends") {
  Netlist n("unit");
  const Format word = sfixed(8, 4);
  const auto source_of = [&](const std::string& name) { return n.nodes().at(static_cast<std::size_t>(n.find(name))).equation; };
  {
    Netlist::Label step(n, "step 1");
    const Wire a = n.input("a", word);
    n.is_negative("flag", a);
    n.constant("one", 1, word);
    n.negate("own", a, word, "Eq 7");
    {
      const Netlist::Label inner(n, "step 1a");
      n.table("read", small_table("AB", ufixed(6, 6)), n.input("x", ufixed(6, 6)));
      const Netlist::Label none(n, "");
      n.negate("still_inner", a, word);
    }
    n.negate("outer_again", a, word);
    step.next("step 2");
    n.negate("second", a, word);
    step.next("");
    n.negate("unlabelled", a, word);
  }
  n.negate("behind", Wire{n.find("a")}, word);
  CHECK(source_of("a").empty());
  CHECK(source_of("x").empty());
  CHECK(source_of("flag") == "step 1");
  CHECK(source_of("one") == "step 1");
  CHECK(source_of("own") == "Eq 7");
  CHECK(source_of("read") == "step 1a");
  CHECK(source_of("read.b") == "step 1a");
  CHECK(source_of("still_inner") == "step 1a");
  CHECK(source_of("outer_again") == "step 1");
  CHECK(source_of("second") == "step 2");
  CHECK(source_of("unlabelled").empty());
  CHECK(source_of("behind").empty());
}

TEST_CASE("a table read is one node and a wire per column") {
  Netlist n("unit");
  const TablePtr shared = small_table("AB", ufixed(6, 6));
  const Wire x = n.input("x", ufixed(6, 6));
  const std::vector<Wire> first = n.table("first", shared, x), second = n.table("second", shared, x);
  REQUIRE(first.size() == 2);
  CHECK(n.nodes()[static_cast<std::size_t>(first[1].node)].name == "first.b");
  CHECK(n.nodes()[static_cast<std::size_t>(first[1].node)].amount == 1);
  CHECK(n.format(first[0]) == sfixed(8, 4));
  CHECK(n.tables().size() == 1);
  CHECK(n.nodes()[static_cast<std::size_t>(n.find("second"))].table == 0);
  CHECK(second[0].node > first[1].node);
}

TEST_CASE("additions to the published design are marked while they are being recorded") {
  Netlist n("unit");
  const Wire a = n.input("a", turns(8));
  n.begin_addition();
  const Wire b = n.add("in_plane", a, a, turns(8));
  n.end_addition();
  n.add("sum", a, b, turns(8));
  CHECK_FALSE(n.nodes()[0].addition);
  CHECK(n.nodes()[1].addition);
  CHECK_FALSE(n.nodes()[2].addition);
}

TEST_CASE("operators that break a rule are refused, name themselves and leave the netlist as it was") {
  Netlist n("unit");
  const Wire s = n.input("s", sfixed(16, 8)), u = n.input("u", ufixed(16, 8)), t = n.input("t", turns(10)), f = n.input("f", flag());
  const Wire wide = n.input("wide", sfixed(60, 0)), fine = n.input("fine", sfixed(20, 40));
  const std::vector<Wire> read = n.table("read", small_table("AB", ufixed(16, 8)), u);
  const std::size_t before = n.nodes().size();
  const Format to = sfixed(12, 8);
  CHECK_THROWS_WITH(n.add("s", s, u, to), Contains("'unit'") && Contains("'s'") && Contains("taken"));
  CHECK_THROWS_WITH(n.add("x", s, u, sfixed(63, 8)), Contains("'x'") && Contains("1 to 62"));
  CHECK_THROWS_WITH(n.add("x", s, u, sfixed(0, 8)), Contains("1 to 62"));
  CHECK_THROWS_WITH(n.add("x", s, u, sfixed(12, 400)), Contains("last place"));
  CHECK_THROWS_WITH(n.add("x", wide, fine, to), Contains("aligned"));
  CHECK_THROWS_WITH(n.mul("x", wide, s, to), Contains("62"));
  CHECK_THROWS_WITH(n.div("x", s, s, to), Contains("divisor") && Contains("unsigned"));
  CHECK_THROWS_WITH(n.div("x", s, u, ufixed(12, 8)), Contains("sign"));
  CHECK_THROWS_WITH(n.div("x", wide, u, sfixed(40, 20)), Contains("dividend"));
  CHECK_THROWS_WITH(n.sqrt("x", s, to), Contains("radicand") && Contains("unsigned"));
  CHECK_THROWS_WITH(n.sqrt("x", u, ufixed(40, 30)), Contains("radicand"));
  CHECK_THROWS_WITH(n.half_turn("x", s), Contains("full-turn"));
  CHECK_THROWS_WITH(n.is_beyond_quarter("x", u), Contains("full-turn"));
  CHECK_THROWS_WITH(n.is_negative("x", u), Contains("never negative"));
  CHECK_THROWS_WITH(n.select("x", s, s, u, to), Contains("flag"));
  CHECK_THROWS_WITH(n.add_sub("x", s, s, u, to), Contains("first operand") && Contains("flag"));
  CHECK_THROWS_WITH(n.add_sub("x", f, wide, fine, to), Contains("aligned") && Contains("add_sub"));
  CHECK_THROWS_WITH(n.shift_by("x", s, s, to), Contains("places") && Contains("s16.8"));
  CHECK_THROWS_WITH(n.shift_by("x", s, u, to), Contains("whole number"));
  CHECK_THROWS_WITH(n.shift_by("x", wide, f, sfixed(12, 10)), Contains("61 bits"));
  CHECK_THROWS_WITH(n.exclusive_or("x", f, u), Contains("second operand") && Contains("flag"));
  CHECK_THROWS_WITH(n.clamp("x", s, 1, 0, to), Contains("wrong way round"));
  CHECK_THROWS_WITH(n.clamp("x", wide, 0, 1, sfixed(12, 10)), Contains("shifted"));
  CHECK_THROWS_WITH(n.shift("x", s, 200, to), Contains("shift"));
  CHECK_THROWS_WITH(n.negate("x", Wire{}, to), Contains("not a wire"));
  CHECK_THROWS_WITH(n.half_turn("x", Wire{}), Contains("not a wire"));
  CHECK_THROWS_WITH(n.negate("x", Wire{n.find("read")}, to), Contains("columns"));
  CHECK_THROWS_WITH(n.table("x", nullptr, u), Contains("no table"));
  CHECK_THROWS_WITH(n.table("x", small_table("CD", ufixed(16, 8)), s), Contains("indexed by u16.8"));
  CHECK_THROWS_WITH(n.table("x", small_table("AB", ufixed(16, 8), 9), u), Contains("another table"));
  CHECK_THROWS_WITH(n.output("y", Wire{99}), Contains("not a wire"));
  CHECK_NOTHROW(n.output("y", t));
  CHECK_THROWS_WITH(n.output("y", f), Contains("taken"));
  CHECK(n.nodes().size() == before);
  try {
    n.sqrt("x", s, to);
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::internal);
  }
}

TEST_CASE("real edges are free of the rules for words") {
  Netlist n("vertex");
  const Wire x = n.input("x", real()), y = n.input("y", real());
  CHECK_NOTHROW(n.div("ratio", x, y, real()));
  CHECK_NOTHROW(n.sqrt("root", x, real()));
  const Wire sign = n.is_negative("sign", x);
  CHECK_NOTHROW(n.add_sub("either", sign, x, y, real()));
  CHECK_NOTHROW(n.shift_by("scaled", x, y, real()));
  CHECK_NOTHROW(n.table("atan", small_table("AB", turns(10)), x));
}

TEST_CASE("every operator has a name of its own") {
  for (int i = 0; i <= static_cast<int>(Op::exclusive_or); ++i)
    for (int j = 0; j < i; ++j) CHECK(std::string(name_of(static_cast<Op>(i))) != name_of(static_cast<Op>(j)));
}

TEST_CASE("a second port reads a ROM that has a first port to itself, and nothing else") {
  Netlist n("unit");
  const TablePtr table = small_table("T", ufixed(8, 8));
  const Wire a = n.input("a", ufixed(8, 8)), b = n.input("b", ufixed(8, 8));
  CHECK_THROWS_WITH(n.second_port("early", table, a), Contains("T") && Contains("first port"));
  n.table("first", table, a);
  CHECK(n.second_port("second", table, b).size() == 2);
  CHECK_THROWS_WITH(n.second_port("third", table, b), Contains("first port"));
  CHECK(n.nodes()[static_cast<std::size_t>(n.find("second"))].second_port);
  CHECK_FALSE(n.nodes()[static_cast<std::size_t>(n.find("first"))].second_port);
}

TEST_CASE("a map is read by all its index words in their formats") {
  Netlist n("unit");
  Table map;
  map.name = "MAP";
  map.index = ufixed(8, 8);
  map.address_bits = 4;
  map.fields = {{ufixed(4, 4), 4}};
  Column column;
  column.name = "value";
  column.map_function = [](const double* x) { return x[0] - x[1]; };
  column.format = sfixed(8, 7);
  map.columns = {column};
  const auto shared = std::make_shared<const Table>(map);
  const Wire a = n.input("a", ufixed(8, 8)), b = n.input("b", ufixed(4, 4));
  CHECK_THROWS_WITH(n.table("one", shared, a), Contains("2 index words"));
  CHECK_THROWS_WITH(n.table("swapped", shared, {b, a}), Contains("indexed by u8.8"));
  CHECK(n.table("read", shared, {a, b}).size() == 1);
  CHECK(n.nodes()[static_cast<std::size_t>(n.find("read"))].operands == std::vector<int>{a.node, b.node});
}

TEST_CASE("words are joined only where their bits do not overlap") {
  Netlist n("unit");
  const Wire high = n.input("high", sfixed(4, -3)), low = n.input("low", ufixed(3, 0)), wide = n.input("wide", ufixed(4, 0)),
             negative = n.input("negative", sfixed(3, 0));
  CHECK_NOTHROW(n.join("address", high, low, sfixed(7, 0)));
  CHECK_THROWS_WITH(n.join("overlapping", high, wide, sfixed(7, 0)), Contains("overlap"));
  CHECK_THROWS_WITH(n.join("signed", high, negative, sfixed(7, 0)), Contains("overlap"));
}
