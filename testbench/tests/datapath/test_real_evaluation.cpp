#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "datapath/evaluate.h"
#include "random_netlist.h"

using namespace bump;
using namespace bump_test;

namespace {

double short_way(double value, const Format& to) {
  if (!(to.is_angle && to.is_signed && to.width == to.fraction)) return value;
  const double rest = std::remainder(value, 1.0);
  return rest == 0.5 ? -0.5 : rest + 0.0;  // a whole turn is plus zero
}

/// Every operator by its formula, one fragment at a time.
std::vector<double> directly(const Netlist& netlist, const std::vector<double>& inputs) {
  std::vector<double> values;
  std::size_t port = 0;
  for (const Node& node : netlist.nodes()) {
    const auto x = [&](std::size_t i) { return values[static_cast<std::size_t>(node.operands[i])]; };
    double value = 0;
    switch (node.op) {
      case Op::input:
        value = inputs[port++];
        break;
      case Op::constant:
        value = node.value;
        break;
      case Op::join:
      case Op::add:
        value = x(0) + x(1);
        break;
      case Op::sub:
        value = x(0) - x(1);
        break;
      case Op::add_sub:
        value = x(0) != 0 ? x(1) - x(2) : x(1) + x(2);
        break;
      case Op::mul:
        value = x(0) * x(1);
        break;
      case Op::div:
        value = x(0) / x(1);
        break;
      case Op::sqrt:
        value = std::sqrt(x(0));
        break;
      case Op::table:
        value = short_way(x(0), netlist.tables()[static_cast<std::size_t>(node.table)]->index);
        break;
      case Op::column: {
        const Node& read = netlist.nodes()[static_cast<std::size_t>(node.operands[0])];
        const Table& table = *netlist.tables()[static_cast<std::size_t>(read.table)];
        std::vector<double> index{x(0)};
        for (std::size_t i = 1; i < read.operands.size(); ++i)
          index.push_back(short_way(values[static_cast<std::size_t>(read.operands[i])], table.fields[i - 1].index));
        value = table.value(table.columns[static_cast<std::size_t>(node.amount)], index.data());
        break;
      }
      case Op::shift:
        value = x(0) * std::pow(2.0, node.amount);
        break;
      case Op::shift_by: {
        const double places = std::floor(x(1));
        value = std::isnan(places) ? places : std::ldexp(x(0), -static_cast<int>(std::max(-2044.0, std::min(2044.0, places))));
        break;
      }
      case Op::negate:
        value = -x(0);
        break;
      case Op::absolute:
        value = std::fabs(x(0));
        break;
      case Op::half_turn:
        value = x(0) + 0.5;
        break;
      case Op::clamp:
        value = std::isnan(x(0)) || x(0) > node.high ? node.high : x(0) < node.low ? node.low : x(0);
        break;
      case Op::select:
        value = x(0) != 0 ? x(1) : x(2);
        break;
      case Op::is_negative:
        value = x(0) < 0;
        break;
      case Op::is_beyond_quarter:
        value = x(0) > 0.25 || x(0) < -0.25;
        break;
      case Op::exclusive_or:
        value = (x(0) != 0) != (x(1) != 0);
        break;
    }
    values.push_back(short_way(value, node.format));
  }
  return values;
}

}  // namespace

TEST_CASE("double evaluation of random netlists equals their formulas to the last bit") {
  Random random(77);
  constexpr int lanes = 7;
  for (int i = 0; i < 1500; ++i) {
    const Netlist netlist = random_netlist(random, 24);
    std::vector<std::vector<double>> inputs, outputs(netlist.outputs().size(), std::vector<double>(lanes));
    std::vector<const double*> in;
    std::vector<double*> out;
    for (const Netlist::Port& port : netlist.inputs()) {
      inputs.emplace_back();
      for (int lane = 0; lane < lanes; ++lane)
        inputs.back().push_back(random_value(random, netlist.nodes()[static_cast<std::size_t>(port.node)].format));
    }
    for (const auto& values : inputs) in.push_back(values.data());
    for (auto& values : outputs) out.push_back(values.data());
    const auto evaluator = make_evaluator(netlist, Arithmetic::real);
    evaluator->evaluate(in.data(), lanes, out.data());
    for (int lane = 0; lane < lanes; ++lane) {
      std::vector<double> values;
      for (const auto& port : inputs) values.push_back(port[static_cast<std::size_t>(lane)]);
      const std::vector<double> expected = directly(netlist, values);
      for (std::size_t node = 0; node < expected.size(); ++node) {
        INFO("netlist " << i << ", " << name_of(netlist.nodes()[node].op) << " '" << netlist.nodes()[node].name << "'");
        const double value = evaluator->value(static_cast<int>(node), lane);
        if (std::isnan(expected[node]))
          REQUIRE(std::isnan(value));
        else
          REQUIRE(value == expected[node]);
      }
      for (std::size_t j = 0; j < outputs.size(); ++j) {
        const double value = outputs[j][static_cast<std::size_t>(lane)],
                     node = expected[static_cast<std::size_t>(netlist.outputs()[j].node)];
        REQUIRE((value == node || (std::isnan(value) && std::isnan(node))));
      }
    }
  }
}

TEST_CASE("a recorded product-to-sum identity gives the product, in double exactly and in fixed point within its words") {
  constexpr double two_pi = 6.283185307179586;
  Table table;
  table.name = "SIN";
  table.index = turns(14);
  table.folding = Folding::quarter;
  table.address_bits = 12;
  Column sine;
  sine.name = "sin";
  sine.function = [](double x) { return std::sin(two_pi * x); };
  sine.format = sfixed(16, 14);
  sine.symmetry.odd_about_zero = true;
  table.columns.push_back(sine);
  const auto shared = std::make_shared<const Table>(table);
  Netlist n("identity");
  const Wire a = n.input("a", turns(14)), b = n.input("b", turns(14));
  const Wire sum = n.table("sin_sum", shared, n.add("sum", a, b, turns(14))).front();
  const Wire difference = n.table("sin_difference", shared, n.sub("difference", a, b, turns(14))).front();
  n.output("sin a cos b", n.shift("half", n.add("both", sum, difference, sfixed(17, 14)), -1, sfixed(17, 15)));
  const auto exact = make_evaluator(n, Arithmetic::real), fixed = make_evaluator(n, Arithmetic::fixed);
  Random random(14);
  for (int i = 0; i < 2000; ++i) {
    const double x = random.real(-3, 3), y = random.real(-3, 3);
    const double* in[] = {&x, &y};
    double value = 0, word = 0;
    double* out_value[] = {&value};
    double* out_word[] = {&word};
    exact->evaluate(in, 1, out_value);
    fixed->evaluate(in, 1, out_word);
    REQUIRE(value == Approx(std::sin(two_pi * x) * std::cos(two_pi * y)).margin(1e-13));
    REQUIRE(std::fabs(word - value) < 2 * two_pi * table.index.step() + sine.format.step());
  }
}

TEST_CASE("zero by zero goes to the upper bound of a clamp in both arithmetics") {
  Netlist n("unit");
  const Wire a = n.input("a", ufixed(8, 8)), b = n.input("b", ufixed(8, 8));
  n.output("ratio", n.clamp("ratio_clamped", n.div("ratio", a, b, ufixed(10, 8)), 0, 1, ufixed(9, 8)));
  const double zero = 0, half = 0.5;
  for (const double* numerator : {&zero, &half})
    for (const Arithmetic arithmetic : {Arithmetic::real, Arithmetic::fixed}) {
      const double* in[] = {numerator, &zero};
      double ratio = -1;
      double* out[] = {&ratio};
      make_evaluator(n, arithmetic)->evaluate(in, 1, out);
      CHECK(ratio == 1.0);
    }
}

TEST_CASE("words are asked of fixed-point evaluators only") {
  Netlist n("unit");
  n.output("y", n.negate("y", n.input("x", sfixed(8, 4)), sfixed(8, 4)));
  CHECK_THROWS(make_evaluator(n, Arithmetic::real)->raw(0, 0));
}

TEST_CASE("in double precision a table of the fraction and a barrel shifter make an exact antilogarithm") {
  Netlist n("antilogarithm");
  Table table;
  table.name = "T";
  table.formula = "2^-x";
  table.index = ufixed(8, 8);
  Column column;
  column.name = "power";
  column.function = [](double x) { return std::exp2(std::floor(x) - x); };
  column.format = ufixed(10, 9);
  table.columns.push_back(column);
  const Wire log = n.input("log", ufixed(12, 8));
  const Wire power = n.table("T", std::make_shared<const Table>(table), n.shift("fraction", log, 0, table.index)).front();
  n.output("value", n.shift_by("value", power, n.shift("whole", log, 0, ufixed(4, 0)), ufixed(16, 15)));
  const auto real = make_evaluator(n, Arithmetic::real), fixed = make_evaluator(n, Arithmetic::fixed);
  Random random(8);
  for (int i = 0; i < 2000; ++i) {
    const double x = i == 0 ? 0 : i == 1 ? 15 : random.real(0, 15.9);
    const double* in[] = {&x};
    double exact = 0, word = 0;
    double* out[] = {&exact};
    real->evaluate(in, 1, out);
    out[0] = &word;
    fixed->evaluate(in, 1, out);
    INFO(x);
    REQUIRE(exact == Approx(std::exp2(-x)).epsilon(1e-14));
    // half a step of the logarithm and of the table's word, relative; then the shifter drops less than a step
    REQUIRE(word <= std::exp2(-x) * (1 + 0x1p-8) + 0x1p-15);
    REQUIRE(word >= std::exp2(-x) * (1 - 0x1p-8) - 0x1p-15);
  }
}
