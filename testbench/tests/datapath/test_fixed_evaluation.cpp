#include <array>
#include <catch2/catch.hpp>
#include <cstring>
#include <functional>

#include "datapath/arithmetic.h"
#include "datapath/error.h"
#include "datapath/evaluate.h"
#include "oracle.h"
#include "random_netlist.h"

using namespace bump;
using namespace bump_test;

namespace {

/// Runs a block of random lanes through the evaluator and returns how many words differ from the oracle; the first difference is described.
int mismatches(const Netlist& netlist, Random& random, int lanes, std::string& first, std::array<int, 21>& seen) {
  std::vector<std::vector<double>> inputs, outputs(netlist.outputs().size(), std::vector<double>(static_cast<std::size_t>(lanes)));
  std::vector<const double*> in;
  std::vector<double*> out;
  for (const Netlist::Port& port : netlist.inputs()) {
    std::vector<double> values;
    for (int i = 0; i < lanes; ++i) values.push_back(random_value(random, netlist.nodes()[static_cast<std::size_t>(port.node)].format));
    inputs.push_back(values);
  }
  for (const auto& values : inputs) in.push_back(values.data());
  for (auto& values : outputs) out.push_back(values.data());
  const auto evaluator = make_evaluator(netlist, Arithmetic::fixed);
  evaluator->evaluate(in.data(), lanes, out.data());
  const Oracle oracle(netlist);
  int count = 0;
  for (int lane = 0; lane < lanes; ++lane) {
    std::vector<double> values;
    for (const auto& port : inputs) values.push_back(port[static_cast<std::size_t>(lane)]);
    const std::vector<std::int64_t> words = oracle.evaluate(values);
    for (std::size_t i = 0; i < words.size(); ++i) {
      const Node& node = netlist.nodes()[i];
      ++seen[static_cast<std::size_t>(node.op)];
      if (evaluator->raw(static_cast<int>(i), lane) == words[i]) continue;
      if (count++ == 0)
        first = std::string(name_of(node.op)) + " '" + node.name + "' to " + to_string(node.format) + ": " +
                std::to_string(evaluator->raw(static_cast<int>(i), lane)) + " instead of " + std::to_string(words[i]);
    }
    for (std::size_t j = 0; j < outputs.size(); ++j) {
      const auto node = static_cast<std::size_t>(netlist.outputs()[j].node);
      if (outputs[j][static_cast<std::size_t>(lane)] != static_cast<double>(words[node]) * netlist.nodes()[node].format.step()) ++count;
    }
  }
  return count;
}

}  // namespace

TEST_CASE("fixed-point evaluation equals an independent bit-level definition for random netlists") {
  Random random(2007);
  std::array<int, 21> seen{};
  for (int i = 0; i < 3000; ++i) {
    const Netlist netlist = random_netlist(random, 24);
    std::string first;
    INFO("netlist " << i);
    const int wrong = mismatches(netlist, random, i % 16 == 0 ? 33 : 9, first, seen);
    INFO(first);
    REQUIRE(wrong == 0);
  }
  for (std::size_t op = 0; op < seen.size(); ++op) {
    INFO(name_of(static_cast<Op>(op)));
    CHECK(seen[op] > 1000);
  }
}

TEST_CASE("words wider and narrower than a lane go through every operator together") {
  // Sums, products, shifts and selects of words at the limits of 32-bit lanes, alone: random netlists seldom hold two such words in a row.
  Random random(32);
  std::array<int, 21> seen{};
  for (int i = 0; i < 1500; ++i) {
    const auto edge = [&] {
      const int width = random.integer(0, 2) == 0 ? random.integer(15, 17) : random.integer(30, 34);
      const int fraction = random.integer(0, 34);
      return random.coin() ? sfixed(width, fraction) : ufixed(std::min(width, 34), fraction);
    };
    Netlist n("limits");
    const Wire a = n.input("a", edge()), b = n.input("b", edge()), f = n.input("f", flag());
    const Format small = random.coin() ? sfixed(random.integer(2, 17), random.integer(0, 20)) : ufixed(random.integer(1, 17), 3);
    const Wire c = n.input("c", small), k = n.input("k", ufixed(random.coin() ? 6 : random.integer(30, 34), 0));
    int recorded = 0;
    const auto record = [&](const std::function<Wire(const std::string&)>& make) {
      const std::string name = "n" + std::to_string(recorded++);
      try {
        n.output("out." + name, make(name));
      } catch (const Error&) {
        // Too many bits for the rules of the netlist.
      }
    };
    record([&](const std::string& name) { return n.add(name, a, b, edge()); });
    record([&](const std::string& name) { return n.sub(name, a, b, edge()); });
    record([&](const std::string& name) { return n.sub(name, a, c, edge()); });
    record([&](const std::string& name) { return n.add_sub(name, f, a, b, edge()); });
    record([&](const std::string& name) { return n.add_sub(name, f, c, a, edge()); });
    record([&](const std::string& name) { return n.shift_by(name, a, k, edge()); });
    record([&](const std::string& name) { return n.shift_by(name, c, k, edge()); });
    record([&](const std::string& name) { return n.mul(name, a, c, edge()); });
    record([&](const std::string& name) { return n.mul(name, c, c, edge()); });
    record([&](const std::string& name) { return n.div(name, a, c, edge()); });
    record([&](const std::string& name) { return n.sqrt(name, a, edge()); });
    record([&](const std::string& name) { return n.shift(name, a, random.integer(-34, 34), edge()); });
    record([&](const std::string& name) { return n.negate(name, a, edge()); });
    record([&](const std::string& name) { return n.absolute(name, a, edge()); });
    record([&](const std::string& name) { return n.select(name, f, a, b, edge()); });
    record([&](const std::string& name) {
      const Format to = edge();
      return n.clamp(name, a, to.lowest() * random.real(0, 1), to.highest() * random.real(0, 1), to);
    });
    std::string first;
    INFO("netlist " << i);
    const int wrong = mismatches(n, random, 17, first, seen);
    INFO(first);
    REQUIRE(wrong == 0);
  }
  for (const Op op : {Op::add, Op::sub, Op::add_sub, Op::shift_by, Op::mul, Op::div, Op::sqrt, Op::shift, Op::negate, Op::absolute,
                      Op::select, Op::clamp}) {
    INFO(name_of(op));
    CHECK(seen[static_cast<std::size_t>(op)] > 1000);
  }
}

TEST_CASE("a node that is asked for between evaluations changes no output and has the word of this block") {
  Random random(64);
  for (int i = 0; i < 300; ++i) {
    const Netlist netlist = random_netlist(random, 24);
    const Oracle oracle(netlist);
    const auto watched = make_evaluator(netlist, Arithmetic::fixed), real_watched = make_evaluator(netlist, Arithmetic::real);
    const auto node = random.integer(0, static_cast<int>(netlist.nodes().size()) - 1);
    for (int block = 0; block < 3; ++block) {
      constexpr int lanes = 5;
      std::vector<std::vector<double>> inputs;
      std::vector<const double*> in;
      for (const Netlist::Port& port : netlist.inputs()) {
        inputs.emplace_back();
        for (int lane = 0; lane < lanes; ++lane)
          inputs.back().push_back(random_value(random, netlist.nodes()[static_cast<std::size_t>(port.node)].format));
      }
      for (const auto& values : inputs) in.push_back(values.data());
      const auto outputs_of = [&](Evaluator& evaluator) {
        std::vector<std::vector<double>> outputs(netlist.outputs().size(), std::vector<double>(lanes));
        std::vector<double*> out;
        for (auto& values : outputs) out.push_back(values.data());
        evaluator.evaluate(in.data(), lanes, out.data());
        return outputs;
      };
      const auto fresh = make_evaluator(netlist, Arithmetic::fixed), real_fresh = make_evaluator(netlist, Arithmetic::real);
      REQUIRE(outputs_of(*watched) == outputs_of(*fresh));
      const auto real_values = outputs_of(*real_watched), real_expected = outputs_of(*real_fresh);
      for (std::size_t j = 0; j < real_values.size(); ++j)
        REQUIRE(std::memcmp(real_values[j].data(), real_expected[j].data(), lanes * sizeof(double)) == 0);
      for (int lane = 0; lane < lanes; ++lane) {
        std::vector<double> values;
        for (const auto& port : inputs) values.push_back(port[static_cast<std::size_t>(lane)]);
        REQUIRE(watched->raw(node, lane) == oracle.evaluate(values)[static_cast<std::size_t>(node)]);
        const double kept = real_watched->value(node, lane), computed = real_fresh->value(node, lane);
        REQUIRE(std::memcmp(&kept, &computed, sizeof kept) == 0);
      }
    }
  }
}

TEST_CASE("every lane of a block is evaluated alike, and no lane more") {
  Random random(11);
  const Netlist netlist = random_netlist(random, 40);
  std::vector<std::vector<double>> inputs;
  std::vector<const double*> in;
  for (const Netlist::Port& port : netlist.inputs())
    inputs.emplace_back(static_cast<std::size_t>(block_lanes),
                        random_value(random, netlist.nodes()[static_cast<std::size_t>(port.node)].format));
  for (const auto& values : inputs) in.push_back(values.data());
  for (const Arithmetic arithmetic : {Arithmetic::fixed, Arithmetic::real}) {
    const auto evaluator = make_evaluator(netlist, arithmetic);
    for (const int lanes : {0, 1, 5, 255, 256}) {
      std::vector<std::vector<double>> outputs(netlist.outputs().size(),
                                               std::vector<double>(static_cast<std::size_t>(block_lanes), -12345.0));
      std::vector<double*> out;
      for (auto& values : outputs) out.push_back(values.data());
      evaluator->evaluate(in.data(), lanes, out.data());
      for (const auto& values : outputs)
        for (int lane = 0; lane < block_lanes; ++lane) {
          const double value = values[static_cast<std::size_t>(lane)];
          if (lane >= lanes) CHECK(value == -12345.0);
          if (lane < lanes && values[0] == values[0]) CHECK(value == values[0]);
        }
    }
    std::vector<double*> none(netlist.outputs().size(), nullptr);
    CHECK_THROWS_AS(evaluator->evaluate(in.data(), block_lanes + 1, none.data()), Error);
  }
}

TEST_CASE("quotients and roots of the quick path equal the restoring arrays") {
  Random random(5);
  for (int i = 0; i < 20000; ++i) {
    const Format a =
        random.coin() ? sfixed(random.integer(2, 40), random.integer(-2, 30)) : ufixed(random.integer(1, 40), random.integer(-2, 30));
    const Format b = ufixed(random.integer(1, 40), random.integer(-2, 30)), q = sfixed(random.integer(2, 62), random.integer(-2, 30));
    const DividerShape divider = divider_shape(a, b, q);
    const std::int64_t word_a = quantise(random_value(random, a), a), word_b = quantise(random_value(random, b), b);
    if (divider.dividend <= 62) {
      REQUIRE(divide(word_a, word_b, divider) == divide_by_array(word_a, word_b, divider));
      REQUIRE(divide(word_a, word_b, divider) == oracle_divide(word_a, a, word_b, b, q));
      if (word_b == 0) REQUIRE(divide(word_a, 0, divider) == (word_a < 0 ? -1 : 1) * ((std::int64_t{1} << (q.width - 1)) - 1));
    }
    const RootShape shape = root_shape(b, q);
    if (b.width + shape.shift > 62) continue;
    REQUIRE(root(word_b, shape) == root_by_array(word_b, shape));
    REQUIRE(root(word_b, shape) == oracle_root(word_b, b, q));
  }
}

TEST_CASE("roots of squares and their neighbours are exact floors up to the widest word") {
  Random random(6);
  const Format word = ufixed(62, 0), result = ufixed(31, 0);
  for (int i = 0; i < 20000; ++i) {
    const auto base = static_cast<std::int64_t>(random.bits() >> random.integer(33, 62));
    for (const std::int64_t a : {base * base - 1, base * base, base * base + 2 * base}) {
      if (a < 0) continue;
      REQUIRE(root(a, root_shape(word, result)) == (a < base * base ? base - 1 : base));
    }
  }
}

TEST_CASE("a netlist with real edges has no fixed-point evaluation") {
  Netlist n("vertex");
  n.output("y", n.add("sum", n.input("a", real()), n.input("b", real()), real()));
  CHECK_THROWS_WITH(make_evaluator(n, Arithmetic::fixed), Catch::Contains("vertex") && Catch::Contains("real"));
  CHECK_NOTHROW(make_evaluator(n, Arithmetic::real));
}

TEST_CASE("evaluators of one table share its ROM and evaluate a new table in its place afresh") {
  for (int round = 0; round < 3; ++round) {
    Table table;
    table.name = "SCALE";
    table.index = ufixed(4, 4);
    table.address_bits = 4;
    Column column;
    column.name = "y";
    column.format = sfixed(8, 4);
    int calls = 0;
    column.function = [&calls, round](double x) { return ++calls, round * x; };
    table.columns.push_back(column);
    const auto shared = std::make_shared<const Table>(table);
    Netlist n("unit");
    const Wire x = n.input("x", ufixed(4, 4));
    n.output("a", n.table("first", shared, x).front());
    n.output("b", n.table("second", shared, x).front());
    const auto one = make_evaluator(n, Arithmetic::fixed), two = make_evaluator(n, Arithmetic::fixed);
    CHECK(calls == 16);
    const double half = 0.5;
    const double* in[] = {&half};
    double a = 0, b = 0;
    double* out[] = {&a, &b};
    two->evaluate(in, 1, out);
    CHECK(a == 0.5 * round);
    CHECK(b == a);
  }
}
