// A fit for programs: CSV and JSON.

#include <cmath>
#include <nlohmann/json.hpp>

#include "testbench/experiments/compare.h"
#include "testbench/experiments/compare_tables.h"
#include "testbench/experiments/fit_formats.h"
#include "testbench/experiments/sweep_columns.h"
#include "testbench/results/error_json.h"
#include "testbench/results/text_table.h"

namespace bump {

namespace {

using Json = nlohmann::ordered_json;

/// JSON has no infinities.
Json decibels(double value) {
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return value;
}

Json optional(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

Json table_name(const PriceTable* table) {
  return table != nullptr ? Json(table->name()) : Json();
}

std::string settings_text(const FitRow& row) {
  std::string text;
  for (std::size_t i = 0; i < row.widths.size(); ++i) text += (text.empty() ? "" : " ") + row.keys[i] + "=" + std::to_string(row.widths[i]);
  return text;
}

Json json_of(const ParameterValue& value) {
  return std::visit([](const auto& typed) { return Json(typed); }, value);
}

std::string structure_text(const FitRow& row) {
  std::string text;
  for (const auto& [key, value] : row.taken()) text += (text.empty() ? "" : " ") + key + "=" + value;
  return text;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// Name and value of every column. What identifies a row stands in front of its status.
Json flat_row(const Fit& fit, const FitRow& row) {
  const bool ok = !row.error.has_value(), own = fit.options.against == FitAgainst::own_double;
  const DesignSize& size = row.size;
  const auto number = [ok](auto value) { return ok ? Json(value) : Json(); };
  Json json;
  json["scheme"] = row.page->id;
  json["structure"] = ok ? Json(structure_text(row)) : Json();
  json["widths"] = ok ? Json(settings_text(row)) : Json();
  json["psnr_target_db"] = fit.options.psnr_db;
  json["against"] = name_of(fit.options.against);
  json["cost"] = name_of(fit.options.cost);
  json["status"] = status_of(row);
  json["reconstruction"] = is_reconstruction(*row.page);
  json["psnr_worst_db"] = ok ? decibels(fit.worst(row)) : Json();
  for (std::size_t i = 0; i < fit.scenes.size(); ++i)
    json["psnr_db." + fit.scenes[i]->name] = ok ? decibels(own ? row.qualities[i].to_double : row.qualities[i].to_reference) : Json();
  json["psnr_double_to_reference_worst_db"] = ok ? decibels(row.worst(&FitQuality::double_to_reference)) : Json();
  json["psnr_hardware_to_double_worst_db"] = ok ? decibels(row.worst(&FitQuality::to_double)) : Json();
  json["multipliers"] = number(size.multipliers);
  json["adders"] = number(size.adders);
  json["dividers"] = number(size.dividers);
  json["square_roots"] = number(size.square_roots);
  json["tables"] = number(size.tables);
  json["maps"] = number(size.maps);
  json["table_bits"] = number(size.table_bits);
  json["table_kilobytes"] = number(static_cast<double>(size.table_bits) / 8192);
  json["light_map_kilobytes"] = ok && size.light_map_bytes > 0 ? Json(size.light_map_bytes / 1024) : Json();
  json["texel_bits"] = number(size.texel_bits);
  json["multiplier_cells"] = number(size.multiplier_cells);
  json["other_cells"] = number(size.other_cells);
  json["area_nand2"] = ok ? optional(size.area) : Json();
  json["area_table"] = table_name(fit.options.book.area);
  json["energy_pj_per_fragment"] = ok ? optional(size.energy) : Json();
  json["energy_table"] = table_name(fit.options.book.energy);
  json["designs_measured"] = row.measured;
  json["designs_failed"] = row.failed;
  json["search_complete"] = number(row.complete);
  json["variants_possible"] = number(row.variants.possible);
  json["variants_measured"] = number(row.variants.measured());
  json["upper_bound"] = number(row.is_upper_bound());
  json["least_allowed"] = ok ? Json(joined(row.costly_limits)) : Json();
  json["reason"] = row.error ? Json(reason_of(*row.error)) : Json();
  return json;
}

std::string cell(const Json& value) {
  if (value.is_null()) return "";
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return to_string(ParameterValue(value.get<double>()));
  return value.dump();
}

Json row_json(const Fit& fit, const FitRow& row) {
  Json json = flat_row(fit, row);
  json["chosen"] = Json::array();
  for (std::size_t i = 0; i < row.widths.size(); ++i)
    json["chosen"].push_back({{"key", row.keys[i]}, {"bits", row.widths[i]}, {"least", row.ranges[i].low}, {"most", row.ranges[i].high}});
  json["choices"] = Json::array();
  for (std::size_t i = 0; i < row.structure.size(); ++i) {
    const FitChoice& choice = row.choices[i];
    Json values = Json::array();
    for (const ParameterValue& value : choice.values) values.push_back(json_of(value));
    json["choices"].push_back({{"key", choice.key},
                               {"value", json_of(choice.values[row.structure[i]])},
                               {"given", json_of(choice.values[choice.given])},
                               {"values", values}});
  }
  json["choices_kept"] = Json::array();
  for (const FitStructure::Kept& kept : row.kept) json["choices_kept"].push_back({{"key", kept.key}, {"reason", kept.reason}});
  json["choices_not_searched"] = row.left;
  const VariantCounts& variants = row.variants;
  json["variants"] = {{"possible", variants.possible},
                      {"fitted", variants.fitted},
                      {"fall_short_at_the_widest", variants.falls_short},
                      {"same_picture", variants.same_picture},
                      {"passed_over_as_costlier", variants.costlier},
                      {"contradictory_or_equal", variants.contradictory}};
  json["least_allowed_without_cost"] = row.idle_limits;
  json["set"] = row.set;
  json["without_effect"] = row.idle;
  json["scenes"] = Json::array();
  for (std::size_t i = 0; i < row.qualities.size(); ++i)
    json["scenes"].push_back({{"name", fit.scenes[i]->name},
                              {"psnr_hardware_to_reference_db", decibels(row.qualities[i].to_reference)},
                              {"psnr_hardware_to_double_db", decibels(row.qualities[i].to_double)},
                              {"psnr_double_to_reference_db", decibels(row.qualities[i].double_to_reference)}});
  json["error"] = row.error ? to_json(row.error->text()) : Json();
  return json;
}

Json price_json(const PriceTable* table, Quantity quantity) {
  if (table == nullptr) return nullptr;
  return {{"name", table->name()}, {"title", table->title()}, {"unit", unit_of(quantity)}, {"accuracy", table->accuracy(quantity)}};
}

}  // namespace

std::string status_of(const FitRow& row) {
  if (row.error) return status_of(row.error->kind());
  return row.reached ? "reached" : "not_reached";
}

std::string fit_csv(const Fit& fit) {
  std::string text;
  for (const FitRow& row : fit.rows) {
    std::vector<std::string> header, cells;
    const Json json = flat_row(fit, row);
    for (const auto& [name, value] : json.items()) {
      header.push_back(name);
      cells.push_back(cell(value));
    }
    if (text.empty()) text = csv_line(header);
    text += csv_line(cells);
  }
  return text;
}

std::string fit_json(const Fit& fit, const std::string& version) {
  Json json = {{"schema", fit_schema}, {"schema_version", fit_schema_version}, {"version", version}};
  json["psnr_target_db"] = fit.options.psnr_db;
  json["against"] = name_of(fit.options.against);
  json["cost"] = name_of(fit.options.cost);
  json["limit"] = fit.options.limit;
  json["structure_searched"] = fit.options.search_structure;
  json["prices"] = {{"area", price_json(fit.options.book.area, Quantity::area)},
                    {"energy", price_json(fit.options.book.energy, Quantity::energy)}};
  json["scenes"] = Json::array();
  for (const Scene* scene : fit.scenes) {
    Json inputs = Json::array();
    for (const Scene::InputFile& input : scene->inputs) inputs.push_back({{"path", input.path}, {"sha256", input.sha256}});
    json["scenes"].push_back({{"name", scene->name}, {"width", scene->width}, {"height", scene->height}, {"inputs", inputs}});
  }
  json["settings"] = Json::object();
  for (const auto& [key, value, fallback] : differences_of(*fit.configuration)) json["settings"][key] = value;
  json["rows"] = Json::array();
  for (const FitRow& row : fit.rows) json["rows"].push_back(row_json(fit, row));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace bump
