#pragma once
// The image that a scene ought to give: shaded at every pixel in object space and double precision, with exact light and half vectors, from
// the same textures that the simulated hardware reads. Not a model of hardware and untimed; what the quality of a scheme is measured
// against. Illumination: Lee 2007, Eq 2, with dots clamped at zero and no further self-shadowing, as in the schemes:
//   colour = clamp(texel * (ambient + sum over lights of intensity * (diffuse * max(0, N'.L) + specular * max(0, N'.H)^shininess)), 0, 1),
//   H = (L + V) normalised.

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

/// The scene at its own size. `filter` applies to all textures. Back faces are culled unless told otherwise; a back face keeps its
/// outward normal. Throws Error(input) for `blinn` when has_blinn_reference is false.
FrameBuffer render_reference(const Scene& scene, Filter filter, ReferenceNormals which, bool cull_back_faces = true);

}  // namespace bump
