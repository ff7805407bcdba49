#include <catch2/catch.hpp>

#include "datapath/arithmetic.h"
#include "rtl/divider_module.h"
#include "verilog_tools.h"

using namespace bump;
using namespace bump_test;
using Catch::Contains;

namespace {

Device divider(const Format& a, const Format& b, const Format& quotient, int stages, std::size_t most, std::mt19937_64& random) {
  Device device;
  device.name = divider_module(a, b, quotient, stages).name;
  device.inputs = {{"a", a}, {"b", b}};
  device.outputs = {{"q", quotient}};
  device.stages = stages;
  device.vectors = words_for(device.inputs, most, random);
  for (const PortWords& words : device.vectors)
    device.expected.push_back({divide_by_array(words[0], words[1], divider_shape(a, b, quotient))});
  return device;
}

/// Any format whose words the divider takes; shifted dividends of up to `most` bits.
struct DividerFormats {
  Format a, b, quotient;
};
DividerFormats random_formats(std::mt19937_64& random, int widest, int most) {
  for (;;) {
    DividerFormats f;
    const bool is_signed = integer(random, 0, 2) > 0;
    f.a =
        is_signed ? sfixed(integer(random, 1, widest), integer(random, -3, 6)) : ufixed(integer(random, 1, widest), integer(random, -3, 6));
    f.b = ufixed(integer(random, 1, widest - 1), integer(random, -3, 6));
    const int width = integer(random, 2, widest + 3), fraction = integer(random, -3, 12);
    f.quotient = is_signed || integer(random, 0, 1) == 1 ? sfixed(width, fraction) : ufixed(width, fraction);
    if (divider_shape(f.a, f.b, f.quotient).dividend <= most) return f;
  }
}

}  // namespace

TEST_CASE("the divider's Verilog divides as the array does, for every word of narrow formats") {
  if (!is_there("iverilog")) return;
  std::mt19937_64 random(1);
  IcarusBench bench;
  for (int i = 0; i < 60; ++i) {
    const DividerFormats f = random_formats(random, 6, 62);
    const int rows = magnitude_bits(f.quotient), stages = i % 3 == 0 ? rows - 1 : integer(random, 0, rows + 2);
    bench.add(divider_module(f.a, f.b, f.quotient, stages));
    bench.add(divider(f.a, f.b, f.quotient, stages, 2048, random));
  }
  CHECK(bench.mismatches() == "");
  if (is_there("verilator")) CHECK(lint(bench.modules()) == "");
}

TEST_CASE("the divider's Verilog divides as the array does, for corner and random words of wide formats") {
  if (!is_there("iverilog")) return;
  std::mt19937_64 random(2);
  IcarusBench bench;
  for (int i = 0; i < 24; ++i) {
    const DividerFormats f = random_formats(random, i % 2 == 0 ? 20 : 40, 62);
    const int rows = magnitude_bits(f.quotient), stages = i % 3 == 0 ? rows - 1 : integer(random, 0, rows + 2);
    bench.add(divider_module(f.a, f.b, f.quotient, stages));
    bench.add(divider(f.a, f.b, f.quotient, stages, 300, random));
  }
  CHECK(bench.mismatches() == "");
  if (is_there("verilator")) CHECK(lint(bench.modules()) == "");
}

TEST_CASE("a divider without internal stages has no clock, and only a share of rows other than one is in its name") {
  const Format a = sfixed(15, 13), b = ufixed(14, 13), q = sfixed(13, 11);
  CHECK(divider_module(a, b, q, 11).name == "div_s15_13_by_u14_13_to_s13_11");
  CHECK(divider_module(a, b, q, 5).name == "div_s15_13_by_u14_13_to_s13_11_n5");
  CHECK_THAT(divider_module(a, b, q, 5).text, Contains("clk"));
  CHECK_THAT(divider_module(a, b, q, 0).text, !Contains("clk"));
  CHECK(divider_module(sfixed(9, -2), ufixed(4, 0), sfixed(9, 0), 7).name == "div_s9_m2_by_u4_0_to_s9_0");
}
