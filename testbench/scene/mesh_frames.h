#pragma once
// What a bare mesh lacks for bump mapping: normals, texture coordinates, tangents.
//   Normals: face normals weighted by the corner's angle (Thuermer and Wuethrich 1998), shared by all vertices at one position.
//   Texture coordinates: box projection. Every triangle is seen along the axis nearest to its mean normal; the texture repeats once over
//   the
//     largest side of the mesh's bounding box, upright along y. Its density is even within a factor of 1.7 and it never folds or
//     degenerates, which latitude and longitude do on a body with ears. Between axes the pattern jumps: vertices are doubled there.
//   Tangents: Cg Tutorial ch. 8, section 8.4: the inverse gradient dP/ds of each triangle from its plane equations, blended by angle at
//     shared vertices, made orthogonal to the normal. Where a texture is mirrored (negative texture area) the vertex is doubled, so that
//     each copy has its own handedness. A triangle without texture area takes the tangents of its neighbours, or any direction.

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "units/scene.h"

namespace bump {

/// One unit normal per position; zero where no triangle gives one. `triangles` index `positions`; equal positions share their normal.
std::vector<glm::dvec3> smooth_normals(const std::vector<glm::dvec3>& positions, const std::vector<glm::uvec3>& triangles);

/// The direction, 0 to 5 (+x, -x, +y, -y, +z, -z), along which box projection sees a surface with this normal.
int box_side(const glm::dvec3& normal);
/// Texture coordinates of a point seen along `side`; `low` and `size` are the corner and the largest side of the bounding box.
glm::dvec2 box_coordinates(const glm::dvec3& position, int side, const glm::dvec3& low, double size);

struct TangentReport {
  int without_texture_area = 0;  ///< triangles
  int doubled_vertices = 0;      ///< copies made for mirrored areas
};

/// Fills tangent and handedness of every vertex from positions, unit normals, texture coordinates and triangles.
TangentReport build_tangents(Mesh& mesh);

}  // namespace bump
