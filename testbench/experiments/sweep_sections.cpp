#include "testbench/experiments/sweep_sections.h"

#include <algorithm>

#include "schemes/scheme.h"
#include "testbench/experiments/sweep_random.h"

namespace bump {

namespace {

constexpr const char* own_keys[] = {scene_key, scheme_key, width_key, height_key};

bool is_own(const std::string& key) {
  return std::any_of(std::begin(own_keys), std::end(own_keys), [&](const char* own) { return key == own; });
}

bool is_side(const std::string& key) {
  return key == width_key || key == height_key;
}

bool is_range(const TomlValue& value) {
  return value.find("low") != nullptr || value.find("high") != nullptr;
}

ParameterValue plain_value(const SweepKeys::Leaf& leaf, const TomlValue& given) {
  switch (given.kind) {
    case TomlValue::Kind::boolean:
      return given.boolean;
    case TomlValue::Kind::integer:
      return given.integer;
    case TomlValue::Kind::number:
      return given.number;
    case TomlValue::Kind::text:
      return given.text;
    default:
      throw Error({leaf.key + " cannot be " + kind_name(given.kind), given.where, "one value is expected here", leaf.key + " = one value"});
  }
}

std::string scheme_called(const ParameterValue& given, const Location& where) {
  std::vector<std::string> ids;
  std::string list;
  for (const Scheme* scheme : all_schemes()) {
    ids.push_back(scheme->page().id);
    list += (list.empty() ? "" : ", ") + scheme->page().id;
  }
  const auto* id = std::get_if<std::string>(&given);
  if (id != nullptr && std::find(ids.begin(), ids.end(), *id) != ids.end()) return *id;
  const std::string near = id != nullptr ? nearest_word(*id, ids) : "";
  throw Error(
      {"unknown scheme '" + to_string(given) + "'", where, "the schemes are: " + list, near.empty() ? "bumpsim list schemes" : near});
}

std::vector<Assignments> grid_points(const TomlEntry& section, SweepKeys& keys) {
  std::vector<Assignments> points = {{}};
  for (const SweepKeys::Leaf& axis : keys.leaves(section.value, {}, false)) {
    const std::vector<ParameterValue> values = keys.values(axis);
    if (points.size() > most_sweep_points / values.size()) refuse_size(axis.where);
    std::vector<Assignments> product;
    for (const Assignments& point : points)
      for (const ParameterValue& value : values) {
        product.push_back(point);
        product.back().push_back({axis.key, value});
      }
    points = std::move(product);
  }
  return points;
}

std::vector<Assignments> listed_points(const TomlEntry& section, SweepKeys& keys) {
  Assignments point;
  for (const SweepKeys::Leaf& leaf : keys.leaves(section.value, {}, false)) point.push_back({leaf.key, keys.value(leaf, *leaf.value)});
  return {point};
}

std::vector<Assignments> single_factors(const TomlEntry& section, SweepKeys& keys) {
  std::vector<Assignments> points = {{}};
  for (const SweepKeys::Leaf& factor : keys.leaves(section.value, {}, false))
    for (const ParameterValue& value : keys.values(factor)) points.push_back({{factor.key, value}});
  return points;
}

std::int64_t whole_number(const TomlEntry& section, const char* key, std::int64_t fallback, std::int64_t low, std::int64_t high) {
  const TomlEntry* entry = section.value.find(key);
  if (entry == nullptr) return fallback;
  if (entry->value.kind == TomlValue::Kind::integer && entry->value.integer >= low && entry->value.integer <= high)
    return entry->value.integer;
  throw Error({std::string("random.") + key + " must be a whole number from " + std::to_string(low) + " to " + std::to_string(high),
               entry->value.where, "", std::string(key) + " = " + std::to_string(std::max<std::int64_t>(low, 1))});
}

/// { low, high, scale } of a key that takes numbers.
RandomRange range_of(const SweepKeys::Leaf& leaf, SweepKeys& keys) {
  RandomRange range;
  const TomlValue& table = *leaf.value;
  if (!keys.is_numeric(leaf.key, range.whole))
    throw Error({leaf.key + " takes no numbers, so that it has no range", table.where, "", leaf.key + " = [\"...\", \"...\"]"});
  for (const TomlEntry& entry : table.entries)
    if (entry.key != "low" && entry.key != "high" && entry.key != "scale")
      throw Error({"unknown key '" + entry.key + "' in a range", entry.where, "a range has low, high and scale",
                   nearest_word(entry.key, {"low", "high", "scale"})});
  for (const char* end : {"low", "high"}) {
    const TomlEntry* entry = table.find(end);
    if (entry == nullptr) throw Error({"the range of " + leaf.key + " has no '" + end + "'", table.where, "", "{ low = 1, high = 100 }"});
    const ParameterValue value = keys.value(leaf, entry->value);
    const auto* whole = std::get_if<std::int64_t>(&value);
    (end[0] == 'l' ? range.low : range.high) = whole != nullptr ? static_cast<double>(*whole) : std::get<double>(value);
  }
  if (range.low > range.high)
    throw Error({"the range of " + leaf.key + " ends before it begins", table.where, "low is above high", "swap them"});
  if (const TomlEntry* scale = table.find("scale")) {
    const bool known = scale->value.kind == TomlValue::Kind::text && (scale->value.text == "linear" || scale->value.text == "log");
    if (!known) throw Error({"unknown scale of " + leaf.key, scale->value.where, "the scales are: linear, log", "scale = \"log\""});
    range.logarithmic = scale->value.text == "log";
  }
  if (range.logarithmic && range.low <= 0)
    throw Error({"a logarithmic range of " + leaf.key + " cannot begin at " + to_string(ParameterValue(range.low)), table.where,
                 "it must be above 0", "low = 1, or scale = \"linear\""});
  return range;
}

std::vector<Assignments> random_points(const TomlEntry& section, SweepKeys& keys) {
  if (section.value.find("count") == nullptr)
    throw Error({"random has no 'count'", section.where, "it says how many points are drawn", "count = 100"});
  const auto count = static_cast<std::size_t>(whole_number(section, "count", 1, 1, static_cast<std::int64_t>(most_sweep_points)));
  const auto seed = static_cast<std::uint64_t>(whole_number(section, "seed", 1, 0, std::int64_t{1} << 53));
  std::vector<Assignments> points(count);
  for (const SweepKeys::Leaf& leaf : keys.leaves(section.value, {"seed", "count"}, true)) {
    const RandomDraws draws(seed, leaf.key);
    if (leaf.value->kind == TomlValue::Kind::table) {
      const RandomRange range = range_of(leaf, keys);
      for (std::size_t i = 0; i < count; ++i)
        points[i].push_back({leaf.key, keys.value(leaf, draws.in_range(i, range), leaf.value->where)});
    } else {
      const std::vector<ParameterValue> values = keys.values(leaf);
      for (std::size_t i = 0; i < count; ++i) points[i].push_back({leaf.key, values[draws.below(i, values.size())]});
    }
  }
  return points;
}

}  // namespace

void refuse_size(const Location& where) {
  throw Error({"the sweep has more than " + std::to_string(most_sweep_points) + " points", where,
               "a grid is the product of all its lists, and all scenes and schemes multiply it", "fewer values, or several sweeps"});
}

std::vector<SweepKeys::Leaf> SweepKeys::leaves(const TomlValue& table, const std::vector<std::string>& skipped, bool ranges) const {
  std::vector<Leaf> found;
  for (const TomlEntry& entry : table.entries) {
    if (std::find(skipped.begin(), skipped.end(), entry.key) != skipped.end()) continue;
    const bool is_leaf = entry.value.kind != TomlValue::Kind::table || (ranges && is_range(entry.value)) ||
                         parameters().find(entry.key) != nullptr || entry.value.entries.empty();
    if (is_leaf) {
      found.push_back({entry.key, entry.where, &entry.value});
      continue;
    }
    for (Leaf& leaf : leaves(entry.value, {}, ranges)) {
      leaf.key = entry.key + "." + leaf.key;
      found.push_back(std::move(leaf));
    }
  }
  return found;
}

void SweepKeys::refuse_unknown(const Leaf& leaf) const {
  if (is_own(leaf.key) || parameters().find(leaf.key) != nullptr) return;
  const std::string near = nearest_word(leaf.key, {std::begin(own_keys), std::end(own_keys)});
  if (near.empty()) return;  // the configuration knows what else is near
  throw Error({"unknown parameter '" + leaf.key + "'", leaf.where, "no module declares it", near});
}

ParameterValue SweepKeys::value(const Leaf& leaf, const TomlValue& given) {
  refuse_unknown(leaf);
  const bool is_known = is_own(leaf.key) || parameters().find(leaf.key) != nullptr;
  if (!is_known) scratch_.set(leaf.key, std::int64_t{0}, leaf.where);  // throws: unknown
  return value(leaf, plain_value(leaf, given), given.where);
}

ParameterValue SweepKeys::value(const Leaf& leaf, const ParameterValue& given, const Location& where) {
  if (leaf.key == scheme_key) return scheme_called(given, where);
  if (leaf.key == scene_key) {
    const auto* name = std::get_if<std::string>(&given);
    if (name == nullptr || name->empty())
      throw Error({"a scene cannot be '" + to_string(given) + "'", where, "it is a text", "\"world_sphere\""});
    return given;
  }
  if (is_side(leaf.key)) {
    const auto* pixels = std::get_if<std::int64_t>(&given);
    if (pixels == nullptr || *pixels < 1 || *pixels > largest_frame)
      throw Error({leaf.key + " cannot be " + to_string(given), where, "it takes a whole number from 1 to 16384", leaf.key + " = 512"});
    return given;
  }
  scratch_.set(leaf.key, given, where);
  return scratch_.entries().at(leaf.key).value;
}

std::vector<ParameterValue> SweepKeys::values(const Leaf& leaf) {
  std::vector<ParameterValue> list;
  const auto add = [&](const ParameterValue& item, const Location& where) {
    if (std::find(list.begin(), list.end(), item) != list.end())
      throw Error({leaf.key + " is to be " + to_string(item) + " twice", where, "", "each value once"});
    list.push_back(item);
  };
  const auto add_given = [&](const TomlValue& given) {
    if (leaf.key == scheme_key && given.kind == TomlValue::Kind::text && given.text == "all") {
      for (const Scheme* scheme : all_schemes()) add(scheme->page().id, given.where);
    } else {
      add(value(leaf, given), given.where);
    }
  };
  if (leaf.value->kind != TomlValue::Kind::array) {
    add_given(*leaf.value);
    return list;
  }
  for (const TomlValue& item : leaf.value->items) add_given(item);
  if (!list.empty()) return list;
  refuse_unknown(leaf);
  throw Error({leaf.key + " has an empty list of values", leaf.value->where, "", leaf.key + " = [...]"});
}

bool SweepKeys::is_numeric(const std::string& key, bool& whole) const {
  whole = is_side(key);
  if (whole) return true;
  const Parameter* parameter = parameters().find(key);
  if (parameter == nullptr) return !is_own(key);  // what it is instead is said when a value is taken
  whole = std::holds_alternative<std::int64_t>(parameter->fallback);
  return whole || std::holds_alternative<double>(parameter->fallback);
}

std::vector<Assignments> section_points(const std::string& kind, const TomlEntry& section, SweepKeys& keys) {
  if (kind == "grid") return grid_points(section, keys);
  if (kind == "list") return listed_points(section, keys);
  if (kind == "random") return random_points(section, keys);
  return single_factors(section, keys);
}

}  // namespace bump
