#include <catch2/catch.hpp>
#include <map>

#include "datapath/slot_plan.h"
#include "random_netlist.h"

using namespace bump;
using namespace bump_test;

TEST_CASE("no slot is written while its node is still to be read, and results never share the slot of an operand") {
  Random random(9);
  for (int round = 0; round < 500; ++round) {
    const int nodes = random.integer(1, 40);
    SlotPlan plan(static_cast<std::size_t>(nodes));
    std::vector<std::vector<int>> reads;
    std::vector<bool> held(static_cast<std::size_t>(nodes), false);
    for (int node = 0; node < nodes; ++node) {
      std::vector<int> read;
      for (int i = random.integer(0, 3); i > 0 && node > 0; --i) read.push_back(random.integer(0, node - 1));
      reads.push_back(read);
      plan.step({node}, read);
      if (random.integer(0, 9) == 0) {
        plan.hold(node);
        held[static_cast<std::size_t>(node)] = true;
      }
    }
    const auto kind = [](int node) { return node % 2; };
    const std::vector<int> slots = plan.assign(kind);
    std::map<std::pair<int, int>, int> content;  // of every slot of every pool
    for (int node = 0; node < nodes; ++node) {
      const auto place = [&](int of) { return std::make_pair(kind(of), slots[static_cast<std::size_t>(of)]); };
      REQUIRE(place(node).second >= 0);
      REQUIRE(place(node).second < plan.slots(kind(node)));
      content[place(node)] = node;
      for (const int read : reads[static_cast<std::size_t>(node)]) REQUIRE(content.at(place(read)) == read);
    }
    for (int node = 0; node < nodes; ++node)
      if (held[static_cast<std::size_t>(node)]) REQUIRE(content.at({kind(node), slots[static_cast<std::size_t>(node)]}) == node);
  }
}

TEST_CASE("a chain of nodes needs two slots however long it is") {
  SlotPlan plan(50);
  plan.step({0}, {});
  for (int node = 1; node < 50; ++node) plan.step({node}, {node - 1});
  plan.hold(49);
  plan.assign([](int) { return 0; });
  CHECK(plan.slots(0) == 2);
}
