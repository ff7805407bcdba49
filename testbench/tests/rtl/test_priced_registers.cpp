// What is priced as registers is what the Verilog declares.

#include <catch2/catch.hpp>
#include <regex>

#include "../datapath/random_netlist.h"
#include "datapath/array_registers.h"
#include "rtl/datapath_module.h"
#include "rtl/divider_module.h"
#include "rtl/square_root_module.h"
#include "schemes/scheme.h"
#include "testbench/experiments/price_registers.h"

using namespace bump;
using namespace bump_test;

namespace {

/// Bits of the registers that a module declares for itself.
std::int64_t declared(const std::string& text) {
  static const std::regex declaration(R"(\n\s*reg (?:\[(\d+):0\] )?\w+;)");
  std::int64_t bits = 0;
  for (auto found = std::sregex_iterator(text.begin(), text.end(), declaration); found != std::sregex_iterator(); ++found)
    bits += (*found)[1].matched ? std::stoi((*found)[1]) + 1 : 1;
  return bits;
}

/// As declared(), with everything that the datapath instantiates.
std::int64_t declared(const DatapathModule& module) {
  std::int64_t bits = declared(module.text);
  for (const VerilogModule& leaf : module.leaves) {
    const std::regex instance("\n  " + leaf.name + " \\w+\\(");
    bits += declared(leaf.text) * std::distance(std::sregex_iterator(module.text.begin(), module.text.end(), instance), {});
  }
  return bits;
}

void compare(const std::string& name, const Netlist& netlist, const OperatorLatencies& latencies, int limit) {
  const Schedule scheduled = schedule(netlist, latencies, limit);
  const DatapathModule module = datapath_module(name, "unit", netlist, scheduled);
  const RegisterBits priced = pipeline_registers(netlist, scheduled);
  CAPTURE(name, netlist.name(), limit, module.text);
  CHECK(priced.between == module.register_bits);
  CHECK(priced.inside == module.inside_bits);
  CHECK(declared(module) == module.register_bits + module.inside_bits);
}

OperatorLatencies slow(int cycles, int rows) {
  OperatorLatencies l;
  l.adder = l.multiplier = l.table = l.clamp = l.shifter = cycles;
  l.divider_bits_per_cycle = l.square_root_bits_per_cycle = rows;
  return l;
}

}  // namespace

TEST_CASE("the registers that are priced are those of the Verilog, for all schemes and any latencies") {
  for (const Scheme* scheme : all_schemes()) {
    Parameters parameters;
    scheme->declare(parameters);
    const Design design = scheme->design(Configuration(parameters), Material{});
    std::vector<const Netlist*> units = {&design.environment, &design.illumination};
    if (design.light_maps) units.push_back(&design.light_maps->address);
    for (const Netlist* unit : units)
      for (const int limit : {0, 2})
        for (const OperatorLatencies& latencies : {OperatorLatencies{}, slow(2, 3), slow(3, 1)})
          compare(scheme->page().id, *unit, latencies, limit);
  }
}

TEST_CASE("the registers that are priced are those of the Verilog, for random netlists") {
  Random random(5);
  for (int i = 0; i < 60; ++i) {
    const Netlist netlist = random_netlist(random, random.integer(5, 40));
    compare("random", netlist, slow(random.integer(1, 3), random.integer(1, 5)), random.integer(0, 3));
  }
}

TEST_CASE("a divider keeps its remainder, and of the dividend only what has not entered") {
  // |a| * 2^0 by b in 8 rows, one a cycle: bits 7 .. 0 of a enter, of which 7 - k are left behind row k.
  const std::vector<DividerEdge> edges = divider_edges(ufixed(8, 0), ufixed(4, 0), ufixed(8, 0), 7);
  REQUIRE(edges.size() == 7);
  for (int k = 1; k <= 7; ++k) {
    const DividerEdge& edge = edges[static_cast<std::size_t>(k) - 1];
    CAPTURE(k);
    CHECK(edge.sign == 0);
    CHECK(edge.divisor == 4);
    CHECK(edge.remainder == std::min(k, 4));
    CHECK(edge.rest == 8 - k);
    CHECK(edge.found == k);
    CHECK(edge.bits() == 1 + 4 + std::min(k, 4) + 8);
  }
  CHECK(divider_module(ufixed(8, 0), ufixed(4, 0), ufixed(8, 0), 7).register_bits == 7 * 13 + 1 + 2 + 3 + 4 * 4);
}

TEST_CASE("a square root keeps its remainder, and of the radicand only what has not entered") {
  const std::vector<RootEdge> edges = root_edges(ufixed(8, 0), ufixed(4, 0), 3);
  REQUIRE(edges.size() == 3);
  for (int k = 1; k <= 3; ++k) {
    CHECK(edges[static_cast<std::size_t>(k) - 1].remainder == k + 1);
    CHECK(edges[static_cast<std::size_t>(k) - 1].rest == 8 - 2 * k);
    CHECK(edges[static_cast<std::size_t>(k) - 1].found == k);
  }
  CHECK(square_root_module(ufixed(8, 0), ufixed(4, 0), 3).register_bits == 9 + 12 + 6);
}
