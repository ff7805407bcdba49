#pragma once
// The image that a scene ought to give: shaded at every pixel in object space and double precision, with exact light and half vectors, from
// the same textures that the simulated hardware reads. Not a model of hardware and untimed; what the quality of a scheme is measured
// against. Illumination: Lee 2007, Eq 2, with dots clamped at zero and no further self-shadowing, as in the schemes:
//   colour = clamp(texel * (ambient + sum over lights of intensity * (diffuse * max(0, N'.L) + specular * max(0, N'.H)^shininess)), 0, 1),
//   H = (L + V) normalised.

#include <functional>
#include <memory>
#include <optional>

#include "memory/texture.h"
#include "units/frame_buffer.h"
#include "units/scene.h"

namespace bump {

/// Where N' comes from (perturbed_normal.h). The two are never mixed: how a map was made moves an image more than hardware does.
enum class ReferenceNormals {
  normal_map,  ///< the map that the schemes encode, in exact, renormalised frames: tells what the hardware loses
  blinn        ///< Blinn's perturbation from the height map: tells what the map loses as well
};

/// True if Blinn's reference can be drawn: some object has heights, and none has a normal map without heights.
bool has_blinn_reference(const Scene& scene);

/// What the picture of any scheme is compared with.
struct References {
  FrameBuffer normal_map;            ///< the scene's own bump map in exact frames
  std::optional<FrameBuffer> blinn;  ///< Blinn's perturbation, where the scene has heights
};

/// Draws a scene's references at its own size, side by side: what is seen, where and in which light is found once for both. `filter`
/// applies to all textures. Back faces are culled or not; a back face keeps its outward normal.
class ReferenceRenderer {
 public:
  /// The scene must outlive it. Throws Error(input) for `with_blinn` when has_blinn_reference is false. `watch` (may be empty) is called
  /// now and then while rows are drawn, from any of the threads, and may throw to end that.
  ReferenceRenderer(const Scene& scene, Filter filter, bool with_blinn, bool cull_back_faces, std::function<void()> watch = {});
  ~ReferenceRenderer();

  /// Rows first_row up to, not including, end_row. Several threads may draw different rows; the first to come finds what is seen while the
  /// others wait.
  void draw_rows(int first_row, int end_row);
  /// The pictures, once all rows are drawn; the renderer is of no use afterwards.
  References release();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// One of the two alone. Throws as above.
FrameBuffer render_reference(const Scene& scene, Filter filter, ReferenceNormals which, bool cull_back_faces = true);

}  // namespace bump
