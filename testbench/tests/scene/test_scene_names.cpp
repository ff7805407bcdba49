#include "scene_bench.h"
#include "testbench/scene/scene_file.h"
#include "testbench/scene/scene_names.h"

using namespace bump;
using namespace bump::test;

namespace {

const std::string shipped = std::string(BUMP_SOURCE_DIR) + "/scenes";

std::string message(const std::string& name, const std::vector<std::string>& folders) {
  try {
    find_scene_path(name, folders);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("scenes are found by name, in the first folder that has them, or by path") {
  const TemporaryFolder first, second;
  first.write("a.toml", "x");
  second.write("a.toml", "x");
  second.write("b.toml", "x");
  const std::vector<std::string> folders = {first.path(""), second.path("")};
  CHECK(find_scene_path("a", folders) == first.path("a.toml"));
  CHECK(find_scene_path("b", folders) == second.path("b.toml"));
  CHECK(find_scene_path(second.path("b.toml"), {}) == second.path("b.toml"));
  CHECK(shipped_scenes(second.path("")) == std::vector<std::string>{"a", "b"});
  CHECK(shipped_scenes(second.path("none")).empty());
}

TEST_CASE("an unknown scene is answered with the nearest name") {
  CHECK(message("wrold_sphere", {shipped}).find("try: world_sphere") != std::string::npos);
  CHECK(message("scenes/brick_cub.toml", {shipped}).find("try: brick_cube") != std::string::npos);
  CHECK(message("zzz", {shipped}).find("the shipped scenes are ") != std::string::npos);
  CHECK(message("zzz", {}).find("no folder of shipped scenes was found") != std::string::npos);
  CHECK(message("", {shipped}).find("no scene is named") != std::string::npos);
  CHECK(message(shipped, {shipped}).find("is a folder, not a scene") != std::string::npos);
}

TEST_CASE("every shipped scene reads, has a title, sound frames and unit normals") {
  const auto names = shipped_scenes(shipped);
  CHECK(names == std::vector<std::string>{"brick_cube", "brick_torus", "bunny", "wood_plane", "world_sphere"});
  for (const auto& name : names) {
    INFO(name);
    const std::string path = find_scene_path(name, {shipped});
    CHECK(read_file(path).substr(0, 2) == "# ");
    const Scene scene = read_scene(path);
    CHECK(scene.name == name);
    for (const auto& warning : scene.warnings) CHECK(warning.find("box projection") != std::string::npos);
    CHECK(scene.inputs.size() >= 3);
    for (const auto& object : scene.objects) {
      check_mesh(*object.mesh);
      CHECK(object.normals->levels[0].width >= 512);
      CHECK(object.normals->levels.back().texels.size() == 3);
      CHECK(object.colour->levels[0].width == object.normals->levels[0].width);
    }
  }
}
