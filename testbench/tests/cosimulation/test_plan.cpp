// What is known of emitted units before they are translated.

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "testbench/cosimulation/plan.h"
#include "testbench/cosimulation/unit_library.h"
#include "testbench/program/configure.h"
#include "testbench/results/output_file.h"
#include "testbench/scene/scene_file.h"

using namespace bump;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

Scene world() {
  return read_scene(std::string(BUMP_SOURCE_DIR) + "/scenes/world_sphere.toml");
}

struct Folder {
  Folder() {
    std::string pattern = (fs::temp_directory_path() / "bumpsim-plan-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path = pattern;
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  std::string path;
};

}  // namespace

TEST_CASE("the colour unit's cycles are the tail of the illumination unit, and capacities are the configuration's") {
  for (const char* scheme : {"lee2007", "peercy1997"}) {
    const auto units = plan_units(world(), find_scheme(scheme), configure({}, {"datapath.latency.multiplier=3", "environment.capacity=5"}));
    REQUIRE(units.size() == 2);
    CHECK(units[0].unit == "environment");
    CHECK(units[0].top == std::string(scheme) + "_environment");
    CHECK(units[0].capacity == 5);
    CHECK(units[0].tail == 0);
    CHECK(units[1].unit == "illumination");
    CHECK(units[1].tail == 1 + 3 + 1);  // sum, product, clamp
    CHECK_THAT(units[1].ports, Contains("#define UNIT_RESULTS(DO) \\\n  DO(out_intensity, \"intensity\", "));
  }
}

TEST_CASE("an emitted folder of another material or configuration is refused") {
  Scene scene = world();
  const Scheme& scheme = find_scheme("lee2007");
  const Configuration plain = configure({}, {});
  const Folder folder;
  for (const PlannedUnit& unit : plan_units(scene, scheme, plain))
    for (const auto& [path, text] : unit.files) write_output_file(folder.path + "/" + path, text, true);
  CHECK_NOTHROW(check_emitted(plan_units(scene, scheme, plain), folder.path));
  CHECK_THROWS_WITH(check_emitted(plan_units(scene, scheme, configure({}, {"environment.multipliers=2"})), folder.path),
                    Contains("other Verilog") && Contains("lee2007_environment"));
  CHECK_THROWS_WITH(check_emitted(plan_units(scene, scheme, plain), folder.path + "/nothing"), Contains("not there"));
  scene.objects.front().material.shininess += 3;
  CHECK_THROWS_WITH(check_emitted(plan_units(scene, scheme, plain), folder.path),
                    Contains("rom/lee2007_SPEC.hex") && Contains("it differs"));
}

TEST_CASE("translated units that are not there are missed by name") {
  const Folder folder;
  CHECK_THROWS_WITH(units_in(folder.path), Contains("no translated unit"));
  std::ofstream(folder.path + "/illumination.so") << "no library";
  CHECK(units_in(folder.path) == std::vector<std::string>{"illumination"});
  CHECK_THROWS_WITH(load_unit(folder.path, "illumination"), Contains("cannot load the translated illumination unit"));
}
