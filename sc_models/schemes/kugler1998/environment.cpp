#include "schemes/kugler1998/environment.h"

#include <cmath>

#include "schemes/common/vectors.h"
#include "schemes/kugler1998/tables.h"

namespace bump::kugler1998 {

namespace {

constexpr const char* mirror_label = "mirror at the equator";

struct Conversion {
  Wire phi;         ///< of N
  Wire below;       ///< flag: N.z < 0
  Wire theta;       ///< of N mirrored into the upper hemisphere
  Wire theta_code;  ///< the same as a field of the map's address
};

/// Half a turn less the angle: sign logic.
Wire opposite(Netlist& n, const std::string& name, Wire x, const Format& format) {
  return n.half_turn(name + "_opposite", n.negate(name + "_negated", x, format));
}

/// Flag: x > `axis`, of a magnitude. An OR of its upper bits.
Wire exceeds_axis(Netlist& n, const std::string& name, Wire x) {
  const Format word = turns(KuglerParameters::component_bits);
  const int places = static_cast<int>(std::log2(1 / KuglerParameters::axis)) - 2;  // the axis limit becomes a quarter turn
  const Wire near = n.clamp(name + "_near", x, 0, 1.5 * KuglerParameters::axis, n.format(x));
  return n.is_beyond_quarter(name + "_exceeds", n.shift(name + "_scaled", near, places, word));
}

/// Both angles of N: 4 multipliers, 3 tables, two of them with a second port. For N on the axis phi is 0.
Conversion polar_normal(Netlist& n, const KuglerParameters& p) {
  const Format turn = p.turn(), tangent = tangent_format(),
               magnitude = ufixed(KuglerParameters::component_bits, KuglerParameters::component_bits - 1);
  const TablePtr reciprocal = reciprocal_table(p), arc_tangent = arc_tangent_table(p);
  const VectorWires normal = input_vector(n, "N", p.component());
  Netlist::Label label(n, "1 / abs N.z, 1 / abs N.x");
  const Wire x = n.absolute("abs_x", normal.x, magnitude), y = n.absolute("abs_y", normal.y, magnitude),
             z = n.absolute("abs_z", normal.z, magnitude);
  const auto divisor = [&](const std::string& name, Wire a) { return n.clamp(name, a, 0, 1, reciprocal->index); };
  const Wire of_z = n.table("RECIP_z", reciprocal, divisor("divisor_z", z)).front();
  const Wire of_x = n.second_port("RECIP_x", reciprocal, divisor("divisor_x", x)).front();
  label.next("m1, m2");
  const Wire x_slope = n.mul("m1", x, of_z, tangent), y_slope = n.mul("m2", y, of_z, tangent);
  label.next("phi_N = atan m3");
  const Wire first = n.shift("phi_first", n.table("ATAN_phi", arc_tangent, n.mul("m3", y, of_x, tangent, "m3")).front(), 0, turn);

  // tan theta = |N.x / N.z| sec phi, by the larger of both components: the secant is 1.42 at most.
  label.next("m4 = tan theta_N");
  const Wire doubled = n.shift("phi_doubled", first, 1, turn);
  const Wire steep = n.is_beyond_quarter("steep", doubled);
  const Wire slope = n.select("larger_slope", steep, y_slope, x_slope, tangent);
  const Wire of_theta = n.mul("m4", slope, n.table("SEC", secant_table(p), doubled).front(), tangent);
  label.next("theta_N = atan m4");
  const std::vector<Wire> theta = n.second_port("ATAN_theta", arc_tangent, of_theta);

  Conversion c;
  label.next("phi_N by the signs of N.x, N.y");
  const Wire upper = n.select("phi_upper", n.is_negative("x_negative", normal.x), opposite(n, "phi_first", first, turn), first, turn);
  const Wire azimuth = n.select("azimuth", n.is_negative("y_negative", normal.y), n.negate("phi_lower", upper, turn), upper, turn);
  label.next("phi_N = 0 on the axis");
  const Wire y_off = exceeds_axis(n, "y", y);
  const Wire off_axis = n.select("off_axis", exceeds_axis(n, "x", x), n.constant("set", 1, flag()), y_off, flag());
  c.phi = n.select("phi_N", off_axis, azimuth, n.constant("no_azimuth", 0, turn), turn);
  label.next(mirror_label);
  c.below = n.is_negative("below", normal.z);
  c.theta = theta[0];
  c.theta_code = theta[1];
  return c;
}

}  // namespace

Netlist environment_unit(const KuglerParameters& p) {
  Netlist n("environment");
  const Format turn = p.turn();
  const Conversion normal = polar_normal(n, p);
  const int guard = 2;  // strength is below 4
  Netlist::Label label(n, "m5 = strength times theta_b");
  const Wire strength = n.constant("strength", p.strength, ufixed(6 + guard, 6));
  const Wire tilt = n.mul("m5", strength, n.input("map.theta", p.tilt_code()), ufixed(p.map_tilt_bits + guard, p.map_tilt_bits));
  const Wire tilt_code = n.clamp("tilt", tilt, 0, last_code(p.map_tilt_bits), p.tilt_code());

  // Lee 2007, section 6: three rotations are two additions and one map. Rotation about z, the map, rotation about z.
  Wire phi_1 = n.input("map.phi", p.map_phi());
  if (p.frame == Frame::none)
    phi_1 = n.shift("phi_1", phi_1, 0, turn, "rotation 1");
  else
    phi_1 = n.add("phi_1", phi_1, n.input("psi", turn), turn, "rotation 1");
  // Below the equator everything is mirrored at it, which turns e_theta round: phi_1 becomes its supplement, theta' too.
  label.next(mirror_label);
  phi_1 = n.select("phi_mirrored", normal.below, opposite(n, "phi_1", phi_1, turn), phi_1, turn);
  const std::vector<Wire> bump = n.table("BUMP", bump_table(p), {phi_1, normal.theta_code, tilt_code}, "rotation 2");
  Wire theta = n.shift("theta_word", bump[0], 0, turn, "rotation 2");
  if (p.map_holds == MapHolds::change) {
    n.begin_addition();
    theta = n.add("theta_sum", theta, normal.theta, turn, "theta_N plus its change");
    n.end_addition();
  }
  theta = n.select("theta", normal.below, opposite(n, "theta", theta, turn), theta, turn);
  n.output("bumped.phi", n.add("phi", normal.phi, bump[1], turn, "rotation 3"));
  n.output("bumped.theta", theta);
  return n;
}

}  // namespace bump::kugler1998
