// What the numbers of Table 2 say, in sentences. Each is made from the table at hand or from the published one: no figure is typed in.

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "testbench/experiments/table2_formats.h"
#include "testbench/experiments/table2_scenes.h"

namespace bump {

namespace {

std::string in_space(ShadingSpace space) {
  return space == ShadingSpace::eye ? "with the pole towards the viewer (eye space)" : "in object space";
}

/// Measured over published, all scenes and channels.
std::vector<double> ratios(const Table2& table, ShadingSpace space, const std::string& reference, const Table2Measure& measure) {
  std::vector<double> values;
  for (const Table2Comparison& c : table.comparisons) {
    if (c.test != "proposed" || c.reference != reference || c.space != space || c.published == nullptr) continue;
    for (std::size_t i = 0; i < 3; ++i) values.push_back((c.whole.*measure.measured)[i] / (c.published->*measure.published)[i]);
  }
  return values;
}

/// Mean NMSE over mean published with a filter of the bump map: " plane 1.04, cube 3.64, sphere 3.96".
std::string mean_ratios(const Table2& table, ShadingSpace space, const std::string& filter) {
  std::string text;
  for (const Table2Scene& scene : table2_scenes) {
    const std::string name(scene.name);
    const Table2Filtered* picture = table.filtered_picture(name, "proposed", space, filter);
    if (picture == nullptr || picture->refused) continue;
    const double published = mean(published::table2_row(name, "conventional")->nmse);
    text += fmt::format("{} {} {}", text.empty() ? "" : ",", name, times(mean(picture->nmse) / published));
  }
  return text;
}

std::string magnitude(const Table2& table, ShadingSpace space) {
  const Spread nmse(ratios(table, space, "conventional", table2_measures()[0]));
  const Spread pmse(ratios(table, space, "conventional", table2_measures()[2]));
  std::string text = fmt::format(
      "Proposed against conventional, {}, bump map {}: NMSE is {} to {} times the published value (median {}), PMSE {} to {} times (median "
      "{}; published PMSE has one or two digits). Mean NMSE over mean published:{}.",
      in_space(space), title_of_filter(table.proposed_filter), times(nmse.low), times(nmse.high), times(nmse.middle), times(pmse.low),
      times(pmse.high), times(pmse.middle), mean_ratios(table, space, table.proposed_filter));
  std::vector<double> vectors;
  for (const Table2Filtered& picture : table.filtered)
    if (picture.test == "proposed" && picture.space == space && picture.filter == "vector" && !picture.refused)
      for (std::size_t i = 0; i < 3; ++i)
        vectors.push_back(picture.nmse[i] / published::table2_row(picture.scene, "conventional")->nmse[i]);
  const Spread filtered(vectors);
  if (table.proposed_filter == "vector" || std::isnan(filtered.low)) return text;
  return text +
         fmt::format(" With the bump map filtered as vectors NMSE is {} to {} times the published value (median {}), and the means:{}.",
                     times(filtered.low), times(filtered.high), times(filtered.middle), mean_ratios(table, space, "vector"));
}

/// The scene with the largest mean NMSE.
template <class MeanOfScene>
std::string worst(const MeanOfScene& mean_of) {
  std::string name;
  double largest = -1;
  for (const Table2Scene& scene : table2_scenes) {
    const double value = mean_of(std::string(scene.name));
    if (value > largest) {
      largest = value;
      name = scene.name;
    }
  }
  return name;
}

std::string ranking(const Table2& table) {
  std::string text = fmt::format("Worst scene by mean NMSE against the conventional method: published {}; here",
                                 worst([](const std::string& scene) { return mean(published::table2_row(scene, "conventional")->nmse); }));
  for (const ShadingSpace space : shading_spaces) {
    const std::string name = worst([&](const std::string& scene) {
      const Table2Comparison* c = table.comparison(scene, "proposed", "conventional", space);
      return c != nullptr ? mean(c->whole.nmse) : -1.0;
    });
    text += fmt::format("{} {} ({} space)", space == shading_spaces.front() ? "" : ",", name, name_of(space));
  }
  return text + ".";
}

/// "33.7 to 41.1 dB", and with vectors where that is not the table's own filter.
std::string distances(const Table2& table, const std::string& method) {
  std::vector<double> own, vectors;
  for (const Table2Filtered& picture : table.filtered) {
    if (picture.test != method) continue;
    if (picture.filter == table.filter_of(method)) own.push_back(picture.psnr_db);
    if (picture.filter == "vector") vectors.push_back(picture.psnr_db);
  }
  const Spread drawn(own), filtered(vectors);
  std::string text = fmt::format("{:.1f} to {:.1f} dB", drawn.low, drawn.high);
  if (table.filter_of(method) != "vector" && !std::isnan(filtered.low))
    text += fmt::format(" ({:.1f} to {:.1f} dB with the bump map filtered as vectors)", filtered.low, filtered.high);
  return text;
}

std::string method_error(const Table2& table) {
  std::vector<double> light;
  for (const Table2Picture& picture : table.pictures)
    if (picture.method == "proposed" && picture.light) light.push_back(picture.light->mean_degrees);
  const Spread off(light);
  return fmt::format(
      "Over object pixels the proposed pictures are {} from the conventional ones, with L' off by {:.1f} to {:.1f} degrees on average; "
      "Kim's, "
      "whose transform is exact up to interpolation and tables, {}.",
      distances(table, "proposed"), off.low, off.high, distances(table, "kim"));
}

std::string map_error(const Table2& table) {
  std::string text;
  for (const Table2Comparison& c : table.comparisons)
    if (c.test == "conventional" && c.reference == "blinn")
      text += fmt::format("{}{} {:.1f} dB", text.empty() ? "" : ", ", c.scene, c.objects.psnr_db);
  if (text.empty()) return "No scene has heights, so the conventional method is drawn from the map that the schemes encode.";
  return "How the bump map is made counts too: exact shading of the encoded map against Blinn's perturbation of the heights it was made "
         "from is " +
         text + " (object pixels). Both are listed; only the comparison with the first leaves the making of the map out.";
}

/// Lowest and highest mean NMSE of each scene and space.
std::string ranges(const std::vector<Table2Angle>& points) {
  std::string text;
  for (const ShadingSpace space : shading_spaces) {
    for (const Table2Scene& scene : table2_scenes) {
      std::vector<double> values;
      for (const Table2Angle& point : points)
        if (point.scene == scene.name && point.space == space) values.push_back(mean(point.nmse));
      const Spread spread(values);
      text += fmt::format("{}{:.4f} to {:.4f} ({}, {})", text.empty() ? "" : ", ", spread.low, spread.high, scene.name, name_of(space));
    }
  }
  return text;
}

std::string light_dependence(const Table2& table) {
  return fmt::format(
      "The error is no property of the method alone. With the light {:g} to {:g} degrees from the eye the mean NMSE (bump map {}) is {}. "
      "Turned around the line of sight at the table's angles it is {}.",
      table2_angles.front(), table2_angles.back(), title_of_filter(table.proposed_filter), ranges(table.angles), ranges(table.azimuths));
}

std::string claim_of_one_percent() {
  int above = 0, cells = 0;
  for (const published::Table2Row& row : published::table2) {
    above += static_cast<int>(std::count_if(row.nmse.begin(), row.nmse.end(), [](double value) { return value >= 0.01; }));
    cells += static_cast<int>(row.nmse.size());
  }
  return fmt::format(
      "The paper's sentence that NMSE and PMSE are below 0.01 is contradicted by its own table: {} of its {} NMSE values are not.", above,
      cells);
}

std::string square_roots() {
  double largest = 0;
  for (const published::Table2Row& row : published::table2) {
    for (std::size_t i = 0; i < 3; ++i) {
      largest = std::max(largest, std::abs(row.rnmse[i] * row.rnmse[i] - row.nmse[i]));
      largest = std::max(largest, std::abs(row.rpmse[i] * row.rpmse[i] - row.pmse[i]));
    }
  }
  return fmt::format(
      "RNMSE and RPMSE squared are NMSE and PMSE, in the published table to {:.6f} (its values have four decimals), so they are no further "
      "evidence.",
      largest);
}

/// RMS over peak of the reference picture follows from RPMSE / RNMSE.
std::string inconsistency(const Table2& table) {
  const published::Table2Row *one = nullptr, *other = nullptr;
  std::size_t channel = 0;
  double largest = 0;
  const auto level = [](const std::array<double, 3>& rpmse, const std::array<double, 3>& rnmse, std::size_t i) {
    return rpmse[i] / rnmse[i];
  };
  double ours = 0;
  for (const Table2Scene& scene : table2_scenes) {
    const published::Table2Row* conventional = published::table2_row(scene.name, "conventional");
    const published::Table2Row* kim = published::table2_row(scene.name, "kim");
    for (std::size_t i = 0; i < 3; ++i) {
      const double difference = std::abs(std::log(level(conventional->rpmse, conventional->rnmse, i) / level(kim->rpmse, kim->rnmse, i)));
      if (difference > largest) {
        largest = difference;
        one = conventional;
        other = kim;
        channel = i;
      }
      for (const ShadingSpace space : shading_spaces) {
        const Table2Comparison* a = table.comparison(std::string(scene.name), "proposed", "conventional", space);
        const Table2Comparison* b = table.comparison(std::string(scene.name), "proposed", "kim", space);
        if (a == nullptr || b == nullptr) continue;
        const double here = std::abs(std::log(level(a->whole.rpmse, a->whole.rnmse, i) / level(b->whole.rpmse, b->whole.rnmse, i)));
        if (std::isfinite(here)) ours = std::max(ours, here);
      }
    }
  }
  const char* const channels[3] = {"red", "green", "blue"};
  return fmt::format(
      "RPMSE / RNMSE is the RMS over peak of the picture compared with, so it should be nearly the same for the conventional and for Kim's "
      "picture of a scene. Published it is not: {}, {}, {:.3f} against {:.3f}, {:.0f} % apart; here at most {:.1f} %.",
      one->scene, channels[channel], level(one->rpmse, one->rnmse, channel), level(other->rpmse, other->rnmse, channel),
      100 * std::expm1(largest), 100 * std::expm1(ours));
}

}  // namespace

Spread::Spread(std::vector<double> values) : low(std::numeric_limits<double>::quiet_NaN()), middle(low), high(low) {
  values.erase(std::remove_if(values.begin(), values.end(), [](double value) { return !std::isfinite(value); }), values.end());
  if (values.empty()) return;
  std::sort(values.begin(), values.end());
  low = values.front();
  high = values.back();
  middle = (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

std::string times(double value) {
  return fmt::format("{:.{}f}", value, value < 10 ? 2 : 0);
}

std::vector<std::string> table2_findings(const Table2& table) {
  std::vector<std::string> findings;
  for (const ShadingSpace space : {ShadingSpace::eye, ShadingSpace::object}) findings.push_back(magnitude(table, space));
  findings.push_back(ranking(table));
  findings.push_back(method_error(table));
  for (std::string& finding : filter_findings(table)) findings.push_back(std::move(finding));
  findings.push_back(map_error(table));
  if (!table.angles.empty()) findings.push_back(light_dependence(table));
  findings.push_back(claim_of_one_percent());
  findings.push_back(square_roots());
  findings.push_back(inconsistency(table));
  findings.push_back(
      "Single values cannot be reproduced: camera, lights (the side on which they stand as much as their angle), material, textures and "
      "their filter, the height of the relief, the share of the background and the definition of the measures are not given. NMSE falls "
      "with "
      "the brightness of the texture and the ambient share, PMSE with the black background; PSNR and the largest error over object pixels, "
      "and the error of L', depend on fewer of these.");
  return findings;
}

}  // namespace bump
