#include <catch2/catch.hpp>

#include "datapath/real_turns.h"
#include "ulp.h"

using namespace bump;
using namespace bump_test;

namespace {

constexpr double largest_angle = 0x1p47, largest_length = 0x1p1000;
constexpr double infinity = std::numeric_limits<double>::infinity(), not_a_number = std::numeric_limits<double>::quiet_NaN();

/// What remains of an angle beyond the nearest quarter turn, and the number of the quarter.
struct Reduced {
  long double angle;
  int quarter;
};
Reduced reduced(double turns) {
  const double rest = std::remainder(turns, 1.0), quarters = std::nearbyint(4 * rest);
  return {long_two_pi * (static_cast<long double>(rest) - quarters / 4.0L), static_cast<int>(quarters) & 3};
}
long double true_sine(double turns) {
  const auto [angle, quarter] = reduced(turns);
  const long double magnitude = quarter % 2 == 0 ? std::sin(angle) : std::cos(angle);
  return quarter >= 2 ? -magnitude : magnitude;
}
long double true_cosine(double turns) {
  const auto [angle, quarter] = reduced(turns);
  const long double magnitude = quarter % 2 == 0 ? std::cos(angle) : std::sin(angle);
  return quarter == 1 || quarter == 2 ? -magnitude : magnitude;
}
long double true_arc_sine(double x) {
  return std::asin(std::fmin(1.0L, std::fmax(-1.0L, x))) / long_two_pi;
}
long double true_arc_cosine(double x) {
  return std::acos(std::fmin(1.0L, std::fabs(static_cast<long double>(x)))) / long_two_pi;
}

template <class F, class Truth>
double largest_error(const std::vector<double>& values, F f, Truth truth) {
  double largest = 0, at = 0;
  for (const double x : values) {
    const double error = ulps(f(x), truth(x));
    if (error > largest || std::isnan(error)) largest = error, at = x;
  }
  UNSCOPED_INFO(largest << " at " << at);
  return largest;
}

}  // namespace

TEST_CASE("sines and cosines of turns are within 1.5 units in the last place") {
  Random random(1);
  const std::vector<double> values = delicate_values(random, largest_angle, 60000);
  CHECK(largest_error(values, sine_of_turns, true_sine) < 1.5);
  CHECK(largest_error(values, cosine_of_turns, true_cosine) < 1.5);
}

TEST_CASE("inverse functions in turns are within 1.5 units in the last place") {
  Random random(2);
  const std::vector<double> values = delicate_values(random, 1, 60000), all = delicate_values(random, largest_length, 60000);
  CHECK(largest_error(values, arc_sine_in_turns, true_arc_sine) < 1.5);
  CHECK(largest_error(values, arc_cosine_of_magnitude_in_turns, true_arc_cosine) < 1.5);
  CHECK(largest_error(
            all, [](double x) { return arc_tangent_in_turns(x); },
            [](double x) { return std::atan(static_cast<long double>(x)) / long_two_pi; }) < 1.5);
}

TEST_CASE("the angle of a vector is within 1.5 units in the last place") {
  Random random(3);
  std::vector<double> ys = delicate_values(random, 4, 20000), xs = delicate_values(random, 4, 20000);
  double largest = 0;
  for (std::size_t i = 0; i < std::min(xs.size(), ys.size()); ++i) {
    const double x = xs[xs.size() - 1 - i], y = ys[i];
    if (x == 0 && y == 0) continue;
    for (const double scale : {1.0, 0x1p900, 0x1p-900})
      largest = std::max(largest, ulps(arc_tangent_in_turns(y * scale, x * scale),
                                       std::atan2(static_cast<long double>(y * scale), x * scale) / long_two_pi));
  }
  CHECK(largest < 1.5);
}

TEST_CASE("multiples of a quarter turn have their exact sines") {
  for (int i = -64; i <= 64; ++i) {
    const double turns = i * 0.25;
    CHECK(sine_of_turns(turns) == (i % 2 == 0 ? 0 : (i & 3) == 1 ? 1 : -1));
    CHECK(cosine_of_turns(turns) == (i % 2 != 0 ? 0 : (i & 3) == 0 ? 1 : -1));
  }
}

TEST_CASE("inverse functions meet their ends exactly") {
  CHECK(arc_sine_in_turns(1) == 0.25);
  CHECK(arc_sine_in_turns(-1) == -0.25);
  CHECK(arc_sine_in_turns(infinity) == 0.25);
  CHECK(arc_sine_in_turns(-1.5) == -0.25);
  CHECK(arc_cosine_of_magnitude_in_turns(-1) == 0);
  CHECK(arc_cosine_of_magnitude_in_turns(2) == 0);
  CHECK(arc_cosine_of_magnitude_in_turns(0) == 0.25);
  CHECK(arc_tangent_in_turns(1) == 0.125);
  CHECK(arc_tangent_in_turns(-1) == -0.125);
  CHECK(arc_tangent_in_turns(infinity) == 0.25);
  CHECK(arc_tangent_in_turns(-infinity) == -0.25);
  CHECK(arc_tangent_in_turns(0, 0) == 0);
  CHECK(arc_tangent_in_turns(0, -1) == 0.5);
  CHECK(arc_tangent_in_turns(-0.0, -1) == -0.5);
  CHECK(arc_tangent_in_turns(-2, -0.0) == -0.25);
  CHECK(arc_tangent_in_turns(3, -3) == 0.375);
}

TEST_CASE("odd functions are odd to the bit, zeros keep their signs and NaN stays NaN") {
  Random random(4);
  const auto same_bits = [](double a, double b) { return bits_from_double(a) == bits_from_double(b); };
  for (const double x : delicate_values(random, 1, 2000)) {
    if (std::remainder(x, 0.25) != 0 || x == 0) REQUIRE(same_bits(sine_of_turns(-x), -sine_of_turns(x)));
    if (std::remainder(x, 0.25) != 0) REQUIRE(same_bits(cosine_of_turns(-x), cosine_of_turns(x)));
    REQUIRE(same_bits(arc_sine_in_turns(-x), -arc_sine_in_turns(x)));
    REQUIRE(same_bits(arc_tangent_in_turns(-x), -arc_tangent_in_turns(x)));
    REQUIRE(same_bits(arc_cosine_of_magnitude_in_turns(-x), arc_cosine_of_magnitude_in_turns(x)));
  }
  CHECK(std::signbit(sine_of_turns(-0.0)));
  CHECK(std::signbit(arc_sine_in_turns(-0.0)));
  CHECK(std::signbit(arc_tangent_in_turns(-0.0)));
  for (const double x : {infinity, -infinity, not_a_number}) {
    CHECK(std::isnan(sine_of_turns(x)));
    CHECK(std::isnan(cosine_of_turns(x)));
  }
  CHECK(std::isnan(arc_sine_in_turns(not_a_number)));
  CHECK(std::isnan(arc_cosine_of_magnitude_in_turns(not_a_number)));
  CHECK(std::isnan(arc_tangent_in_turns(not_a_number)));
  CHECK(std::isnan(arc_tangent_in_turns(not_a_number, 1)));
  CHECK(std::isnan(arc_tangent_in_turns(1, not_a_number)));
}
