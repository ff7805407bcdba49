#include "schemes/lee2007_corrected/rotation.h"

#include <utility>

#include "schemes/common/polar_map.h"
#include "schemes/common/trigonometric_tables.h"

namespace bump::lee2007_corrected {

namespace {

/// Tables of this rotation beside those of every rotation.
struct OwnTables {
  TablePtr cosine;       ///< of an arriving angle
  TablePtr arc_sine;     ///< K -> latitude
  TablePtr sine_cosine;  ///< of an inner angle
};

OwnTables own_tables(const RotationParameters& p) {
  const int w = p.word_bits;
  return {cosine_table("COS_THETA", p.input_angle(), p.table_bits, w),
          arc_sine_table("ASIN", sfixed(w + 2, w + 1), p.inverse_table_bits, angle(w + 1, w + 2)),
          sine_cosine_table("SC_INNER", p.inner_angle(), p.table_bits, w)};
}

void rotate(Netlist& n, const std::string& name, const PolarDirection& a, const PolarDirection& normal, const RotationParameters& p,
            const RotationTables& t, const OwnTables& own) {
  const int w = p.word_bits;
  const Format sum = sfixed(w + 2, w), half_sum = sfixed(w + 2, w + 1), inner = p.inner_angle();
  const auto half_of = [&](const std::string& result, Wire twice, const std::string& equation = "") {
    return n.shift(result, twice, -1, half_sum, equation);
  };
  Wire x, y, z;
  {
    const Netlist::Scope scope(n, name);
    const Wire d = n.sub("d", a.phi, normal.phi, p.input_angle(), "Eq 6");
    const std::vector<Wire> of_X = n.table("SC_X", t.sine_cosine, n.add("X", a.theta, d, p.input_angle(), "Eq 6"), "Eqs 7, 9");
    const std::vector<Wire> of_Y = n.table("SC_Y", t.sine_cosine, n.sub("Y", a.theta, d, p.input_angle(), "Eq 6"), "Eqs 7, 9");
    const Wire G = half_of("G", n.add("twice_G", of_X[0], of_Y[0], sum, "Eq 7"), "Eq 7");
    y = half_of("K", n.sub("twice_K", of_Y[1], of_X[1], sum, "Eq 9"), "Eq 9");
    Netlist::Label label(n, "psi = atan2(G, cos theta_A)");
    const Wire cos_theta = n.table("COS_THETA", own.cosine, a.theta).front();
    const Wire psi = azimuth(n, "psi", G, cos_theta, t.azimuth);
    label.next("b = asin K");
    const Wire b = n.table("ASIN", own.arc_sine, y).front();
    const Wire Z = n.sub("Z", psi, normal.theta, inner, "Eq 8");
    label.next("sin, cos of Z + b, Z - b");
    const std::vector<Wire> of_plus = n.table("SC_PLUS", own.sine_cosine, n.add("Z_plus_b", Z, b, inner));
    const std::vector<Wire> of_minus = n.table("SC_MINUS", own.sine_cosine, n.sub("Z_minus_b", Z, b, inner));
    label.next("x' = (sin(Z+b) + sin(Z-b))/2");
    x = half_of("x_prime", n.add("twice_x", of_plus[0], of_minus[0], sum));
    label.next("z' = (cos(Z+b) + cos(Z-b))/2");
    z = half_of("z_prime", n.add("twice_z", of_plus[1], of_minus[1], sum));
  }
  output_reference(n, name, x, y, z, p, t);
}

}  // namespace

Netlist environment_unit(const RotationParameters& p) {
  Netlist n("environment");
  const PolarDirection normal = input_direction(n, "N", p.input_angle()), light = input_direction(n, "L", p.input_angle()),
                       half = input_direction(n, "H", p.input_angle());
  const RotationTables tables = rotation_tables(p);
  const OwnTables own = own_tables(p);
  for (const auto& [name, a] : {std::pair<std::string, PolarDirection>{"L", light}, {"H", half}})
    rotate(n, name, a, normal, p, tables, own);
  output_map_angles(n, p);
  return n;
}

}  // namespace bump::lee2007_corrected
