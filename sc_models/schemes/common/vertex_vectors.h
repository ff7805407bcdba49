#pragma once
// The part of a vertex program that Cartesian schemes share: frame, unit light vector and unit half vector, in object space. A program on
// floating-point ALUs, not a pipeline. L and H are normalised here, also for a point light, so that interpolated components are bounded by
// 1 as fixed point needs. Leaves out whatever a scheme does with them. Source: Blinn 1977 (half vector); Peercy, Airey and Cabral 1997,
// Figs 1 and 3 (what is interpolated).

#include <string>

#include "schemes/common/vectors.h"
#include "schemes/scheme.h"

namespace bump {

struct VertexVectors {
  VectorWires normal, tangent, binormal;  ///< the vertex frame as it comes
  VectorWires light, half;                ///< unit: 9 multipliers, 9 adders, 3 square roots, 9 dividers together
};

/// Records all five into design.vertex.
VertexVectors record_vertex_vectors(Design& design);

/// Makes "name.x", "name.y", "name.z" outputs of the vertex program and linear interpolants.
void interpolate_vector(Design& design, const std::string& name, const VectorWires& v);
/// All five, as "N", "T", "B", "L", "H".
void interpolate_vectors(Design& design, const VertexVectors& v);

}  // namespace bump
