#include "testbench/scene/toml_document.h"

// toml++ 3.3 assumes here and there what a damaged file does not grant ("[}" within a list): an assertion in debug builds, undefined
// behaviour in release builds. In this one file its assertions stay on and become an exception.
#undef NDEBUG
#undef TOML_HEADER_ONLY
#define TOML_HEADER_ONLY 1
namespace bump {
struct TomlAssumption {};
[[noreturn]] static void refuse_assumption() {
  throw TomlAssumption();
}
}  // namespace bump
#define TOML_ASSERT(condition) ((condition) ? static_cast<void>(0) : ::bump::refuse_assumption())
#include <toml++/toml.h>

#include <algorithm>

namespace bump {

namespace {

Location location_of(const toml::source_region& source, const std::string& file) {
  return {file, static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

bool earlier(const Location& a, const Location& b) {
  return a.line != b.line ? a.line < b.line : a.column < b.column;
}

TomlValue convert(const toml::node& node, const std::string& file) {
  TomlValue value;
  value.where = location_of(node.source(), file);
  if (const auto* table = node.as_table()) {
    value.kind = TomlValue::Kind::table;
    for (const auto& [key, child] : *table) {
      value.entries.push_back({std::string(key.str()), location_of(key.source(), file), convert(child, file)});
    }
    std::stable_sort(value.entries.begin(), value.entries.end(), [](const auto& a, const auto& b) { return earlier(a.where, b.where); });
  } else if (const auto* array = node.as_array()) {
    value.kind = TomlValue::Kind::array;
    for (const auto& item : *array) value.items.push_back(convert(item, file));
  } else if (const auto* boolean = node.as_boolean()) {
    value.kind = TomlValue::Kind::boolean;
    value.boolean = boolean->get();
  } else if (const auto* integer = node.as_integer()) {
    value.kind = TomlValue::Kind::integer;
    value.integer = integer->get();
    value.number = static_cast<double>(value.integer);
  } else if (const auto* number = node.as_floating_point()) {
    value.kind = TomlValue::Kind::number;
    value.number = number->get();
  } else if (const auto* text = node.as_string()) {
    value.kind = TomlValue::Kind::text;
    value.text = text->get();
  }
  return value;
}

}  // namespace

const TomlEntry* TomlValue::find(const std::string& key) const {
  for (const auto& entry : entries) {
    if (entry.key == key) return &entry;
  }
  return nullptr;
}

TomlValue parse_toml(const std::string& text, const std::string& file) {
  try {
    return convert(toml::parse(text, file), file);
  } catch (const toml::parse_error& error) {
    throw Error({"the file is not valid TOML", location_of(error.source(), file), std::string(error.description()),
                 "strings in double quotes, lists in [ ], each key once per table"});
  } catch (const TomlAssumption&) {
    throw Error({"the file is not valid TOML", {file, 0, 0}, "brackets or separators are out of place", "check every [ ] and { }"});
  }
}

std::string kind_name(TomlValue::Kind kind) {
  static constexpr const char* names[] = {"true or false", "a whole number", "a number", "a text", "a list", "a table", "a date or time"};
  return names[static_cast<int>(kind)];
}

}  // namespace bump
