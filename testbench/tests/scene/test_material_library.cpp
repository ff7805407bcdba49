#include "scene_bench.h"
#include "testbench/scene/material_library.h"

using namespace bump;
using namespace bump::test;

namespace {

const FileName library("/far/m.mtl", "m.mtl");

LibraryMaterial material(const std::string& statements, std::vector<std::string>& warnings) {
  const auto all = parse_material_library("# made by hand\nnewmtl a b\n" + statements + "\n", library, warnings);
  REQUIRE(all.count("a b") == 1);
  return all.at("a b");
}

}  // namespace

TEST_CASE("a diffuse colour that is not three finite numbers is an error in its line") {
  struct Case {
    std::string colour, what;
  };
  const auto wrong = GENERATE(values<Case>({{"nan 1 1", "'nan' is not a finite number"},
                                            {"1 -inf 1", "'-inf' is not a finite number"},
                                            {"1 1 1e999", "'1e999' is not a finite number"},
                                            {"x 1 1", "'x' is not a number"},
                                            {"1 0.5.2 1", "'0.5.2' is not a number"},
                                            {"1 1 +-1", "'+-1' is not a number"},
                                            {"0.5", "Kd has 1 number"},
                                            {"0.5 0.5 # two", "Kd has 2 numbers"},
                                            {"", "Kd has 0 numbers"}}));
  const auto end = GENERATE(as<std::string>(), "\n", "\r\n", "\r");
  const std::string text = "newmtl a" + end + end + "  Kd\t" + wrong.colour + end + "Kd 1 1 1" + end;
  const ErrorText error = error_of([&] {
    std::vector<std::string> warnings;
    parse_material_library(text, library, warnings);
  });
  CHECK(error.what == wrong.what);
  CHECK(to_string(error.where) == "/far/m.mtl:3");
  CHECK(error.try_this == "Kd 0.8 0.8 0.8");
}

TEST_CASE("colours of any sound notation are taken, those outside the range clamped with a warning") {
  std::vector<std::string> warnings;
  CHECK(material("Kd .5 +0.25 1e0", warnings).colour == glm::dvec3(0.5, 0.25, 1));
  CHECK(material("Kd 1 1e-999 0.5 # half", warnings).colour == glm::dvec3(1, 0, 0.5));
  CHECK(warnings.empty());
  CHECK(material("Kd 1e300 -1 0.5", warnings).colour == glm::dvec3(1, 0, 0.5));
  CHECK(warnings == std::vector<std::string>{"m.mtl:3: Kd is clamped to [0, 1]"});
}

TEST_CASE("statements without effect and unknown keys are named once for a library, whatever their values") {
  std::vector<std::string> warnings;
  material("Ns 1e9\nKs -1 nan x\nNs 3\nKd 1 1 1\nmap_weird file.png\nillum\nweird", warnings);
  CHECK(warnings ==
        std::vector<std::string>{"'m.mtl': statements without effect: Ks, Ns, illum", "'m.mtl': unknown keys ignored: map_weird, weird"});
}

TEST_CASE("texture options without support are named, those that change nothing are not, and the file is found behind all") {
  struct Case {
    std::string given, warning;
  };
  const auto option = GENERATE(values<Case>({{"", ""},
                                             {"-s 1 1 1", ""},
                                             {"-s 1.0", ""},
                                             {"-o 0 0", ""},
                                             {"-mm 0 1", ""},
                                             {"-clamp off -blendu on", ""},
                                             {"-s 2", "-s 2"},
                                             {"-s 2 2 1", "-s 2 2 1"},
                                             {"-o 0.5 0", "-o 0.5 0"},
                                             {"-t 0 0 nan", "-t 0 0 nan"},
                                             {"-mm 0 2", "-mm 0 2"},
                                             {"-clamp on", "-clamp on"},
                                             {"-cc on", "-cc on"},
                                             {"-imfchan r", "-imfchan r"},
                                             {"-type sphere", "-type sphere"}}));
  const auto key = GENERATE(as<std::string>(), "map_Kd", "map_Bump", "map_bump", "bump", "norm");
  std::vector<std::string> warnings;
  const LibraryMaterial read = material(key + " " + option.given + " my file 2.png", warnings);
  CHECK((key == "map_Kd" ? read.colour_map : key == "norm" ? read.normal_map : read.bump_map) == "my file 2.png");
  if (option.warning.empty()) {
    CHECK(warnings.empty());
  } else {
    CHECK(warnings == std::vector<std::string>{"m.mtl:3: option " + option.warning + " of " + key + " is not supported and ignored"});
  }
}

TEST_CASE("a multiplier counts for height maps only and must be a number from -1000 to 1000") {
  std::vector<std::string> warnings;
  CHECK(material("bump -s 1 1 1 -bm -2.5 -o 0 0 0 h.png", warnings).bump_multiplier == -2.5);
  CHECK(warnings.empty());
  CHECK(material("norm -bm 2 n.png", warnings).bump_multiplier == 1);
  CHECK(warns_of(warnings, "option -bm 2 of norm is not supported"));
  const auto wrong = GENERATE(as<std::string>(), "nan", "x", "1e9", "-inf", "1e999");
  warnings.clear();
  const LibraryMaterial read = material("map_Bump -bm " + wrong + " h.png", warnings);
  CHECK(read.bump_multiplier == 1);
  CHECK(read.bump_map == "h.png");
  CHECK(warnings == std::vector<std::string>{"m.mtl:3: map_Bump has an unusable -bm, which takes a number from -1000 to 1000; 1 is used"});
}

TEST_CASE("a map without a file is named and left out") {
  std::vector<std::string> warnings;
  CHECK(material("map_Kd -s 1 1 1", warnings).colour_map == "1");  // the last word can only be the file
  CHECK(material("norm", warnings).normal_map.empty());
  CHECK(warnings == std::vector<std::string>{"m.mtl:3: norm names no file; it is ignored"});
}
