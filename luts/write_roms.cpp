#include "luts/write_roms.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "datapath/error.h"
#include "datapath/invariant.h"
#include "datapath/sha256.h"
#include "luts/rom_error.h"
#include "luts/rom_folder.h"
#include "luts/rom_image.h"

namespace bump {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* manifest_name = "manifest.json";

const char* name_of(Folding folding) {
  switch (folding) {
    case Folding::none:
      return "none";
    case Folding::magnitude:
      return "magnitude";
    case Folding::quarter:
      return "quarter";
    case Folding::floating:
      return "floating";
  }
  return "";
}

std::string file_name(const std::string& scheme, const std::string& table) {
  std::string name = scheme + "_" + table + ".hex";
  for (char& c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '.';
    if (!plain) c = '_';
  }
  return name;
}

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json describe_column(const Table& table, const Column& column, int& low_bit, const ColumnError& error) {
  Json json;
  json["name"] = column.name;
  json["format"] = to_string(column.format);
  if (column.mirrors_first) {
    json["mirrors"] = table.columns.front().name;
  } else {
    low_bit -= table.stored_width(column);
    json["stored_bits"] = table.stored_width(column);
    json["low_bit"] = low_bit;
  }
  if (table.folding == Folding::magnitude || table.folding == Folding::quarter) json["odd_about_zero"] = column.symmetry.odd_about_zero;
  if (table.folding == Folding::quarter) json["odd_about_quarter"] = column.symmetry.odd_about_quarter;
  json["max_error"] = number(error.largest);
  json["max_error_in_range"] = number(error.largest_in_range);
  json["codes_out_of_range"] = error.out_of_range;
  return json;
}

Json describe(const Table& table, const TableContents& contents) {
  const RomError error = rom_error(table, contents);
  Json json;
  json["formula"] = table.formula;
  json["index"] = to_string(table.index);
  json["folding"] = name_of(table.folding);
  json["address_bits"] = table.address_bits;
  if (table.folding == Folding::floating) {
    json["exponent_bits"] = table.exponent_bits;
    json["min_exponent"] = table.min_exponent;
  }
  json["entries"] = table.entries();
  json["word_bits"] = table.word_bits();
  json["bits"] = table.bits();
  json["per_material"] = table.per_material;
  json["map"] = table.is_map();
  for (const MapField& field : table.fields)
    json["fields"].push_back({{"index", to_string(field.index)}, {"address_bits", field.address_bits}});
  json["codes_checked"] = error.codes;
  json["all_codes_checked"] = error.all_codes;
  int low_bit = table.word_bits();
  json["columns"] = Json::array();
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    json["columns"].push_back(describe_column(table, table.columns[i], low_bit, error.columns[i]));
  return json;
}

bool is_real(const Table& table) {
  return table.index.is_real ||
         std::any_of(table.fields.begin(), table.fields.end(), [](const MapField& field) { return field.index.is_real; }) ||
         std::any_of(table.columns.begin(), table.columns.end(), [](const Column& column) { return column.format.is_real; });
}

/// All readers of one table of one scheme.
struct Rom {
  TablePtr table;
  std::set<std::string> units;
  std::string image;
};

std::map<std::pair<std::string, std::string>, Rom> collect(const std::vector<RomSource>& sources) {
  std::map<std::pair<std::string, std::string>, Rom> roms;
  for (const RomSource& source : sources) {
    BUMP_ASSERT(source.table != nullptr);
    if (is_real(*source.table)) continue;
    Rom& rom = roms[{source.scheme, source.table->name}];
    rom.units.insert(source.unit);
    if (rom.table == source.table) continue;
    std::string image = rom_image(*source.table, tabulate(*source.table));
    if (rom.table && image != rom.image)
      throw Error(ErrorKind::internal,
                  {"scheme '" + source.scheme + "' has two tables called '" + source.table->name + "' with different words",
                   {},
                   "a table's name is the name of its ROM image",
                   ""});
    if (rom.table) continue;
    rom.table = source.table;
    rom.image = std::move(image);
  }
  return roms;
}

}  // namespace

std::map<std::string, std::string> rom_files(const std::vector<RomSource>& sources) {
  std::map<std::string, std::string> files;
  Json manifest;
  manifest["schema"] = "bumpsim-roms/1";
  manifest["roms"] = Json::array();
  for (const auto& [key, rom] : collect(sources)) {
    const std::string name = file_name(key.first, key.second);
    if (!files.emplace(name, rom.image).second)
      throw Error(ErrorKind::internal,
                  {"two tables would be written to '" + name + "'", {}, "", "table names that differ in letters, digits, '_', '-' or '.'"});
    Json json;
    json["image"] = name;
    json["scheme"] = key.first;
    json["units"] = rom.units;
    json["table"] = key.second;
    json.update(describe(*rom.table, tabulate(*rom.table)));
    json["sha256"] = sha256_hex(rom.image.data(), rom.image.size());
    manifest["roms"].push_back(std::move(json));
  }
  files[manifest_name] = manifest.dump(2) + "\n";
  return files;
}

void write_roms(const std::vector<RomSource>& sources, const std::string& folder) {
  write_rom_folder(rom_files(sources), manifest_name, folder);
}

std::vector<std::string> outdated_roms(const std::vector<RomSource>& sources, const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& [name, contents] : rom_files(sources)) {
    std::ifstream file(std::filesystem::path(folder) / name, std::ios::binary);
    const std::string held{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (!file.is_open() || held != contents) names.push_back(name);
  }
  return names;
}

}  // namespace bump
