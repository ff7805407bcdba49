#pragma once
// Loads the textures of a scene, each picture once and each texture made from it once, and lists every file that was read.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "testbench/scene/bump_map.h"
#include "testbench/scene/input_files.h"

namespace bump {

struct BumpTextures {
  std::shared_ptr<const Texture> normals;
  std::shared_ptr<const Texture> heights;  ///< null if the map came as normals
};

class TextureStore {
 public:
  /// `files` and `warnings` must outlive the store.
  TextureStore(InputFiles& files, std::vector<std::string>& warnings) : files_(files), warnings_(warnings) {}

  // `from` is the place that refers to the file. All throw Error(input): see decode_image() and bump_map.h.
  std::shared_ptr<const Texture> colour(const FileName& file, const Wrap& wrap, const Location& from);
  BumpTextures from_heights(const FileName& file, double scale, const Wrap& wrap, const Location& from);
  BumpTextures from_normals(const FileName& file, bool green_down, const Wrap& wrap, const Location& from,
                            NamedBy named_by = NamedBy::scene);
  /// Heights or normals, judged by content: material libraries, which this is for, name both "bump".
  BumpTextures from_either(const FileName& file, double scale, const Wrap& wrap, const Location& from);
  /// Warns if the green channel of a normal map contradicts the height map that comes with it.
  void compare(const Texture& normals, const FileName& height_file, const Location& from);

 private:
  const Image& image(const FileName& file, const Location& from);

  InputFiles& files_;
  std::vector<std::string>& warnings_;
  std::map<std::string, Image> images_;
  std::map<std::string, std::shared_ptr<const Texture>> colours_;
  std::map<std::string, BumpTextures> bumps_;
};

}  // namespace bump
