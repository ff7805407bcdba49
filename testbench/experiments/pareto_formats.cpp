#include "testbench/experiments/pareto_formats.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "testbench/experiments/document.h"
#include "testbench/experiments/svg_axis.h"
#include "testbench/experiments/svg_plot.h"
#include "testbench/results/text_table.h"

namespace bump {

namespace {

using Json = nlohmann::ordered_json;

std::string number_text(double value) {
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return fmt::format("{:.10g}", value);
}

/// JSON has no infinities.
Json number_json(double value) {
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return value;
}

const char* better(const ParetoAxis& axis) {
  return axis.high_is_better ? "high" : "low";
}

/// Columns may have the names of these.
std::string label_header(const ParetoFront& front) {
  return front.label.empty() ? "label" : front.label;
}

std::vector<std::array<double, 2>> steps_along(const ParetoFront& front) {
  std::vector<std::array<double, 2>> corners;
  for (const ParetoPoint* point : front.front()) {
    if (!corners.empty()) {
      const std::array<double, 2> last = corners.back();
      // Between two points only what the cheaper (or less) of them offers can be had.
      corners.push_back(front.x.high_is_better ? std::array<double, 2>{last[0], point->y} : std::array<double, 2>{point->x, last[1]});
    }
    corners.push_back({point->x, point->y});
  }
  return corners;
}

std::string hint_of(const ParetoFront& front, const ParetoPoint& point) {
  std::string hint = fmt::format("row {}", point.row + 1);
  if (!front.label.empty()) hint += fmt::format(", {} {}", front.label, point.label);
  hint += fmt::format(", {} {}, {} {}", front.x.column, number_text(point.x), front.y.column, number_text(point.y));
  for (std::size_t i = 0; i < front.identity.size(); ++i) hint += fmt::format(", {} {}", front.identity[i], point.identity[i]);
  return hint;
}

}  // namespace

std::string axis_title(const ParetoAxis& axis) {
  constexpr std::array<std::array<const char*, 2>, 14> units = {{{"_db", "dB"},
                                                                 {"_bits", "bits"},
                                                                 {"_kilobytes", "KB"},
                                                                 {"_bytes", "bytes"},
                                                                 {"_nand2", "NAND2 equivalents"},
                                                                 {"_pj_per_fragment", "pJ a fragment"},
                                                                 {"_pj", "pJ"},
                                                                 {"_percent", "%"},
                                                                 {"_degrees", "degrees"},
                                                                 {"cycles", "cycles"},
                                                                 {"_per_second", "1/s"},
                                                                 {"_per_cycle", "1/cycle"},
                                                                 {"_latency", "cycles"},
                                                                 {"_steps_of_255", "of 255"}}};
  std::string title = axis.column;
  const std::string bare = title.substr(0, title.find('.'));  // "psnr_db.world_sphere"
  for (const auto& [end, unit] : units) {
    const std::string suffix = end;
    if (bare.size() < suffix.size() || bare.compare(bare.size() - suffix.size(), suffix.size(), suffix) != 0) continue;
    title += fmt::format(" ({})", unit);
    break;
  }
  return title + fmt::format(", {} is better", better(axis));
}

std::string pareto_document(const ParetoFront& front, bool markdown) {
  Document document(markdown);
  const std::vector<const ParetoPoint*> marked = front.front();
  document.heading(1, fmt::format("Pareto front: {} ({}) and {} ({})", front.x.column, better(front.x), front.y.column, better(front.y)));
  std::string counts = fmt::format("{} of {} points of {} are on it", marked.size(), front.points.size(), front.file);
  std::string out;
  for (const auto& [count, why] : {std::pair<std::size_t, const char*>{front.filtered, "by --where"},
                                   {front.failed, "that failed"},
                                   {front.not_reached, "that did not reach the quality"},
                                   {front.without_value, "without a number in both columns"}})
    if (count > 0) out += fmt::format("{}{} {}", out.empty() ? "" : ", ", count, why);
  if (!out.empty()) counts += fmt::format("; of {} rows left out: {}", front.rows, out);
  document.paragraph(counts + ".");

  std::vector<std::string> header = {"row"};
  if (!front.label.empty()) header.push_back(front.label);
  header.push_back(front.x.column);
  header.push_back(front.y.column);
  header.insert(header.end(), front.identity.begin(), front.identity.end());
  std::vector<std::vector<std::string>> rows;
  for (const ParetoPoint* point : marked) {
    std::vector<std::string> cells = {std::to_string(point->row + 1)};
    if (!front.label.empty()) cells.push_back(point->label);
    cells.push_back(number_text(point->x));
    cells.push_back(number_text(point->y));
    cells.insert(cells.end(), point->identity.begin(), point->identity.end());
    rows.push_back(std::move(cells));
  }
  document.table(header, rows, front.label.empty() ? 1 : 2);
  return document.text();
}

std::string pareto_csv(const ParetoFront& front) {
  std::vector<std::string> header = {"row", label_header(front), front.x.column, front.y.column, "on_front"};
  header.insert(header.end(), front.identity.begin(), front.identity.end());
  std::string text = csv_line(header);
  for (const ParetoPoint& point : front.points) {
    std::vector<std::string> cells = {std::to_string(point.row + 1), point.label, number_text(point.x), number_text(point.y),
                                      point.on_front ? "true" : "false"};
    cells.insert(cells.end(), point.identity.begin(), point.identity.end());
    text += csv_line(cells);
  }
  return text;
}

std::string pareto_json(const ParetoFront& front) {
  const auto axis_json = [](const ParetoAxis& axis) { return Json{{"column", axis.column}, {"better", better(axis)}}; };
  Json json = {{"schema", pareto_schema}, {"schema_version", pareto_schema_version}, {"file", front.file}};
  json["x"] = axis_json(front.x);
  json["y"] = axis_json(front.y);
  json["label"] = front.label.empty() ? Json() : Json(front.label);
  json["rows"] = front.rows;
  json["left_out"] = {
      {"where", front.filtered}, {"failed", front.failed}, {"not_reached", front.not_reached}, {"without_value", front.without_value}};
  json["points"] = Json::array();
  for (const ParetoPoint& point : front.points) {
    Json one = {{"row", point.row + 1}, {"label", point.label}, {"x", number_json(point.x)}, {"y", number_json(point.y)}};
    one["on_front"] = point.on_front;
    one["identity"] = Json::object();
    for (std::size_t i = 0; i < front.identity.size(); ++i) one["identity"][front.identity[i]] = point.identity[i];
    json["points"].push_back(std::move(one));
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string pareto_svg(const ParetoFront& front, const std::string& title) {
  SvgPlot plot;
  plot.title = title.empty() ? front.y.column + " over " + front.x.column : title;
  plot.x = {axis_title(front.x), front.x.logarithmic};
  plot.y = {axis_title(front.y), front.y.logarithmic};
  for (const ParetoPoint& point : front.points) {
    const auto known = std::find(plot.series.begin(), plot.series.end(), point.label);
    const auto index = static_cast<std::size_t>(known - plot.series.begin());
    if (known == plot.series.end()) plot.series.push_back(point.label);
    plot.points.push_back({point.x, point.y, index, point.on_front, point.label, hint_of(front, point)});
  }
  plot.line = steps_along(front);
  return svg_plot(plot);
}

}  // namespace bump
