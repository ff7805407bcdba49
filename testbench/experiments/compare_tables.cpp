#include "testbench/experiments/compare_tables.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "testbench/experiments/compare_metrics.h"

namespace bump {

namespace {

using Json = nlohmann::ordered_json;

/// "1,234,567".
std::string grouped(std::int64_t number) {
  std::string digits = fmt::format("{}", number);
  for (int i = static_cast<int>(digits.size()) - 3; i > 0; i -= 3) digits.insert(static_cast<std::size_t>(i), ",");
  return digits;
}

std::string cell(const Json& value, int decimals) {
  if (value.is_string()) return value;
  if (!value.is_number()) return "-";
  if (value.is_number_integer()) return grouped(value.get<std::int64_t>());
  if (std::isinf(value.get<double>())) return "identical";
  if (decimals == 0) return grouped(std::llround(value.get<double>()));
  return fmt::format("{:.{}f}", value.get<double>(), decimals);
}

/// "9", or "9+12" with what stands beside the published operators.
std::string operators_cell(const Json& metrics, const std::string& unit, const std::string& name) {
  const Json &built = metrics[unit + "_" + name], &more = metrics[unit + "_additional_" + name];
  if (!built.is_number()) return "-";
  return more.is_number() && more != 0 ? fmt::format("{}+{}", built.get<int>(), more.get<int>()) : fmt::format("{}", built.get<int>());
}

/// The first words of what went wrong; the whole of it stands below the tables.
std::string in_short(const ErrorText& error) {
  constexpr std::size_t longest = 44;
  if (error.what.size() <= longest) return "failed: " + error.what;
  return "failed: " + error.what.substr(0, std::min(longest, error.what.find_last_of(" :;,", longest))) + " ...";
}

struct Entry {
  std::string id;
  Json metrics;
  std::string failure;
};

struct Figure {
  std::string group, header, metric;
  int decimals = 0;
};

const std::vector<std::string>& short_operator_names() {
  static const std::vector<std::string> names = {"mult", "add", "div", "sqrt", "table", "map", "shift"};
  return names;
}

ComparisonTable table_of(const std::string& title, const std::vector<Entry>& entries, const std::vector<Figure>& figures) {
  ComparisonTable table;
  table.title = title;
  table.columns = {{"", "scheme", true}};
  for (const Figure& figure : figures) table.columns.push_back({figure.group, figure.header, false});
  for (const Entry& entry : entries) {
    table.rows.push_back({entry.id});
    for (const Figure& figure : figures) table.rows.back().push_back(cell(entry.metrics[figure.metric], figure.decimals));
  }
  return table;
}

ComparisonTable speed_table(const std::vector<Entry>& entries) {
  ComparisonTable table = table_of("Speed", entries,
                                   {{"", "cycles", "cycles", 0},
                                    {"", "fragments", "fragments", 0},
                                    {"", "per cycle", "fragments_per_cycle", 4},
                                    {"", "frames/s", "frames_per_second", 1},
                                    {"", "bound reached %", "bound_reached_percent", 1}});
  table.columns.push_back({"", "bound by", true});
  for (std::size_t i = 0; i < entries.size(); ++i)
    table.rows[i].push_back(entries[i].failure.empty() ? cell(entries[i].metrics["bound_by"], 0) : entries[i].failure);
  return table;
}

/// Whether any of the schemes has the operator in any of the units.
bool any_has(const std::vector<Entry>& entries, const std::vector<std::string>& units, const std::string& name) {
  return std::any_of(entries.begin(), entries.end(), [&](const Entry& entry) {
    return std::any_of(units.begin(), units.end(), [&](const std::string& unit) {
      const Json &built = entry.metrics[unit + "_" + name], &more = entry.metrics[unit + "_additional_" + name];
      return (built.is_number() && built != 0) || (more.is_number() && more != 0);
    });
  });
}

/// The operators that a table lists: those of the paper's, and barrel shifters if a scheme has any.
std::size_t operators_listed(const std::vector<Entry>& entries, const std::vector<std::string>& units) {
  return operator_names().size() - (any_has(entries, units, "shifters") ? 0 : 1);
}

ComparisonTable operators_table(const std::vector<Entry>& entries) {
  ComparisonTable table;
  table.title = "Operators built";
  table.note = "+n: beside those that the paper's table lists";
  table.columns = {{"", "scheme", true}};
  const std::vector<std::string> units = {"environment", "illumination"};
  const std::size_t listed = operators_listed(entries, units);
  for (const std::string& unit : units)
    for (std::size_t i = 0; i < listed; ++i) table.columns.push_back({unit, short_operator_names()[i], false});
  for (const Entry& entry : entries) {
    table.rows.push_back({entry.id});
    for (const std::string& unit : units)
      for (std::size_t i = 0; i < listed; ++i) table.rows.back().push_back(operators_cell(entry.metrics, unit, operator_names()[i]));
  }
  return table;
}

/// Units that few schemes have: per-pixel conversion, light maps.
ComparisonTable further_units_table(const std::vector<Entry>& entries) {
  ComparisonTable table;
  table.title = "Operators of further units";
  table.columns = {{"", "scheme", true}, {"", "unit", true}};
  const std::vector<std::string> units = {"conversion", "light_map_address", "frame"};
  const std::size_t listed = operators_listed(entries, units);
  for (std::size_t i = 0; i < listed; ++i) table.columns.push_back({"", short_operator_names()[i], false});
  for (const Entry& entry : entries) {
    for (const std::string& unit : units) {
      if (entry.metrics[unit + "_multipliers"].is_null()) continue;
      table.rows.push_back({entry.id, unit});
      for (std::size_t i = 0; i < listed; ++i) table.rows.back().push_back(operators_cell(entry.metrics, unit, operator_names()[i]));
    }
  }
  return table;
}

bool any(const std::vector<Entry>& entries, const std::string& metric) {
  return std::any_of(entries.begin(), entries.end(), [&](const Entry& entry) { return !entry.metrics[metric].is_null(); });
}

ComparisonTable work_table(const std::vector<Entry>& entries) {
  const std::string used = "operations per fragment";
  std::vector<Figure> figures = {{used, "mult", "multipliers_used_per_fragment", 1},
                                 {used, "add", "adders_used_per_fragment", 1},
                                 {used, "div", "dividers_used_per_fragment", 1},
                                 {used, "sqrt", "square_roots_used_per_fragment", 1},
                                 {"per fragment", "table reads", "table_reads_per_fragment", 1},
                                 {"tables, KB", "in ROMs", "tables_rom_kilobytes", 2},
                                 {"tables, KB", "distinct", "tables_distinct_kilobytes", 2},
                                 {"interpolated", "components", "interpolated_components", 0},
                                 {"operations", "per vertex", "vertex_operations_per_vertex", 1}};
  if (operators_listed(entries, compared_units()) == operator_names().size())
    figures.insert(figures.begin() + 4, {used, "shift", "shifters_used_per_fragment", 1});
  if (any(entries, "operations_per_frame")) figures.push_back({"operations", "per frame", "operations_per_frame", 0});
  ComparisonTable table = table_of("Work and tables", entries, figures);
  table.note = "of the units above, additions included, without interpolation, transform and colour; the last two with table reads";
  return table;
}

ComparisonTable memory_table(const std::vector<Entry>& entries) {
  const std::string texture = "texture";
  std::vector<Figure> figures = {{texture, "texels/fragment", "texels_per_fragment", 2},
                                 {texture, "hits %", "texture_hit_rate_percent", 2},
                                 {texture, "KB from memory", "texture_kilobytes", 1}};
  if (any(entries, "light_map_kilobytes")) {
    figures.push_back({"light maps", "reads/fragment", "light_map_reads_per_fragment", 2});
    figures.push_back({"light maps", "hits %", "light_map_hit_rate_percent", 2});
    figures.push_back({"light maps", "KB from memory", "light_map_kilobytes", 1});
    figures.push_back({"light maps", "KB filled", "light_map_filled_kilobytes", 1});
  }
  return table_of("Memory", entries, figures);
}

ComparisonTable picture_table(const std::vector<Entry>& entries) {
  const std::string psnr = "PSNR, dB";
  ComparisonTable table = table_of("Picture", entries,
                                   {{psnr, "hardware/reference", "psnr_hardware_to_reference_db", 2},
                                    {psnr, "double/reference", "psnr_double_to_reference_db", 2},
                                    {psnr, "hardware/double", "psnr_hardware_to_double_db", 2},
                                    {psnr, "hardware/Blinn", "psnr_hardware_to_blinn_db", 2},
                                    {"largest error", "steps of 255", "max_error_steps_of_255", 1},
                                    {"mean angle of L'", "degrees", "mean_angle_of_light_degrees", 3}});
  table.note = "hardware: as drawn; double: the scheme's formula in double precision; reference: the same map, exact; Blinn: from heights";
  return table;
}

ComparisonTable origin_table(const Comparison& comparison) {
  ComparisonTable table;
  table.title = "Where the schemes come from";
  table.note = "(R): a reconstruction, in whole or in part; in all tables - is not applicable";
  table.columns = {{"", "scheme", true}, {"", "provenance", true}};
  for (const ComparisonRow& row : comparison.rows) table.rows.push_back({marked_id(*row.page), row.page->provenance});
  return table;
}

}  // namespace

std::vector<ComparisonTable> comparison_tables(const Comparison& comparison) {
  std::vector<Entry> entries;
  for (const ComparisonRow& row : comparison.rows) {
    entries.push_back({marked_id(*row.page), metrics_of(row.result), row.error ? in_short(row.error->text()) : ""});
  }
  std::vector<ComparisonTable> tables = {speed_table(entries), operators_table(entries)};
  const ComparisonTable further = further_units_table(entries);
  if (!further.rows.empty()) tables.push_back(further);
  for (const ComparisonTable& table : {work_table(entries), memory_table(entries), picture_table(entries), origin_table(comparison)})
    tables.push_back(table);
  return tables;
}

std::string conditions_of(const Comparison& comparison) {
  const Scene& scene = *comparison.scene;
  return fmt::format("{} x {} pixels, {} {}, {} engine, {:g} MHz", scene.width, scene.height, scene.lights.size(),
                     scene.lights.size() == 1 ? "light" : "lights", comparison.engine, comparison.configuration->number("clock.megahertz"));
}

std::vector<std::array<std::string, 3>> differences_of(const Configuration& configuration) {
  std::vector<std::array<std::string, 3>> differences;
  for (const auto& [key, entry] : configuration.entries()) {
    const ParameterValue& fallback = configuration.parameters().find(key)->fallback;
    if (entry.value != fallback) differences.push_back({key, to_string(entry.value), to_string(fallback)});
  }
  return differences;
}

std::string settings_of(const Comparison& comparison) {
  std::string text;
  for (const auto& [key, value, fallback] : differences_of(*comparison.configuration))
    text += fmt::format("{}{} = {} (default {})", text.empty() ? "" : ", ", key, value, fallback);
  return text.empty() ? "default" : text;
}

}  // namespace bump
