#include "schemes/cart/units.h"

#include "schemes/common/sums_projection.h"

namespace bump::cart {

namespace {

struct FrameWires {
  Wire x1, y, z1;  ///< z1 negated for texels that are vectors
};

/// Ry(theta_N): 4 multipliers, 2 adders.
FrameWires rotated_vector(Netlist& n, const CartParameters& p, const SineCosine& theta) {
  const Netlist::Label label(n, "CART step 1");
  const VectorTexelWires texel = vector_texel(n, p, p.turn());
  const auto times = [&](const char* name, Wire a, Wire b) { return n.mul(name, a, b, p.product()); };
  const Wire x_cos = times("x_cos_theta", texel.x, theta.cosine), x_sin = times("x_sin_theta", texel.x, theta.sine);
  const Wire z_cos = times("z_cos_theta", texel.minus_z, theta.cosine), z_sin = times("z_sin_theta", texel.minus_z, theta.sine);
  const Wire x1 = n.sub("x1", x_cos, z_sin, p.product());
  return {x1, texel.y, n.add("minus_z1", z_cos, x_sin, p.product())};
}

void rotate_by_angles(Netlist& n, const CartParameters& p) {
  SineReads reads(n, p.sums());
  const PolarDirection normal = input_polar(n, "N", reads);
  const bool vector = p.texel == TexelAs::vector;
  FrameWires v;
  if (vector) {
    v = rotated_vector(n, p, reads.both("N.SC_THETA", normal.theta, "CART step 1"));
  } else {
    const YPoleWires texel = y_pole_texel(n, p, p.turn());
    const TurnedNormalWires turned = turned_normal(n, texel.psi, texel.latitude, normal.theta, reads);
    v = {turned.a, turned.s, turned.c};
  }
  // Rz(phi_N)
  const Netlist::Label label(n, "CART step 2");
  const SineCosine phi = reads.both("N.SC_PHI", normal.phi);
  const auto times = [&](const char* name, Wire a, Wire b) { return n.mul(name, a, b, p.product()); };
  const Wire x_cos = times("x_cos_phi", v.x1, phi.cosine), x_sin = times("x_sin_phi", v.x1, phi.sine);
  const Wire y_cos = times("y_cos_phi", v.y, phi.cosine), y_sin = times("y_sin_phi", v.y, phi.sine);
  n.output("N_os.x", n.sub("X", x_cos, y_sin, p.product()));
  n.output("N_os.y", n.add("Y", x_sin, y_cos, p.product()));
  n.output(vector ? "N_os.minus_z" : "N_os.z", v.z1);
}

void rotate_by_matrix(Netlist& n, const CartParameters& p) {
  const VectorWires normal = input_vector(n, "N", p.vector()), tangent = input_vector(n, "T", p.vector()),
                    binormal = input_vector(n, "B", p.vector());
  const VectorTexelWires texel = vector_texel(n, p, p.turn());
  const Netlist::Label label(n, "matrix of T, B, N");
  const auto row = [&](const std::string& name, Wire t, Wire b, Wire along_n, bool negated) {
    const Netlist::Scope scope(n, name);
    const auto times = [&](const char* result, Wire component, Wire of_texel) { return n.mul(result, component, of_texel, p.product()); };
    const Wire x = times("x", t, texel.x), y = times("y", b, texel.y), z = times("z", along_n, texel.minus_z);
    const Wire plane = n.add("plane", x, y, p.product());
    return negated ? n.sub("sum", z, plane, p.product()) : n.sub("sum", plane, z, p.product());
  };
  n.output("N_os.x", row("X", tangent.x, binormal.x, normal.x, false));
  n.output("N_os.y", row("Y", tangent.y, binormal.y, normal.y, false));
  n.output("N_os.minus_z", row("minus_Z", tangent.z, binormal.z, normal.z, true));
}

}  // namespace

Netlist environment_unit(const CartParameters& p) {
  Netlist n("environment");
  if (p.normal == NormalFrom::angles)
    rotate_by_angles(n, p);
  else
    rotate_by_matrix(n, p);
  return n;
}

Netlist illumination_unit(const CartParameters& p, const Material& material) {
  Netlist n("illumination");
  const VectorWires light = input_vector(n, "L", p.vector()), half = input_vector(n, "H", p.vector());
  const Wire x = n.input("N_os.x", p.product()), y = n.input("N_os.y", p.product());
  const bool angles = p.texel == TexelAs::angles;
  const VectorWires bumped{x, y, angles ? n.input("N_os.z", p.half_word()) : n.input("N_os.minus_z", p.product())};
  const Netlist::Label label(n, "CART step 3");
  const auto dot = angles ? dot_of : dot_less_last;
  const Wire n_l = dot(n, "N_L", light, bumped, p), n_h = dot(n, "N_H", half, bumped, p);
  output_intensity(n, n_l, n_h, p, material);
  return n;
}

}  // namespace bump::cart
