// What Table 2 says of the filter of the bump map: the assumption, the section and the sentences made from its numbers.

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "testbench/experiments/document.h"
#include "testbench/experiments/table2_formats.h"
#include "testbench/experiments/table2_scenes.h"

namespace bump {

namespace {

constexpr std::array<const char*, 2> methods{"proposed", "kim"};

std::string decimals(double value, int places) {
  return std::isnan(value) ? "-" : fmt::format("{:.{}f}", value, places);
}

/// Every way to filter is the nearest texel, or every map is filtered like the reference's.
bool one_filter(const Table2& table) {
  return table.texture_filter == "nearest" || (table.proposed_filter == "vector" && table.kim_filter == "vector");
}

/// Mean NMSE with one filter over that with another, of one scene and space; NaN where either is refused.
double change(const Table2& table, const std::string& scene, const char* method, ShadingSpace space, const char* to) {
  const Table2Filtered* nearest = table.filtered_picture(scene, method, space, "nearest");
  const Table2Filtered* other = table.filtered_picture(scene, method, space, to);
  return nearest != nullptr && other != nullptr ? mean(other->nmse) / mean(nearest->nmse) : std::nan("");
}

Spread changes(const Table2& table, const char* method, const char* to) {
  std::vector<double> values;
  for (const ShadingSpace space : shading_spaces)
    for (const Table2Scene& scene : table2_scenes) values.push_back(change(table, std::string(scene.name), method, space, to));
  return Spread(values);
}

std::string per_cent(double share) {
  return fmt::format("{:.{}f}", 100 * share, std::abs(share) < 0.1 ? 1 : 0);
}

std::string share_of_filter(const Table2& table) {
  std::string shares;
  bool compensates = false;
  for (const ShadingSpace space : {ShadingSpace::eye, ShadingSpace::object}) {
    for (const Table2Scene& scene : table2_scenes) {
      const double share = 1 - change(table, std::string(scene.name), "proposed", space, "vector");
      if (!std::isfinite(share)) continue;
      compensates = compensates || share < 0;
      shares += fmt::format("{}{} % ({}, {})", shares.empty() ? "" : ", ", per_cent(share), scene.name, name_of(space));
    }
  }
  if (shares.empty()) return "";
  const Spread proposed = changes(table, "proposed", "vector"), kim = changes(table, "kim", "vector");
  std::string text =
      "What of this is the filter: with the bump map filtered as vectors instead of fetched as the nearest texel, mean NMSE of "
      "the proposed pictures against the conventional ones falls by " +
      shares + (compensates ? " (negative: there the two errors compensate one another)" : "") +
      fmt::format("; {} to {} % of it stay and are the method's own", per_cent(proposed.low), per_cent(proposed.high));
  if (!std::isnan(kim.low)) text += fmt::format(". Of Kim's {} to {} % stay", per_cent(kim.low), per_cent(kim.high));
  return text + " (rotation or transform, interpolation, tables, words).";
}

std::string angles_filtered(const Table2& table) {
  const Spread proposed = changes(table, "proposed", "linear"), kim = changes(table, "kim", "linear");
  if (std::isnan(proposed.low) || std::isnan(kim.low)) return "";
  std::string text = fmt::format(
      "With the two angles of a texel filtered as they are, which is the paper's sentence taken literally, mean NMSE is {:.2f} to {:.2f} "
      "times that of the nearest texel for the proposed method, {:.2f} to {:.2f} times for Kim's",
      proposed.low, proposed.high, kim.low, kim.high);
  if (proposed.low > 0.9 && proposed.high < 1.1) text += ": which of the two is meant hardly changes the proposed method's values";
  return text + ".";
}

}  // namespace

std::string title_of_filter(const std::string& filter) {
  return filter == "nearest" ? "nearest texel" : filter == "linear" ? "its two angles filtered as they are" : "filtered as vectors";
}

std::string filter_assumption(const Table2& table) {
  const bool fallback = table.proposed_filter == "nearest" && table.kim_filter == "nearest";
  std::string text = fmt::format(
      "Filter of the bump map: the paper (section 7) says that bump maps are interpolated in the way of textures, not in which. Here "
      "colours, and the normals of the conventional method, are filtered by texture_fetch.filter ({}). Map of the proposed method: {}; of "
      "Kim's: {}.",
      table.texture_filter, title_of_filter(table.proposed_filter), title_of_filter(table.kim_filter));
  const std::string reason =
      "phi means nothing on flat texels, so filtering phi and theta is no filter of normals, and one of vectors takes hardware that the "
      "paper does not have";
  text +=
      fallback ? " The nearest texel is an assumption, too: " + reason + "." : " The default is the nearest texel, since " + reason + ".";
  if (one_filter(table)) return text;
  text +=
      " So the polar methods and the conventional one share the map, not N' at every pixel, and their pictures differ by the "
      "filter as well as by the method; \"Dependence on the filter of the bump map\" tells the two apart.";
  if (table.proposed_filter == table.kim_filter) text += " The proposed pictures and Kim's have the same filter.";
  return text;
}

void filter_section(Document& document, const Table2& table) {
  document.heading(2, "Dependence on the filter of the bump map");
  document.paragraph(fmt::format(
      "Against the conventional pictures, mean NMSE of red, green, blue over the whole frame, for the proposed method over the "
      "published mean too, and PSNR over object pixels in dB. nearest: the nearest texel. linear: the two angles of a texel filtered as "
      "they are. vector: "
      "texels hold vectors, which are filtered and turned into angles for each pixel, an addition to the hardware of the paper; then "
      "the map is filtered like the reference's, and what remains is the method. The sections above have {} (proposed) and {} (Kim).",
      table.proposed_filter, table.kim_filter));
  if (table.texture_filter == "nearest")
    document.paragraph("With texture_fetch.filter=nearest, linear and vector take the nearest texel, too, and so does the reference.");
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> refusals;
  for (const ShadingSpace space : shading_spaces) {
    for (const char* method : methods) {
      for (const Table2Scene& scene : table2_scenes) {
        const std::string name(scene.name);
        std::vector<std::string> row{method, name_of(space), name}, ratios, decibels;
        for (const char* filter : table2_filters) {
          const Table2Filtered* picture = table.filtered_picture(name, method, space, filter);
          if (picture == nullptr) continue;
          row.push_back(decimals(mean(picture->nmse), 5));
          const published::Table2Row* row_of_paper =
              std::string(method) == "proposed" ? published::table2_row(name, "conventional") : nullptr;
          ratios.push_back(row_of_paper != nullptr ? decimals(mean(picture->nmse) / mean(row_of_paper->nmse), 2) : "-");
          decibels.push_back(decimals(picture->psnr_db, 1));
          if (!picture->refused) continue;
          const std::string refusal = fmt::format("{}, {}: {}.", method, filter, *picture->refused);
          if (std::find(refusals.begin(), refusals.end(), refusal) == refusals.end()) refusals.push_back(refusal);
        }
        row.insert(row.end(), ratios.begin(), ratios.end());
        row.insert(row.end(), decibels.begin(), decibels.end());
        rows.push_back(std::move(row));
      }
    }
  }
  document.table({"picture", "space", "scene", "NMSE nearest", "linear", "vector", "here/paper nearest", "linear", "vector", "PSNR nearest",
                  "linear", "vector"},
                 rows, 3);
  for (const std::string& refusal : refusals) document.item(refusal);
}

std::vector<std::string> filter_findings(const Table2& table) {
  std::vector<std::string> findings;
  for (std::string& finding : std::vector<std::string>{share_of_filter(table), angles_filtered(table)})
    if (!finding.empty()) findings.push_back(std::move(finding));
  return findings;
}

}  // namespace bump
