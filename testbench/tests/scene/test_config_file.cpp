#include "scene_bench.h"
#include "testbench/scene/config_file.h"

using namespace bump;
using namespace bump::test;

namespace {

Configuration sample_configuration() {
  Parameters parameters;
  parameters.integer("texture_fetch.cache.ways", 4, 1, 64, "ways", "lines a set holds");
  parameters.number("clock", 100, 0.001, 1e5, "MHz", "frequency of the one clock");
  parameters.number("scale", 1, 1e-30, 1e30, "", "any");
  parameters.boolean("rasterizer.early_z", true, "hidden fragments are dropped before they are shaded");
  parameters.choice("rasterizer.traversal", "tiled", {"tiled", "scanline"}, "order of the fragments of a triangle");
  return Configuration(parameters);
}

ErrorText error_in(const std::string& text) {
  return error_of([&] {
    Configuration configuration = sample_configuration();
    read_configuration_text(text, "c.toml", configuration);
  });
}

}  // namespace

TEST_CASE("tables and dotted keys are module paths") {
  Configuration configuration = sample_configuration();
  read_configuration_text("clock = 250\nrasterizer.traversal = \"scanline\"\n[texture_fetch.cache]\nways = 8\n", "c.toml", configuration);
  CHECK(configuration.number("clock") == 250);
  CHECK(configuration.choice("rasterizer.traversal") == "scanline");
  CHECK(configuration.integer("texture_fetch.cache.ways") == 8);
  CHECK(to_string(configuration.entries().at("texture_fetch.cache.ways").origin) == "c.toml:4:8");
  CHECK(configuration.entries().at("rasterizer.early_z").origin.file == "default");
}

TEST_CASE("mistakes in a configuration are told with line and column") {
  const ErrorText misspelt = error_in("\n[texture_fetch.cache]\nwyas = 8\n");
  CHECK(to_string(misspelt.where) == "c.toml:3:1");
  CHECK(misspelt.what == "unknown parameter 'texture_fetch.cache.wyas'");
  CHECK(misspelt.try_this == "texture_fetch.cache.ways (4, allowed 1 to 64 ways)");

  const ErrorText module = error_in("[texture_fecth.cache]\nways = 8\n");
  CHECK(module.where.line == 2);
  CHECK(module.try_this == "texture_fetch.cache.ways (4, allowed 1 to 64 ways)");

  const ErrorText range = error_in("texture_fetch.cache.ways = 65");
  CHECK(to_string(range.where) == "c.toml:1:28");
  CHECK(range.why.find("allowed 1 to 64 ways") != std::string::npos);

  CHECK(error_in("clock = nan").why.find("finite") != std::string::npos);
  CHECK(error_in("clock = \"fast\"").why.find("it takes a number") == 0);
  CHECK(error_in("texture_fetch.cache.ways = 4.5").why.find("it takes a whole number") == 0);
  CHECK(error_in("clock = [1, 2]").what == "clock cannot be a list");
  CHECK(error_in("clock = 1979-05-27").what == "clock cannot be a date or time");
  CHECK(error_in("klock = [1, 2]").what == "unknown parameter 'klock'");
  CHECK(error_in("rasterizer = 3").what == "'rasterizer' is a module, not a parameter");
  CHECK(error_in("[clock]\n").what == "'clock' is a parameter, not a module");
  CHECK(error_in("[colour_unit]\n").what == "unknown module 'colour_unit'");
  CHECK(error_in("clock = 1\nclock = 2\n").where.line == 2);
  CHECK(error_in("clock = \n").what == "the file is not valid TOML");
  CHECK(error_in("clock = \"abc").where.line == 1);
}

TEST_CASE("a configuration file must exist but may be empty") {
  const TemporaryFolder folder;
  Configuration configuration = sample_configuration();
  read_configuration(folder.write("empty.toml", ""), configuration);
  CHECK(configuration.number("clock") == 100);
  folder.write("fast.toml", "clock = 200\n");
  const ErrorText missing = error_of([&] { read_configuration(folder.path("fats.toml"), configuration); });
  CHECK(missing.what.find("does not exist") != std::string::npos);
  CHECK(missing.try_this == folder.path("fast.toml"));
  CHECK(error_of([&] { read_configuration(folder.path(""), configuration); }).what.find("is a folder") != std::string::npos);
}

TEST_CASE("later files win over earlier ones, and --set over files") {
  const TemporaryFolder folder;
  Configuration configuration = sample_configuration();
  read_configuration(folder.write("a.toml", "clock = 200\nscale = 2.0\n"), configuration);
  read_configuration(folder.write("b.toml", "clock = 300\n"), configuration);
  CHECK(configuration.number("clock") == 300);
  apply_setting("clock=400", configuration);
  apply_setting(" rasterizer.traversal = scanline", configuration);
  CHECK(configuration.number("clock") == 400);
  CHECK(configuration.number("scale") == 2);
  CHECK(configuration.choice("rasterizer.traversal") == "scanline");
  CHECK(to_string(configuration.entries().at("clock").origin) == "--set");
}

TEST_CASE("a setting without key or value is refused") {
  Configuration configuration = sample_configuration();
  const auto text = GENERATE(as<std::string>(), "clock", "", "=5", "  = 5", "clock=", "clock==5", "klock=5");
  const ErrorText error = error_of([&] { apply_setting(text, configuration); });
  CHECK(error.where.file == "--set");
  CHECK(configuration.number("clock") == 100);
}

TEST_CASE("the resolved configuration reads back as itself and tells each origin") {
  Configuration configuration = sample_configuration();
  read_configuration_text("scale = 1e-7\nrasterizer.early_z = false\n", "c.toml", configuration);
  apply_setting("clock=123", configuration);
  const std::string text = to_toml(configuration);
  CHECK(text.find("clock = 123.0  # --set; default 100, allowed 0.001 to 1e+05 MHz; frequency of the one clock\n") != std::string::npos);
  CHECK(text.find("scale = 1e-07  # c.toml:1:9;") != std::string::npos);
  CHECK(text.find("texture_fetch.cache.ways = 4  # default;") != std::string::npos);

  Configuration again = sample_configuration();
  read_configuration_text(text, "resolved.toml", again);
  for (const auto& [key, entry] : configuration.entries()) CHECK(again.entries().at(key).value == entry.value);
}
