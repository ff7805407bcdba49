#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "system/simulation.h"
#include "testbench/experiments/compare.h"
#include "testbench/experiments/compare_formats.h"
#include "testbench/experiments/compare_metrics.h"

namespace bump {

namespace {

using Json = nlohmann::ordered_json;

/// The parts of a result document that metrics are made of, with numbers that are easy to follow.
Json result_document() {
  const auto unit = [](int first) {
    Json counts;
    int number = first;
    for (const std::string& name : operator_names()) counts[name] = number++;
    return counts;
  };
  Json none = unit(0);
  for (auto& [name, count] : none.items()) count = 0;
  Json json;
  json["cycles"] = 2000;
  json["fragments"] = 1000;
  json["fragments_per_cycle"] = 0.5;
  json["bound"] = {{"cycles", 1500.0}, {"by", "memory: bandwidth"}};
  json["frames_per_second"] = 50000.0;
  json["operators"]["environment"] = {{"built", unit(1)}, {"additional", none}, {"used_per_fragment", unit(1)}, {"executions", 1000}};
  json["operators"]["illumination"] = {{"built", unit(11)}, {"additional", unit(1)}, {"used_per_fragment", unit(12)}, {"executions", 1000}};
  json["operators"]["vertex"] = {
      {"built", unit(1)}, {"additional", none}, {"used_per_fragment", {{"multipliers", 0.5}, {"adders", 0.25}}}, {"executions", 50}};
  json["interpolator_components"] = 7;
  json["tables"] = Json::array({{{"unit", "environment"}, {"bits", 8192}, {"copies", 4}, {"reads", 4000}},
                                {{"unit", "vertex"}, {"bits", 4096}, {"copies", 1}, {"reads", 50}}});
  json["texture"] = {{"reads", 5000}, {"hit_rate", 0.75}, {"bytes", 2048}};
  json["quality"] = {{"against_reference", {{"psnr_db", 25.5}, {"max_error", 12.5}, {"pixels", 900}}},
                     {"against_double", {{"psnr_db", nullptr}, {"max_error", 0.0}, {"pixels", 900}}},
                     {"against_blinn", nullptr},
                     {"double_against_reference", {{"psnr_db", nullptr}, {"max_error", nullptr}, {"pixels", 0}}}};
  json["angular_error"]["hardware"] = Json::array({{{"vector", "H'"}, {"mean_degrees", 9.0}}, {{"vector", "L'"}, {"mean_degrees", 2.5}}});
  return json;
}

struct Sample {
  Scene scene;
  Configuration configuration{all_parameters()};
  std::vector<SchemePage> pages = {{"lee2007", "Polar", "Lee", "reconstruction of | bars", "s", {"environment"}},
                                   {"plain", "Plain, with comma", "P", "as published", "s"}};
  Comparison comparison;

  Sample() {
    scene.name = "wood_plane";
    scene.width = 64;
    scene.height = 32;
    scene.lights.resize(1);
    scene.inputs = {{"wood.toml", std::string(64, 'a')}};
    configuration.set_text("fifos.depth", "3", {"--set"});
    comparison.scene = &scene;
    comparison.configuration = &configuration;
    comparison.engine = "dated";
    for (const SchemePage& page : pages) {
      ComparisonRow row;
      row.page = &page;
      row.result = result_document();
      comparison.rows.push_back(row);
    }
  }
  Sample(const Sample&) = delete;
  void fail(std::size_t row, ErrorKind kind) {
    comparison.rows[row].error = Error(kind, {"deadlock: nothing, \"moves\"", {}, "a | b", "fifos.depth at least 8"});
    comparison.rows[row].result = nullptr;
  }
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Fields of one CSV line without line feeds in it.
std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
      fields.back() += line[i++];
    } else if (line[i] == '"') {
      quoted = !quoted;
    } else if (line[i] == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += line[i];
    }
  }
  return fields;
}

std::size_t cells_of(const std::string& line) {
  std::size_t bars = 0;
  for (std::size_t i = 0; i < line.size(); ++i) bars += line[i] == '|' && (i == 0 || line[i - 1] != '\\');
  return bars - 1;
}

}  // namespace

TEST_CASE("metrics are the figures of the result, in the units of their names") {
  const Json metrics = metrics_of(result_document());
  CHECK(metrics["cycles"] == 2000);
  CHECK(metrics["bound_reached_percent"] == 75.0);
  CHECK(metrics["environment_adders"] == 2);
  CHECK(metrics["illumination_additional_maps"] == 6);
  CHECK(metrics["multipliers_used_per_fragment"] == 13.0);
  CHECK(metrics["table_reads_per_fragment"] == 4.0);  // not those of the vertices
  CHECK(metrics["tables_rom_kilobytes"] == 4.5);
  CHECK(metrics["tables_distinct_kilobytes"] == 1.5);
  CHECK(metrics["vertex_operations_per_vertex"] == 15.0);
  CHECK(metrics["texture_kilobytes"] == 2.0);
  CHECK(metrics["texture_hit_rate_percent"] == 75.0);
  CHECK(metrics["psnr_hardware_to_reference_db"] == 25.5);
  CHECK(metrics["psnr_hardware_to_double_db"] == std::numeric_limits<double>::infinity());
  CHECK(metrics["mean_angle_of_light_degrees"] == 2.5);
}

TEST_CASE("what does not apply is null, never nought") {
  const Json metrics = metrics_of(result_document());
  for (const char* name :
       {"conversion_multipliers", "light_map_address_additional_adders", "frame_maps", "operations_per_frame", "light_map_kilobytes",
        "light_map_hit_rate_percent", "psnr_hardware_to_blinn_db", "psnr_double_to_reference_db"}) {
    INFO(name);
    CHECK(metrics[name].is_null());
  }
  const Json nothing = metrics_of(nullptr);
  CHECK(nothing.size() == metrics.size());
  for (const auto& [name, value] : nothing.items()) {
    INFO(name);
    CHECK(value.is_null());
    CHECK(metrics.contains(name));
  }
}

TEST_CASE("light maps and the work of a frame are counted where a scheme has them") {
  Json result = result_document();
  result["operators"]["frame"] = {{"built", {{"multipliers", 3}, {"adders", 2}}},
                                  {"used_per_fragment", {{"multipliers", 3}, {"adders", 2}, {"tables", 1}}},
                                  {"executions", 100}};
  result["light_maps"] = Json::array({{{"reads", 1000}, {"hits", 800}, {"bytes", 1024}, {"bytes_written", 4096}},
                                      {{"reads", 1000}, {"hits", 400}, {"bytes", 1024}, {"bytes_written", 4096}}});
  const Json metrics = metrics_of(result);
  CHECK(metrics["operations_per_frame"] == 6 * result["fragments"].get<double>());
  CHECK(metrics["light_map_reads_per_fragment"] == 2.0);
  CHECK(metrics["light_map_hit_rate_percent"] == 60.0);
  CHECK(metrics["light_map_kilobytes"] == 2.0);
  CHECK(metrics["light_map_filled_kilobytes"] == 8.0);

  Sample sample;
  sample.comparison.rows[0].result = result;
  const std::string text = comparison_text(sample.comparison);
  CHECK(text.find("light maps") != std::string::npos);
  CHECK(text.find("Operators of further units") != std::string::npos);
}

TEST_CASE("barrel shifters have columns where a scheme has any") {
  Sample sample;
  const std::string with = comparison_text(sample.comparison);
  CHECK(with.find(" shift") != std::string::npos);
  for (ComparisonRow& row : sample.comparison.rows)
    for (auto& [unit, counts] : row.result["operators"].items())
      for (const char* kind : {"built", "additional", "used_per_fragment"}) counts[kind]["shifters"] = 0;
  const std::string without = comparison_text(sample.comparison);
  CHECK(without.find(" shift") == std::string::npos);
  CHECK(comparison_markdown(sample.comparison).find("shift") == std::string::npos);
}

TEST_CASE("the text's columns line up and no line is too long") {
  Sample sample;
  sample.fail(1, ErrorKind::deadlock);
  for (const char* key : {"fifos.setup_to_rasterizer", "fifos.interpolators_to_texture_fetch", "texture_fetch.batch", "clock.megahertz"})
    if (sample.configuration.parameters().find(key) != nullptr) sample.configuration.set_text(key, "7", {"--set"});
  const std::string text = comparison_text(sample.comparison);
  for (const std::string& line : lines_of(text)) {
    INFO(line);
    CHECK(line.size() <= 140);
    CHECK((line.empty() || line.back() != ' '));
  }
  // Numbers of a column end below one another.
  const auto lines = lines_of(text);
  const auto header =
      std::find_if(lines.begin(), lines.end(), [](const std::string& line) { return line.find("frames/s") != std::string::npos; });
  REQUIRE(header != lines.end());
  const std::size_t end = header->find("frames/s") + 8;
  CHECK((header + 1)->substr(0, end).find("50000.0") == end - 7);
  CHECK((header + 2)->substr(0, end).back() == '-');
  CHECK(text.find("fifos.depth = 3 (default ") != std::string::npos);
}

TEST_CASE("a comparison marks reconstructions in every format") {
  const Sample sample;
  CHECK(comparison_text(sample.comparison).find("lee2007 (R)") != std::string::npos);
  CHECK(comparison_text(sample.comparison).find("plain (R)") == std::string::npos);
  CHECK(comparison_markdown(sample.comparison).find("lee2007 (R)") != std::string::npos);
  CHECK(fields_of(lines_of(comparison_csv(sample.comparison))[1])[2] == "true");
  CHECK(fields_of(lines_of(comparison_csv(sample.comparison))[2])[2] == "false");
  const Json json = Json::parse(comparison_json(sample.comparison, "bumpsim 1"));
  CHECK(json["schemes"][0]["reconstruction"] == true);
  CHECK(json["schemes"][1]["reconstruction"] == false);
}

TEST_CASE("every row of a Markdown table has as many cells as its header") {
  Sample sample;
  sample.fail(0, ErrorKind::deadlock);
  std::size_t width = 0, tables = 0;
  for (const std::string& line : lines_of(comparison_markdown(sample.comparison))) {
    if (line.empty() || line.front() != '|') {
      width = 0;
      continue;
    }
    INFO(line);
    tables += width == 0;
    if (width == 0) width = cells_of(line);
    CHECK(cells_of(line) == width);
  }
  CHECK(tables == 6);
}

TEST_CASE("every CSV row has a field for every name, and numbers read back") {
  Sample sample;
  sample.fail(1, ErrorKind::self_check);
  const auto lines = lines_of(comparison_csv(sample.comparison));
  REQUIRE(lines.size() == 3);
  const auto names = fields_of(lines[0]), first = fields_of(lines[1]), second = fields_of(lines[2]);
  REQUIRE(first.size() == names.size());
  REQUIRE(second.size() == names.size());
  const Json metrics = metrics_of(result_document());
  for (std::size_t i = 5; i < names.size(); ++i) {
    INFO(names[i]);
    const Json& value = metrics[names[i]];
    if (value.is_number()) CHECK(std::stod(first[i]) == value.get<double>());
    if (value.is_null()) CHECK(first[i].empty());
    CHECK(second[i].empty());
  }
  CHECK(second[3] == "self_check_failed");
  CHECK(second[4] == "deadlock: nothing, \"moves\"");
}

TEST_CASE("the JSON document holds every result, the configuration's differences and the failures") {
  Sample sample;
  sample.fail(1, ErrorKind::deadlock);
  const Json json = Json::parse(comparison_json(sample.comparison, "bumpsim 1"));
  CHECK(json["schema"] == comparison_schema);
  CHECK(json["schema_version"] == 1);
  CHECK(json["status"] == "deadlock");
  CHECK(json["config_differences"].size() == 1);
  CHECK(json["config_differences"][0]["key"] == "fifos.depth");
  CHECK(json["config_differences"][0]["value"] == 3);
  CHECK(json["inputs"][0]["path"] == "wood.toml");
  CHECK(json["schemes"][0]["status"] == "ok");
  CHECK(json["schemes"][0]["error"].is_null());
  CHECK(json["schemes"][0]["metrics"]["psnr_hardware_to_double_db"].is_null());
  CHECK(json["schemes"][0]["result"]["texture"]["bytes"] == 2048);
  CHECK(json["schemes"][1]["status"] == "deadlock");
  CHECK(json["schemes"][1]["error"]["why"] == "a | b");
  CHECK(json["schemes"][1]["metrics"].is_null());
  CHECK(json["schemes"][1]["result"].is_null());
}

TEST_CASE("the worst failure is the one that says most against the program") {
  Sample sample;
  CHECK(worst_failure(sample.comparison) == nullptr);
  sample.fail(1, ErrorKind::deadlock);
  CHECK(worst_failure(sample.comparison)->page->id == "plain");
  CHECK_FALSE(is_void(sample.comparison));
  sample.fail(0, ErrorKind::input);
  CHECK(worst_failure(sample.comparison)->page->id == "plain");
  sample.fail(0, ErrorKind::internal);
  CHECK(worst_failure(sample.comparison)->page->id == "lee2007");
  CHECK(is_void(sample.comparison));
}

TEST_CASE("schemes are listed by ids, once each, and misspelt ones are named with the nearest") {
  const auto ids = [](const std::string& list) {
    std::string text;
    for (const Scheme* scheme : schemes_of(list)) text += scheme->page().id + " ";
    return text;
  };
  CHECK(ids("peercy1997, lee2007,peercy1997") == "peercy1997 lee2007 ");
  CHECK(schemes_of("all").size() == all_schemes().size());
  CHECK(ids("phong1975,all").rfind("phong1975 blinn1978 ", 0) == 0);
  CHECK(schemes_of("phong1975,all").size() == all_schemes().size());
  for (const char* bad : {"lee2008", "lee2007,lee2008", "lee2007;peercy1997", "", "lee2007,", ",", "ALL"}) {
    INFO(bad);
    CHECK_THROWS_AS(schemes_of(bad), Error);
  }
  CHECK_THROWS_WITH(schemes_of("lee2008"), Catch::Contains("with lee2007"));
}

}  // namespace bump
