#include "schemes/n2l/environment.h"

#include "schemes/common/log_reads.h"
#include "schemes/common/object_angles_tables.h"
#include "schemes/common/polar_rotation.h"
#include "schemes/common/rom_ports.h"
#include "schemes/n2l/tables.h"

namespace bump::n2l {

namespace {

/// atan2(sin b, cos b sin Psi): 2 adders, 3 tables.
Wire longitude(Netlist& n, Wire Psi, Wire b, const N2lParameters& p) {
  const Netlist::Scope scope(n, "longitude");
  const Format in = p.input_angle(), inner = p.inner_angle();
  const int f = p.log_bits, k = p.table_bits;
  Netlist::Label label(n, "N2L step 2");
  const Wire log_tangent = n.table("LTAN_B", log_tangent_table("LTAN", in, k, f), b).front();
  const Wire log_sine = n.table("LSIN_PSI", log_sine_table("LSIN", in, k, f), Psi).front();
  const Wire x = n.sub("x", log_tangent, log_sine, sfixed(2 + log_whole_bits + f, f));
  const TablePtr arc_tangent = arc_tangent_of_power_table("ATAN_POWER", ufixed(1 + log_whole_bits + f, f), p.inverse_table_bits,
                                                          uangle(p.word_bits, p.word_bits + 3));
  label.next("N2L step 3");
  const Wire octant = n.shift("octant", n.table("ATAN_POWER", arc_tangent, n.absolute("abs_x", x, arc_tangent->index)).front(), 0, inner);
  const Wire steep = n.sub("quarter_less", n.constant("quarter", 0.25, inner), octant, inner);
  const Wire quadrant = n.select("quadrant", n.is_negative("is_steep", x), steep, octant, inner);
  label.next("N2L step 4");
  const Wire behind = n.exclusive_or("behind", n.is_negative("sin_Psi_negative", Psi), n.is_beyond_quarter("cos_b_negative", b));
  const Wire upper = opposite_if(n, "upper", behind, quadrant);
  return n.select("angle", n.is_negative("sin_b_negative", b), n.negate("lower", upper, inner), upper, inner);
}

}  // namespace

Netlist environment_unit(const N2lParameters& p) {
  Netlist n("environment");
  const Format in = p.input_angle(), inner = p.inner_angle();
  const int fine = p.word_bits + pole_bits;
  const PolarDirection normal = input_direction(n, "N", in);
  const YPoleWires texel = y_pole_texel(n, p, p.turn());
  const Wire Psi = n.add("N.Psi", texel.psi, normal.theta, in, "N3 step 2");
  n.output("N_object.phi", n.add("phi", longitude(n, Psi, texel.latitude, p), normal.phi, inner, "N2L step 1"));
  const Netlist::Label label(n, "N2L step 5");
  RomPorts cosine(scaled_cosine_table("COS_FINE", in, p.table_bits, {fine, 1}), p.ports);
  const Wire of_P = cosine.read(n, "N.COS_P", n.add("N.P", Psi, texel.latitude, in)).front(),
             of_M = cosine.read(n, "N.COS_M", n.sub("N.M", Psi, texel.latitude, in)).front();
  const Wire c = n.shift("N_c", n.add("twice_N_c", of_P, of_M, sfixed(fine + 2, fine)), -1, sfixed(fine + 2, fine + 1));
  n.output("N_object.theta", polar_arc_cosine(n, "theta", c, p.inverse_table_bits, p.word_bits, inner));
  return n;
}

}  // namespace bump::n2l
