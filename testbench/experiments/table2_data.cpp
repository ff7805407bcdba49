// Table 2 for programs: JSON and CSV, and what all formats share.

#include <fmt/core.h>

#include <cmath>

#include "testbench/experiments/table2_formats.h"
#include "testbench/experiments/table2_scenes.h"
#include "testbench/results/result_json.h"

namespace bump {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 3> channel_names{"red", "green", "blue"};

/// JSON has no infinities: what is not a number is null.
Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

std::string csv_number(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "";
}

Json space_json(const std::optional<ShadingSpace>& space) {
  return space ? Json(name_of(*space)) : Json(nullptr);
}

Json measures_json(const Table2Comparison& c) {
  Json json = Json::object();
  for (const Table2Measure& measure : table2_measures()) {
    Json& channels = json[measure.name] = Json::object();
    for (std::size_t i = 0; i < 3; ++i) {
      const double measured = (c.whole.*measure.measured)[i];
      const double printed = c.published != nullptr ? (c.published->*measure.published)[i] : std::nan("");
      channels[channel_names[i]] = {{"published", number(printed)}, {"measured", number(measured)}, {"ratio", number(measured / printed)}};
    }
  }
  return json;
}

Json light_json(const AngularError& error) {
  return {{"count", error.count},
          {"mean_degrees", number(error.mean_degrees)},
          {"rms_degrees", number(error.rms_degrees)},
          {"max_degrees", number(error.max_degrees)}};
}

Json scenes_json(const Table2& table) {
  Json list = Json::array();
  for (std::size_t s = 0; s < table.scenes.size(); ++s) {
    const Scene& scene = table.scenes[s];
    const glm::dvec3 light = scene.lights.front().vector;
    Json inputs = Json::array();
    for (const Scene::InputFile& file : scene.inputs) inputs.push_back({{"path", file.path}, {"sha256", file.sha256}});
    list.push_back({{"name", table2_scenes[s].name},
                    {"scene", scene.name},
                    {"width", scene.width},
                    {"height", scene.height},
                    {"light_degrees", table2_scenes[s].light_degrees},
                    {"light_position", {light.x, light.y, light.z}},
                    {"inputs", inputs}});
  }
  return list;
}

/// Of the published table, what the mean NMSE of `picture` stands beside.
const published::Table2Row* published_row(const Table2Filtered& picture) {
  return picture.test == "proposed" ? published::table2_row(picture.scene, "conventional") : nullptr;
}

Json filters_json(const Table2& table) {
  Json list = Json::array();
  for (const Table2Filtered& picture : table.filtered) {
    const published::Table2Row* row = published_row(picture);
    const double measured = mean(picture.nmse), printed = row != nullptr ? mean(row->nmse) : std::nan("");
    list.push_back({{"scene", picture.scene},
                    {"space", name_of(picture.space)},
                    {"test", picture.test},
                    {"reference", "conventional"},
                    {"bump_filter", picture.filter},
                    {"table", picture.filter == table.filter_of(picture.test)},
                    {"nmse", {{"red", number(picture.nmse[0])}, {"green", number(picture.nmse[1])}, {"blue", number(picture.nmse[2])}}},
                    {"mean_nmse", {{"published", number(printed)}, {"measured", number(measured)}, {"ratio", number(measured / printed)}}},
                    {"psnr_db", number(picture.psnr_db)},
                    {"refused", picture.refused ? Json(*picture.refused) : Json(nullptr)}});
  }
  return list;
}

Json lights_json(const std::vector<Table2Angle>& points) {
  Json list = Json::array();
  for (const Table2Angle& point : points)
    list.push_back({{"scene", point.scene},
                    {"space", name_of(point.space)},
                    {"degrees", point.light.degrees},
                    {"azimuth", point.light.azimuth},
                    {"nmse", {{"red", number(point.nmse[0])}, {"green", number(point.nmse[1])}, {"blue", number(point.nmse[2])}}},
                    {"mean_nmse", number(mean(point.nmse))}});
  return list;
}

}  // namespace

const std::array<Table2Measure, 4>& table2_measures() {
  static const std::array<Table2Measure, 4> measures{{{"NMSE", &WholeFrameMeasures::nmse, &published::Table2Row::nmse},
                                                      {"RNMSE", &WholeFrameMeasures::rnmse, &published::Table2Row::rnmse},
                                                      {"PMSE", &WholeFrameMeasures::pmse, &published::Table2Row::pmse},
                                                      {"RPMSE", &WholeFrameMeasures::rpmse, &published::Table2Row::rpmse}}};
  return measures;
}

double mean(const std::array<double, 3>& channels) {
  return (channels[0] + channels[1] + channels[2]) / 3;
}

std::vector<std::string> changed_settings(const Configuration& configuration) {
  std::vector<std::string> changed;
  for (const auto& [key, entry] : configuration.entries())
    if (entry.origin.file != "default") changed.push_back(key + "=" + to_string(entry.value));
  return changed;
}

std::string title_of(const std::string& method, const Table2& table) {
  if (method == "proposed")
    return "the proposed method, scheme lee2007 as the simulated hardware draws it; bump map " + title_of_filter(table.proposed_filter);
  if (method == "kim")
    return "Kim's polar coordinate method, scheme kim2001 as the simulated hardware draws it; bump map " +
           title_of_filter(table.kim_filter);
  if (method == "blinn") return "Blinn's perturbation (Eq 1) of the heights in object space, double precision: the conventional method";
  return "exact Cartesian shading in object space, double precision, of the bump map that the schemes encode, its normals filtered like "
         "colours (" +
         table.texture_filter + "): the conventional method with the same map";
}

nlohmann::ordered_json table2_json(const Table2& table, const Configuration& configuration) {
  Json json = {{"schema", "bumpsim-table2"}, {"schema_version", table2_json_version}, {"status", "ok"}, {"source", "Lee et al. 2007, Table 2"}};
  json["assumptions"] = {
      {"scenes", scenes_json(table)},
      {"material",
       {{"ambient", table2_material.ambient},
        {"diffuse", table2_material.diffuse},
        {"specular", table2_material.specular},
        {"shininess", table2_material.shininess}}},
      {"light", "one point light of intensity 1, as far from the object's centre as the eye, towards the viewer's right"},
      {"bump_map_filter",
       {{"texture_fetch.filter", table.texture_filter},
        {"lee2007.map_filter", table.proposed_filter},
        {"kim2001.map_filter", table.kim_filter},
        {"note", filter_assumption(table)}}}};
  json["settings"] = changed_settings(configuration);
  for (const char* method : {"proposed", "kim", "conventional", "blinn"}) json["methods"][method] = title_of(method, table);
  json["comparisons"] = Json::array();
  for (const Table2Comparison& c : table.comparisons) {
    Json row = {{"scene", c.scene},
                {"space", space_json(c.space)},
                {"test", c.test},
                {"reference", c.reference},
                {"published_row", c.published != nullptr ? Json(c.published->source) : Json(nullptr)},
                {"whole_frame_8_bit", measures_json(c)},
                {"object_pixels_unrounded", to_json(c.objects)}};
    const Table2Picture* picture = table.picture(c.scene, c.test, c.space);
    row["angular_error_of_light"] = picture != nullptr && picture->light ? light_json(*picture->light) : Json(nullptr);
    json["comparisons"].push_back(std::move(row));
  }
  json["bump_map_filters"] = filters_json(table);
  json["light_angles"] = lights_json(table.angles);
  json["light_azimuths"] = lights_json(table.azimuths);
  json["findings"] = table2_findings(table);
  return json;
}

std::string table2_csv(const Table2& table) {
  std::string csv =
      "section,scene,space,test,reference,bump_filter,light_degrees,light_azimuth,measure,channel,unit,published,measured,ratio\n";
  for (const Table2Comparison& c : table.comparisons) {
    const std::string key = fmt::format("{},{},{},{},{}", c.scene, c.space ? name_of(*c.space) : "", c.test, c.reference,
                                        c.space ? table.filter_of(c.test) : "");
    for (const Table2Measure& measure : table2_measures()) {
      for (std::size_t i = 0; i < 3; ++i) {
        const double measured = (c.whole.*measure.measured)[i];
        const double printed = c.published != nullptr ? (c.published->*measure.published)[i] : std::nan("");
        csv += fmt::format("whole_frame_8_bit,{},,,{},{},1,{},{},{}\n", key, measure.name, channel_names[i], csv_number(printed),
                           csv_number(measured), csv_number(measured / printed));
      }
    }
    const auto line = [&](const char* section, const char* measure, const char* unit, double value) {
      csv += fmt::format("{},{},,,{},,{},,{},\n", section, key, measure, unit, csv_number(value));
    };
    line("object_pixels_unrounded", "PSNR", "dB", c.objects.psnr_db);
    line("object_pixels_unrounded", "max_error", "of 255", c.objects.max_error);
    line("object_pixels_unrounded", "mean_error", "of 255", c.objects.mean_error);
    const Table2Picture* picture = table.picture(c.scene, c.test, c.space);
    if (picture == nullptr || !picture->light) continue;
    line("angular_error_of_light", "mean", "degrees", picture->light->mean_degrees);
    line("angular_error_of_light", "rms", "degrees", picture->light->rms_degrees);
    line("angular_error_of_light", "max", "degrees", picture->light->max_degrees);
  }
  for (const Table2Filtered& picture : table.filtered) {
    const std::string key =
        fmt::format("bump_map_filters,{},{},{},conventional,{},,", picture.scene, name_of(picture.space), picture.test, picture.filter);
    const published::Table2Row* row = published_row(picture);
    for (std::size_t i = 0; i < 3; ++i) {
      const double measured = picture.nmse[i], printed = row != nullptr ? row->nmse[i] : std::nan("");
      csv += fmt::format("{},NMSE,{},1,{},{},{}\n", key, channel_names[i], csv_number(printed), csv_number(measured),
                         csv_number(measured / printed));
    }
    csv += fmt::format("{},PSNR,,dB,,{},\n", key, csv_number(picture.psnr_db));
  }
  const auto lights = [&](const char* section, const std::vector<Table2Angle>& points) {
    for (const Table2Angle& point : points)
      for (std::size_t i = 0; i < 3; ++i)
        csv += fmt::format("{},{},{},proposed,conventional,{},{},{},NMSE,{},1,,{},\n", section, point.scene, name_of(point.space),
                           table.proposed_filter, point.light.degrees, point.light.azimuth, channel_names[i], csv_number(point.nmse[i]));
  };
  lights("light_angles", table.angles);
  lights("light_azimuths", table.azimuths);
  return csv;
}

std::string table2_text(const Table2& table, const Configuration& configuration, const std::string& format) {
  if (format == "json") return table2_json(table, configuration).dump(2) + "\n";
  if (format == "csv") return table2_csv(table);
  return table2_document(table, configuration, format == "md");
}

}  // namespace bump
