#include "schemes/tl2/units.h"

#include "schemes/common/trigonometric_tables.h"

namespace bump::tl2 {

Netlist environment_unit(const TangentAngleParameters& p) {
  Netlist n("environment");
  const Format in = p.input_angle();
  const YPoleWires texel = y_pole_texel(n, p, p.turn());
  for (const char* name : {"L", "H"}) {
    const LongitudeLatitude a = input_tangent_angles(n, name, p);
    const Netlist::Scope scope(n, name);
    n.output("less", n.sub("less", texel.latitude, a.b, in, "TL2"));
    n.output("plus", n.add("plus", texel.latitude, a.b, in, "TL2"));
    n.output("psi_less", n.sub("psi_less", texel.psi, a.psi, in, "TL2"));
  }
  return n;
}

Netlist illumination_unit(const TangentAngleParameters& p, const Material& material) {
  Netlist n("illumination");
  const Format in = p.input_angle(), sum = sfixed(p.word_bits + 2, p.word_bits);
  RomPorts cosine(cosine_table("COS", in, p.table_bits, p.word_bits), p.ports),
      haversine(haversine_table("HAV", in, p.half_turn_table_bits, p.word_bits), p.ports);
  const auto dot = [&](const std::string& name, const std::string& of) {
    const Wire less = n.input(of + ".less", in), plus = n.input(of + ".plus", in), psi_less = n.input(of + ".psi_less", in);
    const Netlist::Scope scope(n, name);
    const Wire u = cosine.read(n, "COS_LESS", less, "TL2").front(), v = cosine.read(n, "COS_PLUS", plus, "TL2").front();
    const Wire away = haversine.read(n, "HAV_PSI", psi_less, "TL2").front();
    const Wire share = n.mul("share", n.add("u_plus_v", u, v, sum, "TL2"), away, p.product(), "TL2");
    return n.sub("dot", u, share, p.product(), "TL2");
  };
  const Wire n_l = dot("N_L", "L"), n_h = dot("N_H", "H");
  output_intensity(n, n_l, n_h, p, material);
  return n;
}

}  // namespace bump::tl2
