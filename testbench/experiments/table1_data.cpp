// Table 1 for programs: CSV and JSON.

#include <cmath>
#include <nlohmann/json.hpp>

#include "testbench/experiments/table1_formats.h"
#include "testbench/published/lee2007_table1.h"
#include "testbench/results/text_table.h"

namespace bump {

namespace {

using Json = nlohmann::ordered_json;

Json number(const std::optional<double>& value) {
  if (!value) return nullptr;
  const double hundredths = std::round(100 * *value) / 100;
  if (hundredths == std::floor(hundredths)) return static_cast<std::int64_t>(hundredths);
  return hundredths;
}

Json cell(const Table1Value& value) {
  Json json = {{"published", number(value.published)},
               {"derived", number(value.derived)},
               {"difference", number(value.difference())},
               {"unit", value.unit}};
  if (!value.why.empty()) json["why"] = value.why;
  return json;
}

const char* name_of(Table1Kind kind) {
  switch (kind) {
    case Table1Kind::step:
      return "step";
    case Table1Kind::addition:
      return "addition";
    case Table1Kind::reading:
      return "reading";
    case Table1Kind::total:
      return "total";
    case Table1Kind::other:
      return "other";
  }
  return "";
}

Json row_json(const Table1Row& row) {
  Json json = {{"scheme", row.scheme}, {"step", row.step}};
  if (row.section == Table1Section::operators) json["kind"] = name_of(row.kind);
  if (!row.settings.empty()) json["settings"] = row.settings;
  json["reconstruction"] = row.reconstruction;
  json["agreement"] = row.agreement;
  if (!row.source.empty()) json["source"] = row.source;
  if (!row.why.empty()) json["why"] = row.why;
  for (const Table1Value& value : row.values) json["cells"][value.quantity] = cell(value);
  return json;
}

Json scheme_json(const Table1Scheme& scheme) {
  const auto text = [](const std::string& value) { return value.empty() ? Json(nullptr) : Json(value); };
  return {{"scheme", scheme.id},
          {"column", text(scheme.column)},
          {"modelled", scheme.modelled},
          {"title", text(scheme.title)},
          {"source", text(scheme.source)},
          {"provenance", text(scheme.provenance)},
          {"reconstruction", !scheme.reconstructed.empty()},
          {"reconstructed_steps", Json(scheme.reconstructed)},
          {"configured", Json(scheme.configured)}};
}

}  // namespace

std::string table1_number(double value) {
  return number(value).dump();
}

std::string table1_json(const Table1& table) {
  Json json = {{"schema", "bumpsim-table1"}, {"schema_version", table1_json_version}, {"status", "ok"}, {"settings", Json(table.settings)}};
  json["schemes"] = Json::array();
  for (const Table1Scheme& scheme : table.schemes) json["schemes"].push_back(scheme_json(scheme));
  for (const Table1Section section : {Table1Section::operators, Table1Section::text, Table1Section::storage, Table1Section::text_sizes,
                                      Table1Section::reduction, Table1Section::claim, Table1Section::beyond})
    json[bump::name_of(section)] = Json::array();
  for (const Table1Row& row : table.rows) json[bump::name_of(row.section)].push_back(row_json(row));
  return json.dump(2) + "\n";
}

std::string table1_csv(const Table1& table) {
  std::string text = csv_line({"section", "scheme", "step", "kind", "settings", "quantity", "unit", "derived", "published", "difference",
                               "reconstruction", "agreement", "why"});
  const auto field = [](const std::optional<double>& value) { return value ? table1_number(*value) : std::string(); };
  for (const Table1Row& row : table.rows)
    for (const Table1Value& value : row.values)
      text += csv_line({bump::name_of(row.section), row.scheme, row.step, name_of(row.kind), row.settings, value.quantity, value.unit,
                        field(value.derived), field(value.published), field(value.difference()), row.reconstruction ? "true" : "false",
                        row.agreement, value.why.empty() ? row.why : value.why});
  return text;
}

}  // namespace bump
