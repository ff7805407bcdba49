// Maps that belong to one surface, as a user meets them: quality against the reference that each is to reach, and refusals.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program_runner.h"

using namespace bump;
using Json = nlohmann::json;

namespace {

std::string scene_of(const std::string& shape, const std::string& more = "") {
  const std::string world = std::string(BUMP_SOURCE_DIR) + "/scenes/world/";
  return "[frame]\nwidth = 128\nheight = 128\n[camera]\neye = [0.6, -1.2, 1.1]\nfield_of_view = 55.0\nup = [0.0, 0.0, 1.0]\n"
         "[[light]]\ntype = \"point\"\nposition = [2.0, -2.0, 3.0]\n"
         "[[object]]\nname = \"thing\"\nshape = \"" +
         shape + "\"\n" + more + "height = \"" + world + "earth_height_512x256.png\"\nbump_scale = 8.0\n";
}

const std::string sphere = "radius = 0.7\ntessellation = [64, 32]\n";
const std::string torus = "radius = 0.5\ntube = 0.25\ntessellation = [64, 32]\nuv_scale = [2.0, 1.0]\n";
const std::string plane = "size = [2.0, 1.0]\nrotate = [20.0, 10.0, 30.0]\n";

/// PSNR of a run with these settings against the map's own reference and against Blinn's.
struct Decibels {
  double reference, blinn;
};
Decibels measure(const std::string& scene, const std::string& settings) {
  const TemporaryFolder folder;
  folder.write("scene.toml", scene);
  const Outcome run = bumpsim("run scene.toml --scheme peercy1997 --set numeric=double " + settings + " --out result", folder.path());
  INFO(run.err);
  REQUIRE(run.code == 0);
  const Json quality = Json::parse(read_file(folder.path() / "result" / "result.json"))["quality"];
  return {quality["against_reference"]["psnr_db"], quality["against_blinn"]["psnr_db"]};
}

}  // namespace

TEST_CASE("maps in object space give the picture of the scene's map") {
  for (const std::string& scene : {scene_of("sphere", sphere), scene_of("torus", torus), scene_of("plane", plane)}) {
    CAPTURE(scene);
    const Decibels in_object = measure(scene, "--set peercy1997.map=object_space");
    CHECK(in_object.reference > 55);
  }
}

TEST_CASE("maps from the derivatives of a surface come nearer to Blinn than the square patch") {
  for (const std::string& scene : {scene_of("sphere", sphere), scene_of("torus", torus)})
    for (const std::string map : {"tangent", "object_space"}) {
      CAPTURE(scene, map);
      const Decibels square = measure(scene, "--set peercy1997.map=" + map);
      const Decibels surface = measure(scene, "--set peercy1997.map=" + map + " --set peercy1997.perturbation=surface");
      CHECK(surface.blinn > square.blinn + 4);
      CHECK(surface.reference < square.reference);
    }
}

TEST_CASE("surfaces that use a texel twice are refused a map of their own, with advice") {
  const TemporaryFolder folder;
  folder.write("cube.toml", scene_of("cube"));
  const Outcome in_object = bumpsim("run cube.toml --scheme peercy1997 --set peercy1997.map=object_space --out result", folder.path());
  CHECK(in_object.code == 2);
  CHECK_THAT(in_object.err, Catch::Contains("'thing'") && Catch::Contains("two places") && Catch::Contains("try: ") &&
                                Catch::Contains("peercy1997.map=tangent"));
  CHECK(!std::filesystem::exists(folder.path() / "result"));
  // In tangent space all six faces need the same normals.
  CHECK(bumpsim("run cube.toml --scheme peercy1997 --set peercy1997.perturbation=surface --out result", folder.path()).code == 0);
  folder.write("repeats.toml", scene_of("sphere", "uv_scale = [30.0, 30.0]\n"));
  const Outcome large = bumpsim("run repeats.toml --scheme peercy1997 --set peercy1997.map=object_space --out large", folder.path());
  CHECK(large.code == 2);
  CHECK_THAT(large.err, Catch::Contains("repeats 30 x 30 times"));
}
