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

const Image& TextureStore::image(const std::string& path, const Location& from) {
  const auto known = images_.find(path);
  if (known != images_.end()) return known->second;
  try {
    return images_.emplace(path, decode_image(path, files_.read(path, "texture", from), from)).first->second;
  } catch (const std::bad_alloc&) {
    throw Error({"texture '" + path + "' does not fit into memory", from, "", "scale it down"});
  }
}

std::shared_ptr<const Texture> TextureStore::colour(const std::string& path, const Wrap& wrap, const Location& from) {
  auto& texture = colours_[key_of("colour", path, 0, wrap)];
  if (!texture) texture = std::make_shared<const Texture>(colour_texture(image(path, from), path, wrap, warnings_));
  return texture;
}

BumpTextures TextureStore::from_heights(const std::string& path, double scale, const Wrap& wrap, const Location& from) {
  BumpTextures& bump = bumps_[key_of("heights", path, scale, wrap)];
  if (!bump.normals) {
    auto heights = std::make_shared<const Texture>(height_texture(image(path, from), path, scale, wrap, from, warnings_));
    bump = {std::make_shared<const Texture>(normals_from_heights(*heights)), heights};
  }
  return bump;
}

BumpTextures TextureStore::from_normals(const std::string& path, bool green_down, const Wrap& wrap, const Location& from) {
  BumpTextures& bump = bumps_[key_of("normals", path, green_down ? 1 : 0, wrap)];
  if (!bump.normals) {
    bump = {std::make_shared<const Texture>(normals_from_map(image(path, from), path, green_down, wrap, from, warnings_)), nullptr};
  }
  return bump;
}

BumpTextures TextureStore::from_either(const std::string& path, double scale, const Wrap& wrap, const Location& from) {
  if (!looks_like_normal_map(image(path, from))) return from_heights(path, scale, wrap, from);
  warnings_.push_back("'" + path + "' is named as a height map but looks like a normal map; it is used as one, green up");
  return from_normals(path, false, wrap, from);
}

void TextureStore::compare(const Texture& normals, const std::string& height_path, const Location& from) {
  const Texture heights = height_texture(image(height_path, from), height_path, 1.0, {normals.wrap_u, normals.wrap_v}, from, warnings_);
  const auto& a = normals.levels.front();
  const auto& b = heights.levels.front();
  if (a.width != b.width || a.height != b.height) {
    warnings_.push_back("'" + height_path + "' and '" + normals.name + "' differ in size; they are not compared");
    return;
  }
  const double correlation = green_correlation(normals, heights);
  if (correlation >= -0.2) return;
  const double shown = static_cast<int>(correlation * 1000 - 0.5) / 1000.0;
  warnings_.push_back("the green channel of '" + normals.name + "' contradicts the heights in '" + height_path + "' (correlation " +
                      to_string(ParameterValue(shown)) + "); try the other value of green");
}

}  // namespace bump
