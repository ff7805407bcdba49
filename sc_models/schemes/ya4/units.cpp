#include "schemes/ya4/units.h"

#include <utility>

#include "schemes/common/inverse_tables.h"
#include "schemes/common/sums_projection.h"

namespace bump::ya4 {

namespace {

/// A table word resolves a quarter turn.
Format inner_angle(const YPoleParameters& p) {
  return turns(p.word_bits + 2);
}

}  // namespace

Netlist environment_unit(const YPoleParameters& p) {
  Netlist n("environment");
  const int w = p.word_bits;
  SineReads reads(n, p.sums());
  const PolarDirection normal = input_polar(n, "N", reads), light = input_polar(n, "L", reads), half = input_polar(n, "H", reads);
  const Format inner = inner_angle(p), component = sfixed(w + 2, w + 1);
  const AzimuthFormats formats = azimuth_formats(w + 1, p.inverse_table_bits, w, inner);
  const TablePtr arc_sine = arc_sine_table("ASIN", component, p.inverse_table_bits, angle(w + 1, w + 2));
  for (const auto& [name, a] : {std::pair<std::string, PolarDirection>{"L", light}, {"H", half}}) {
    const ProjectedWires of_a = projected(n, name, a, normal.phi, reads);
    const Netlist::Label label(n, "YA4 step 1");
    n.output(name + "_turned.psi", azimuth(n, name + ".psi", of_a.G, of_a.z, formats));
    const Wire sine = n.clamp(name + ".sine", of_a.K, -1, 1, component);
    n.output(name + "_turned.latitude", n.shift(name + ".b", n.table(name + ".ASIN", arc_sine, sine).front(), 0, inner));
  }
  const YPoleWires texel = y_pole_texel(n, p, p.turn());
  const Netlist::Label label(n, "YA4 step 2");
  n.output("N_turned.psi", n.add("N.Psi", texel.psi, normal.theta, inner));
  n.output("N_turned.latitude", n.shift("N.b", texel.latitude, 0, inner));
  return n;
}

Netlist illumination_unit(const YPoleParameters& p, const Material& material) {
  Netlist n("illumination");
  const Format inner = inner_angle(p);
  SumWidths widths = p.sums();
  widths.index = inner;
  widths.suffix = "_INNER";
  SineReads r(n, widths);
  const Wire Psi = n.input("N_turned.psi", inner), b = n.input("N_turned.latitude", inner);
  const auto dot = [&](const std::string& name, const std::string& of) {
    const Wire psi_a = n.input(of + "_turned.psi", inner), b_a = n.input(of + "_turned.latitude", inner);
    const Netlist::Scope scope(n, name);
    const Netlist::Label label(n, "YA4 step 3");
    const Wire difference = r.cosine("COS_DIFFERENCE", r.minus("b_difference", b, b_a));
    const Wire sum = r.cosine("COS_SUM", r.plus("b_sum", b, b_a));
    const Wire sines = r.half_difference("sines", difference, sum), cosines = r.half_sum("cosines", difference, sum);
    const Wire along = r.cosine("COS_PSI", r.minus("psi_difference", Psi, psi_a));
    return n.add("dot", sines, n.mul("share", cosines, along, p.product()), p.product());
  };
  const Wire n_l = dot("N_L", "L"), n_h = dot("N_H", "H");
  output_intensity(n, n_l, n_h, p, material);
  return n;
}

}  // namespace bump::ya4
