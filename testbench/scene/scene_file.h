#pragma once
// Reads a scene: a TOML scene file (described in scenes/README.md), or a Wavefront OBJ file directly, whose camera and light are then
// placed by its bounds and which gets a built-in relief if its materials have none. The result is checked: whoever gets it may rely on unit
// frames, finite cameras and complete textures.

#include <string>

#include "units/scene.h"

namespace bump {

/// Throws Error(input) with file, line and column. Scene::warnings tells what was mended, Scene::inputs every file that was read,
/// named from the scene's folder.
Scene read_scene(const std::string& path);

}  // namespace bump
