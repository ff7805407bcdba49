#include "channels/parameters.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>

#include "datapath/invariant.h"

namespace bump {

namespace {

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Optimal string alignment distance, case ignored: one slip is an insertion, a deletion, a substitution or a swap of neighbours.
int edit_distance(const std::string& a, const std::string& b) {
  const std::size_t columns = b.size() + 1;
  std::vector<int> before(columns), previous(columns), current(columns);
  for (std::size_t j = 0; j < columns; ++j) previous[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    current[0] = static_cast<int>(i);
    for (std::size_t j = 1; j < columns; ++j) {
      const bool same = lower(a[i - 1]) == lower(b[j - 1]);
      current[j] = std::min({previous[j] + 1, current[j - 1] + 1, previous[j - 1] + (same ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
      if (swapped) current[j] = std::min(current[j], before[j - 2] + 1);
    }
    std::swap(before, previous);
    std::swap(previous, current);
  }
  return previous[columns - 1];
}

bool ends_with_path(const std::string& key, const std::string& tail) {
  return key.size() > tail.size() && key.compare(key.size() - tail.size(), tail.size(), tail) == 0 &&
         key[key.size() - tail.size() - 1] == '.';
}

const char* type_name(const ParameterValue& value) {
  static constexpr const char* names[] = {"true or false", "a whole number", "a number", "a word"};
  return names[value.index()];
}

std::string quoted(const ParameterValue& value) {
  return std::holds_alternative<std::string>(value) ? "'" + std::get<std::string>(value) + "'" : to_string(value);
}

/// "allowed 1 to 16 tokens", the part of allowed() behind the default.
std::string range_of(const Parameter& parameter) {
  switch (parameter.fallback.index()) {
    case 0:
      return "allowed true or false";
    case 3: {
      std::string list = "allowed ";
      for (std::size_t i = 0; i < parameter.choices.size(); ++i) list += (i == 0 ? "" : ", ") + parameter.choices[i];
      return list;
    }
    default:
      return "allowed " + to_string(ParameterValue(parameter.low)) + " to " + to_string(ParameterValue(parameter.high)) +
             (parameter.unit.empty() ? "" : " " + parameter.unit);
  }
}

[[noreturn]] void reject(const Parameter& parameter, const std::string& given, const std::string& why, const Location& origin,
                         const std::string& try_this = "") {
  throw Error({parameter.key + " cannot be " + given, origin, why + "; " + range_of(parameter) + " (" + parameter.meaning + ")",
               try_this.empty() ? parameter.key + " = " + quoted(parameter.fallback) + ", the default" : try_this});
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

template <class Number>
std::from_chars_result parse(const std::string& text, Number& value) {
  const char* first = text.data() + (text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0);
  return std::from_chars(first, text.data() + text.size(), value);
}

bool in_range(const Parameter& parameter, double value) {
  return value >= parameter.low && value <= parameter.high;
}

}  // namespace

std::string nearest_word(const std::string& word, const std::vector<std::string>& candidates) {
  int best = std::min(3, std::max(1, static_cast<int>(word.size()) / 2)) + 1;  // one more than what still counts as near
  std::string nearest;
  for (const auto& candidate : candidates) {
    const auto difference = word.size() > candidate.size() ? word.size() - candidate.size() : candidate.size() - word.size();
    if (difference >= static_cast<std::size_t>(best)) continue;
    const int distance = edit_distance(word, candidate);
    if (distance >= best) continue;
    best = distance;
    nearest = candidate;
  }
  return nearest;
}

std::string to_string(const ParameterValue& value) {
  switch (value.index()) {
    case 0:
      return std::get<bool>(value) ? "true" : "false";
    case 1:
      return std::to_string(std::get<std::int64_t>(value));
    case 2: {
      char text[40];
      const auto end = std::to_chars(text, text + sizeof text, std::get<double>(value)).ptr;  // shortest text that reads back the same
      return std::string(text, end);
    }
    default:
      return std::get<std::string>(value);
  }
}

std::string allowed(const Parameter& parameter) {
  return to_string(parameter.fallback) + ", " + range_of(parameter);
}

Parameter& Parameters::declare(Parameter parameter) {
  BUMP_ASSERT(!parameter.key.empty());
  for (const char c : parameter.key) BUMP_ASSERT((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '.');
  BUMP_ASSERT(!parameter.meaning.empty());
  std::string key = parameter.key;
  const auto [place, added] = parameters_.emplace(std::move(key), std::move(parameter));
  BUMP_ASSERT(added);  // declared twice otherwise
  return place->second;
}

Parameter& Parameters::integer(const std::string& key, std::int64_t fallback, std::int64_t low, std::int64_t high, const std::string& unit,
                         const std::string& meaning) {
  constexpr std::int64_t exact = std::int64_t{1} << 53;  // bounds are kept as doubles
  BUMP_ASSERT(-exact <= low && low <= fallback && fallback <= high && high <= exact);
  return declare({key, fallback, static_cast<double>(low), static_cast<double>(high), {}, unit, meaning, false});
}

Parameter& Parameters::number(const std::string& key, double fallback, double low, double high, const std::string& unit,
                        const std::string& meaning) {
  BUMP_ASSERT(std::isfinite(low) && std::isfinite(high) && low <= fallback && fallback <= high);
  return declare({key, fallback, low, high, {}, unit, meaning, false});
}

Parameter& Parameters::boolean(const std::string& key, bool fallback, const std::string& meaning) {
  return declare({key, fallback, 0, 1, {}, "", meaning, false});
}

Parameter& Parameters::choice(const std::string& key, const std::string& fallback, const std::vector<std::string>& choices,
                        const std::string& meaning) {
  BUMP_ASSERT(std::find(choices.begin(), choices.end(), fallback) != choices.end());
  return declare({key, fallback, 0, 0, choices, "", meaning, false});
}

const Parameter* Parameters::find(const std::string& key) const {
  const auto found = parameters_.find(key);
  return found == parameters_.end() ? nullptr : &found->second;
}

std::string Parameters::nearest(const std::string& key) const {
  std::vector<std::string> keys;
  for (const auto& [known, parameter] : parameters_) keys.push_back(known);
  const std::string near = nearest_word(key, keys);
  if (!near.empty()) return near;
  // The tail of a path ("ways" for "texture_fetch.cache.ways") is not near by letters, but is what people leave out.
  for (const auto& known : keys) {
    if (ends_with_path(known, key)) return known;
  }
  const auto dot = key.rfind('.');
  if (dot == std::string::npos) return "";
  // A right name under the wrong module.
  for (const auto& known : keys) {
    if (ends_with_path(known, key.substr(dot + 1))) return known;
  }
  return "";
}

Configuration::Configuration(Parameters parameters) : parameters_(std::move(parameters)) {
  for (const auto& [key, parameter] : parameters_.all()) entries_[key] = {parameter.fallback, {"default", 0, 0}};
}

namespace {

const Parameter& declared(const Parameters& parameters, const std::string& key, const Location& origin) {
  if (const Parameter* parameter = parameters.find(key)) return *parameter;
  const std::string prefix = key + ".";
  const auto below = parameters.all().lower_bound(prefix);
  if (below != parameters.all().end() && below->first.compare(0, prefix.size(), prefix) == 0) {
    throw Error({"'" + key + "' is a module, not a parameter", origin, "values are set on its parameters", below->first});
  }
  const std::string near = parameters.nearest(key);
  throw Error({"unknown parameter '" + key + "'", origin, "no module declares it",
               near.empty() ? "bumpsim describe lists every parameter" : near + " (" + allowed(*parameters.find(near)) + ")"});
}

}  // namespace

void Configuration::set_text(const std::string& key, const std::string& text, const Location& origin) {
  const Parameter& parameter = declared(parameters_, key, origin);
  const std::string word = trimmed(text);
  const std::string given = "'" + word + "'";
  const std::string wrong_type = std::string("it takes ") + type_name(parameter.fallback);
  switch (parameter.fallback.index()) {
    case 0:
      if (word != "true" && word != "false") reject(parameter, given, wrong_type, origin);
      return set(key, word == "true", origin);
    case 1: {
      std::int64_t value = 0;
      const auto [end, error] = parse(word, value);
      if (error == std::errc::result_out_of_range) reject(parameter, given, "it is out of range", origin);
      if (error != std::errc() || end != word.data() + word.size()) reject(parameter, given, wrong_type, origin);
      return set(key, value, origin);
    }
    case 2: {
      double value = 0;
      const auto [end, error] = parse(word, value);
      if (error == std::errc::result_out_of_range) reject(parameter, given, "it is out of range", origin);
      if (error != std::errc() || end != word.data() + word.size()) reject(parameter, given, wrong_type, origin);
      return set(key, value, origin);
    }
    default:
      // Quotes as in a configuration file are accepted: shells often leave them in.
      if (word.size() >= 2 && (word.front() == '"' || word.front() == '\'') && word.back() == word.front()) {
        return set(key, word.substr(1, word.size() - 2), origin);
      }
      return set(key, word, origin);
  }
}

void Configuration::set(const std::string& key, const ParameterValue& value, const Location& origin) {
  const Parameter& parameter = declared(parameters_, key, origin);
  ParameterValue accepted = value;
  if (std::holds_alternative<double>(parameter.fallback) && std::holds_alternative<std::int64_t>(value)) {
    accepted = static_cast<double>(std::get<std::int64_t>(value));
  }
  if (accepted.index() != parameter.fallback.index()) {
    reject(parameter, quoted(value), std::string("it takes ") + type_name(parameter.fallback), origin);
  }
  if (const auto* integer = std::get_if<std::int64_t>(&accepted)) {
    constexpr std::int64_t exact = std::int64_t{1} << 53;
    if (*integer < -exact || *integer > exact || !in_range(parameter, static_cast<double>(*integer))) {
      reject(parameter, quoted(value), "it is out of range", origin);
    }
  } else if (const auto* number = std::get_if<double>(&accepted)) {
    if (!std::isfinite(*number)) reject(parameter, quoted(value), "it takes a finite number", origin);
    if (!in_range(parameter, *number)) reject(parameter, quoted(value), "it is out of range", origin);
  } else if (const auto* word = std::get_if<std::string>(&accepted)) {
    if (std::find(parameter.choices.begin(), parameter.choices.end(), *word) == parameter.choices.end()) {
      const std::string near = nearest_word(*word, parameter.choices);
      reject(parameter, quoted(value), "it is none of its words", origin, near.empty() ? "" : key + " = '" + near + "'");
    }
  }
  entries_[key] = {accepted, origin};
}

const Configuration::Entry& Configuration::entry(const std::string& key) const {
  const auto found = entries_.find(key);
  BUMP_ASSERT(found != entries_.end());  // a module reads a parameter that nobody declared
  return found->second;
}

std::int64_t Configuration::integer(const std::string& key) const {
  const auto* value = std::get_if<std::int64_t>(&entry(key).value);
  BUMP_ASSERT(value != nullptr);
  return *value;
}

double Configuration::number(const std::string& key) const {
  const auto* value = std::get_if<double>(&entry(key).value);
  BUMP_ASSERT(value != nullptr);
  return *value;
}

bool Configuration::boolean(const std::string& key) const {
  const auto* value = std::get_if<bool>(&entry(key).value);
  BUMP_ASSERT(value != nullptr);
  return *value;
}

const std::string& Configuration::choice(const std::string& key) const {
  const auto* value = std::get_if<std::string>(&entry(key).value);
  BUMP_ASSERT(value != nullptr);
  return *value;
}

}  // namespace bump
