#include "testbench/experiments/compare_formats.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "testbench/experiments/compare_metrics.h"
#include "testbench/experiments/compare_tables.h"
#include "testbench/results/error_json.h"
#include "testbench/results/text_table.h"

namespace bump {

namespace {

using Json = nlohmann::ordered_json;

std::string padded(const std::string& text, std::size_t width, bool left) {
  const std::string blanks(width - std::min(width, text.size()), ' ');
  return left ? text + blanks : blanks + text;
}

std::string without_trailing_blanks(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

std::string text_of(const ComparisonTable& table) {
  const auto& columns = table.columns;
  std::vector<std::size_t> widths;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    std::size_t width = columns[i].header.size();
    for (const auto& row : table.rows) width = std::max(width, row[i].size());
    widths.push_back(width);
  }
  // A group's name stands over its columns; the last of them takes what it needs beyond them.
  std::string groups = " ";
  for (std::size_t begin = 0, end; begin < columns.size(); begin = end) {
    std::size_t width = 0;
    for (end = begin; end < columns.size() && (end == begin || (!columns[end].group.empty() && columns[end].group == columns[begin].group));
         ++end)
      width += widths[end] + (end > begin ? 2 : 0);
    if (columns[begin].group.size() > width) {
      widths[end - 1] += columns[begin].group.size() - width;
      width = columns[begin].group.size();
    }
    const std::size_t dashes = end - begin > 1 ? width - columns[begin].group.size() : 0;
    const std::string name =
        dashes >= 4 ? std::string(dashes / 2 - 1, '-') + " " + columns[begin].group + " " + std::string(dashes - dashes / 2 - 1, '-')
                    : columns[begin].group;
    groups += " " + padded(columns[begin].group.empty() ? "" : name, width, false) + " ";
  }
  const auto line = [&](const auto& cell) {
    std::string text = " ";
    for (std::size_t i = 0; i < columns.size(); ++i) text += " " + padded(cell(i), widths[i], columns[i].left) + " ";
    return without_trailing_blanks(text);
  };
  const bool grouped = std::any_of(columns.begin(), columns.end(), [](const auto& column) { return !column.group.empty(); });
  std::string text = "\n" + table.title + (table.note.empty() ? "" : " (" + table.note + ")") + "\n";
  if (grouped) text += without_trailing_blanks(groups);
  text += line([&](std::size_t i) { return columns[i].header; });
  for (const auto& row : table.rows) text += line([&](std::size_t i) { return row[i]; });
  return text;
}

/// What would end a cell, emphasise, or be taken for markup.
std::string escaped(const std::string& text) {
  std::string safe;
  for (const char letter : text) {
    if (letter == '|' || letter == '*' || letter == '<' || letter == '`' || letter == '\\') safe += '\\';
    safe += letter == '\n' ? ' ' : letter;
  }
  return safe;
}

std::string markdown_of(const ComparisonTable& table) {
  std::string text = "\n## " + table.title + "\n\n" + (table.note.empty() ? "" : escaped(table.note) + "\n\n");
  std::string rule = "|";
  text += "|";
  for (const auto& column : table.columns) {
    text += " " + escaped(column.group.empty() ? column.header : column.group + ": " + column.header) + " |";
    rule += column.left ? "--|" : "--:|";
  }
  text += "\n" + rule + "\n";
  for (const auto& row : table.rows) {
    text += "|";
    for (const std::string& cell : row) text += " " + escaped(cell) + " |";
    text += "\n";
  }
  return text;
}

std::string failures_of(const Comparison& comparison, const std::string& heading, const std::string& indent, bool markdown) {
  std::string text;
  for (const ComparisonRow& row : comparison.rows) {
    if (!row.error) continue;
    const std::string what = row.page->id + ": " + row.error->what();
    text += (text.empty() ? heading : "") + indent + (markdown ? escaped(what) : what) + "\n";
  }
  return text;
}

std::string field_of(const Json& value) {
  if (value.is_string()) return value;
  if (value.is_number_integer()) return fmt::format("{}", value.get<std::int64_t>());
  return value.is_number() ? fmt::format("{}", value.get<double>()) : "";
}

Json values_of(const ParameterValue& value) {
  return std::visit([](const auto& typed) { return Json(typed); }, value);
}

const char* status_of_row(const ComparisonRow& row) {
  return row.error ? status_of(row.error->kind()) : "ok";
}

Json json_of(const ComparisonRow& row) {
  Json json = {{"id", row.page->id},
               {"title", row.page->title},
               {"source", row.page->source},
               {"provenance", row.page->provenance},
               {"reconstruction", is_reconstruction(*row.page)},
               {"status", status_of_row(row)},
               {"error", row.error ? to_json(row.error->text()) : Json(nullptr)},
               {"metrics", row.error ? Json(nullptr) : metrics_of(row.result)}};
  json["result"] = row.result;
  // They are the comparison's own.
  if (json["result"].is_object())
    for (const char* shared : {"schema", "schema_version", "status", "scene", "scheme", "engine", "inputs", "config"})
      json["result"].erase(shared);
  return json;
}

}  // namespace

std::string comparison_text(const Comparison& comparison) {
  constexpr std::size_t columns = 110;
  std::string text = fmt::format("{}: {} {} compared\n", comparison.scene->name, comparison.rows.size(),
                                 comparison.rows.size() == 1 ? "scheme" : "schemes") +
                     std::string(columns, '-') + "\n";
  text += conditions_of(comparison) + "\n" + folded("configuration: " + settings_of(comparison), columns);
  if (!is_void(comparison))
    for (const ComparisonTable& table : comparison_tables(comparison)) text += text_of(table);
  return text + failures_of(comparison, "\nFailed\n", "  ", false);
}

std::string comparison_markdown(const Comparison& comparison) {
  std::string text = "# Schemes compared on " + escaped(comparison.scene->name) + "\n\n" + conditions_of(comparison) +
                     "; configuration: " + escaped(settings_of(comparison)) + "\n";
  if (!is_void(comparison))
    for (const ComparisonTable& table : comparison_tables(comparison)) text += markdown_of(table);
  return text + failures_of(comparison, "\n## Failed\n\n", "- ", true);
}

std::string comparison_csv(const Comparison& comparison) {
  std::vector<std::string> header = {"scheme", "provenance", "reconstruction", "status", "error"};
  const Json names = metrics_of(nullptr);
  for (const auto& [name, value] : names.items()) header.push_back(name);
  std::string text = csv_line(header);
  for (const ComparisonRow& row : comparison.rows) {
    std::vector<std::string> fields = {row.page->id, row.page->provenance, is_reconstruction(*row.page) ? "true" : "false",
                                       status_of_row(row), row.error ? row.error->text().what : ""};
    const Json metrics = metrics_of(row.result);
    for (const auto& [name, value] : metrics.items()) fields.push_back(field_of(value));
    text += csv_line(fields);
  }
  return text;
}

std::string comparison_json(const Comparison& comparison, const std::string& version) {
  const Scene& scene = *comparison.scene;
  const ComparisonRow* worst = worst_failure(comparison);
  Json json;
  json["schema"] = comparison_schema;
  json["schema_version"] = comparison_schema_version;
  json["status"] = worst == nullptr ? "ok" : status_of(worst->error->kind());
  json["version"] = version;
  json["scene"] = {{"name", scene.name},
                   {"width", scene.width},
                   {"height", scene.height},
                   {"objects", scene.objects.size()},
                   {"lights", scene.lights.size()},
                   {"warnings", scene.warnings}};
  json["engine"] = comparison.engine;
  json["config_differences"] = Json::array();
  json["config"] = Json::object();
  for (const auto& [key, entry] : comparison.configuration->entries()) {
    const ParameterValue& fallback = comparison.configuration->parameters().find(key)->fallback;
    if (entry.value != fallback)
      json["config_differences"].push_back({{"key", key}, {"value", values_of(entry.value)}, {"default", values_of(fallback)}});
    json["config"][key] = values_of(entry.value);
  }
  json["inputs"] = Json::array();
  for (const Scene::InputFile& input : scene.inputs) json["inputs"].push_back({{"path", input.path}, {"sha256", input.sha256}});
  json["warnings"] = comparison.warnings;
  json["schemes"] = Json::array();
  for (const ComparisonRow& row : comparison.rows) json["schemes"].push_back(json_of(row));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace bump
