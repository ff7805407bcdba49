#include "schemes/tl0/units.h"

#include "schemes/common/trigonometric_tables.h"
#include "schemes/tl0/tables.h"

namespace bump::tl0 {

namespace {

/// Of a cosine: a haversine is the square of a sine.
Format log_cosine_format(const Tl0Parameters& p) {
  return log_format(p.logs(), p.log_whole_bits - 1);
}

}  // namespace

Netlist environment_unit(const Tl0Parameters& p) {
  Netlist n("environment");
  const Format in = p.input_angle();
  RomPorts log_cosine(log_cosine_table("LCOS", in, p.log_table_bits, log_cosine_format(p)), p.ports);
  const YPoleWires texel = y_pole_texel(n, p, p.turn());
  Netlist::Label label(n, "TL0 step 3");
  n.output("log_cos", log_cosine.read(n, "LCOS_B", texel.latitude).front());
  for (const char* name : {"L", "H"}) {
    const LongitudeLatitude a = input_tangent_angles(n, name, p);
    const Netlist::Scope scope(n, name);
    label.next("TL0 step 2");
    n.output("less", n.sub("less", texel.latitude, a.b, in));
    n.output("psi_less", n.sub("psi_less", texel.psi, a.psi, in));
    label.next("TL0 step 3");
    n.output("log_cos", log_cosine.read(n, "LCOS", a.b).front());
  }
  return n;
}

Netlist illumination_unit(const Tl0Parameters& p, const Material& material) {
  Netlist n("illumination");
  const Format in = p.input_angle(), log = log_cosine_format(p);
  const LogWidths widths = p.logs();
  LogReads reads(n, widths);
  RomPorts cosine(cosine_table("COS", in, p.table_bits, p.word_bits), p.ports),
      log_haversine(log_haversine_table("LHAV", in, p.half_turn_table_bits, log_format(widths, widths.whole_bits)), p.ports);
  Netlist::Label label(n, "TL0 step 3");
  const Wire log_b = n.input("log_cos", log), positive = n.constant("positive", 0, flag());
  const auto dot = [&](const std::string& name, const std::string& of) {
    const Wire less = n.input(of + ".less", in), psi_less = n.input(of + ".psi_less", in), log_a = n.input(of + ".log_cos", log);
    const Netlist::Scope scope(n, name);
    label.next("TL0 step 3");
    const Wire cosines = n.add("log_cosines", log_b, log_a, log_format(widths, widths.whole_bits));
    const Wire away = log_haversine.read(n, "LHAV_PSI", psi_less).front();
    const Wire product = n.add("log_share", cosines, away, log_format(widths, widths.whole_bits + 1));
    const Wire half_share = reads.magnitude("half_share", {product, positive});
    const int fraction = reads.fraction() - 1;
    const Wire share = n.shift("share", half_share, 1, ufixed(fraction + 1, fraction));
    label.next("TL0 step 2");
    const Wire upright = cosine.read(n, "COS_LESS", less).front();
    return n.sub("dot", upright, share, sfixed(fraction + 2, fraction));
  };
  const Wire n_l = dot("N_L", "L"), n_h = dot("N_H", "H");
  output_intensity(n, n_l, n_h, p, material);
  return n;
}

}  // namespace bump::tl0
