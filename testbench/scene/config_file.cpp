#include "testbench/scene/config_file.h"

#include <cmath>

#include "testbench/scene/input_files.h"
#include "testbench/scene/toml_document.h"

namespace bump {

namespace {

bool is_module(const Parameters& parameters, const std::string& path) {
  const auto below = parameters.all().lower_bound(path + ".");
  return below != parameters.all().end() && below->first.compare(0, path.size() + 1, path + ".") == 0;
}

void check_module(const TomlEntry& entry, const std::string& path, const Parameters& parameters) {
  if (is_module(parameters, path)) return;
  if (const Parameter* parameter = parameters.find(path)) {
    throw Error({"'" + path + "' is a parameter, not a module", entry.where, "its value is " + allowed(*parameter), path + " = ..."});
  }
  if (!entry.value.entries.empty()) return;  // its keys are reported, each with the nearest one
  throw Error(
      {"unknown module '" + path + "'", entry.where, "no parameter is declared under it", "bumpsim describe lists every parameter"});
}

void apply(const TomlValue& table, const std::string& prefix, Configuration& configuration) {
  for (const auto& entry : table.entries) {
    const std::string key = prefix + entry.key;
    const TomlValue& value = entry.value;
    if (value.kind == TomlValue::Kind::table) {
      check_module(entry, key, configuration.parameters());
      apply(value, key + ".", configuration);
      continue;
    }
    // An unknown key is reported where the key stands, a wrong value where the value stands.
    const Location& where = configuration.parameters().find(key) == nullptr ? entry.where : value.where;
    switch (value.kind) {
      case TomlValue::Kind::boolean:
        configuration.set(key, value.boolean, where);
        break;
      case TomlValue::Kind::integer:
        configuration.set(key, value.integer, where);
        break;
      case TomlValue::Kind::number:
        configuration.set(key, value.number, where);
        break;
      case TomlValue::Kind::text:
        configuration.set(key, value.text, where);
        break;
      default: {
        const Parameter* parameter = configuration.parameters().find(key);
        if (parameter == nullptr) configuration.set(key, std::string(), where);  // throws: unknown
        throw Error({key + " cannot be " + kind_name(value.kind), where, "its value is " + allowed(*parameter), key + " = one value"});
      }
    }
  }
}

std::string toml_value(const ParameterValue& value) {
  if (const auto* word = std::get_if<std::string>(&value)) return "\"" + *word + "\"";
  std::string text = to_string(value);
  if (std::holds_alternative<double>(value) && text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

}  // namespace

void read_configuration_text(const std::string& text, const std::string& file, Configuration& configuration) {
  apply(parse_toml(text, file), "", configuration);
}

void read_configuration(const std::string& path, Configuration& configuration) {
  const bool may_be_empty = true;  // unlike an empty scene or texture, an empty configuration says something: all defaults
  read_configuration_text(read_bytes(path, "configuration", {}, may_be_empty), path, configuration);
}

void apply_setting(const std::string& key_equals_value, Configuration& configuration) {
  const auto equals = key_equals_value.find('=');
  const Location origin{"--set", 0, 0};
  if (equals == std::string::npos) {
    throw Error({"'" + key_equals_value + "' sets nothing", origin, "there is no '=' in it", "--set key=value"});
  }
  const auto first = key_equals_value.find_first_not_of(' ');
  const auto last = key_equals_value.find_last_not_of(' ', equals == 0 ? 0 : equals - 1);
  const std::string key = equals == 0 || first >= equals ? "" : key_equals_value.substr(first, last - first + 1);
  if (key.empty()) throw Error({"'" + key_equals_value + "' names no parameter", origin, "nothing stands before '='", "--set key=value"});
  configuration.set_text(key, key_equals_value.substr(equals + 1), origin);
}

std::string to_toml(const Configuration& configuration) {
  // Dotted keys on the top level rather than tables: each line stands for itself and can be handed to --set.
  std::string text;
  for (const auto& [key, entry] : configuration.entries()) {
    const Parameter& parameter = *configuration.parameters().find(key);
    text += key + " = " + toml_value(entry.value) + "  # " + to_string(entry.origin);
    text += "; default " + allowed(parameter) + "; " + parameter.meaning + "\n";
  }
  return text;
}

}  // namespace bump
