#pragma once
// The material of a scene for hardware whose constants and tables hold one.

#include "units/scene.h"

namespace bump {

/// Throws Error(input) if the scene has no object, or objects of several materials.
const Material& only_material(const Scene& scene);

}  // namespace bump
