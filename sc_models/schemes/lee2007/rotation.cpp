#include "schemes/lee2007/rotation.h"

#include <utility>

#include "schemes/common/polar_map.h"
#include "schemes/lee2007/tables.h"

namespace bump::lee2007 {

namespace {

constexpr const char* exact_x_label = "x_prime = exact";

/// A direction in polar angles: phi from +x, theta from +z, turns.
struct Direction {
  Wire phi, theta;
};

/// One vector's datapath while it is recorded; a method a step of the paper.
class Rotation {
 public:
  Rotation(Netlist& netlist, const LeeParameters& parameters, const RotationTables& tables) : n(netlist), p(parameters), t(tables) {}

  /// Eqs 5-7 up to the arc sine, and the numerator of Eqs 9 and 27.
  void first_rotation(const Direction& a, const Direction& normal) {
    const Netlist::Label label(n, "Eq 9");
    // As printed, X and Y are halves: d must then not wrap, or its half would jump by half a turn.
    const Format sum = p.half_xy ? angle(p.angle_bits + 2, p.angle_bits) : p.input_angle();
    const Wire d = n.sub("d", a.phi, normal.phi, sum, "Eq 6");
    const Wire theta_plus_d = n.add(p.half_xy ? "twice_X" : "X", a.theta, d, sum, "Eq 6");
    const Wire theta_less_d = n.sub(p.half_xy ? "twice_Y" : "Y", a.theta, d, sum, "Eq 6");
    const Wire X = p.half_xy ? n.shift("X", theta_plus_d, -1, p.input_angle(), "Eq 6") : theta_plus_d;
    const Wire Y = p.half_xy ? n.shift("Y", theta_less_d, -1, p.input_angle(), "Eq 6") : theta_less_d;
    const std::vector<Wire> of_X = n.table("SC_X", t.sine_cosine, X, "Eqs 7, 9");
    const std::vector<Wire> of_Y = n.table("SC_Y", t.sine_cosine, Y, "Eqs 7, 9");
    sx_ = n.shift("sx", n.add("sine_sum", of_X[0], of_Y[0], sfixed(p.word_bits + 2, p.word_bits), "Eq 7"), -1, half_sum_format(p), "Eq 7");
    const Wire twice_y = n.sub("cosine_difference", of_Y[1], of_X[1], sfixed(p.word_bits + 2, p.word_bits), "Eqs 9, 18");
    y_negative_ = n.is_negative("y_negative", n.shift("y", twice_y, -1, half_sum_format(p), "Eq 9"));
    twice_abs_y_ = n.absolute("twice_abs_y", twice_y, ufixed(p.word_bits + 1, p.word_bits));
  }

  /// Z = theta_x - theta_N, which takes the projected vector for the vector.
  void angle_in_plane(const Direction& a, const Direction& normal) {
    const Netlist::Label label(n, "Eq 7");
    const Wire principal = widened("theta_x_principal", n.table("ASIN", t.arc_sine, sx_).front());
    Wire theta_x = principal;
    if (p.hemisphere_bit)
      theta_x =
          n.select("theta_x", n.is_beyond_quarter("below_equator", a.theta), opposite("theta_x", principal), principal, p.inner_angle());
    else
      theta_x = n.shift("theta_x", principal, 0, p.inner_angle());
    z_ = n.sub("Z", theta_x, normal.theta, p.inner_angle(), "Eq 8");
  }

  /// Z = asin(x') with the true z of A: 2 multipliers more, and 2 multipliers and an adder for the hemisphere.
  void angle_in_plane_exact(const Direction& a, const std::vector<Wire>& of_normal) {
    Netlist::Label label(n, exact_x_label);
    const Wire cos_a = n.table("COS_A", t.cosine_input, a.theta).front();
    const Format product = half_sum_format(p), sum = sfixed(p.word_bits + 3, p.word_bits + 1);
    const Wire x = n.sub("x_prime", n.mul("sx_cos", sx_, of_normal[1], product), n.mul("cos_sin", cos_a, of_normal[0], product), sum);
    label.next("Eq 7");
    const Wire principal =
        widened("Z_principal", n.table("ASIN", t.arc_sine, n.clamp("x_prime_clamped", x, -1, 1, half_sum_format(p))).front());
    z_ = principal;
    if (!p.hemisphere_bit) return;
    label.next(exact_x_label);
    const Wire z = n.add("z_prime", n.mul("sx_sin", sx_, of_normal[0], product), n.mul("cos_cos", cos_a, of_normal[1], product), sum);
    z_ = n.select("Z", n.is_negative("below_horizon", z), opposite("Z", principal), principal, p.inner_angle());
  }

  void reciprocals() {
    const std::vector<Wire> of_Z = n.table("RECIP", t.reciprocal, z_, "Eqs 9, 27");
    half_over_sin_ = of_Z[0];
    half_over_cos_ = of_Z[1];
  }

  /// Eq 9, folded over the turn by the signs of sin Z and y.
  Wire azimuth() {
    const Netlist::Label label(n, "Eq 9");
    const Wire tangent = n.mul("tangent", twice_abs_y_, half_over_sin_, tangent_format(p));
    const Wire first = widened("phi_first", n.table("ATAN", t.arc_tangent, tangent).front());
    const Wire left = p.quadrant_fix ? opposite("phi", first) : n.negate("phi_principal", first, p.inner_angle());
    const Wire upper = n.select("phi_upper", n.is_negative("Z_negative", z_), left, first, p.inner_angle());
    return n.select("phi_ref", y_negative_, n.negate("phi_lower", upper, p.inner_angle()), upper, p.inner_angle());
  }

  Wire polar_angle() {
    const Netlist::Label label(n, "Eq 27");
    const Wire y_k = n.mul("y_k", twice_abs_y_, half_over_cos_, tangent_format(p));
    // E5: the clamp saturates at 1 itself, whose top bit overrules the table (asin of the last entry's centre would be 86 degrees, not 90).
    const Wire clamped = n.clamp("y_k_clamped", y_k, 0, 1, ufixed(p.word_bits + 1, p.word_bits));
    y_k_is_one_ = n.is_negative("y_k_is_one", n.shift("y_k_top_bit", clamped, 0, sfixed(p.word_bits + 1, p.word_bits)));
    y_k_index_ = n.shift("y_k_index", clamped, 0, proportion_format(p));
    if (p.exact_eq16) return spherical();
    return p.abs_fix ? linear() : linear_signed();
  }

 private:
  Wire widened(const std::string& name, Wire part) { return n.shift(name, part, 0, p.inner_angle()); }
  /// Half a turn less the angle: sign logic.
  Wire opposite(const std::string& name, Wire x) {
    return n.half_turn(name + "_opposite", n.negate(name + "_negated", x, p.inner_angle()));
  }
  Wire quarter(const Format& format) { return n.constant("quarter", 0.25, format); }
  Wire magnitude_of_Z() { return n.absolute("abs_Z", z_, uangle(p.word_bits + 2, p.word_bits + 2)); }

  /// asin(y_k) read from a table, `at_one` where the clamp has saturated.
  Wire arc_of_y_k(const std::string& name, const Wire& read, double at_one, const Format& format) {
    const Netlist::Label label(n, "Eq 26");
    return n.select(name, y_k_is_one_, n.constant(name + "_at_one", at_one, format), read, format);
  }
  Wire proportion(const std::string& name) {
    return arc_of_y_k(name, n.table("T_prop", t.proportion, y_k_index_, "Eq 26").front(), 1, ufixed(p.word_bits + 1, p.word_bits));
  }

  /// Eqs 16 and 26 with |Z| and |y_k|.
  Wire linear() {
    const Netlist::Label label(n, "Eq 16");
    const Wire prop = proportion("prop");
    const Wire z = magnitude_of_Z();
    const Wire rest = n.sub("quarter_less_Z", quarter(p.inner_angle()), z, p.inner_angle());
    return n.add("theta_ref", z, n.mul("share", rest, prop, p.inner_angle()), p.inner_angle());
  }

  /// Eqs 16 and 26 to the letter: prop and Z keep their signs.
  Wire linear_signed() {
    Netlist::Label label(n, "Eq 26");
    const Format fraction = sfixed(p.word_bits + 2, p.word_bits);
    const Wire prop = n.shift("prop_signed", proportion("prop_magnitude"), 0, fraction);
    const Wire by_y = n.select("prop_by_y", y_negative_, n.negate("prop_negative", prop, fraction), prop, fraction);
    const Wire by_cos =
        n.select("prop", n.is_beyond_quarter("cos_Z_negative", z_), n.negate("prop_opposite", by_y, fraction), by_y, fraction);
    label.next("Eq 16");
    const Format wide = angle(p.word_bits + 3, p.word_bits + 2);  // 90 - Z may exceed half a turn
    const Wire rest = n.sub("quarter_less_Z", quarter(wide), z_, wide);
    return n.add("theta_ref", z_, n.mul("share", rest, by_cos, wide), p.inner_angle());
  }

  /// acos(cos Z cos w), w = asin(y_k), as 90 degrees less the arc sine of [cos(|Z| + w) + cos(|Z| - w)] / 2.
  Wire spherical() {
    const Netlist::Label label(n, "Eq 16, exact");
    const Wire w = arc_of_y_k("w", n.table("ASIN_YK", t.arc_sine_quarter, y_k_index_, "Eq 26").front(), 0.25,
                              uangle(p.word_bits + 1, p.word_bits + 2));
    const Wire z = magnitude_of_Z();
    const Wire sum = n.table("COS_PLUS", t.cosine_inner, n.add("Z_plus_w", z, w, p.inner_angle())).front();
    const Wire difference = n.table("COS_MINUS", t.cosine_inner, n.sub("Z_minus_w", z, w, p.inner_angle())).front();
    const Wire cosine =
        n.shift("cos_theta", n.add("cosine_sum", sum, difference, sfixed(p.word_bits + 2, p.word_bits)), -1, half_sum_format(p));
    return n.sub("theta_ref", quarter(p.inner_angle()), n.table("ASIN_COS", t.arc_sine, cosine).front(), p.inner_angle());
  }

  Netlist& n;
  const LeeParameters& p;
  const RotationTables& t;
  Wire sx_, twice_abs_y_, y_negative_, z_, half_over_sin_, half_over_cos_, y_k_is_one_, y_k_index_;
};

Direction input_direction(Netlist& n, const std::string& name, const LeeParameters& p) {
  return {n.input(name + ".phi", p.input_angle()), n.input(name + ".theta", p.input_angle())};
}

Direction rotate(Netlist& n, const std::string& name, const Direction& a, const Direction& normal, const std::vector<Wire>& of_normal,
                 const LeeParameters& p, const RotationTables& tables) {
  const Netlist::Scope scope(n, name);
  Rotation rotation(n, p, tables);
  rotation.first_rotation(a, normal);
  if (p.exact_x_prime)
    rotation.angle_in_plane_exact(a, of_normal);
  else
    rotation.angle_in_plane(a, normal);
  rotation.reciprocals();
  const Wire phi = rotation.azimuth();
  return {phi, rotation.polar_angle()};
}

}  // namespace

Netlist environment_unit(const LeeParameters& p) {
  Netlist n("environment");
  const Direction normal = input_direction(n, "N", p), light = input_direction(n, "L", p), half = input_direction(n, "H", p);
  const RotationTables tables = rotation_tables(p);
  std::vector<Wire> of_normal;
  if (p.exact_x_prime) of_normal = n.table("N.SC", tables.sine_cosine, normal.theta, exact_x_label);
  for (const auto& [name, a] : {std::pair<std::string, Direction>{"L", light}, {"H", half}}) {
    const Direction rotated = rotate(n, name, a, normal, of_normal, p, tables);
    n.output(name + "_ref.phi", rotated.phi);
    n.output(name + "_ref.theta", rotated.theta);
  }
  output_map_angles(n, p);
  return n;
}

}  // namespace bump::lee2007
