#pragma once
// The floor that the netlist evaluators are measured against: environment and illumination unit of Lee 2007 (default reading) written by
// hand as one loop over the lanes, in double precision, with nothing stored between the units. The mathematics is a parameter: polynomials
// good to about 1e-7 (Abramowitz and Stegun 4.4.46 and 4.4.49, Taylor series), which vectorise; or the library's functions, good to about
// half a unit in the last place, a call for every value.

#include <cmath>
#include <cstdint>

#include "datapath/lane_clones.h"
#include "datapath/lane_math.h"

namespace bump::bench {

/// What a fragment brings, in turns, an array of lanes each; and what the diffuse and specular tables hold.
struct LeeFragments {
  const double *n_phi, *n_theta, *l_phi, *l_theta, *h_phi, *h_theta, *map_phi, *map_theta, *alpha;
  double diffuse, specular, shininess;
};

constexpr double two_pi = 6.283185307179586476925;
constexpr double turns_per_radian = 1 / two_pi;

struct LibraryMathematics {
  static double sine(double turns) { return std::sin(two_pi * turns); }
  static double cosine(double turns) { return std::cos(two_pi * turns); }
  static double arc_sine(double x) { return std::asin(x) / two_pi; }
  /// Of y / x, both positive.
  static double arc_tangent(double y, double x) { return std::atan(y / x) / two_pi; }
  static double power(double x, double n) { return std::pow(x, n); }
};

struct PolynomialMathematics {
  /// sin(2 pi x) for |x| <= 1/4, Taylor series to the 11th power: 6e-8.
  static double quarter_sine(double x) {
    const double a = two_pi * x, s = a * a;
    return a * (1 + s * (-1.0 / 6 + s * (1.0 / 120 + s * (-1.0 / 5040 + s * (1.0 / 362880 - s * (1.0 / 39916800))))));
  }
  static double cosine(double turns) {
    const double whole = (turns + one_and_a_half_times_two_to_52) - one_and_a_half_times_two_to_52;
    return quarter_sine(0.25 - std::fabs(turns - whole));
  }
  static double sine(double turns) { return cosine(turns - 0.25); }
  static double arc_sine(double x) {
    const double m = std::fabs(x);
    const double sum =
        1.5707963050 +
        m * (-0.2145988016 +
             m * (0.0889789874 + m * (-0.0501743046 + m * (0.0308918810 + m * (-0.0170881256 + m * (0.0066700901 - m * 0.0012624911))))));
    return std::copysign(0.25 - std::sqrt(1 - m) * sum * turns_per_radian, x);
  }
  static double arc_tangent(double y, double x) {
    const double t = (y < x ? y : x) / (y < x ? x : y), s = t * t;
    const double sum =
        1 + s * (-0.3333314528 +
                 s * (0.1999355085 +
                      s * (-0.1420889944 +
                           s * (0.1065626393 + s * (-0.0752896400 + s * (0.0429096138 + s * (-0.0161657367 + s * 0.0028662257)))))));
    const double turns = t * sum * turns_per_radian;
    return y < x ? turns : 0.25 - turns;
  }
  /// x^n for 0 <= x <= 1: the mantissa's logarithm by the series of the inverse hyperbolic tangent, the power by that of the exponential.
  static double power(double x, double n) {
    const std::int64_t bits = bits_from_double(x < 1e-30 ? 1e-30 : x);
    const std::int64_t above = bits - 0x3fe6a09e667f3bcd;  // from sqrt(1/2)
    const auto biased = static_cast<std::int64_t>(static_cast<std::uint64_t>(above + (std::int64_t{1} << 62)) >> 52);
    const double exponent = double_of_narrow(biased - 1024);
    const double mantissa = double_from_bits(bits - ((biased - 1024) << 52));
    const double q = (mantissa - 1) / (mantissa + 1), s = q * q;
    const double logarithm = exponent + 2.885390081777927 * q * (1 + s * (1.0 / 3 + s * (1.0 / 5 + s * (1.0 / 7 + s * (1.0 / 9)))));
    const double y = n * logarithm < -1000 ? -1000 : n * logarithm;
    const double whole = (y + one_and_a_half_times_two_to_52) - one_and_a_half_times_two_to_52;
    const double f = (y - whole) * 0.6931471805599453;
    const double series = 1 + f * (1 + f * (1.0 / 2 + f * (1.0 / 6 + f * (1.0 / 24 + f * (1.0 / 120 + f * (1.0 / 720))))));
    return double_from_bits(bits_from_double(series) + (narrow_of_double(whole) << 52));
  }
};

template <class M>
struct LeeDatapath {
  struct Direction {
    double phi, theta;
  };

  /// Eqs 5-9, 16, 26, 27.
  static inline __attribute__((always_inline)) Direction rotate(double phi, double theta, double n_phi, double n_theta) {
    const double d = phi - n_phi, X = theta + d, Y = theta - d;
    const double sx = 0.5 * (M::sine(X) + M::sine(Y)), twice_y = M::cosine(Y) - M::cosine(X), abs_y = 0.5 * std::fabs(twice_y);
    const double principal = M::arc_sine(sx > 1 ? 1 : sx < -1 ? -1 : sx);
    const double theta_x = std::fabs(theta) > 0.25 ? 0.5 - principal : principal;
    const double apart = theta_x - n_theta;
    const double Z = apart - ((apart + one_and_a_half_times_two_to_52) - one_and_a_half_times_two_to_52);
    const double sine = std::fabs(M::sine(Z)) + 1e-13, cosine = std::fabs(M::cosine(Z)) + 1e-13;
    const double first = M::arc_tangent(abs_y, sine);
    const double upper = Z < 0 ? 0.5 - first : first;
    const double y_k = abs_y < cosine ? abs_y / cosine : 1;
    const double share = 4 * M::arc_sine(y_k), abs_z = std::fabs(Z);
    return {twice_y < 0 ? -upper : upper, abs_z + (0.25 - abs_z) * share};
  }

  /// Eqs 24 and 25 in the form of 11 adders.
  static inline __attribute__((always_inline)) double dot(const Direction& a, double phi, double theta) {
    const double u = M::cosine(a.theta - theta), v = M::cosine(a.theta + theta), c = 0.5 + 0.5 * M::cosine(a.phi - phi);
    const double product = v + (u - v) * c;
    const double below = product < 1 ? product : 1;
    return below > 0 ? below : 0;
  }

  static inline __attribute__((always_inline)) void shade(const LeeFragments& f, int lanes, double* __restrict intensity) {
    for (int i = 0; i < lanes; ++i) {
      const Direction light = rotate(f.l_phi[i], f.l_theta[i], f.n_phi[i], f.n_theta[i]);
      const Direction half = rotate(f.h_phi[i], f.h_theta[i], f.n_phi[i], f.n_theta[i]);
      const double phi = f.map_phi[i] + f.alpha[i], theta = f.map_theta[i];
      intensity[i] = f.diffuse * dot(light, phi, theta) + f.specular * M::power(dot(half, phi, theta), f.shininess);
    }
  }
};

BUMP_LANE_LOOP void shade_by_polynomials(const LeeFragments& fragments, int lanes, double* __restrict intensity) {
  LeeDatapath<PolynomialMathematics>::shade(fragments, lanes, intensity);
}

inline void shade_by_library(const LeeFragments& fragments, int lanes, double* __restrict intensity) {
  LeeDatapath<LibraryMathematics>::shade(fragments, lanes, intensity);
}

}  // namespace bump::bench
