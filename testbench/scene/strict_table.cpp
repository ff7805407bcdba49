#include "testbench/scene/strict_table.h"

#include <algorithm>
#include <cmath>

#include "channels/parameters.h"

namespace bump {

namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string list;
  for (const auto& word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}

std::string range(double low, double high) {
  return to_string(ParameterValue(low)) + " to " + to_string(ParameterValue(high));
}

std::string given(const TomlValue& value) {
  switch (value.kind) {
    case TomlValue::Kind::boolean:
      return value.boolean ? "true" : "false";
    case TomlValue::Kind::integer:
      return std::to_string(value.integer);
    case TomlValue::Kind::number:
      return to_string(ParameterValue(value.number));
    case TomlValue::Kind::text:
      return "'" + value.text + "'";
    default:
      return kind_name(value.kind);
  }
}

/// The nearest value that is allowed, as it would be written.
std::string allowed(const TomlValue& value, double low, double high, bool whole) {
  const double nearest = std::clamp(value.is_number() && !std::isnan(value.number) ? value.number : 0, low, high);
  return whole ? std::to_string(static_cast<long>(nearest)) : to_string(ParameterValue(nearest));
}

std::string allowed_list(const TomlValue& list, double low, double high, bool whole) {
  std::vector<std::string> items;
  for (const auto& item : list.items) items.push_back(allowed(item, low, high, whole));
  return "[" + joined(items) + "]";
}

}  // namespace

StrictTable::StrictTable(const TomlValue& value, std::string name, std::vector<std::string> keys) : value_(value), name_(std::move(name)) {
  if (value.kind != TomlValue::Kind::table) {
    throw Error({name_ + " is " + kind_name(value.kind), value.where, "it has keys of its own: " + joined(keys), "[" + name_ + "]"});
  }
  for (const auto& entry : value.entries) {
    if (std::find(keys.begin(), keys.end(), entry.key) != keys.end()) continue;
    const std::string near = nearest_word(entry.key, keys);
    throw Error({"unknown key '" + entry.key + "' in " + name_, entry.where, name_ + " has the keys " + joined(keys), near});
  }
}

Location StrictTable::where(const std::string& key) const {
  const TomlEntry* entry = value_.find(key);
  return entry == nullptr ? value_.where : entry->value.where;
}

std::string StrictTable::full_name(const std::string& key) const {
  return name_.rfind("the ", 0) == 0 ? key : name_ + "." + key;
}

const TomlValue* StrictTable::find(const std::string& key) const {
  const TomlEntry* entry = value_.find(key);
  return entry == nullptr ? nullptr : &entry->value;
}

void StrictTable::reject(const std::string& key, const std::string& problem, const std::string& why, const std::string& try_this) const {
  throw Error({full_name(key) + " " + problem, where(key), why, try_this});
}

const TomlValue& StrictTable::required(const std::string& key) const {
  const TomlEntry* entry = value_.find(key);
  if (entry == nullptr) throw Error({name_ + " has no '" + key + "'", value_.where, "there is no default for it", key + " = ..."});
  return entry->value;
}

double StrictTable::checked(const std::string& key, const TomlValue& value, double low, double high, bool whole,
                            const TomlValue* list) const {
  const std::string full = full_name(key);
  const std::string wanted = whole ? "a whole number" : "a number";
  const std::string advice = list != nullptr ? key + " = " + allowed_list(*list, low, high, whole) : wanted + " from " + range(low, high);
  if (!value.is_number() || (whole && value.kind != TomlValue::Kind::integer)) {
    throw Error({full + " cannot be " + given(value), value.where, "it takes " + wanted + (list != nullptr ? "s" : ""), advice});
  }
  if (!std::isfinite(value.number)) throw Error({full + " is " + given(value), value.where, "it must be finite", advice});
  if (value.number < low || value.number > high) {
    throw Error({full + " = " + given(value) + " is out of range", value.where, "allowed " + range(low, high),
                 key + " = " + (list != nullptr ? allowed_list(*list, low, high, whole) : allowed(value, low, high, whole))});
  }
  return value.number;
}

double StrictTable::number(const std::string& key, double low, double high) const {
  return checked(key, required(key), low, high, false);
}

double StrictTable::number(const std::string& key, double fallback, double low, double high) const {
  return has(key) ? number(key, low, high) : fallback;
}

int StrictTable::integer(const std::string& key, int fallback, int low, int high) const {
  return has(key) ? static_cast<int>(checked(key, required(key), low, high, true)) : fallback;
}

glm::dvec3 StrictTable::vector(const std::string& key, double low, double high) const {
  const TomlValue& value = required(key);
  if (value.kind != TomlValue::Kind::array || value.items.size() != 3) {
    reject(key, "must be a list of three numbers",
           value.kind == TomlValue::Kind::array ? "it has " + std::to_string(value.items.size()) : "it is " + kind_name(value.kind),
           key + " = [0.0, 0.0, 1.0]");
  }
  return glm::dvec3(checked(key, value.items[0], low, high, false, &value), checked(key, value.items[1], low, high, false, &value),
                    checked(key, value.items[2], low, high, false, &value));
}

glm::dvec3 StrictTable::vector(const std::string& key, const glm::dvec3& fallback, double low, double high) const {
  return has(key) ? vector(key, low, high) : fallback;
}

std::pair<double, double> StrictTable::pair(const std::string& key, std::pair<double, double> fallback, double low, double high) const {
  const TomlValue* value = find(key);
  if (value == nullptr) return fallback;
  if (value->kind != TomlValue::Kind::array) {
    const double both = checked(key, *value, low, high, false);
    return {both, both};
  }
  if (value->items.size() != 2) reject(key, "must be one number or a list of two", "", key + " = [1.0, 1.0]");
  return {checked(key, value->items[0], low, high, false, value), checked(key, value->items[1], low, high, false, value)};
}

std::pair<int, int> StrictTable::integer_pair(const std::string& key, std::pair<int, int> fallback, int low, int high) const {
  const TomlValue* value = find(key);
  if (value == nullptr) return fallback;
  if (value->kind != TomlValue::Kind::array) {
    const int both = static_cast<int>(checked(key, *value, low, high, true));
    return {both, both};
  }
  if (value->items.size() != 2) reject(key, "must be one whole number or a list of two", "", key + " = [64, 32]");
  return {static_cast<int>(checked(key, value->items[0], low, high, true, value)),
          static_cast<int>(checked(key, value->items[1], low, high, true, value))};
}

std::string StrictTable::text(const std::string& key) const {
  const TomlValue& value = required(key);
  if (value.kind != TomlValue::Kind::text) reject(key, "cannot be " + given(value), "it takes a text", key + " = \"...\"");
  if (value.text.empty()) reject(key, "is an empty text", "", key + " = \"...\"");
  return value.text;
}

std::string StrictTable::checked_word(const std::string& key, const TomlValue& value, const std::vector<std::string>& words) const {
  if (value.kind == TomlValue::Kind::text && std::find(words.begin(), words.end(), value.text) != words.end()) return value.text;
  const std::string near = value.kind == TomlValue::Kind::text ? nearest_word(value.text, words) : "";
  reject(key, "cannot be " + given(value), "allowed " + joined(words), key + " = \"" + (near.empty() ? words.front() : near) + "\"");
}

std::string StrictTable::word(const std::string& key, const std::vector<std::string>& words) const {
  const TomlValue* value = find(key);
  return value == nullptr ? words.front() : checked_word(key, *value, words);
}

std::pair<std::string, std::string> StrictTable::word_pair(const std::string& key, std::pair<std::string, std::string> fallback,
                                                           const std::vector<std::string>& words) const {
  const TomlValue* value = find(key);
  if (value == nullptr) return fallback;
  if (value->kind != TomlValue::Kind::array) {
    const std::string both = checked_word(key, *value, words);
    return {both, both};
  }
  if (value->items.size() != 2) reject(key, "must be one word or a list of two", "", key + " = [\"repeat\", \"clamp\"]");
  return {checked_word(key, value->items[0], words), checked_word(key, value->items[1], words)};
}

}  // namespace bump
