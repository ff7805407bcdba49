#include "schemes/common/vertex_vectors.h"

namespace bump {

VertexVectors record_vertex_vectors(Design& design) {
  Netlist& n = design.vertex;
  VertexVectors v;
  v.normal = input_vector(n, "N", real());
  v.tangent = input_vector(n, "T", real());
  v.binormal = input_vector(n, "B", real());
  const VectorWires to_light = input_vector(n, "L", real()), to_eye = input_vector(n, "V", real());
  v.light = normalise_vertex(n, "L_unit", to_light);
  v.half = normalise_vertex(n, "H_unit", half_vector(n, "H", v.light, normalise_vertex(n, "V_unit", to_eye)));
  return v;
}

void interpolate_vector(Design& design, const std::string& name, const VectorWires& v) {
  output_vector(design.vertex, name, v);
  for (const char* component : {".x", ".y", ".z"}) design.interpolants.push_back({name + component, InterpolantKind::linear});
}

void interpolate_vectors(Design& design, const VertexVectors& v) {
  interpolate_vector(design, "N", v.normal);
  interpolate_vector(design, "T", v.tangent);
  interpolate_vector(design, "B", v.binormal);
  interpolate_vector(design, "L", v.light);
  interpolate_vector(design, "H", v.half);
}

}  // namespace bump
