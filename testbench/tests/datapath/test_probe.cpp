#include <catch2/catch.hpp>

#include "datapath/error.h"
#include "datapath/probe.h"

using namespace bump;
using Catch::Contains;

TEST_CASE("a probe shows every node in double precision and as the word of the hardware") {
  Netlist n("environment");
  const Wire a = n.input("phi", turns(8)), b = n.input("offset", turns(8));
  n.begin_addition();
  const Wire sum = n.add("sum", a, b, turns(8), "Eq 6");
  n.end_addition();
  n.output("sum", sum);
  const std::vector<ProbeRow> rows = probe(n, {{"phi", 0.3}, {"offset", 0.4}});
  REQUIRE(rows.size() == 3);
  CHECK(rows[0].name == "phi");
  CHECK(rows[0].raw == 77);
  CHECK(rows[0].real == 0.3);
  CHECK(rows[0].fixed == 77.0 / 256);
  CHECK(rows[2].op == "add");
  CHECK(rows[2].equation == "Eq 6");
  CHECK(rows[2].format == "turn8");
  CHECK(rows[2].real == Approx(-0.3));
  CHECK(rows[2].raw == 77 + 102 - 256);
  CHECK(rows[2].fixed == (77.0 + 102 - 256) / 256);
  CHECK(rows[2].addition);
  CHECK(rows[2].is_angle);
  CHECK_FALSE(rows[0].addition);
}

TEST_CASE("a table shows its index and its address") {
  Table t;
  t.name = "T";
  t.index = ufixed(8, 8);
  t.address_bits = 4;
  Column c;
  c.name = "y";
  c.function = [](double x) { return x; };
  c.format = ufixed(8, 8);
  t.columns.push_back(c);
  Netlist n("unit");
  n.output("y", n.table("read", std::make_shared<const Table>(t), n.input("x", ufixed(8, 8))).front());
  const std::vector<ProbeRow> rows = probe(n, {{"x", 0.51}});
  CHECK(rows[1].op == "table");
  CHECK(rows[1].real == 0.51);
  CHECK(rows[1].fixed == 131.0 / 256);
  CHECK(rows[1].raw == 8);
  CHECK(rows[2].real == 0.51);
  CHECK(rows[2].raw == 136);  // the codes 128 to 143 share a word: their centre, rounded up
}

TEST_CASE("a vertex program is shown in double precision only") {
  Netlist n("vertex");
  n.output("y", n.mul("square", n.input("x", real()), n.input("z", real()), real()));
  const std::vector<ProbeRow> rows = probe(n, {{"x", 1.5}, {"z", 3}});
  CHECK(rows[2].real == 4.5);
  CHECK(rows[2].fixed == 4.5);
  CHECK(rows[2].raw == 0);
}

TEST_CASE("unknown and missing inputs are named, with those that exist") {
  Netlist n("illumination");
  const Wire a = n.input("L.phi", turns(8));
  n.output("y", n.add("y", a, n.input("map.phi", turns(8)), turns(8)));
  CHECK_THROWS_WITH(probe(n, {{"L.phi", 0}, {"map.phi", 0}, {"map.psi", 0}}),
                    Contains("'map.psi'") && Contains("L.phi (turn8), map.phi (turn8)"));
  CHECK_THROWS_WITH(probe(n, {{"L.phi", 0}}), Contains("needs a value for map.phi"));
  try {
    probe(n, {});
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::input);
    CHECK_THAT(error.what(), Contains("L.phi, map.phi"));
  }
}
