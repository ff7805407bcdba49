#include <catch2/catch.hpp>

#include "datapath/real_power.h"
#include "ulp.h"

using namespace bump;
using namespace bump_test;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity(), not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("powers are within 1.5 units in the last place, from subnormals to infinity") {
  Random random(1);
  std::vector<double> bases;
  for (int i = 0; i < 40000; ++i) {
    bases.push_back(random.real(0, 1));
    bases.push_back(random.real(0, 4));
    bases.push_back(std::exp2(random.real(-1074, 1023)));
    bases.push_back(1 + random.real(-1, 1) * std::exp2(random.real(-52, -1)));
    bases.push_back(std::sqrt(0.5) * std::exp2(random.integer(-20, 20)) * (1 + random.real(-1, 1) * std::exp2(random.real(-52, -10))));
  }
  add_neighbours(bases, 1);
  add_neighbours(bases, std::numeric_limits<double>::min());
  for (double x = std::numeric_limits<double>::denorm_min(); x < 1; x *= 2) bases.push_back(x);
  double largest = 0, base = 0, exponent = 0;
  for (const double x : bases) {
    for (const double n : {1.0, 30.0, random.real(1, 1024), random.real(-2, 2), random.real(-1, 1) * std::exp2(random.real(-30, 20)),
                           random.real(-1074, 1024) / std::log2(x)}) {
      if (!(std::fabs(n) <= 0x1p20)) continue;
      const double error = ulps(power(x, n), std::pow(static_cast<long double>(x), static_cast<long double>(n)));
      if (error > largest) largest = error, base = x, exponent = n;
    }
  }
  INFO(largest << " at " << base << " to the power " << exponent);
  CHECK(largest < 1.5);
}

TEST_CASE("powers of the ends of the range are those of the C library") {
  for (const double n : {1.0, 30.0, 1e-3, -1.0, -0.5, 0.0, 1048576.0, -1048576.0})
    for (const double x :
         {0.0, std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max(), 1.0, infinity, not_a_number}) {
      INFO(x << " to the power " << n);
      const double value = power(x, n), expected = std::pow(x, n);
      CHECK((std::isnan(expected) ? std::isnan(value) : value == Approx(expected).epsilon(1e-15)));
    }
  CHECK(std::isnan(power(-0.5, 2)));
  CHECK(power(-0.0, 2) == 0);
}
