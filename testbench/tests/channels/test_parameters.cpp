#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "channels/parameters.h"

using namespace bump;

namespace {

Parameters sample_parameters() {
  Parameters parameters;
  parameters.integer("texture_fetch.cache.ways", 4, 1, 64, "ways", "lines a set holds");
  parameters.integer("texture_fetch.cache.sets", 32, 1, 65536, "sets", "sets of the cache");
  parameters.number("clock", 100, 0.001, 1e5, "MHz", "frequency of the one clock");
  parameters.boolean("early_z", true, "hidden fragments are dropped before they are shaded");
  parameters.choice("rasterizer.traversal", "tiled", {"tiled", "scanline", "serpentine"}, "order of the fragments of a triangle");
  return parameters;
}

ErrorText error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::input);
    return error.text();
  }
  FAIL("no error was thrown");
  return {};
}

const Location here{"fast.toml", 3, 7};

}  // namespace

TEST_CASE("a configuration starts from the declared defaults") {
  const Configuration configuration(sample_parameters());
  CHECK(configuration.integer("texture_fetch.cache.ways") == 4);
  CHECK(configuration.number("clock") == 100);
  CHECK(configuration.boolean("early_z"));
  CHECK(configuration.choice("rasterizer.traversal") == "tiled");
  for (const auto& [key, entry] : configuration.entries()) CHECK(entry.origin.file == "default");
}

TEST_CASE("later settings win and remember where they came from") {
  Configuration configuration(sample_parameters());
  configuration.set("texture_fetch.cache.ways", std::int64_t{8}, here);
  configuration.set_text("texture_fetch.cache.ways", " 16 ", {"--set", 0, 0});
  CHECK(configuration.integer("texture_fetch.cache.ways") == 16);
  CHECK(configuration.entries().at("texture_fetch.cache.ways").origin.file == "--set");
  configuration.set("clock", std::int64_t{250}, here);
  CHECK(configuration.number("clock") == 250.0);
  CHECK(to_string(configuration.entries().at("clock").origin) == "fast.toml:3:7");
}

TEST_CASE("a text is read as the parameter's type") {
  Configuration configuration(sample_parameters());
  configuration.set_text("clock", "2.5e2", here);
  configuration.set_text("early_z", "false", here);
  configuration.set_text("rasterizer.traversal", "\"scanline\"", here);
  CHECK(configuration.number("clock") == 250.0);
  CHECK_FALSE(configuration.boolean("early_z"));
  CHECK(configuration.choice("rasterizer.traversal") == "scanline");
}

TEST_CASE("a misspelt key is answered with the nearest one") {
  Configuration configuration(sample_parameters());
  const auto typed = GENERATE(as<std::string>(), "texture_fetch.cache.way", "texture_fetch.cahce.ways", "Texture_Fetch.cache.ways",
                              "cache.ways", "ways", "texture.cache.ways");
  const ErrorText text = error_of([&] { configuration.set_text(typed, "8", here); });
  CHECK(text.what == "unknown parameter '" + typed + "'");
  CHECK(text.where.line == 3);
  CHECK(text.where.column == 7);
  CHECK(text.try_this == "texture_fetch.cache.ways (4, allowed 1 to 64 ways)");
}

TEST_CASE("a key like no other has no nearest one") {
  Configuration configuration(sample_parameters());
  CHECK(error_of([&] { configuration.set_text("zzzzzzzzz", "8", here); }).try_this == "bumpsim describe lists every parameter");
  CHECK(error_of([&] { configuration.set_text("texture_fetch.cache", "8", here); }).what ==
        "'texture_fetch.cache' is a module, not a parameter");
}

TEST_CASE("a value out of range is answered with the range") {
  Configuration configuration(sample_parameters());
  const auto given = GENERATE(as<std::string>(), "0", "65", "-1", "9223372036854775807", "99999999999999999999");
  const ErrorText text = error_of([&] { configuration.set_text("texture_fetch.cache.ways", given, here); });
  CHECK(text.why == "it is out of range; allowed 1 to 64 ways (lines a set holds)");
  CHECK(configuration.integer("texture_fetch.cache.ways") == 4);
}

TEST_CASE("a value of another type is refused") {
  Configuration configuration(sample_parameters());
  const auto refuses = [&](const std::string& key, const ParameterValue& value, const std::string& why) {
    CHECK(error_of([&] { configuration.set(key, value, here); }).why.find(why) == 0);
  };
  refuses("texture_fetch.cache.ways", 4.0, "it takes a whole number");
  refuses("texture_fetch.cache.ways", true, "it takes a whole number");
  refuses("clock", std::string("fast"), "it takes a number");
  refuses("early_z", std::int64_t{1}, "it takes true or false");
  refuses("rasterizer.traversal", std::int64_t{1}, "it takes a word");
  const auto refuses_text = [&](const std::string& key, const std::string& value, const std::string& why) {
    CHECK(error_of([&] { configuration.set_text(key, value, here); }).why.find(why) == 0);
  };
  refuses_text("texture_fetch.cache.ways", "4.5", "it takes a whole number");
  refuses_text("texture_fetch.cache.ways", "", "it takes a whole number");
  refuses_text("texture_fetch.cache.ways", "+-4", "it takes a whole number");
  refuses_text("clock", "1,5", "it takes a number");
  refuses_text("clock", "1e999", "it is out of range");
  refuses_text("early_z", "yes", "it takes true or false");
}

TEST_CASE("numbers that are not finite are refused") {
  Configuration configuration(sample_parameters());
  const auto text = GENERATE(as<std::string>(), "nan", "inf", "-inf", "NaN");
  CHECK(error_of([&] { configuration.set_text("clock", text, here); }).why.find("it takes a finite number") == 0);
  const double value = std::numeric_limits<double>::quiet_NaN();
  CHECK(error_of([&] { configuration.set("clock", value, here); }).why.find("it takes a finite number") == 0);
}

TEST_CASE("an unknown word is answered with the words that are allowed") {
  Configuration configuration(sample_parameters());
  const ErrorText text = error_of([&] { configuration.set_text("rasterizer.traversal", "tilde", here); });
  CHECK(text.why.find("allowed tiled, scanline, serpentine") != std::string::npos);
  CHECK(text.try_this == "rasterizer.traversal = 'tiled'");
}

TEST_CASE("what nobody declared cannot be read, and nothing is declared twice") {
  Configuration configuration(sample_parameters());
  CHECK_THROWS_AS(configuration.integer("no.such.key"), Error);
  CHECK_THROWS_AS(configuration.integer("clock"), Error);
  Parameters parameters = sample_parameters();
  CHECK_THROWS_AS(parameters.boolean("clock", true, "again"), Error);
  CHECK_THROWS_AS(parameters.integer("depth", 9, 1, 8, "", "default out of its own range"), Error);
  CHECK_THROWS_AS(parameters.choice("word", "c", {"a", "b"}, "default not among the words"), Error);
}

TEST_CASE("allowed values are told with the default first") {
  const Parameters parameters = sample_parameters();
  CHECK(allowed(*parameters.find("texture_fetch.cache.ways")) == "4, allowed 1 to 64 ways");
  CHECK(allowed(*parameters.find("early_z")) == "true, allowed true or false");
  CHECK(allowed(*parameters.find("rasterizer.traversal")) == "tiled, allowed tiled, scanline, serpentine");
}

TEST_CASE("every number reads back from its text as the same number") {
  Parameters parameters;
  parameters.number("x", 0, -1e300, 1e300, "", "any");
  Configuration configuration(parameters);
  double value = 1.0 / 3;
  for (int i = 0; i < 200; ++i) {
    value = std::fmod(value * 1.7320508 + 0.1, 3.0) * (i % 2 == 0 ? 1e7 : 1e-7) * (i % 3 == 0 ? -1 : 1);
    configuration.set_text("x", to_string(ParameterValue(value)), here);
    CHECK(configuration.number("x") == value);
  }
}

TEST_CASE("the nearest word bears one slip in short words and three in long ones") {
  const std::vector<std::string> words = {"eye", "target", "field_of_view"};
  CHECK(nearest_word("eey", words) == "eye");
  CHECK(nearest_word("Target", words) == "target");
  CHECK(nearest_word("feild_of_veiw", words) == "field_of_view");
  CHECK(nearest_word("x", words).empty());
  CHECK(nearest_word("", words).empty());
  CHECK(nearest_word("background", words).empty());
  CHECK(nearest_word("anything", {}).empty());
}
