#include <catch2/catch.hpp>

#include "datapath/arithmetic.h"
#include "rtl/square_root_module.h"
#include "verilog_tools.h"

using namespace bump;
using namespace bump_test;
using Catch::Contains;

namespace {

Device square_root(const Format& a, const Format& root, int stages, std::size_t most, std::mt19937_64& random) {
  Device device;
  device.name = square_root_module(a, root, stages).name;
  device.inputs = {{"a", a}};
  device.outputs = {{"q", root}};
  device.stages = stages;
  device.vectors = words_for(device.inputs, most, random);
  for (const PortWords& words : device.vectors) device.expected.push_back({root_by_array(words[0], root_shape(a, root))});
  return device;
}

void compare(int devices, int widest, std::size_t most, std::uint64_t seed) {
  if (!is_there("iverilog")) return;
  std::mt19937_64 random(seed);
  IcarusBench bench;
  for (int i = 0; i < devices; ++i) {
    const Format a = ufixed(integer(random, 1, widest), integer(random, -4, widest));
    const int width = integer(random, 2, widest), fraction = integer(random, -4, widest);
    const Format root = integer(random, 0, 1) == 0 ? ufixed(width, fraction) : sfixed(width, fraction);
    if (a.width + root_shape(a, root).shift > 62) continue;
    const int bits = magnitude_bits(root), stages = i % 3 == 0 ? bits - 1 : integer(random, 0, bits + 2);
    bench.add(square_root_module(a, root, stages));
    bench.add(square_root(a, root, stages, most, random));
  }
  CHECK(bench.modules().size() > static_cast<std::size_t>(devices) / 2);
  CHECK(bench.mismatches() == "");
  if (is_there("verilator")) CHECK(lint(bench.modules()) == "");
}

}  // namespace

TEST_CASE("the square root's Verilog takes the root as the array does, for every word of narrow formats") {
  compare(70, 10, 1024, 3);
}

TEST_CASE("the square root's Verilog takes the root as the array does, for corner and random words of wide formats") {
  compare(40, 34, 300, 4);
}

TEST_CASE("a square root without internal stages has no clock, and only stages other than one a bit are in its name") {
  const Format a = ufixed(16, 14), q = ufixed(9, 8);
  CHECK(square_root_module(a, q, 8).name == "sqrt_u16_14_to_u9_8");
  CHECK(square_root_module(a, q, 2).name == "sqrt_u16_14_to_u9_8_n2");
  CHECK_THAT(square_root_module(a, q, 2).text, Contains("clk"));
  CHECK_THAT(square_root_module(a, q, 0).text, !Contains("clk"));
}
