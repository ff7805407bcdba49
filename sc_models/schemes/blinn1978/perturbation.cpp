#include "schemes/blinn1978/perturbation.h"

#include "schemes/common/cartesian_units.h"
#include "schemes/common/vertex_vectors.h"

namespace bump::blinn1978 {

namespace {

VectorWires scaled(Netlist& n, const std::string& name, Wire factor, const VectorWires& v, const Format& format) {
  const Netlist::Scope scope(n, name);
  return {n.mul("x", factor, v.x, format), n.mul("y", factor, v.y, format), n.mul("z", factor, v.z, format)};
}

VectorWires less(Netlist& n, const std::string& name, const VectorWires& a, const VectorWires& b, const Format& format) {
  const Netlist::Scope scope(n, name);
  return {n.sub("x", a.x, b.x, format), n.sub("y", a.y, b.y, format), n.sub("z", a.z, b.z, format)};
}

VectorWires perturbed_normal(Netlist& n, const BlinnParameters& p) {
  const Format component = p.widths.component();
  const VectorWires normal = input_vector(n, "N", component), pu = input_vector(n, "Pu", component), pv = input_vector(n, "Pv", component);
  const Format slope = p.widths.product(p.slopes.integer_bits);  // filtered slopes have more places than texels
  const Netlist::Label label(n, "Eq 1 of Lee 2007");
  const Wire bu = n.input("map.u", slope), bv = n.input("map.v", slope);
  // Cross products of vectors no longer than 1 stay in [-1, 1]; two scaled ones and N add up to less than 2^(integer_bits + 2).
  const Format unscaled = p.widths.product(), sum = p.widths.product(p.slopes.integer_bits + 2);
  if (p.factored) {
    const VectorWires along = less(n, "along", scaled(n, "Bu_Pv", bu, pv, sum), scaled(n, "Bv_Pu", bv, pu, sum), sum);
    return sum_of_vectors(n, "N_bumped", normal, cross_product(n, "D", normal, along, sum, sum), sum);
  }
  const VectorWires across_v = cross_product(n, "N_x_Pv", normal, pv, unscaled, unscaled);
  const VectorWires across_u = cross_product(n, "N_x_Pu", normal, pu, unscaled, unscaled);
  const VectorWires first = sum_of_vectors(n, "N_plus", normal, scaled(n, "Bu_N_x_Pv", bu, across_v, sum), sum);
  return less(n, "N_bumped", first, scaled(n, "Bv_N_x_Pu", bv, across_u, sum), sum);
}

}  // namespace

void record_vertex_program(Design& design) {
  const VertexVectors v = record_vertex_vectors(design);
  Netlist& n = design.vertex;
  // Blinn's N is along Pu x Pv. Where a texture chart is mirrored, T x B points inwards and both are turned about.
  n.begin_addition();
  const VectorWires pu = cross_product(n, "Pu", v.binormal, v.normal, real(), real());
  const VectorWires pv = cross_product(n, "Pv", v.normal, v.tangent, real(), real());
  n.end_addition();
  interpolate_vector(design, "N", v.normal);
  interpolate_vector(design, "Pu", pu);
  interpolate_vector(design, "Pv", pv);
  interpolate_vector(design, "L", v.light);
  interpolate_vector(design, "H", v.half);
}

Netlist environment_unit(const BlinnParameters& p) {
  Netlist n("environment");
  const VectorWires bumped = perturbed_normal(n, p);
  const Netlist::Label label(n, "normaliser, Lee 2007 sec. 6");
  for (const char* name : {"L", "H"}) {
    const std::string unit = std::string(name) + "_unit";
    output_vector(n, unit, normalise_pixel(n, unit, input_vector(n, name, p.widths.component()), p.widths));
  }
  output_vector(n, "N_unit", normalise_pixel(n, "N_unit", bumped, p.widths, p.slopes.integer_bits + 2));
  return n;
}

}  // namespace bump::blinn1978
