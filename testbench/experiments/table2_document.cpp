// Table 2 for readers, as plain text and as Markdown.

#include <fmt/core.h>

#include <cmath>

#include "testbench/experiments/document.h"
#include "testbench/experiments/table2_formats.h"
#include "testbench/experiments/table2_scenes.h"

namespace bump {

namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string decimals(double value, int places) {
  return std::isnan(value) ? "-" : std::isinf(value) ? "inf" : fmt::format("{:.{}f}", value, places);
}

/// Three significant digits are more than the published values have.
std::string ratio(double value) {
  return decimals(value, std::abs(value) < 10 ? 2 : 1);
}

std::string space_name(const std::optional<ShadingSpace>& space) {
  return space ? name_of(*space) : "-";
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text;
}

void assumptions(Document& document, const Table2& table, const Configuration& configuration) {
  document.paragraph(fmt::format(
      "Assumptions of this project, since the paper names the objects and textures only: the shipped scenes with their cameras, relief and "
      "textures; one point light of intensity 1, as far from the object's centre as the eye, at the stated angle from the eye, towards the "
      "viewer's right (with --angles also elsewhere); ambient {:g}, diffuse {:g}, specular {:g}, shininess {:g}.",
      table2_material.ambient, table2_material.diffuse, table2_material.specular, table2_material.shininess));
  Rows rows;
  for (std::size_t s = 0; s < table.scenes.size(); ++s) {
    const Scene& scene = table.scenes[s];
    const bool heights = table.picture(std::string(table2_scenes[s].name), "blinn", std::nullopt) != nullptr;
    rows.push_back({std::string(table2_scenes[s].name), std::string(table2_scenes[s].description), scene.name,
                    fmt::format("{} x {}", scene.width, scene.height), fmt::format("{:g}", table2_scenes[s].light_degrees),
                    heights ? "heights" : "normals only"});
  }
  document.table({"scene", "in the paper", "scene file", "pixels", "light, degrees", "relief"}, rows, 3);
  const std::vector<std::string> changed = changed_settings(configuration);
  if (!changed.empty()) document.paragraph("Settings: " + joined(changed) + ".");
  for (const char* method : {"proposed", "kim", "conventional", "blinn"})
    document.item(fmt::format("{}: {}.", method, title_of(method, table)));
  document.paragraph(filter_assumption(table));
  document.paragraph(
      "Space: the axes in which polar angles are taken, the object's own or the camera's (pole towards the viewer); the paper does not "
      "say. "
      "A scene without heights has no picture from heights; there the same map, exactly shaded, stands for the conventional method.");
}

void published_block(Document& document, const Table2& table, ShadingSpace space, const std::string& reference) {
  Rows rows;
  for (const Table2Measure& measure : table2_measures()) {
    for (const Table2Scene& scene : table2_scenes) {
      const Table2Comparison* c = table.comparison(std::string(scene.name), "proposed", reference, space);
      if (c == nullptr || c->published == nullptr) continue;
      std::vector<std::string> row{measure.name, c->scene}, measured, ratios;
      for (std::size_t i = 0; i < 3; ++i) {
        const double printed = (c->published->*measure.published)[i], value = (c->whole.*measure.measured)[i];
        row.push_back(decimals(printed, 4));
        measured.push_back(decimals(value, 4));
        ratios.push_back(ratio(value / printed));
      }
      row.insert(row.end(), measured.begin(), measured.end());
      row.insert(row.end(), ratios.begin(), ratios.end());
      rows.push_back(std::move(row));
    }
  }
  if (rows.empty()) return;
  document.heading(3, fmt::format("proposed against {}, {} space", reference, name_of(space)));
  document.table({"measure", "scene", "paper R", "G", "B", "here R", "G", "B", "here/paper R", "G", "B"}, rows, 2);
}

void beyond_the_paper(Document& document, const Table2& table) {
  document.heading(2, "Beyond Table 2");
  document.paragraph(
      "Mean NMSE of red, green, blue as above; PSNR and largest error over object pixels on unrounded colours, in dB and steps of 255; and "
      "how "
      "far the delivered L' of the tested method is from the true one where it lights the surface, in degrees.");
  Rows rows;
  for (const Table2Comparison& c : table.comparisons) {
    const Table2Picture* picture = table.picture(c.scene, c.test, c.space);
    const bool light = picture != nullptr && picture->light;
    rows.push_back({c.test, c.reference, space_name(c.space), c.scene, decimals(mean(c.whole.nmse), 5), decimals(c.objects.psnr_db, 1),
                    decimals(c.objects.max_error, 0), light ? decimals(picture->light->mean_degrees, 1) : "-",
                    light ? decimals(picture->light->max_degrees, 1) : "-"});
  }
  document.table({"picture", "against", "space", "scene", "mean NMSE", "PSNR", "max error", "L' mean", "L' max"}, rows, 4);
}

/// One row for each position of the light, `coordinate` of which differs.
void light_table(Document& document, const std::vector<Table2Angle>& points, double Table2Light::*coordinate, const std::string& name) {
  std::vector<std::string> header{name};
  for (const ShadingSpace space : shading_spaces)
    for (const Table2Scene& scene : table2_scenes) header.push_back(std::string(scene.name) + " " + name_of(space));
  Rows rows;
  for (const Table2Angle& first : points) {
    if (first.scene != table2_scenes.front().name || first.space != shading_spaces.front()) continue;
    rows.push_back({fmt::format("{:g}", first.light.*coordinate)});
    for (const ShadingSpace space : shading_spaces)
      for (const Table2Scene& scene : table2_scenes)
        for (const Table2Angle& point : points)
          if (point.scene == scene.name && point.space == space && point.light.*coordinate == first.light.*coordinate)
            rows.back().push_back(decimals(mean(point.nmse), 4));
  }
  document.table(header, rows, 0);
}

void moved_lights(Document& document, const Table2& table) {
  if (table.angles.empty()) return;
  document.heading(2, "Dependence on the light");
  document.paragraph(
      "Mean NMSE of red, green, blue, proposed against conventional (bump map " + title_of_filter(table.proposed_filter) +
      ", whose share these values do not tell apart), with the light at other angles from the eye, towards the viewer's right:");
  light_table(document, table.angles, &Table2Light::degrees, "degrees");
  document.paragraph("and at the angle of the table, turned around the line of sight (0 is to the right, 90 above):");
  light_table(document, table.azimuths, &Table2Light::azimuth, "azimuth");
}

}  // namespace

std::string table2_document(const Table2& table, const Configuration& configuration, bool markdown) {
  Document document(markdown);
  document.heading(1, "Table 2 of Lee et al. 2007: picture quality, measured beside published");
  assumptions(document, table, configuration);
  document.heading(2, "Table 2");
  document.paragraph(
      "Whole frame, background included, 8 bits a channel; x the picture compared with: NMSE = sum (x - y)^2 / sum x^2, "
      "PMSE = mean (x - y)^2 / 255^2, RNMSE and RPMSE their square roots. The formulas are missing from the paper; these are the usual "
      "ones.");
  for (const char* reference : {"conventional", "kim", "blinn"})
    for (const ShadingSpace space : shading_spaces) published_block(document, table, space, reference);
  beyond_the_paper(document, table);
  filter_section(document, table);
  moved_lights(document, table);
  document.heading(2, "What reproduces and what cannot");
  for (const std::string& finding : table2_findings(table)) document.item(finding);
  return document.text();
}

}  // namespace bump
