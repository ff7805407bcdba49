#pragma once
// Camera and light for a mesh that is given without a scene: in front (+z), a little to the right and above, so that the bounding sphere
// fills the frame; the light about 50 degrees to the camera's left, so that relief shows. A mesh that turns its back, as one wound
// clockwise does, is seen from where it shows most, for faces are drawn from their front only.

#include <string>

#include "units/scene.h"

namespace bump {

/// Sets camera and lights of a scene that has objects. Camera and light move together, by half a turn about one of the axes, if at least a
/// tenth more of the area projected along the view faces away than towards the camera; a closed mesh faces both ways alike and small holes
/// do not count. Tells so in Scene::warnings, with `mesh` as the name of the file.
void place_view(const std::string& mesh, Scene& scene);

}  // namespace bump
