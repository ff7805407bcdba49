#include "testbench/scene/texture_store.h"

#include <new>

#include "channels/parameters.h"

namespace bump {

namespace {

std::string key_of(const std::string& role, const std::string& path, double parameter, const Wrap& wrap) {
  return role + ":" + to_string(ParameterValue(parameter)) + ":" + std::to_string(static_cast<int>(wrap.u)) +
         std::to_string(static_cast<int>(wrap.v)) + ":" + path;
}

}  // namespace

const Image& TextureStore::image(const FileName& file, const Location& from) {
  const auto known = images_.find(file.path);
  if (known != images_.end()) return known->second;
  try {
    return images_.emplace(file.path, decode_image(file.path, files_.read(file, "texture", from), from)).first->second;
  } catch (const std::bad_alloc&) {
    throw Error({"texture '" + file.path + "' does not fit into memory", from, "", "scale it down"});
  }
}

std::shared_ptr<const Texture> TextureStore::colour(const FileName& file, const Wrap& wrap, const Location& from) {
  auto& texture = colours_[key_of("colour", file.path, 0, wrap)];
  if (!texture) texture = std::make_shared<const Texture>(colour_texture(image(file, from), file, wrap, warnings_));
  return texture;
}

BumpTextures TextureStore::from_heights(const FileName& file, double scale, const Wrap& wrap, const Location& from) {
  BumpTextures& bump = bumps_[key_of("heights", file.path, scale, wrap)];
  if (!bump.normals) {
    auto heights = std::make_shared<const Texture>(height_texture(image(file, from), file, scale, wrap, from, warnings_));
    bump = {std::make_shared<const Texture>(normals_from_heights(*heights)), heights};
  }
  return bump;
}

BumpTextures TextureStore::from_normals(const FileName& file, bool green_down, const Wrap& wrap, const Location& from, NamedBy named_by) {
  BumpTextures& bump = bumps_[key_of("normals", file.path, green_down ? 1 : 0, wrap)];
  if (!bump.normals) {
    bump = {std::make_shared<const Texture>(normals_from_map(image(file, from), file, green_down, wrap, from, warnings_, named_by)),
            nullptr};
  }
  return bump;
}

BumpTextures TextureStore::from_either(const FileName& file, double scale, const Wrap& wrap, const Location& from) {
  if (!looks_like_normal_map(image(file, from))) return from_heights(file, scale, wrap, from);
  warnings_.push_back("'" + file.shown + "' is named as a height map but looks like a normal map; it is used as one, green up");
  return from_normals(file, false, wrap, from, NamedBy::material_library);
}

void TextureStore::compare(const Texture& normals, const FileName& height_file, const Location& from) {
  const Texture heights = height_texture(image(height_file, from), height_file, 1.0, {normals.wrap_u, normals.wrap_v}, from, warnings_);
  const auto& a = normals.levels.front();
  const auto& b = heights.levels.front();
  if (a.width != b.width || a.height != b.height) {
    warnings_.push_back("'" + height_file.shown + "' and '" + normals.name + "' differ in size; they are not compared");
    return;
  }
  const double correlation = green_correlation(normals, heights);
  if (correlation >= -0.2) return;
  const double shown = static_cast<int>(correlation * 1000 - 0.5) / 1000.0;
  warnings_.push_back("the green channel of '" + normals.name + "' contradicts the heights in '" + height_file.shown + "' (correlation " +
                      to_string(ParameterValue(shown)) + "); try the other value of green");
}

}  // namespace bump
