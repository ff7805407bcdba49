#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "datapath/format.h"
#include "datapath/lane_kernels.h"
#include "oracle.h"
#include "random_netlist.h"

using namespace bump;
using namespace bump_test;

TEST_CASE("formats print as their authors write them") {
  CHECK(to_string(sfixed(12, 10)) == "s12.10");
  CHECK(to_string(ufixed(8, 8)) == "u8.8");
  CHECK(to_string(turns(10)) == "turn10");
  CHECK(to_string(angle(10, 12)) == "angle s10.12");
  CHECK(to_string(uangle(8, 10)) == "angle u8.10");
  CHECK(to_string(flag()) == "flag");
  CHECK(to_string(real()) == "real");
}

TEST_CASE("a format knows its step and its range") {
  CHECK(sfixed(12, 10).step() == std::ldexp(1.0, -10));
  CHECK(sfixed(12, 10).lowest() == -2.0);
  CHECK(sfixed(12, 10).highest() == 2.0 - std::ldexp(1.0, -10));
  CHECK(ufixed(8, 8).lowest() == 0.0);
  CHECK(ufixed(8, 8).highest() == 255.0 / 256.0);
  CHECK(turns(10).wraps());
  CHECK(angle(10, 10) == turns(10));
  CHECK_FALSE(uangle(10, 10).wraps());
  CHECK_FALSE(angle(9, 10).wraps());
  CHECK_FALSE(sfixed(10, 10).wraps());
  CHECK(std::isinf(real().highest()));
}

TEST_CASE("truncation floors and wraps for any shift") {
  Random random(3);
  for (int i = 0; i < 50000; ++i) {
    const Format to = random_format(random);
    const auto raw = static_cast<std::int64_t>(random.bits()) >> random.integer(2, 63);
    const int fraction = random.integer(-80, 140);
    INFO(raw << " at " << fraction << " to " << to_string(to));
    REQUIRE(truncate(raw, fraction, to) == oracle_round(raw, fraction, to));
    REQUIRE(rounding_rule(fraction, to).apply(raw) == oracle_round(raw, fraction, to));
    REQUIRE(wrap(raw, to) == oracle_round(raw, to.fraction, to));
  }
}

TEST_CASE("floor_shift is a floor for words of 62 bits") {
  Random random(4);
  for (int i = 0; i < 20000; ++i) {
    const auto raw = static_cast<std::int64_t>(random.bits()) >> random.integer(2, 63);
    const int right = random.integer(0, 62);
    REQUIRE(floor_shift(raw, right) == raw >> right);
  }
}

TEST_CASE("numbers enter as the nearest word, halves up") {
  Random random(8);
  for (int i = 0; i < 50000; ++i) {
    const Format to = random_format(random);
    const double value = random_value(random, to);
    INFO(value << " to " << to_string(to));
    REQUIRE(quantise(value, to) == oracle_quantise(value, to));
  }
  const Format f = sfixed(8, 4);
  CHECK(quantise(0.5 / 16, f) == 1);
  CHECK(quantise(-0.5 / 16, f) == 0);
  CHECK(quantise(-1.5 / 16, f) == -1);
  CHECK(quantise(std::nextafter(0.5, 0.0) / 16, f) == 0);
  CHECK(quantise(std::nextafter(-0.5, -1.0) / 16, f) == -1);
}

TEST_CASE("numbers that no word can hold saturate, angles wrap, and not-a-number is zero") {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const int width : {4, 50, 51, 62}) {
    const std::int64_t top = (std::int64_t{1} << (width - 1)) - 1;
    CHECK(quantise(infinity, sfixed(width, 3)) == top);
    CHECK(quantise(-infinity, sfixed(width, 3)) == -top - 1);
    CHECK(quantise(1e300, ufixed(width, 3)) == 2 * top + 1);
    CHECK(quantise(-1.0, ufixed(width, 3)) == 0);
    CHECK(quantise(std::nan(""), sfixed(width, 3)) == 0);
    CHECK(quantise(std::nan(""), turns(width)) == 0);
    CHECK(quantise(infinity, turns(width)) == 0);
    CHECK(quantise(0.5, turns(width)) == -top - 1);
    CHECK(quantise(-0.5, turns(width)) == -top - 1);
    CHECK(quantise(7.25, turns(width)) == (std::int64_t{1} << (width - 2)));
    CHECK(quantise(-1e15, turns(width)) == 0);
  }
}

TEST_CASE("words survive the way to a double and back") {
  Random random(9);
  for (int i = 0; i < 20000; ++i) {
    Format f = random_format(random);
    f.width = std::min(f.width, 53);
    const std::int64_t word = wrap(static_cast<std::int64_t>(random.bits()), f);
    REQUIRE(quantise(to_double(word, f), f) == word);
  }
}

TEST_CASE("full turns are brought to half a turn on either side of 0, everything else is left alone") {
  Random random(10);
  for (int i = 0; i < 20000; ++i) {
    const double value = random.real(-3, 3) * std::ldexp(1.0, random.integer(-60, 60));
    const double wrapped = wrap_turns(value, turns(10));
    REQUIRE(wrapped >= -0.5);
    REQUIRE(wrapped < 0.5);
    const double remainder = std::remainder(value, 1.0);
    REQUIRE(wrapped == (remainder == 0.5 ? -0.5 : remainder));
    REQUIRE(wrap_turns(value, sfixed(10, 10)) == value);
  }
  CHECK(wrap_turns(0.5, turns(4)) == -0.5);
  CHECK(wrap_turns(std::nextafter(0.5, 0.0), turns(4)) == std::nextafter(0.5, 0.0));
  CHECK(wrap_turns(-1e-300, turns(4)) == -1e-300);
}
