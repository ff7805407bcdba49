#include <algorithm>
#include <catch2/catch.hpp>
#include <map>

#include "datapath/error.h"
#include "datapath/inventory.h"
#include "datapath/schedule.h"
#include "random_netlist.h"

using namespace bump;
using namespace bump_test;

namespace {

OperatorLatencies random_latencies(Random& random) {
  OperatorLatencies l;
  l.adder = random.integer(0, 2);
  l.multiplier = random.integer(0, 4);
  l.table = random.integer(0, 2);
  l.clamp = random.integer(0, 1);
  l.shifter = random.integer(0, 3);
  l.divider_bits_per_cycle = random.integer(1, 4);
  l.square_root_bits_per_cycle = random.integer(1, 4);
  return l;
}

/// Longest path that ends with a node, by recursion over the graph.
int longest_path(const Netlist& n, const OperatorLatencies& l, int node, std::map<int, int>& known) {
  const auto found = known.find(node);
  if (found != known.end()) return found->second;
  int before = 0;
  for (const int operand : n.nodes()[static_cast<std::size_t>(node)].operands)
    before = std::max(before, longest_path(n, l, operand, known));
  return known[node] = before + latency_of(n.nodes()[static_cast<std::size_t>(node)], l);
}

}  // namespace

TEST_CASE("without a limit every operator starts as soon as its operands are there, one result a cycle") {
  Random random(30);
  for (int i = 0; i < 500; ++i) {
    const Netlist n = random_netlist(random, 40);
    const OperatorLatencies l = random_latencies(random);
    const Schedule s = schedule(n, l);
    std::map<int, int> known;
    int latency = 0;
    for (const Netlist::Port& port : n.outputs()) latency = std::max(latency, longest_path(n, l, port.node, known));
    for (int node = 0; node < static_cast<int>(n.nodes().size()); ++node)
      REQUIRE(s.finish[static_cast<std::size_t>(node)] == longest_path(n, l, node, known));
    CHECK(s.latency == latency);
    CHECK(s.initiation_interval == 1);
    CHECK(s.multipliers_built == count(n).multipliers);
  }
}

TEST_CASE("with a limit, no cycle of the interval needs more multipliers than there are, and no operator runs ahead of its operands") {
  Random random(31);
  for (int i = 0; i < 1500; ++i) {
    const Netlist n = random_netlist(random, 60);
    const OperatorLatencies l = random_latencies(random);
    const int products = count(n).multipliers, limit = random.integer(1, 6);
    const Schedule s = schedule(n, l, limit), unlimited = schedule(n, l);
    REQUIRE(s.initiation_interval == std::max(1, (products + limit - 1) / limit));
    std::map<int, int> slots;
    for (std::size_t node = 0; node < n.nodes().size(); ++node) {
      REQUIRE(s.finish[node] == s.start[node] + latency_of(n.nodes()[node], l));
      REQUIRE(s.start[node] >= unlimited.start[node]);
      for (const int operand : n.nodes()[node].operands) REQUIRE(s.start[node] >= s.finish[static_cast<std::size_t>(operand)]);
      if (n.nodes()[node].op == Op::mul) ++slots[s.start[node] % s.initiation_interval];
    }
    int built = 0;
    for (const auto& [slot, taken] : slots) built = std::max(built, taken);
    REQUIRE(built <= limit);
    REQUIRE(s.multipliers_built == built);
    REQUIRE(s.latency >= unlimited.latency);
    if (products <= limit) REQUIRE(s.start == unlimited.start);
  }
}

TEST_CASE("a time-shared inner product takes its factors in turn") {
  Netlist n("dot");
  std::vector<Wire> products;
  for (const std::string axis : {"x", "y", "z"})
    products.push_back(n.mul(axis, n.input("a" + axis, sfixed(8, 6)), n.input("b" + axis, sfixed(8, 6)), sfixed(10, 8)));
  const Wire sum = n.add("xy", products[0], products[1], sfixed(11, 8));
  n.output("dot", n.add("xyz", sum, products[2], sfixed(12, 8)));
  OperatorLatencies l;
  l.multiplier = 2;
  const Schedule parallel = schedule(n, l), one = schedule(n, l, 1), two = schedule(n, l, 2);
  CHECK(parallel.latency == 4);
  CHECK(one.initiation_interval == 3);
  CHECK(one.latency == 5);
  CHECK(one.multipliers_built == 1);
  CHECK(two.initiation_interval == 2);
  CHECK(two.multipliers_built == 2);
}

TEST_CASE("products in need of one multiplier take it in order of depth, not of recording") {
  Netlist n("unit");
  const Wire a = n.input("a", sfixed(8, 6)), b = n.input("b", sfixed(8, 6));
  const Wire deep = n.mul("deep", n.add("offset", n.add("sum", a, b, sfixed(9, 6)), a, sfixed(10, 6)), b, sfixed(12, 6));
  const Wire shallow = n.mul("shallow", a, b, sfixed(12, 6));
  n.output("y", n.add("y", deep, shallow, sfixed(13, 6)));
  const Schedule s = schedule(n, {}, 1);
  CHECK(s.start[static_cast<std::size_t>(shallow.node)] == 0);
  CHECK(s.start[static_cast<std::size_t>(deep.node)] ==
        3);  // ready in cycle 2, when the multiplier belongs to the next token's shallow product
}

TEST_CASE("operators take the cycles of their kind, wiring and sign logic none") {
  Netlist n("unit");
  const Wire s = n.input("s", sfixed(12, 8)), u = n.input("u", ufixed(12, 8)), t = n.input("t", turns(10));
  OperatorLatencies l;
  l.adder = 2;
  l.multiplier = 3;
  l.table = 4;
  l.clamp = 5;
  l.shifter = 6;
  l.divider_bits_per_cycle = 4;
  l.square_root_bits_per_cycle = 3;
  const auto cycles = [&](Wire wire) { return latency_of(n.nodes()[static_cast<std::size_t>(wire.node)], l); };
  CHECK(cycles(s) == 0);
  CHECK(cycles(n.constant("c", 1, sfixed(4, 2))) == 0);
  CHECK(cycles(n.add("add", s, u, sfixed(14, 8))) == 2);
  CHECK(cycles(n.sub("sub", s, u, sfixed(14, 8))) == 2);
  CHECK(cycles(n.mul("mul", s, u, sfixed(14, 8))) == 3);
  CHECK(cycles(n.clamp("clamp", s, 0, 1, sfixed(12, 8))) == 5);
  CHECK(cycles(n.div("div", s, u, sfixed(14, 8))) == 4);   // 13 magnitude bits, four a cycle
  CHECK(cycles(n.div("udiv", u, u, ufixed(12, 8))) == 3);  // 12 magnitude bits
  CHECK(cycles(n.sqrt("root", u, ufixed(10, 8))) == 4);    // 10 root bits, three a cycle
  CHECK(cycles(n.shift("shift", s, -1, sfixed(12, 9))) == 0);
  CHECK(cycles(n.shift_by("shift_by", s, n.input("k", ufixed(3, 0)), sfixed(12, 8))) == 6);
  CHECK(cycles(n.negate("negate", s, sfixed(12, 8))) == 0);
  CHECK(cycles(n.absolute("absolute", s, ufixed(12, 8))) == 0);
  CHECK(cycles(n.half_turn("half_turn", t)) == 0);
  const Wire sign = n.is_negative("sign", s);
  CHECK(cycles(sign) == 0);
  CHECK(cycles(n.add_sub("add_sub", sign, s, u, sfixed(14, 8))) == 2);
  CHECK(cycles(n.exclusive_or("signs", sign, sign)) == 0);
  CHECK(cycles(n.is_beyond_quarter("far", t)) == 0);
  CHECK(cycles(n.select("select", sign, s, u, sfixed(14, 8))) == 0);
}

TEST_CASE("a netlist without products has interval one under any limit, an empty one no latency") {
  Netlist n("wires");
  n.output("y", n.input("x", sfixed(8, 4)));
  const Schedule s = schedule(n, {}, 1);
  CHECK(s.initiation_interval == 1);
  CHECK(s.latency == 0);
  CHECK(s.multipliers_built == 0);
  CHECK(schedule(Netlist("empty"), {}).latency == 0);
}

TEST_CASE("numbers that no pipeline can have are refused") {
  const Netlist n("unit");
  OperatorLatencies negative, none;
  negative.adder = -1;
  none.divider_bits_per_cycle = 0;
  CHECK_THROWS_WITH(schedule(n, negative), Catch::Contains("adders") && Catch::Contains("-1"));
  CHECK_THROWS_WITH(schedule(n, none), Catch::Contains("quotient bits"));
  CHECK_THROWS_WITH(schedule(n, {}, -2), Catch::Contains("limit"));
  try {
    schedule(n, negative);
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::input);
  }
}

TEST_CASE("a vertex program is no pipeline") {
  Netlist n("vertex");
  n.output("y", n.add("y", n.input("a", real()), n.input("b", real()), real()));
  CHECK_THROWS_WITH(schedule(n, {}), Catch::Contains("vertex") && Catch::Contains("pipeline"));
}
