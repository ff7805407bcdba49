#include "testbench/experiments/price_table.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "channels/parameters.h"
#include "testbench/scene/input_files.h"
#include "testbench/scene/strict_table.h"

namespace bump {

namespace {

constexpr std::array<const char*, 5> form_names = {"constant", "linear", "product", "power", "excluded"};
constexpr double largest_coefficient = 1e12;

/// Factor from the unit that a section is written in to the unit of totals.
double unit_factor(Quantity quantity, const StrictTable& section) {
  if (!section.has("unit")) section.reject("unit", "is missing", "prices have a unit", fmt::format("unit = \"{}\"", unit_of(quantity)));
  if (quantity == Quantity::area) {
    section.word("unit", {"NAND2"});
    return 1;
  }
  const std::string unit = section.word("unit", {"pJ", "fJ", "nJ"});
  return unit == "pJ" ? 1 : unit == "fJ" ? 1e-3 : 1e3;
}

std::vector<std::string> component_names() {
  std::vector<std::string> names;
  for (int i = 0; i < static_cast<int>(Component::count); ++i) names.emplace_back(name_of(static_cast<Component>(i)));
  return names;
}

Component component_of(Quantity quantity, const TomlEntry& entry) {
  const std::vector<std::string> names = component_names();
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] != entry.key) continue;
    const auto component = static_cast<Component>(i);
    if (quantity == Quantity::area && group_of(component) == CostGroup::memory)
      throw Error(
          {"area." + entry.key + " has no meaning", entry.where, "areas of caches and memories are not priced", "energy." + entry.key});
    return component;
  }
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  throw Error({fmt::format("unknown component '{}' in {}", entry.key, name_of(quantity)), entry.where, "the components are: " + list,
               nearest_word(entry.key, names)});
}

/// Keys that an entry of this form has, by size and apart from them.
std::vector<std::string> keys_of(PriceEntry::Form form, Component component) {
  std::vector<std::string> keys = {"form", "source", "technology", "accuracy", "rule"};
  const auto for_each_size = [&](const std::string& prefix) {
    for (const std::string& size : sizes_of(component)) keys.push_back(prefix + size);
  };
  switch (form) {
    case PriceEntry::Form::constant:
      keys.push_back("value");
      break;
    case PriceEntry::Form::linear:
      keys.push_back("base");
      for_each_size("per_");
      break;
    case PriceEntry::Form::product:
      keys.insert(keys.end(), {"base", "coefficient"});
      for_each_size("per_");
      break;
    case PriceEntry::Form::power:
      keys.push_back("coefficient");
      for_each_size("reference_");
      for_each_size("exponent_");
      break;
    case PriceEntry::Form::excluded:
      return {"form", "reason"};
  }
  return keys;
}

PriceEntry::Form form_of(const TomlValue& value, const std::string& name, Component component) {
  const TomlEntry* form = value.kind == TomlValue::Kind::table ? value.find("form") : nullptr;
  const StrictTable probe(value, name, [&] {
    std::vector<std::string> keys;  // every key of any form: which ones belong is checked when the form is known
    for (int f = 0; f < static_cast<int>(form_names.size()); ++f)
      for (const std::string& key : keys_of(static_cast<PriceEntry::Form>(f), component))
        if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
    return keys;
  }());
  const std::vector<std::string> words(form_names.begin(), form_names.end());
  if (form == nullptr) probe.reject("form", "is missing", "it says how the price follows from the sizes", "form = \"linear\"");
  const std::string word = probe.word("form", words);
  for (std::size_t i = 0; i < words.size(); ++i)
    if (words[i] == word) return static_cast<PriceEntry::Form>(i);
  return PriceEntry::Form::constant;
}

/// A linear or product form whose coefficients are all zero, or absent, prices nothing.
bool is_nothing(const PriceEntry& entry) {
  return entry.base == 0 && entry.coefficient == 0 && entry.per == PriceSizes{};
}

PriceEntry read_entry(const TomlValue& value, const std::string& name, Component component, double factor, const std::string& technology) {
  PriceEntry entry;
  entry.form = form_of(value, name, component);
  entry.where = value.where;
  const StrictTable table(value, name, keys_of(entry.form, component));
  if (entry.is_excluded()) {
    entry.reason = table.text("reason");
    return entry;
  }
  entry.source = table.text("source");
  entry.accuracy = table.text("accuracy");
  entry.technology = table.has("technology") ? table.text("technology") : technology;
  if (table.has("rule")) entry.rule = table.text("rule");
  const std::vector<std::string>& sizes = sizes_of(component);
  if (entry.form == PriceEntry::Form::product && sizes.size() < 2)
    table.reject("form", "cannot be a product", fmt::format("{} has fewer than two sizes", name_of(component)),
                 "form = \"linear\" or \"power\"");
  const double top = largest_coefficient;
  if (entry.form == PriceEntry::Form::constant) entry.base = factor * table.number("value", 0, top);
  if (entry.form == PriceEntry::Form::linear || entry.form == PriceEntry::Form::product) {
    entry.base = factor * table.number("base", 0.0, -top, top);
    for (std::size_t i = 0; i < sizes.size(); ++i) entry.per[i] = factor * table.number("per_" + sizes[i], 0.0, -top, top);
  }
  if (entry.form == PriceEntry::Form::product || entry.form == PriceEntry::Form::power)
    entry.coefficient = factor * table.number("coefficient", 0, top);
  if (entry.form == PriceEntry::Form::power) {
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      entry.reference[i] = table.number("reference_" + sizes[i], 1.0, 1e-6, top);
      entry.exponent[i] = table.number("exponent_" + sizes[i], 0.0, -8, 8);
    }
  }
  if (is_nothing(entry))
    throw Error({name + " is a price of nothing", value.where, "a component that is left out is excluded, with a reason",
                 "form = \"excluded\" and reason = \"...\""});
  return entry;
}

std::string number(double value) {
  return fmt::format("{:.5g}", value);
}

}  // namespace

const char* name_of(Quantity quantity) {
  return quantity == Quantity::area ? "area" : "energy";
}
const char* unit_of(Quantity quantity) {
  return quantity == Quantity::area ? "NAND2" : "pJ";
}

double PriceEntry::at(const PriceSizes& sizes) const {
  double price = coefficient;
  double sum = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) sum += per[i] * sizes[i];
  switch (form) {
    case Form::constant:
      return base;
    case Form::linear:
      return base + sum;
    case Form::product:
      return base + coefficient * sizes[0] * sizes[1] + sum;
    case Form::power:
      for (std::size_t i = 0; i < sizes.size(); ++i)
        if (exponent[i] != 0) price *= std::pow(sizes[i] / reference[i], exponent[i]);
      return price;
    case Form::excluded:
      return 0;
  }
  return 0;
}

std::string formula(const PriceEntry& entry, Component component) {
  const std::vector<std::string>& sizes = sizes_of(component);
  std::string text;
  const auto plus = [&](const std::string& term) { text += (text.empty() ? "" : " + ") + term; };
  if (entry.is_excluded()) return "excluded";
  if (entry.form == PriceEntry::Form::power) {
    text = number(entry.coefficient);
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      if (entry.exponent[i] == 0) continue;
      const std::string base = entry.reference[i] == 1 ? sizes[i] : "(" + sizes[i] + "/" + number(entry.reference[i]) + ")";
      text += " " + base + (entry.exponent[i] == 1 ? "" : "^" + number(entry.exponent[i]));
    }
    return text;
  }
  if (entry.base != 0) plus(number(entry.base));
  if (entry.form == PriceEntry::Form::product) {
    std::string product = number(entry.coefficient);
    for (std::size_t i = 0; i < sizes.size() && i < 2; ++i) product += " " + sizes[i];
    plus(product);
  }
  for (std::size_t i = 0; i < sizes.size(); ++i)
    if (entry.per[i] != 0) plus(number(entry.per[i]) + " " + sizes[i]);
  return text;
}

PriceTable::PriceTable(const std::string& text, const std::string& file, std::string name) : file_(file), name_(std::move(name)) {
  const TomlValue document = parse_toml(text, file);
  const StrictTable top(document, "the price table", {"title", "technology", "source", "area", "energy"});
  title_ = top.text("title");
  technology_ = top.text("technology");
  source_ = top.text("source");
  for (const Quantity quantity : {Quantity::area, Quantity::energy}) {
    const TomlValue* value = top.find(name_of(quantity));
    if (value == nullptr) continue;
    std::vector<std::string> keys = component_names();
    keys.insert(keys.end(), {"unit", "accuracy"});
    if (value->kind == TomlValue::Kind::table)
      for (const TomlEntry& entry : value->entries)
        if (entry.key != "unit" && entry.key != "accuracy") component_of(quantity, entry);
    const StrictTable section(*value, name_of(quantity), keys);
    const double factor = unit_factor(quantity, section);
    Section& into = sections_[static_cast<std::size_t>(quantity)];
    into.accuracy = section.text("accuracy");
    for (const TomlEntry& entry : value->entries) {
      if (entry.key == "unit" || entry.key == "accuracy") continue;
      const Component component = component_of(quantity, entry);
      const std::string path = std::string(name_of(quantity)) + "." + entry.key;
      into.entries.emplace(component, read_entry(entry.value, path, component, factor, technology_));
    }
  }
  if (!prices(Quantity::area) && !prices(Quantity::energy))
    throw Error({"the table prices nothing", Location(file), "it has neither areas nor energies", "[area.adder] or [energy.adder], ..."});
}

Component PriceTable::entry_component(Quantity quantity, Component component) const {
  const auto& entries = section(quantity).entries;
  if (entries.count(component) == 0 && entries.count(general(component)) > 0) return general(component);
  return component;
}

const PriceEntry* PriceTable::find(Quantity quantity, Component component) const {
  const auto& entries = section(quantity).entries;
  const auto found = entries.find(entry_component(quantity, component));
  return found == entries.end() ? nullptr : &found->second;
}

const PriceEntry& PriceTable::at(Quantity quantity, Component component, const std::string& who) const {
  if (const PriceEntry* entry = find(quantity, component)) return *entry;
  const std::string path = std::string(name_of(quantity)) + "." + name_of(general(component));
  throw Error({"price table '" + name_ + "' has no " + path, Location(file_), "needed by " + who,
               "add [" + path + "], or choose another table with --prices"});
}

PriceTable read_price_table(const std::string& path) {
  return PriceTable(read_bytes(path, "price table"), path, std::filesystem::path(path).stem().string());
}

PriceBook make_price_book(const std::vector<PriceTable>& tables) {
  PriceBook book;
  for (const PriceTable& table : tables) {
    if (book.area == nullptr && table.prices(Quantity::area)) book.area = &table;
    if (book.energy == nullptr && table.prices(Quantity::energy)) book.energy = &table;
  }
  return book;
}

}  // namespace bump
