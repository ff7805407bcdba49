#include "schemes/peercy1997/surface_maps.h"

#include <algorithm>

#include "datapath/error.h"

namespace bump::peercy1997 {

namespace {

glm::dvec3 unit_or_upright(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : glm::dvec3(0, 0, 1);
}

glm::dvec3 scene_normal(const Texture& normals, const glm::dvec2& uv) {
  double n[3];
  sample(normals, Filter::bilinear, uv.x, uv.y, 0, n);
  return unit_or_upright({n[0], n[1], n[2]});
}

/// Eqs 3-6 in the frame T, B, N of shading; `side` is the length of a texel of the heights in object space. T is Pu / |Pu| in the paper.
/// Where interpolation has turned it, components along the frame's own axes are what shading needs, so Eq 1 is written out in them.
glm::dvec3 surface_normal(const Texture& heights, double side, const SurfaceTexel& at) {
  const auto height = [&](double u, double v) {
    double value;
    sample(heights, Filter::bilinear, u, v, 0, &value);
    return side * value;
  };
  const double du = 1.0 / heights.levels[0].width, dv = 1.0 / heights.levels[0].height;
  const double fu = (height(at.uv.x + du, at.uv.y) - height(at.uv.x - du, at.uv.y)) / (2 * du);
  const double fv = (height(at.uv.x, at.uv.y + dv) - height(at.uv.x, at.uv.y - dv)) / (2 * dv);
  const glm::dvec3 &t = at.frame[0], &b = at.frame[1], &pu = at.along_u, &pv = at.along_v;
  const glm::dvec2 along_u{glm::dot(t, pu), glm::dot(b, pu)}, along_v{glm::dot(t, pv), glm::dot(b, pv)};
  // c is positive in a mirrored chart, too: Pu x Pv and B = -N x T both change sides.
  return unit_or_upright(
      {-fu * along_v.y + fv * along_u.y, -(fv * along_u.x - fu * along_v.x), along_u.x * along_v.y - along_u.y * along_v.x});
}

bool is_flat(const Texture& normals) {
  const std::vector<double>& texels = normals.levels[0].texels;
  for (std::size_t i = 0; i < texels.size(); i += 3)
    if (texels[i] != 0 || texels[i + 1] != 0 || texels[i + 2] <= 0) return false;
  return true;
}

}  // namespace

SurfaceMap surface_map(const SceneObject& object, MapSpace space, Perturbation perturbation) {
  const bool from_heights = perturbation == Perturbation::surface && !is_flat(*object.normals);
  if (from_heights && !object.heights)
    throw Error({"object '" + object.name + "' has a normal map without heights",
                 {},
                 "peercy1997.perturbation=surface needs slopes of a height field, Eqs 3-6",
                 "height = \"...\" instead of normal in the scene, or peercy1997.perturbation=square_patch"});
  if (space == MapSpace::tangent) {
    if (!from_heights) return {*object.normals};
    const double side = mean_texel_side(object, *object.heights);
    return bake_surface_map(
        object, *object.heights, [&](const SurfaceTexel& at) { return surface_normal(*object.heights, side, at); },
        "peercy1997.perturbation=square_patch");
  }
  const std::string remedy = "peercy1997.map=tangent";
  if (!from_heights)
    return bake_surface_map(
        object, *object.normals, [&](const SurfaceTexel& at) { return at.frame * scene_normal(*object.normals, at.uv); }, remedy);
  const double side = mean_texel_side(object, *object.heights);
  return bake_surface_map(
      object, *object.heights, [&](const SurfaceTexel& at) { return at.frame * surface_normal(*object.heights, side, at); }, remedy);
}

}  // namespace bump::peercy1997
