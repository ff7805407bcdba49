#pragma once
// The projection that the simulated hardware and the reference renderer share, so that they cover the same pixels: an OpenGL perspective
// camera (right-handed, looking along -z), clip volume -w <= x, y, z <= w, pixel (0, 0) at the top left with its centre at (0.5, 0.5).
// It is fixed for a frame, so it costs no time in the models; applying it to a vertex is the vertex processor's work.
// Source: the OpenGL specification, gluPerspective and gluLookAt.

#include <glm/glm.hpp>

#include "units/scene.h"

namespace bump {

/// Camera coordinates from world coordinates: the eye at the origin, x to the right, y up, z towards the viewer.
glm::dmat4 world_to_eye(const Camera& camera);

/// Homogeneous clip coordinates from world coordinates for a frame of width x height pixels. `far` > camera.near, in world units.
/// Square pixels: the horizontal field of view follows from the aspect ratio.
glm::dmat4 world_to_clip(const Camera& camera, int width, int height, double far);

/// A far plane that no vertex of the scene lies beyond: a little more than the largest distance from the eye, and at least 2 * near.
/// World units.
double far_distance(const Scene& scene);

/// Where a clip-space position falls on the screen.
struct ScreenPosition {
  double x = 0, y = 0;   ///< pixels, y downwards; the centre of pixel (i, j) is (i + 0.5, j + 0.5)
  double depth = 0;      ///< (z / w + 1) / 2: 0 on the near plane, 1 on the far plane, affine on the screen
  double inverse_w = 0;  ///< 1 / w
};

/// The perspective division and the viewport of a frame of width x height pixels. clip.w must be positive.
ScreenPosition to_screen(const glm::dvec4& clip, int width, int height);

}  // namespace bump
