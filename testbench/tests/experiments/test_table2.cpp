// Table 2 as a whole, on small frames of the shipped scenes.

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "system/simulation.h"
#include "testbench/experiments/table2.h"
#include "testbench/experiments/table2_formats.h"
#include "testbench/experiments/table2_pictures.h"
#include "testbench/scene/scene_file.h"

namespace bump {
namespace {

using Json = nlohmann::ordered_json;

/// The coarse levels of a texture: frames are small, and every simulation encodes the map anew.
std::shared_ptr<const Texture> coarse(const std::shared_ptr<const Texture>& texture) {
  if (!texture) return nullptr;
  Texture small = *texture;
  while (small.levels.size() > 1 && small.levels.front().width > 64) small.levels.erase(small.levels.begin());
  return std::make_shared<Texture>(std::move(small));
}

std::vector<Scene> small_scenes() {
  std::vector<Scene> scenes;
  for (const Table2Scene& scene : table2_scenes) {
    scenes.push_back(read_scene(std::string(BUMP_SOURCE_DIR) + "/scenes/" + std::string(scene.shipped) + ".toml"));
    scenes.back().width = 48;
    scenes.back().height = 40;
    for (SceneObject& object : scenes.back().objects)
      for (auto* texture : {&object.colour, &object.normals, &object.heights}) *texture = coarse(*texture);
  }
  return scenes;
}

Configuration defaults() {
  return Configuration(all_parameters());
}

/// The table without any setting, drawn once for all tests.
const Table2& default_table() {
  static const Table2 table = measure_table2(small_scenes(), defaults(), {});
  return table;
}

Json find(const Json& document, const std::string& scene, const std::string& space, const std::string& test, const std::string& reference) {
  for (const Json& c : document["comparisons"])
    if (c["scene"] == scene && c["space"] == space && c["test"] == test && c["reference"] == reference) return c;
  return nullptr;
}

TEST_CASE("every published value of Table 2 stands beside a measured one, in both spaces") {
  const Configuration configuration = defaults();
  const Table2& table = default_table();
  const Json document = Json::parse(table2_text(table, configuration, "json"));
  CHECK(document["schema"] == "bumpsim-table2");
  CHECK(document["schema_version"] == table2_json_version);
  for (const published::Table2Row& row : published::table2) {
    for (const char* space : {"object", "eye"}) {
      const Json c = find(document, std::string(row.scene), space, "proposed", std::string(row.reference));
      INFO(row.scene << " " << row.reference << " " << space);
      REQUIRE(c.is_object());
      for (const Table2Measure& measure : table2_measures()) {
        const char* const channels[3] = {"red", "green", "blue"};
        for (std::size_t i = 0; i < 3; ++i) {
          const Json& cell = c["whole_frame_8_bit"][measure.name][channels[i]];
          REQUIRE(cell["published"] == (row.*measure.published)[i]);
          REQUIRE(cell["measured"] > 0.0);
          REQUIRE(cell["ratio"].get<double>() == Approx(cell["measured"].get<double>() / cell["published"].get<double>()));
        }
      }
    }
  }
  CHECK(find(document, "plane", "eye", "kim", "conventional")["published_row"].is_null());
  CHECK(find(document, "cube", "eye", "proposed", "blinn").is_null());  // its map came as normals
  CHECK(find(document, "sphere", "eye", "proposed", "blinn").is_object());
}

TEST_CASE("measures are those of the pictures, and Kim's pictures are nearer to the conventional ones than the proposed") {
  const Table2& table = default_table();
  for (const Table2Comparison& c : table.comparisons) {
    INFO(c.scene << " " << c.test << " " << c.reference);
    const Table2Picture* test = table.picture(c.scene, c.test, c.space);
    const Table2Picture* reference = table.picture(c.scene, c.reference, c.reference == "kim" ? c.space : std::nullopt);
    REQUIRE((test != nullptr && reference != nullptr));
    double squared = 0, energy = 0;
    for (std::size_t i = 1; i < test->frame.colour.size(); i += 3) {
      const double y = std::floor(255 * test->frame.colour[i] + 0.5), x = std::floor(255 * reference->frame.colour[i] + 0.5);
      squared += (x - y) * (x - y);
      energy += x * x;
    }
    CHECK(c.whole.nmse[1] == Approx(squared / energy));
    CHECK(c.whole.pmse[1] == Approx(squared / (255.0 * 255 * 48 * 40)));
    CHECK(c.objects.pixels > 300);
    CHECK(c.objects.psnr_db == compare_frames(test->frame, reference->frame).psnr_db);
  }
  for (const Table2Scene& scene : table2_scenes) {
    for (const ShadingSpace space : shading_spaces) {
      const std::string name(scene.name);
      CHECK(table.comparison(name, "kim", "conventional", space)->objects.psnr_db >
            table.comparison(name, "proposed", "conventional", space)->objects.psnr_db + 2);
      CHECK(table.picture(name, "proposed", space)->light->mean_degrees > 2);
      CHECK(table.picture(name, "kim", space)->light->mean_degrees < 1);
    }
  }
}

TEST_CASE("the result does not depend on the number of jobs, and its formats agree") {
  const Configuration configuration = defaults();
  Table2Options one, three;
  one.jobs = 1;
  one.angles = three.angles = true;
  three.jobs = 3;
  double share = 0;
  bool grows = true;
  three.progress = [&](double now) {
    grows = grows && now >= share && now <= 1;
    share = now;
  };
  const Table2 a = measure_table2(small_scenes(), configuration, one), b = measure_table2(small_scenes(), configuration, three);
  CHECK(grows);
  CHECK(share == Approx(1).margin(0.02));
  for (const char* format : {"text", "md", "csv", "json"})
    CHECK(table2_text(a, configuration, format) == table2_text(b, configuration, format));

  // Every measured number of the CSV is in the JSON document, in order.
  const Json document = Json::parse(table2_text(a, configuration, "json"));
  std::istringstream lines(table2_text(a, configuration, "csv"));
  std::string line;
  std::getline(lines, line);
  std::size_t cells = 0;
  for (const Json& c : document["comparisons"]) {
    for (const auto& [measure, channels] : c["whole_frame_8_bit"].items()) {
      for (const auto& [channel, cell] : channels.items()) {
        do REQUIRE(std::getline(lines, line));
        while (line.rfind("whole_frame_8_bit", 0) != 0);
        std::vector<std::string> fields;
        std::istringstream stream(line + ",");
        for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
        REQUIRE(fields.size() == 14);
        REQUIRE(fields[1] == c["scene"]);
        REQUIRE(fields[8] == measure);
        REQUIRE(fields[9] == channel);
        REQUIRE(std::stod(fields[12]) == cell["measured"].get<double>());
        REQUIRE((fields[11].empty() ? cell["published"].is_null() : std::stod(fields[11]) == cell["published"].get<double>()));
        ++cells;
      }
    }
  }
  CHECK(cells == 12 * a.comparisons.size());

  CHECK(a.angles.size() == 6 * table2_angles.size());
  CHECK(a.azimuths.size() == 6 * table2_azimuths.size());
  for (const Table2Angle& point : a.azimuths)
    if (point.light.azimuth == 0) CHECK(point.nmse == a.comparison(point.scene, "proposed", "conventional", point.space)->whole.nmse);
  for (const char* format : {"text", "md"})
    CHECK(table2_text(a, configuration, format).find("Dependence on the light") != std::string::npos);
}

TEST_CASE("the light stands at the stated angle, as far away as the eye, to the right of the viewer") {
  for (const Scene& shipped : small_scenes()) {
    for (const double degrees : {0.0, 11.0, 65.0}) {
      for (const double azimuth : {0.0, 90.0, 200.0}) {
        const Scene scene = arrange_table2_scene(shipped, {degrees, azimuth});
        REQUIRE(scene.lights.size() == 1);
        REQUIRE(!scene.lights[0].directional);
        const glm::dvec3 centre{scene.objects[0].to_world[3]};
        const glm::dvec3 light = scene.lights[0].vector - centre, eye = scene.camera.eye - centre;
        CHECK(glm::length(light) == Approx(glm::length(eye)));
        CHECK(glm::dot(light, eye) == Approx(glm::dot(eye, eye) * std::cos(glm::radians(degrees))));
        const glm::dvec3 right = glm::normalize(glm::cross(eye, glm::cross(scene.camera.up, eye)));  // up, across the line of sight
        CHECK(glm::dot(light, right) ==
              Approx(glm::length(eye) * std::sin(glm::radians(degrees)) * std::sin(glm::radians(azimuth))).margin(0.02 * glm::length(eye)));
        CHECK(scene.objects[0].material == table2_material);
        CHECK(shipped.lights[0].directional);
      }
    }
  }
}

TEST_CASE("settings hold for every picture, but the space is the table's own") {
  Configuration configuration = defaults();
  configuration.set_text("numeric", "double", Location("--set"));
  configuration.set_text("lee2007.x_prime", "exact", Location("--set"));
  configuration.set_text("lee2007.eq16", "exact", Location("--set"));
  const Table2 table = measure_table2(small_scenes(), configuration, {});
  for (const Table2Picture& picture : table.pictures)
    if (picture.light) CHECK(picture.light->mean_degrees < 1);  // both corrections make the rotation exact
  CHECK(table2_text(table, configuration, "text").find("Settings: lee2007.eq16=exact, lee2007.x_prime=exact, numeric=double.") !=
        std::string::npos);

  configuration.set_text("vertex_processor.space", "eye", Location("--set"));
  CHECK_THROWS_AS(measure_table2(small_scenes(), configuration, {}), Error);
}

TEST_CASE("each scheme is drawn with each filter of the bump map, and with vectors Kim's pictures are the conventional ones") {
  const Table2& table = default_table();
  REQUIRE(table.filtered.size() == 3 * 2 * 2 * 3);
  for (const Table2Scene& scene : table2_scenes) {
    const std::string name(scene.name);
    for (const ShadingSpace space : shading_spaces) {
      INFO(name << " " << name_of(space));
      for (const char* method : {"proposed", "kim"}) {
        const Table2Comparison* own = table.comparison(name, method, "conventional", space);
        const Table2Filtered* nearest = table.filtered_picture(name, method, space, "nearest");
        REQUIRE(nearest != nullptr);
        CHECK(nearest->nmse == own->whole.nmse);
        CHECK(nearest->psnr_db == own->objects.psnr_db);
      }
      const Table2Filtered* vectors = table.filtered_picture(name, "kim", space, "vector");
      CHECK(vectors->psnr_db > 45);
      CHECK(vectors->psnr_db > table.filtered_picture(name, "kim", space, "nearest")->psnr_db + 10);
      CHECK(vectors->psnr_db > table.filtered_picture(name, "kim", space, "linear")->psnr_db + 10);
      // The method's own error is still there.
      CHECK(table.filtered_picture(name, "proposed", space, "vector")->psnr_db < vectors->psnr_db - 10);
    }
  }
}

TEST_CASE("all formats hold the filters, and name those of the table") {
  const Table2& table = default_table();
  const Json document = Json::parse(table2_text(table, defaults(), "json"));
  CHECK(document["assumptions"]["bump_map_filter"]["lee2007.map_filter"] == "nearest");
  CHECK(document["assumptions"]["bump_map_filter"]["texture_fetch.filter"] == "bilinear");
  REQUIRE(document["bump_map_filters"].size() == table.filtered.size());
  std::istringstream lines(table2_text(table, defaults(), "csv"));
  std::string line;
  std::size_t cells = 0;
  for (const Json& row : document["bump_map_filters"]) {
    CHECK(row["table"] == (row["bump_filter"] == "nearest"));
    CHECK(row["mean_nmse"]["published"].is_null() == (row["test"] == "kim"));
    for (std::size_t i = 0; i < 4; ++i) {
      do REQUIRE(std::getline(lines, line));
      while (line.rfind("bump_map_filters", 0) != 0);
      const Json& value = i == 3 ? row["psnr_db"] : row["nmse"][i == 0 ? "red" : i == 1 ? "green" : "blue"];
      std::vector<std::string> fields;
      std::istringstream stream(line + ",");
      for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
      REQUIRE(fields.size() == 14);
      REQUIRE((fields[1] == row["scene"] && fields[2] == row["space"] && fields[3] == row["test"] && fields[5] == row["bump_filter"]));
      REQUIRE(std::stod(fields[12]) == value.get<double>());
      ++cells;
    }
  }
  CHECK(cells == 4 * table.filtered.size());
  for (const char* format : {"text", "md"}) {
    const std::string text = table2_text(table, defaults(), format);
    for (const char* part : {"Dependence on the filter of the bump map", "bump map nearest texel", "Filter of the bump map:"})
      CHECK(text.find(part) != std::string::npos);
    CHECK(text.find("same N'") == std::string::npos);
  }
}

TEST_CASE("a filter that the user sets is the table's own, and the section still has all three") {
  Configuration configuration = defaults();
  configuration.set_text("lee2007.map_filter", "vector", Location("--set"));
  const Table2 table = measure_table2(small_scenes(), configuration, {});
  REQUIRE(table.filtered.size() == default_table().filtered.size());
  for (std::size_t i = 0; i < table.filtered.size(); ++i) {  // drawn with and without dates, by the two tables
    CHECK(table.filtered[i].nmse == default_table().filtered[i].nmse);
    CHECK(table.filtered[i].psnr_db == default_table().filtered[i].psnr_db);
  }
  for (const Table2Scene& scene : table2_scenes)
    CHECK(table.comparison(std::string(scene.name), "proposed", "conventional", ShadingSpace::eye)->whole.nmse ==
          table.filtered_picture(std::string(scene.name), "proposed", ShadingSpace::eye, "vector")->nmse);
  CHECK(filter_assumption(table).find("Map of the proposed method: filtered as vectors; of Kim's: nearest texel.") != std::string::npos);
  CHECK(table2_text(table, configuration, "text").find("Settings: lee2007.map_filter=vector.") != std::string::npos);
}

TEST_CASE("a filter that does not go with the settings leaves its rows empty and says why") {
  Configuration configuration = defaults();
  configuration.set_text("kim2001.transform", "direct", Location("--set"));
  configuration.set_text("texture_fetch.filter", "nearest", Location("--set"));
  const Table2 table = measure_table2(small_scenes(), configuration, {});
  for (const Table2Filtered& picture : table.filtered) {
    const bool refused = picture.test == "kim" && picture.filter == "vector";
    REQUIRE(picture.refused.has_value() == refused);
    REQUIRE(std::isnan(picture.psnr_db) == refused);
  }
  const std::string text = table2_text(table, configuration, "md");
  CHECK(text.find("nan") == std::string::npos);
  CHECK(text.find("kim, vector: kim2001.transform = direct does not go with kim2001.map_filter = vector.") != std::string::npos);
  CHECK(text.find("With texture_fetch.filter=nearest") != std::string::npos);
  CHECK(filter_assumption(table).find("differ by the filter") == std::string::npos);
  CHECK(Json::parse(table2_text(table, configuration, "json"))["bump_map_filters"].size() == table.filtered.size());
}

TEST_CASE("findings quote the paper's own contradictions and the numbers of this table") {
  const Table2& table = default_table();
  std::string all;
  for (const std::string& finding : table2_findings(table)) all += finding + "\n";
  CHECK(all.find("12 of its 18 NMSE values are not") != std::string::npos);
  CHECK(all.find("What of this is the filter") != std::string::npos);
  CHECK(all.find("isolates") == std::string::npos);
  CHECK(all.find("published sphere") != std::string::npos);
  CHECK(all.find("cube, red, 0.190 against 0.147") != std::string::npos);
  CHECK(all.find("Turned around the line of sight") == std::string::npos);  // not asked for
  for (const char* format : {"text", "md"}) CHECK(table2_text(table, defaults(), format).find("nan") == std::string::npos);
}

}  // namespace
}  // namespace bump
