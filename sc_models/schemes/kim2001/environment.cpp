#include "schemes/kim2001/environment.h"

#include "schemes/common/inverse_tables.h"
#include "schemes/common/polar_conversion.h"
#include "schemes/common/polar_map.h"
#include "schemes/common/trigonometric_tables.h"
#include "schemes/common/vectors.h"

namespace bump::kim2001 {

namespace {

constexpr int guard_bits = 2;  // of products before they are summed

struct Matrix {
  VectorWires tangent, binormal, normal;
  Format product;
};

/// M v, rows T, B, N: 9 multipliers, 6 adders.
VectorWires transformed(Netlist& n, const std::string& name, const VectorWires& v, const Matrix& m) {
  const Netlist::Label label(n, "M L, M H, M N");
  return {dot_product(n, name + ".x", v, m.tangent, m.product, m.product), dot_product(n, name + ".y", v, m.binormal, m.product, m.product),
          dot_product(n, name + ".z", v, m.normal, m.product, m.product)};
}

/// A of polar angles as a vector: 2 multipliers, 2 tables.
VectorWires cartesian(Netlist& n, const std::string& name, const TablePtr& sine_cosine, const KimParameters& p) {
  const Netlist::Scope scope(n, name);
  Netlist::Label label(n, "sine and cosine of phi, theta");
  const std::vector<Wire> of_phi = n.table("SC_PHI", sine_cosine, n.input("phi", p.input_angle()));
  const std::vector<Wire> of_theta = n.table("SC_THETA", sine_cosine, n.input("theta", p.input_angle()));
  label.next("L and H as vectors");
  const Format component = n.format(of_phi[0]);
  return {n.mul("x", of_theta[0], of_phi[1], component), n.mul("y", of_theta[0], of_phi[0], component), of_theta[1]};
}

/// N' for each dot product: the two circuits of Eqs 3 and 4 take it separately.
void output_normal(Netlist& n, Wire phi, Wire theta) {
  for (const char* name : {"N_L", "N_H"}) {
    n.output(std::string(name) + ".phi", phi);
    n.output(std::string(name) + ".theta", theta);
  }
}

void record_matrix(Netlist& n, const KimParameters& p) {
  const int w = p.word_bits, fraction = w - 1 + guard_bits;
  const Format component = sfixed(w, w - 1), inner = p.inner_angle();
  const TablePtr sine_cosine = sine_cosine_table("SC", p.input_angle(), p.table_bits, w);
  const TablePtr arc_cosine_rom = arc_cosine_table("ACOS", sfixed(fraction + 1, fraction), p.inverse_table_bits, uangle(w, w + 2));
  const PolarFormats arc_tangent = pixel_polar_formats(fraction + 1, p.inverse_table_bits, inner.width, "ATAN_REF");
  Matrix m;
  m.normal = input_vector(n, "N", component);
  m.tangent = input_vector(n, "T", component);
  m.binormal = input_vector(n, "B", component);
  m.product = sfixed(fraction + 2, fraction);
  for (const std::string name : {"L", "H"}) {
    const VectorWires v = transformed(n, name + "_ref", cartesian(n, name, sine_cosine, p), m);
    n.output(name + "_ref.theta", arc_cosine(n, name + ".theta_ref", v.z, arc_cosine_rom, inner, "theta' = acos z'"));
    const Netlist::Label label(n, "phi' = atan2(y', x')");
    n.begin_addition();
    n.output(name + "_ref.phi", polar_angle(n, name + ".phi_ref", v.y, v.x, arc_tangent));
    n.end_addition();
  }
  output_vector(n, "N_ref", transformed(n, "N_ref", m.normal, m));
  const MapAngles map = map_angles(n, p);
  const Netlist::Label label(n, "N' for Eqs 3, 4");
  output_normal(n, n.shift("phi", map.phi, 0, inner), n.shift("theta", map.theta, 0, inner));
}

/// n' = n + (dphi, dtheta): 2 adders.
void record_direct(Netlist& n, const KimParameters& p) {
  const Format inner = p.inner_angle();
  Netlist::Label label(n, "L, H in object space");
  for (const std::string name : {"L", "H"})
    for (const std::string part : {".phi", ".theta"})
      n.output(name + "_ref" + part, n.shift(name + part + "_word", n.input(name + part, p.input_angle()), 0, inner));
  label.next("n' = n + (dphi, dtheta)");
  const Wire phi = n.add("phi", n.input("N.phi", p.input_angle()), n.input("map.dphi", p.change_of_phi()), inner);
  const Wire theta = n.add("theta", n.input("N.theta", p.input_angle()), n.input("map.dtheta", p.change_of_theta()), inner);
  output_normal(n, phi, theta);
}

}  // namespace

Netlist environment_unit(const KimParameters& p) {
  Netlist n("environment");
  if (p.transform == Transform::matrix)
    record_matrix(n, p);
  else
    record_direct(n, p);
  return n;
}

}  // namespace bump::kim2001
