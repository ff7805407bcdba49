#include <cmath>

#include "datapath/sha256.h"
#include "scene_bench.h"
#include "testbench/scene/scene_file.h"

using namespace bump;
using namespace bump::test;

namespace {

struct SceneText {
  std::string frame = "";
  std::string camera = "[camera]\neye = [0, 0, 3]\n";
  std::string light = "[[light]]\ndirection = [0, 0, 2]\n";
  std::string object = "[[object]]\nshape = \"plane\"\n";
  std::string all() const { return frame + camera + light + object; }
};

Scene read(const TemporaryFolder& folder, const std::string& text) {
  return read_scene(folder.write("scene.toml", text));
}

ErrorText error_in(const std::string& text) {
  const TemporaryFolder folder;
  ErrorText error = error_of([&] { read(folder, text); });
  CHECK(error.where.file == folder.path("scene.toml"));
  return error;
}

ErrorText object_error(const std::string& keys) {
  SceneText text;
  text.object = "[[object]]\n" + keys + "\n";
  const ErrorText error = error_in(text.all());
  CHECK(error.where.line >= 5);
  return error;
}

ErrorText camera_error(const std::string& keys) {
  SceneText text;
  text.camera = "[camera]\n" + keys + "\n";
  return error_in(text.all());
}

}  // namespace

TEST_CASE("the smallest scene is filled with defaults") {
  const TemporaryFolder folder;
  const Scene scene = read(folder, SceneText{}.all());
  CHECK(scene.name == "scene");
  CHECK(scene.width == 512);
  REQUIRE(scene.lights.size() == 1);
  CHECK(scene.lights[0].directional);
  CHECK(scene.lights[0].vector == glm::dvec3(0, 0, 1));
  REQUIRE(scene.objects.size() == 1);
  const SceneObject& object = scene.objects[0];
  CHECK(object.name == "plane1");
  CHECK(object.mesh->triangles.size() == 512);
  CHECK(object.normals->levels[0].texels == std::vector<double>{0, 0, 1});
  CHECK(object.heights == nullptr);
  CHECK(object.to_world == glm::dmat4(1));
  CHECK(object.material == Material{});
  CHECK(scene.warnings.empty());
}

TEST_CASE("every key of a scene arrives where it belongs") {
  const TemporaryFolder folder;
  folder.write_image("colour.png", 2, 2, 3, std::vector<float>(12, 1.0f));
  folder.write_image("height.png", 4, 4, 1, {0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 0});
  const Scene scene = read(folder, R"(
[frame]
width = 64
height = 48
background = [0.1, 0.2, 0.3]
[camera]
eye = [1.0, 2, 3]
target = [0, 0, 1]
up = [0, 0, 1]
field_of_view = 60
near = 0.5
[[light]]
type = "point"
position = [5, 6, 7]
intensity = 2.5
[[object]]
name = "ball"
shape = "sphere"
radius = 2
tessellation = [8, 4]
scale = 3
rotate = [90, 0, 0]
translate = [1, 2, 3]
colour = "colour.png"
height = "height.png"
bump_scale = 5
wrap = ["repeat", "clamp"]
uv_scale = [2, 1]
material = { ambient = 0.1, diffuse = 0.2, specular = 0.3, shininess = 40 }
[[object]]
shape = "cube"
size = 4
tessellation = 1
colour = [1, 0.5, 0]
)");
  CHECK(scene.width == 64);
  CHECK(scene.height == 48);
  CHECK(scene.background == glm::dvec3(0.1, 0.2, 0.3));
  CHECK(scene.camera.eye == glm::dvec3(1, 2, 3));
  CHECK(scene.camera.target == glm::dvec3(0, 0, 1));
  CHECK(scene.camera.up == glm::dvec3(0, 0, 1));
  CHECK(scene.camera.field_of_view == 60);
  CHECK(scene.camera.near == 0.5);
  CHECK_FALSE(scene.lights[0].directional);
  CHECK(scene.lights[0].vector == glm::dvec3(5, 6, 7));
  CHECK(scene.lights[0].intensity == 2.5);
  REQUIRE(scene.objects.size() == 2);
  const SceneObject& ball = scene.objects[0];
  check_mesh(*ball.mesh);
  CHECK(ball.name == "ball");
  CHECK(glm::length(ball.mesh->vertices.back().position) == Approx(2));
  CHECK(ball.mesh->vertices.back().uv.x == 2);
  // A quarter turn about x takes y to z; then scale and shift.
  CHECK(glm::dvec3(ball.to_world * glm::dvec4(0, 1, 0, 1)) == glm::dvec3(1, 2, 6));
  CHECK(glm::dvec3(ball.to_world * glm::dvec4(0, 0, 1, 1)) == glm::dvec3(1, -1, 3));
  CHECK(ball.heights->levels[0].texels[5] == 5);
  CHECK(ball.heights->wrap_v == WrapMode::clamp);
  CHECK(ball.material == Material{0.1, 0.2, 0.3, 40});
  CHECK(scene.objects[1].colour->levels[0].texels == std::vector<double>{1, 0.5, 0});
  CHECK(scene.objects[1].mesh->triangles.size() == 12);
  REQUIRE(scene.inputs.size() == 3);
  CHECK(scene.inputs[1].path == "colour.png");
  for (const auto& input : scene.inputs) {
    const std::string bytes = read_file(folder.path(input.path));
    CHECK(input.sha256 == sha256_hex(bytes.data(), bytes.size()));
  }
}

TEST_CASE("rotations are about x, then y, then z") {
  const TemporaryFolder folder;
  SceneText text;
  text.object += "rotate = [90, 90, 30]\n";
  const glm::dmat4 placed = read(folder, text.all()).objects[0].to_world;
  const glm::dvec3 moved(placed * glm::dvec4(0, 1, 0, 1));  // y to z by x, z to x by y, x turned by 30 degrees
  CHECK(glm::distance(moved, glm::dvec3(std::sqrt(0.75), 0.5, 0)) < 1e-12);
}

TEST_CASE("unknown and misspelt keys are errors at the key, with the nearest one") {
  const ErrorText camera = camera_error("eye = [0, 0, 3]\nfield_of_veiw = 60");
  CHECK(camera.what == "unknown key 'field_of_veiw' in camera");
  CHECK(camera.where.line == 3);
  CHECK(camera.where.column == 1);
  CHECK(camera.try_this == "field_of_view");
  CHECK(object_error("shape = \"cube\"\ncolor = [1, 1, 1]").try_this == "colour");
  CHECK(object_error("shape = \"cube\"\nmaterial = { shinines = 3 }").try_this == "shininess");
  SceneText text;
  text.frame = "[frmae]\nwidth = 3\n";
  CHECK(error_in(text.all()).try_this == "frame");
  text.frame = "title = \"x\"\n";
  CHECK(error_in(text.all()).why.find("frame, camera, light, object") != std::string::npos);
}

TEST_CASE("values out of range are errors at the value, with the range") {
  SceneText text;
  text.frame = "[frame]\nwidth = 16385\n";
  const ErrorText width = error_in(text.all());
  CHECK(width.what == "frame.width = 16385 is out of range");
  CHECK(width.why == "allowed 1 to 16384");
  CHECK(width.where.line == 2);
  CHECK(width.where.column == 9);
  text.frame = "[frame]\nheight = 0\n";
  CHECK(error_in(text.all()).why == "allowed 1 to 16384");
  text.frame = "[frame]\nwidth = 3.5\n";
  CHECK(error_in(text.all()).why == "it takes a whole number");
  text.frame = "[frame]\nbackground = [0, 0, 2]\n";
  CHECK(error_in(text.all()).why == "allowed 0 to 1");
  CHECK(camera_error("eye = [0, 0, 3]\nfield_of_view = 180").why == "allowed 1 to 170");
  CHECK(camera_error("eye = [0, 0, 3]\nnear = 0").why == "allowed 1e-06 to 1e+06");
  CHECK(object_error("shape = \"sphere\"\nradius = -1").what == "object.radius = -1 is out of range");
  CHECK(object_error("shape = \"sphere\"\ntessellation = [2, 32]").why == "allowed 3 to 1024");
  CHECK(object_error("shape = \"cube\"\nmaterial = { shininess = 0 }").why == "allowed 1 to 1024");
  CHECK(object_error("shape = \"cube\"\nscale = 0").what == "object.scale = 0 is out of range");
  CHECK(object_error("shape = \"cube\"\nuv_scale = [1, 0]").what == "object.uv_scale must not be 0");
  CHECK(object_error("shape = \"torus\"\nradius = 1\ntube = 1").what == "object.tube is not smaller than the radius");
}

TEST_CASE("cameras that are not finite, or look nowhere, are errors") {
  const auto number = GENERATE(as<std::string>(), "nan", "inf", "-inf");
  const ErrorText eye = camera_error("eye = [0, " + number + ", 3]");
  CHECK(eye.what.find("camera.eye is ") == 0);
  CHECK(eye.why == "it must be finite");
  CHECK(eye.where.line == 2);
  CHECK(camera_error("eye = [0, 0, 3]\nfield_of_view = " + number).why == "it must be finite");
  CHECK(camera_error("eye = [0, 0, 1e300]").what.find("out of range") != std::string::npos);
  CHECK(camera_error("eye = [1, 2, 3]\ntarget = [1, 2, 3]").what == "camera.eye is the same point as the target");
  CHECK(camera_error("eye = [0, 5, 0]").what == "camera.up is parallel to the view");
  CHECK(camera_error("eye = [0, 0, 3]\nup = [0, 0, 0]").what == "camera.up has no length");
  CHECK(camera_error("eye = [0, 3]").what == "camera.eye must be a list of three numbers");
  CHECK(camera_error("target = [0, 0, 0]").what == "camera has no 'eye'");
}

TEST_CASE("lights that shine from nowhere are errors") {
  const auto light_error = [](const std::string& keys) {
    SceneText text;
    text.light = "[[light]]\n" + keys + "\n";
    return error_in(text.all());
  };
  CHECK(light_error("direction = [0, 0, 0]").what == "light.direction has no length");
  CHECK(light_error("type = \"point\"\ndirection = [0, 0, 1]").what == "light.direction means nothing for a point light");
  CHECK(light_error("position = [0, 0, 1]").try_this == "type = \"point\"");
  CHECK(light_error("type = \"pont\"\nposition = [0, 0, 1]").try_this == "type = \"point\"");
  CHECK(light_error("direction = [0, 0, 1]\nintensity = -1").why == "allowed 0 to 100");
  SceneText text;
  for (int i = 0; i < 8; ++i) text.light += "[[light]]\ndirection = [0, 0, 1]\n";
  CHECK(error_in(text.all()).what == "the scene has 9 lights");
  text.light = "[light]\ndirection = [0, 0, 1]\n";
  CHECK(error_in(text.all()).try_this == "[[light]]");
}

TEST_CASE("a scene without camera, light or object is refused") {
  SceneText text;
  text.camera = "";
  CHECK(error_in(text.all()).what == "the scene has no camera");
  text = {};
  text.light = "";
  CHECK(error_in(text.all()).what == "the scene has no light");
  text = {};
  text.object = "";
  CHECK(error_in(text.all()).what == "the scene has no object");
  CHECK(error_in("object = []\n" + text.all()).what == "the scene has no object");
}

TEST_CASE("shapes take only their own keys") {
  CHECK(object_error("name = \"x\"").what == "object.shape is missing");
  CHECK(object_error("shape = \"spere\"").try_this == "shape = \"sphere\"");
  CHECK(object_error("shape = \"plane\"\nradius = 2").what == "object.radius means nothing for a plane");
  CHECK(object_error("shape = \"mesh\"").what == "object.mesh is missing");
  CHECK(object_error("shape = \"mesh\"\nmesh = \"a.obj\"\ntessellation = 3").what == "object.tessellation means nothing for a mesh");
  CHECK(object_error("shape = \"cube\"\ntessellation = [3, 3]").what == "object.tessellation cannot be a list");
  CHECK(object_error("shape = \"cube\"\ngreen = \"down\"").what == "object.green means nothing without a normal map");
  CHECK(object_error("shape = \"cube\"\nbump_scale = 2").what == "object.bump_scale means nothing without a height map");
  CHECK(object_error("shape = \"cube\"\nname = \"a\"\n[[object]]\nshape = \"cube\"\nname = \"a\"").what == "object.name 'a' is taken");
  CHECK(object_error("shape = \"cube\"\nmaterial = 3").what == "material is a whole number");
  CHECK(object_error("shape = \"cube\"\ncolour = 3").what == "object.colour cannot be a whole number");
}

TEST_CASE("missing, empty, truncated and wrong textures are errors at the key that names them") {
  const TemporaryFolder folder;
  const std::string picture = read_file(folder.write_image("map.png", 16, 16, 3, std::vector<float>(768, 0.5f)));
  folder.write("empty.png", "");
  folder.write("cut.png", picture.substr(0, picture.size() / 2));
  folder.write("text.png", "hello");
  const auto texture_error = [&](const std::string& line) {
    SceneText text;
    text.object += line + "\n";
    const ErrorText error = error_of([&] { read(folder, text.all()); });
    CHECK(error.where.file == folder.path("scene.toml"));
    CHECK(error.where.line == 7);
    return error;
  };
  const ErrorText missing = texture_error("colour = \"mpa.png\"");
  CHECK(missing.what == "texture '" + folder.path("mpa.png") + "' does not exist");
  CHECK(missing.try_this == folder.path("map.png"));
  CHECK(texture_error("height = \"empty.png\"").what == "texture '" + folder.path("empty.png") + "' is empty");
  CHECK(texture_error("normal = \"cut.png\"").what.find("is truncated or damaged") != std::string::npos);
  CHECK(texture_error("colour = \"text.png\"").what.find("is not an image") != std::string::npos);
  CHECK(texture_error("colour = \".\"").what.find("is a folder") != std::string::npos);
  CHECK(texture_error("colour = \"\"").what == "object.colour is an empty text");
  CHECK(texture_error("normal = \"map.png\"").what.find("is grey and cannot be a normal map") != std::string::npos);
}

TEST_CASE("a normal map beside its height map is checked against it, and shades alone") {
  const TemporaryFolder folder;
  std::vector<float> heights, normals;
  const int side = 32;
  for (int row = 0; row < side; ++row) {  // from the top: y = side - row
    for (int x = 0; x < side; ++x) {
      const double a = 2 * 3.14159265358979 / side, h = 0.5 + 0.25 * (std::sin(a * x) + std::sin(a * row));
      heights.push_back(static_cast<float>(h));
      const glm::dvec3 n = glm::normalize(glm::dvec3(-3 * a * std::cos(a * x), 3 * a * std::cos(a * row), 1));
      for (int i = 0; i < 3; ++i) normals.push_back(static_cast<float>(0.5 + 0.5 * n[i]));
    }
  }
  folder.write_image("h.png", side, side, 1, heights, 16);
  folder.write_image("n.png", side, side, 3, normals, 16);
  SceneText text;
  const std::string object = text.object + "normal = \"n.png\"\nheight = \"h.png\"\n";
  text.object = object;
  const Scene right = read(folder, text.all());
  CHECK(right.warnings.empty());
  CHECK(right.objects[0].heights == nullptr);
  text.object = object + "green = \"down\"\n";
  CHECK(warns_of(read(folder, text.all()).warnings, "contradicts the heights"));
}

TEST_CASE("the advice for a list is a list that is accepted in its place") {
  struct Case {
    std::string key, list, advice;
  };
  SceneText text;
  const auto check = [&](std::string& part, const Case& wrong) {
    const std::string before = part;
    part = before + wrong.key + " = " + wrong.list + "\n";
    CHECK(error_in(text.all()).try_this == wrong.key + " = " + wrong.advice);
    part = before + wrong.key + " = " + wrong.advice + "\n";
    const TemporaryFolder folder;
    CHECK_NOTHROW(read(folder, text.all()));
    part = before;
  };
  text.camera = "[camera]\n";
  check(text.camera, {"eye", "[0, 0, 1e308]", "[0, 0, 1e+09]"});
  check(text.camera, {"eye", "[-inf, 2.5, 1]", "[-1e+09, 2.5, 1]"});
  check(text.camera, {"eye", "[true, nan, 3]", "[0, 0, 3]"});
  text = {};
  text.light = "[[light]]\n";
  check(text.light, {"direction", "[0, 1e10, 1]", "[0, 1e+09, 1]"});
  text = {};
  check(text.object, {"translate", "[\"x\", 1, 2]", "[0, 1, 2]"});
  check(text.object, {"colour", "[0.5, 2, -1]", "[0.5, 1, 0]"});
  check(text.object, {"size", "[0, 3]", "[1e-06, 3]"});
  check(text.object, {"tessellation", "[0, 5000]", "[1, 1024]"});
  check(text.object, {"tessellation", "[4, 2.5]", "[4, 2]"});
  check(text.object, {"tessellation", "5000", "1024"});
}

TEST_CASE("scene files that are missing, empty, damaged or of another kind are refused") {
  const TemporaryFolder folder;
  CHECK(error_of([&] { read_scene(folder.path("none.toml")); }).what.find("does not exist") != std::string::npos);
  CHECK(error_of([&] { read(folder, ""); }).what.find("is empty") != std::string::npos);
  const auto damage = GENERATE(as<std::string>(), "[camera\n", "a = [}1, 2]\n", "a = {]}\n", "a = \"\n", "= 3\n", "\xff\xfe\n");
  CHECK(error_in(damage).what == "the file is not valid TOML");
  CHECK(error_in("[camera]\neye = [0, 0, 3]\neye = [0, 0, 4]\n").where.line == 3);
  CHECK(error_of([&] { read_scene(folder.write("a.png", "x")); }).what.find("is no scene") != std::string::npos);
  CHECK(error_of([&] { read_scene(folder.write("a.gltf", "{}")); }).why == "glTF is not supported yet");
  CHECK(error_of([&] { read_scene(folder.write("a.glb", "glTF")); }).why == "glTF is not supported yet");
}
