#pragma once
// Which surface point lies under each texel of a texture that an object wears: the mesh rasterised in texture space. For maps that belong
// to one surface, as object-space normal maps do. Preprocessing by the host: no hardware, no time. Texture coordinates may repeat; the
// chart covers the whole repeats that the object uses. A texel's surface point is that of its centre; a centre on a common edge belongs to
// one triangle (top-left rule). Texels outside every triangle take the surface of the nearest texel inside one, so that filters at the
// border of a chart read no foreign surface. Source: Peercy, Airey and Cabral 1997, sections 2 and 2.1 ask for such maps; how to make them
// is left to the reader.

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "units/scene.h"

namespace bump {

/// What is known about the surface under a texel.
struct SurfaceTexel {
  glm::dvec2 uv{0};                   ///< of the texel's own centre, also where the surface is borrowed from a neighbour
  glm::dvec3 position{0};             ///< object units
  glm::dmat3 frame{1};                ///< columns T, B, N: orthonormal, interpolated as shading interpolates them
  glm::dvec3 along_u{0}, along_v{0};  ///< Pu, Pv of the flat triangle: object units per whole texture
};

class TextureChart {
 public:
  /// Asked when two distant surface points lie under one texel: whether a map can serve both.
  using Agree = std::function<bool(const SurfaceTexel&, const SurfaceTexel&)>;

  /// `texture` gives texels per repeat and wrap modes; sides shorter than least_side over the whole chart are refined by powers of two, as
  /// the surface curves between the texels of the coarsest map. Throws Error(input), with `remedy` as its advice, if two points disagree,
  /// if the chart needs more than largest_area texels, or if the mesh's texture coordinates span no texel.
  TextureChart(const SceneObject& object, const Texture& texture, const Agree& agree, const std::string& remedy);

  static constexpr int least_side = 128;
  static constexpr std::int64_t largest_area = std::int64_t{4096} * 4096;

  int width() const { return width_; }
  int height() const { return height_; }
  glm::dvec2 origin() const { return origin_; }    ///< texture coordinates of the chart's lower left corner
  glm::dvec2 repeats() const { return repeats_; }  ///< its size in texture coordinates, whole numbers
  SurfaceTexel at(int x, int y) const;
  /// Wrap modes that suit a map of the chart: that of the texture, but clamp where it repeats and the surface does not close over the
  /// border.
  WrapMode wrap_u() const { return wrap_u_; }
  WrapMode wrap_v() const { return wrap_v_; }

 private:
  void place(const Texture& texture, const std::string& remedy);
  void cover(std::int32_t triangle, const Agree& agree, const std::string& remedy);
  void cover_texel(int x, int y, std::int32_t triangle, const Agree& agree, const std::string& remedy);
  void borrow();
  WrapMode border_mode(WrapMode wrap, bool across) const;
  glm::dvec2 centre(int x, int y) const;
  SurfaceTexel surface(std::int32_t triangle, const glm::dvec2& uv) const;
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  const SceneObject& object_;
  glm::dvec2 origin_{0}, repeats_{1};
  int width_ = 0, height_ = 0;
  WrapMode wrap_u_ = WrapMode::repeat, wrap_v_ = WrapMode::repeat;
  std::vector<std::int32_t> triangle_;  ///< per texel; -1: none
  std::vector<std::int32_t> lender_;    ///< per texel: the covered texel whose surface it has
};

}  // namespace bump
