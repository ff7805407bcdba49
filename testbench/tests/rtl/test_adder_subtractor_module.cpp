#include <algorithm>
#include <catch2/catch.hpp>

#include "rtl/adder_subtractor_module.h"
#include "verilog_tools.h"

using namespace bump;
using namespace bump_test;

namespace {

Format random_format(std::mt19937_64& random, int widest) {
  const int width = integer(random, 1, widest), fraction = integer(random, -3, 8);
  return integer(random, 0, 1) == 0 ? ufixed(width, fraction) : sfixed(width, fraction);
}

/// The rule of the netlist: exact, then format.h.
std::int64_t sum_of(const Format& a, const Format& b, const Format& sum, const PortWords& words) {
  const int fraction = std::max(a.fraction, b.fraction);
  const std::int64_t left = words[1] * (std::int64_t{1} << (fraction - a.fraction)),
                     right = words[2] * (std::int64_t{1} << (fraction - b.fraction));
  return truncate(words[0] != 0 ? left - right : left + right, fraction, sum);
}

void compare(int devices, int widest, std::size_t most, std::uint64_t seed) {
  if (!is_there("iverilog")) return;
  std::mt19937_64 random(seed);
  IcarusBench bench;
  for (int i = 0; i < devices; ++i) {
    const Format a = random_format(random, widest), b = random_format(random, widest), sum = random_format(random, widest + 3);
    Device device;
    bench.add(adder_subtractor_module(a, b, sum));
    device.name = adder_subtractor_module(a, b, sum).name;
    device.inputs = {{"subtract", flag()}, {"a", a}, {"b", b}};
    device.outputs = {{"q", sum}};
    device.vectors = words_for(device.inputs, most, random);
    for (const PortWords& words : device.vectors) device.expected.push_back({sum_of(a, b, sum, words)});
    bench.add(std::move(device));
  }
  CHECK(bench.mismatches() == "");
  if (is_there("verilator")) CHECK(lint(bench.modules()) == "");
}

}  // namespace

TEST_CASE("the adder-subtractor's Verilog follows the rule of arithmetic for every word of narrow formats") {
  compare(120, 5, 2048, 5);
}

TEST_CASE("the adder-subtractor's Verilog follows the rule of arithmetic for corner and random words of wide formats") {
  compare(60, 48, 300, 6);
}
