#pragma once
// Cuts planar polygons into triangles by clipping ears (Meisters 1975): convex and concave outlines without holes; a polygon that is not
// simple still gives n - 2 triangles. Used for the faces of meshes.

#include <array>
#include <glm/glm.hpp>
#include <vector>

namespace bump {

/// `outline`: n >= 3 corners. Returns n - 2 triples of indices into it, each in the outline's sense of rotation.
std::vector<std::array<int, 3>> triangulate(const std::vector<glm::dvec3>& outline);

}  // namespace bump
