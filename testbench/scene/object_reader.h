#pragma once
// Reads the [[object]] tables of a scene file: shape, placement, textures, material. The keys are described in scenes/README.md.

#include <string>
#include <vector>

#include "testbench/scene/input_files.h"
#include "testbench/scene/texture_store.h"
#include "testbench/scene/toml_document.h"
#include "units/scene.h"

namespace bump {

/// Appends the objects of one [[object]] table to `scene.objects` (a mesh with several materials gives several). `scene_file`: textures and
/// meshes are relative to its folder. Throws Error(input).
void read_object(const TomlValue& table, const FileName& scene_file, InputFiles& files, TextureStore& textures, Scene& scene);

}  // namespace bump
