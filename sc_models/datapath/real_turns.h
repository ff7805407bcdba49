#pragma once
// Trigonometry of double-precision evaluation with angles in turns, as the netlists hold them: sine, cosine and their inverses. Free of
// branches, calls and tables, so that a loop over lanes vectorises and gives the same bits at any width, on any machine and at any place
// of a block; errors are below 1.5 units in the last place over the whole range accepted (testbench/tests/datapath/test_real_turns.cpp).
// Reduction is exact because a turn is a number, which 2 pi is not: cos 2 pi x at x = 1/4 is 0. Written here because the deterministic
// functions of SLEEF 3.5.1 take, for Lee's datapath, more than twice the time of the whole loop written by hand (lee_floor.h), and
// the C library takes a call a lane. Coefficients interpolate at Chebyshev's nodes. Timing: none, this is host arithmetic.

#include "datapath/lane_math.h"

namespace bump {

/// 2 pi and 1 / 2 pi, each a leading half and the rest.
constexpr double two_pi_top = 0x1.921fb5p+2, two_pi_rest = 0x1.110b4611a6263p-24;
constexpr double turn_top = 0x1.45f3068p-3, turn_rest = 0x1.727220a94fe14p-29;

struct SineCosine {
  double sine, cosine;
};

/// Of 2 pi x, |x| < 2^48; infinities and NaN give NaN. The sine of a zero is that zero; other zeros have either sign.
BUMP_LANE_FUNCTION SineCosine sine_cosine_of_turns(double x) {
  // The nearest quarter turn; its number modulo 4 stands in the lowest bits of the sum.
  const double sum = 4 * x + one_and_a_half_times_two_to_52;
  const std::int64_t quarter = bits_from_double(sum);
  const double rest = x - 0.25 * (sum - one_and_a_half_times_two_to_52), r = std::fabs(rest), s = r * r;
  constexpr double of_sine[] = {-0x1.4abbce625be52p+5, 0x1.466bc6775a476p+6,  -0x1.32d2cce500387p+6,
                                0x1.50783208843ebp+5,  -0x1.e3027dea82bd7p+3, 0x1.e4a9d9166f052p+1};
  constexpr double of_cosine[] = {-0x1.3bd3cc9be45dep+4, 0x1.03c1f081b5ac0p+6, -0x1.55d3c7e3cb241p+6, 0x1.e1f5068688d5bp+5,
                                  -0x1.a6d1eef479be1p+4, 0x1.f9ce245cada0bp+2, -0x1.b2f3eb054afcdp+0};
  const double top = top_half(r);
  const double sine = top * two_pi_top + ((r - top) * two_pi_top + r * (two_pi_rest + s * polynomial(of_sine, s)));
  const double cosine = 1 + s * polynomial(of_cosine, s);
  // An odd quarter swaps the two; signs go by bits, which no comparison or multiplication touches.
  const std::int64_t swap = -(quarter & 1), topmost = bits_from_double(-0.0);
  const std::int64_t s_bits = bits_from_double(sine) ^ (bits_from_double(rest) & topmost), c_bits = bits_from_double(cosine);
  const std::int64_t differ = (s_bits ^ c_bits) & swap;
  const std::int64_t s_sign = (quarter << 62) & topmost, c_sign = ((quarter + 1) << 62) & topmost;
  return {double_from_bits(s_bits ^ differ ^ s_sign), double_from_bits(c_bits ^ differ ^ c_sign)};
}

BUMP_LANE_FUNCTION double sine_of_turns(double x) {
  return sine_cosine_of_turns(x).sine;
}

BUMP_LANE_FUNCTION double cosine_of_turns(double x) {
  return sine_cosine_of_turns(x).cosine;
}

/// z / 2 pi + z^3 p(z^2) as a leading product without rounding, and the rest.
struct TopAndRest {
  double top, rest;
};
template <std::size_t n>
BUMP_LANE_FUNCTION TopAndRest in_turns(double z, double squared, const double (&p)[n]) {
  const double top = top_half(z);
  return {top * turn_top, (z - top) * turn_top + z * (turn_rest + squared * polynomial(p, squared))};
}

/// asin |x| / 2 pi as top + rest where |x| <= 1/2, acos |x| / 4 pi elsewhere: what both inverses begin with.
struct ArcOfMagnitude {
  TopAndRest angle;
  std::int64_t beyond;  ///< all ones beyond 1/2
};
BUMP_LANE_FUNCTION ArcOfMagnitude arc_of_magnitude(double magnitude) {
  constexpr double p[] = {0x1.b2995e7b7b604p-6, 0x1.8723a1d588499p-7,  0x1.d1a452f2a0e7bp-8,  0x1.3ce52a04819f0p-8,  0x1.d2b3511ff8b23p-9,
                          0x1.69fbea396bfafp-9, 0x1.23733817c23abp-9,  0x1.deedbc4af55d9p-10, 0x1.aeaef5be792a6p-10, 0x1.c76410ac3621cp-11,
                          0x1.6afed9e72d4a0p-9, -0x1.35d2548eb0149p-9, 0x1.2bf48c984f23ep-8};
  const double m = magnitude > 1 ? 1 : magnitude;
  const std::int64_t beyond = -static_cast<std::int64_t>(m > 0.5);
  const double half_rest = 0.5 - 0.5 * m, own = m * m, root = std::sqrt(half_rest);
  return {in_turns(choose(beyond, root, m), choose(beyond, half_rest, own), p), beyond};
}

/// asin(x) / 2 pi; what lies outside [-1, 1] counts as the bound, as a saturated index does.
BUMP_LANE_FUNCTION double arc_sine_in_turns(double x) {
  const auto [angle, beyond] = arc_of_magnitude(std::fabs(x));
  const double base = choose(beyond, 0.25, 0), factor = choose(beyond, -2, 1);
  return std::copysign((base + factor * angle.top) + factor * angle.rest, x);
}

/// acos |x| / 2 pi; |x| above 1 counts as 1.
BUMP_LANE_FUNCTION double arc_cosine_of_magnitude_in_turns(double x) {
  const auto [angle, beyond] = arc_of_magnitude(std::fabs(x));
  const double base = choose(beyond, 0, 0.25), factor = choose(beyond, 2, -1);
  return (base + factor * angle.top) + factor * angle.rest;
}

/// The angle of (x, y), both in [0, 2^1000], from the x axis, in turns; of (0, 0) it is 0. y may also be infinite if x is not.
BUMP_LANE_FUNCTION double arc_tangent_of_magnitudes_in_turns(double y, double x) {
  constexpr double p[] = {-0x1.b2995e7b7b603p-5, 0x1.04c26be3b0659p-5,  -0x1.7483758e5cdc4p-6, 0x1.21bb944ddc998p-6,  -0x1.da1bab480d68dp-7,
                          0x1.912aefc664045p-7,  -0x1.5baacfb440aa9p-7, 0x1.32a1923f59214p-7,  -0x1.1147f65236fe9p-7, 0x1.e2b872f2538c8p-8,
                          -0x1.8d0c62a9e443ap-8, 0x1.04d3c9806ad9ep-8,  -0x1.807f2db8a6df4p-10};
  // From 0, an eighth or a quarter of a turn, whichever is near: the tangent of what remains is at most 1/2.
  const double sum = y + x, difference = y - x;
  const bool low = 2 * y <= x, high = y >= 2 * x;
  const double numerator = low ? y : high ? -x : difference, divisor = low ? x : high ? y : sum;
  const double base = low ? 0 : high ? 0.25 : 0.125;
  const double t = numerator / (divisor == 0 ? 1 : divisor);
  const TopAndRest angle = in_turns(t, t * t, p);
  return (base + angle.top) + angle.rest;
}

/// atan(x) / 2 pi of any x.
BUMP_LANE_FUNCTION double arc_tangent_in_turns(double x) {
  return std::copysign(arc_tangent_of_magnitudes_in_turns(std::fabs(x), 1), x);
}

/// atan2(y, x) / 2 pi, |x|, |y| <= 2^1000; a zero y above a negative x gives half a turn with the sign of y.
BUMP_LANE_FUNCTION double arc_tangent_in_turns(double y, double x) {
  const double first = arc_tangent_of_magnitudes_in_turns(std::fabs(y), std::fabs(x));
  return std::copysign(std::copysign(1.0, x) < 0 ? 0.5 - first : first, y);
}

}  // namespace bump
