#include "schemes/exact10/units.h"

#include <utility>

#include "schemes/common/sums_projection.h"

namespace bump::exact10 {

namespace {

/// x' (or -x' where `backwards`) and z'.
struct TurnedWires {
  Wire x, z;
};

TurnedWires turned(Netlist& n, Wire G, Wire theta, Wire normal_theta, const SineCosine& of_normal, SineReads& reads, bool backwards,
                   const Format& product) {
  const Netlist::Label label(n, "EXACT10 steps 1, 3");
  const SineCosine plus = reads.both("SC_PLUS", reads.plus("theta_plus", theta, normal_theta));
  const SineCosine minus = reads.both("SC_MINUS", reads.minus("theta_minus", theta, normal_theta));
  const Wire cos_sin = reads.half_difference("cos_sin", plus.sine, minus.sine, "EXACT10 step 1"),
             cos_cos = reads.half_sum("cos_cos", plus.cosine, minus.cosine, "EXACT10 step 3");
  const Wire G_cos = n.mul("G_cos", G, of_normal.cosine, product, "EXACT10 step 1"),
             G_sin = n.mul("G_sin", G, of_normal.sine, product, "EXACT10 step 3");
  const Wire x =
      backwards ? n.sub("minus_x", cos_sin, G_cos, product, "EXACT10 step 1") : n.sub("x", G_cos, cos_sin, product, "EXACT10 step 1");
  return {x, n.add("z", G_sin, cos_cos, product, "EXACT10 step 3")};
}

}  // namespace

Netlist environment_unit(const YPoleParameters& p) {
  Netlist n("environment");
  SineReads reads(n, p.sums());
  const PolarDirection normal = input_polar(n, "N", reads), light = input_polar(n, "L", reads), half = input_polar(n, "H", reads);
  const SineCosine of_normal = reads.both("N.SC_THETA", normal.theta, "EXACT10 steps 1, 3");
  const bool parallel = p.chart == Chart::parallel;
  for (const auto& [name, a] : {std::pair<std::string, PolarDirection>{"L", light}, {"H", half}}) {
    const PlaneWires plane = projected_plane(n, name, a, normal.phi, reads);
    TurnedWires of_a;
    {
      const Netlist::Scope scope(n, name);
      of_a = turned(n, plane.G, a.theta, normal.theta, of_normal, reads, parallel, p.product());
    }
    const Wire y = n.shift(name + ".y", plane.K, 0, p.product(), "EXACT10 step 2");
    output_vector(n, name + "_ref", parallel ? VectorWires{y, of_a.x, of_a.z} : VectorWires{of_a.x, y, of_a.z});
  }
  return n;
}

Netlist illumination_unit(const YPoleParameters& p, const Material& material) {
  Netlist n("illumination");
  const VectorWires light = input_vector(n, "L_ref", p.product()), half = input_vector(n, "H_ref", p.product());
  const VectorTexelWires texel = vector_texel(n, p, p.turn());
  const VectorWires bumped{texel.x, texel.y, texel.minus_z};
  const Netlist::Label label(n, "EXACT10 step 4");
  const Wire n_l = dot_less_last(n, "N_L", light, bumped, p), n_h = dot_less_last(n, "N_H", half, bumped, p);
  output_intensity(n, n_l, n_h, p, material);
  return n;
}

}  // namespace bump::exact10
