#include "schemes/kugler1998/tables.h"

#include <algorithm>
#include <cmath>

#include "datapath/lane_clones.h"
#include "datapath/real_tables.h"
#include "datapath/real_turns.h"

namespace bump::kugler1998 {

namespace {

constexpr double two_pi = 6.283185307179586476925;
constexpr double smallest_divisor = 1e-13;  // keeps the double evaluation finite; a word saturates long before
constexpr int reciprocal_fraction = 8;      // words are 1 at least

Table make_table(const std::string& name, const std::string& formula, const Format& index, Folding folding, int address_bits) {
  Table table;
  table.name = name;
  table.formula = formula;
  table.index = index;
  table.folding = folding;
  table.address_bits = address_bits;
  return table;
}

Column make_column(const std::string& name, const Format& format, RealFunction function) {
  Column column;
  column.name = name;
  column.function = std::move(function);
  column.format = format;
  return column;
}

TablePtr share(Table table) {
  return std::make_shared<const Table>(std::move(table));
}

/// b in the frame (e_theta, e_phi, N) as a vector in the frame of N's meridian: turned by theta_N about y. Index values as the map takes
/// them.
struct Meridian {
  double x, y, z;
};
Meridian bumped(const double* at, const KuglerParameters& p) {
  const double phi = two_pi * at[0], normal = at[1] / last_code(p.map_theta_bits) * two_pi / 4,
               tilt = at[2] / last_code(p.map_tilt_bits) * p.max_tilt / 360 * two_pi;
  const double across = std::sin(tilt) * std::cos(phi), along = std::cos(tilt);
  return {across * std::cos(normal) + along * std::sin(normal), std::sin(tilt) * std::sin(phi),
          along * std::cos(normal) - across * std::sin(normal)};
}

/// Of BUMP: turns for a step of its codes. `change` is 1 where the map holds the change of theta, else 0.
struct BumpScales {
  double theta, tilt, change;
};

/// What BUMP's map functions compute.
BUMP_LANE_LOOP void bump_lanes(const double* __restrict phi, const double* __restrict theta_code, const double* __restrict tilt_code,
                               BumpScales scales, double* __restrict theta, double* __restrict delta, int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const double normal_theta = theta_code[i] * scales.theta;
    const SineCosine azimuth = sine_cosine_of_turns(phi[i]), normal = sine_cosine_of_turns(normal_theta),
                     tilt = sine_cosine_of_turns(tilt_code[i] * scales.tilt);
    const double across = tilt.sine * azimuth.cosine, along = tilt.cosine;
    const double x = across * normal.cosine + along * normal.sine, y = tilt.sine * azimuth.sine,
                 z = along * normal.cosine - across * normal.sine;
    theta[i] = arc_tangent_in_turns(std::sqrt(x * x + y * y), z) - scales.change * normal_theta;
    delta[i] = arc_tangent_in_turns(y, x);
  }
}

BUMP_LANE_LOOP void secant_lanes(const double* __restrict x, double* __restrict secant, int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const SineCosine both = sine_cosine_of_turns(std::fabs(x[i]) / 2);
    secant[i] = 1 / (both.cosine < both.sine ? both.sine : both.cosine);
  }
}

}  // namespace

Format tangent_format() {
  return ufixed(KuglerParameters::component_bits + 1 + tangent_fraction, tangent_fraction);
}

TablePtr reciprocal_table(const KuglerParameters& p) {
  constexpr int bits = KuglerParameters::component_bits;
  Table table = make_table("RECIP", "1 / x, x >= 0", ufixed(bits, bits), Folding::floating, p.table_bits);
  table.exponent_bits = 4;
  table.min_exponent = -bits;
  table.columns = {make_column("value", ufixed(bits + 1 + reciprocal_fraction, reciprocal_fraction),
                               [](double x) { return 1 / std::max(x, smallest_divisor); })};
  table.block = real_tables::reciprocal(smallest_divisor);
  return share(std::move(table));
}

TablePtr arc_tangent_table(const KuglerParameters& p) {
  Table table = make_table("ATAN", "atan(x) / 2 pi, its code; x >= 0", tangent_format(), Folding::floating, p.table_bits);
  table.exponent_bits = 4;
  table.min_exponent = -8;
  table.columns = {
      make_column("angle", uangle(p.angle_bits - 2, p.angle_bits), [](double x) { return std::atan(x) / two_pi; }),
      make_column("code", p.theta_code(), [last = last_code(p.map_theta_bits)](double x) { return std::atan(x) * 4 / two_pi * last; })};
  table.block = real_tables::arc_tangent_and_code(4 * last_code(p.map_theta_bits));
  return share(std::move(table));
}

TablePtr secant_table(const KuglerParameters& p) {
  Table table =
      make_table("SEC", "1 / max(cos pi x, sin pi x), 0 <= x <= 1/2", p.turn(), Folding::quarter, std::min(p.table_bits, p.angle_bits - 2));
  table.columns = {make_column("value", ufixed(p.word_bits + 1, p.word_bits), [](double x) {
    const double phi = std::abs(x) * two_pi / 2;
    return 1 / std::max(std::cos(phi), std::sin(phi));
  })};
  table.block = [](const double* const* x, double* const* y, int lanes) { secant_lanes(x[0], y[0], lanes); };
  return share(std::move(table));
}

TablePtr bump_table(const KuglerParameters& p) {
  const bool change = p.map_holds == MapHolds::change;
  Table table = make_table("BUMP",
                           change ? "spherical triangle of phi_1, theta_N, theta_b: theta' - theta_N, delta"
                                  : "spherical triangle of phi_1, theta_N, theta_b: theta', delta",
                           p.turn(), Folding::magnitude, p.map_phi_bits);
  table.fields = {{p.theta_code(), p.map_theta_bits}, {p.tilt_code(), p.map_tilt_bits}};
  Column theta, delta;
  theta.name = "theta";
  theta.format = change ? angle(p.map_word_bits, p.map_word_bits + 1) : uangle(p.map_word_bits, p.map_word_bits + 1);
  theta.map_function = [p, change](const double* at) {
    const Meridian v = bumped(at, p);
    return std::atan2(std::hypot(v.x, v.y), v.z) / two_pi - (change ? at[1] / last_code(p.map_theta_bits) / 4 : 0);
  };
  delta.name = "delta";
  delta.format = turns(p.map_word_bits + 1);
  delta.symmetry.odd_about_zero = true;
  delta.map_function = [p](const double* at) {
    const Meridian v = bumped(at, p);
    return std::atan2(v.y, v.x) / two_pi;
  };
  table.columns = {theta, delta};
  const BumpScales scales{0.25 / last_code(p.map_theta_bits), p.max_tilt / 360 / last_code(p.map_tilt_bits), change ? 1.0 : 0.0};
  table.block = [scales](const double* const* x, double* const* y, int lanes) { bump_lanes(x[0], x[1], x[2], scales, y[0], y[1], lanes); };
  return share(std::move(table));
}

TablePtr paraboloid_table(const KuglerParameters& p) {
  Table table = make_table("RECIP_1", "1 / x, 1 <= x < 2", ufixed(p.word_bits + 1, p.word_bits), Folding::floating, p.table_bits);
  table.columns = {make_column("value", ufixed(p.word_bits + 1, p.word_bits), [](double x) { return 1 / std::max(x, 0.5); })};
  table.block = real_tables::reciprocal(0.5);
  return share(std::move(table));
}

}  // namespace bump::kugler1998
