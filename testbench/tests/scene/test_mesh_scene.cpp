#include <cmath>
#include <filesystem>

#include "scene_bench.h"
#include "testbench/scene/scene_file.h"

using namespace bump;
using namespace bump::test;

namespace {

const std::string quad = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";

std::vector<float> slopes() {
  std::vector<float> values;
  for (int i = 0; i < 64; ++i) values.insert(values.end(), {0.5f + 0.3f * static_cast<float>(i % 2), 0.5f, 0.9f});
  return values;
}

}  // namespace

TEST_CASE("a bare mesh is framed by its bounds and gets a relief") {
  const TemporaryFolder folder;
  const Scene scene = read_scene(folder.write("thing.obj", quad + "f 1/1 2/2 3/3 4/4\n"));
  CHECK(scene.name == "thing");
  REQUIRE(scene.objects.size() == 1);
  check_mesh(*scene.objects[0].mesh);
  CHECK(scene.objects[0].heights != nullptr);
  CHECK(scene.objects[0].normals->levels[0].width == 256);
  CHECK(scene.camera.target == glm::dvec3(1, 1, 0));
  // The bounding sphere touches the edge of the view.
  const double distance = glm::distance(scene.camera.eye, scene.camera.target);
  CHECK(distance * std::sin(scene.camera.field_of_view * 3.14159265358979 / 360) == Approx(std::sqrt(2.0)));
  CHECK(scene.camera.near < distance - std::sqrt(2.0));
  REQUIRE(scene.lights.size() == 1);
  CHECK(glm::length(scene.lights[0].vector) == Approx(1));
  CHECK(scene.inputs.size() == 1);
}

TEST_CASE("materials bring colours, heights with their multiplier, and normals, also with paths of another system") {
  const TemporaryFolder folder;
  folder.write("maps/x", "");
  folder.write_image("maps/colour.png", 1, 1, 3, {1, 0, 0});
  folder.write_image("maps/height.png", 8, 8, 1, std::vector<float>(64, 1.0f));
  folder.write_image("maps/normal.png", 8, 8, 3, slopes());
  folder.write("m.mtl",
               "newmtl a\nKd 0.1 0.2 0.3\nmap_Kd maps\\colour.png\nmap_Bump -bm 0.5 maps\\height.png\n"
               "newmtl b\nKd 0.25 0.5 0.75\nnorm maps/normal.png\nmap_weird thing.png\n"
               "newmtl c\nKd 0.5 0.5 0.5\nbump maps/normal.png\n");
  const Scene scene = read_scene(folder.write(
      "m.obj",
      "mtllib m.mtl\n" + quad + "usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 1/1 3/3 4/4\nusemtl c\nf 1/1 2/2 4/4\nusemtl d\nf 2/2 3/3 4/4\n"));
  REQUIRE(scene.objects.size() == 4);
  CHECK(scene.objects[0].name == "m/a");
  CHECK(scene.objects[0].colour->levels[0].texels == std::vector<double>{1, 0, 0});
  REQUIRE(scene.objects[0].heights);
  CHECK(scene.objects[0].heights->levels[0].texels[0] == 1.0);  // 1.0 times the default of 2 texels times 0.5
  CHECK(scene.objects[1].colour->levels[0].texels == std::vector<double>{0.25, 0.5, 0.75});
  CHECK(scene.objects[1].heights == nullptr);
  CHECK(scene.objects[1].normals->levels[0].width == 8);
  CHECK(scene.objects[2].heights == nullptr);
  CHECK(scene.objects[2].normals->levels[0].width == 8);
  CHECK(scene.objects[3].heights != nullptr);
  CHECK(warns_of(scene.warnings, "is named as a height map but looks like a normal map"));
  CHECK(warns_of(scene.warnings, "unknown keys ignored: map_weird"));
  CHECK(warns_of(scene.warnings, "no library describes material 'd'"));
  CHECK(scene.inputs.size() == 5);
}

TEST_CASE("missing libraries and maps are warnings that name them, damaged maps are errors") {
  const TemporaryFolder folder;
  const std::string mesh = folder.write("m.obj", "mtllib m.mtl\n" + quad + "usemtl a\nf 1/1 2/2 3/3\n");
  CHECK(warns_of(read_scene(mesh).warnings, "m.obj:1: material library 'm.mtl' does not exist"));
  folder.write("m.mtl", "newmtl a\nmap_Kd gone.png\n");
  CHECK(warns_of(read_scene(mesh).warnings, "'m.mtl': texture 'gone.png' of material 'a' does not exist"));
  folder.write("gone.png", "no picture");
  CHECK(error_of([&] { read_scene(mesh); }).where.file == folder.path("m.mtl"));
}

TEST_CASE("what a scene gives wins over the mesh's materials") {
  const TemporaryFolder folder;
  folder.write("m.mtl", "newmtl a\nKd 0.25 0.5 0.75\n");
  folder.write("m.obj", "mtllib m.mtl\n" + quad + "usemtl a\nf 1/1 2/2 3/3\n");
  const std::string head = "[camera]\neye = [0, 0, 3]\n[[light]]\ndirection = [0, 0, 1]\n[[object]]\nshape = \"mesh\"\nmesh = \"m.obj\"\n";
  CHECK(read_scene(folder.write("s.toml", head)).objects[0].colour->levels[0].texels == std::vector<double>{0.25, 0.5, 0.75});
  const Scene own = read_scene(folder.write("t.toml", head + "colour = [1, 1, 1]\nuv_scale = -2\n"));
  CHECK(own.objects[0].colour->levels[0].texels == std::vector<double>{1, 1, 1});
  CHECK(own.objects[0].normals->levels[0].texels == std::vector<double>{0, 0, 1});
  check_mesh(*own.objects[0].mesh);
  CHECK(own.objects[0].mesh->vertices[0].tangent.x == Approx(-1));
  const ErrorText missing = error_of([&] { read_scene(folder.write("u.toml", head.substr(0, head.size() - 7) + "n.obj\"\n")); });
  CHECK(missing.what.find("mesh '" + folder.path("n.obj") + "' does not exist") == 0);
  CHECK(missing.where.line == 7);
  CHECK(missing.try_this == folder.path("m.obj"));
}

TEST_CASE("warnings, inputs and texture names do not depend on how the scene is called") {
  const TemporaryFolder folder;
  folder.write("art/x", "");
  folder.write_image("art/green.png", 8, 8, 3, slopes());
  folder.write_image("art/colours.png", 2, 1, 3, {1, 0, 0, 0, 1, 0});
  folder.write("mesh/m.mtl", "newmtl a\nKd 2 0 0\nKs 1 1 1\nmap_Bump -s 2 2 2 ../art/green.png\nnewmtl b\nmap_Kd gone.png\n");
  const std::string mesh = folder.write(
      "mesh/m.obj", "mtllib m.mtl\nmtllib none.mtl\n" + quad + "usemtl a\nf 1 2 3\nf 1 1 1\nusemtl b\nf 1 3 4\nusemtl c\nf 2 3 4\n");
  const std::string toml = folder.write("s.toml",
                                        "[camera]\neye = [0, 0, 3]\n[[light]]\ndirection = [0, 0, 1]\n[[object]]\nshape = \"mesh\"\n"
                                        "mesh = \"mesh/m.obj\"\n[[object]]\nshape = \"plane\"\nheight = \"mesh/../art/colours.png\"\n");
  for (const std::string& path : {mesh, toml}) {
    const Scene absolute = read_scene(path);
    CHECK(absolute.warnings.size() >= 7);
    for (const auto& warning : absolute.warnings) CHECK(warning.find(folder.path("").substr(0, 5)) == std::string::npos);
    const std::filesystem::path relative = std::filesystem::relative(path);
    for (const auto& other : {relative, "." / relative, relative.parent_path() / "." / relative.filename()}) {
      const Scene scene = read_scene(other.string());
      CHECK(scene.warnings == absolute.warnings);
      REQUIRE(scene.inputs.size() == absolute.inputs.size());
      for (std::size_t i = 0; i < scene.inputs.size(); ++i) CHECK(scene.inputs[i].path == absolute.inputs[i].path);
      for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        CHECK(scene.objects[i].normals->name == absolute.objects[i].normals->name);
      }
    }
  }
  CHECK(warns_of(read_scene(toml).warnings, "mesh/m.mtl:4: option -s 2 2 2 of map_Bump"));
  CHECK(warns_of(read_scene(toml).warnings, "'art/colours.png' is a height map in colour"));
  CHECK(read_scene(toml).inputs[1].path == "mesh/m.obj");
}

TEST_CASE("a green channel of the wrong sign is told in words that fit who names the map") {
  const TemporaryFolder folder;
  std::vector<float> down;
  const int side = 32;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {  // a relief of sin(x + y), green turned over
      const double slope = std::cos(2 * 3.14159265358979 * (x + y) / side);
      const glm::dvec3 n = glm::normalize(glm::dvec3(-slope, slope, 1));
      for (int i = 0; i < 3; ++i) down.push_back(static_cast<float>(0.5 + 0.5 * (i == 1 ? -1 : 1) * n[i]));
    }
  }
  folder.write_image("n.png", side, side, 3, down, 16);
  folder.write("m.mtl", "newmtl a\nnorm n.png\n");
  const std::string mesh = folder.write("m.obj", "mtllib m.mtl\n" + quad + "usemtl a\nf 1/1 2/2 3/3\n");
  std::string advice;
  for (const auto& warning : read_scene(mesh).warnings) advice += warning;
  const bool green_down = advice.find("green seems to point down") != std::string::npos;
  const std::string wrong = "[camera]\neye = [0, 0, 3]\n[[light]]\ndirection = [0, 0, 1]\n[[object]]\nshape = \"mesh\"\nmesh = \"m.obj\"\n";
  REQUIRE(green_down);
  CHECK(advice.find("a scene file with [[object]], shape = \"mesh\", mesh, normal and green = \"down\" (see scenes/README.md)") !=
        std::string::npos);
  // What it advises mends it.
  CHECK_FALSE(warns_of(read_scene(folder.write("t.toml", wrong + "normal = \"n.png\"\ngreen = \"down\"\n")).warnings, "green"));
  CHECK(warns_of(read_scene(folder.write("u.toml", wrong + "normal = \"n.png\"\n")).warnings, "down; try green = \"down\""));
}
