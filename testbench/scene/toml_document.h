#pragma once
// A parsed TOML file as a plain tree in which every key and value knows its line and column, so that whoever reads it can say where a
// mistake is. Parsing is toml++'s; keeping it behind this tree keeps its headers out of every other file. Entries are in file order.

#include <cstdint>
#include <string>
#include <vector>

#include "datapath/error.h"

namespace bump {

struct TomlEntry;

struct TomlValue {
  enum class Kind { boolean, integer, number, text, array, table, other };
  Kind kind = Kind::other;
  bool boolean = false;
  std::int64_t integer = 0;
  double number = 0;  ///< also set for integers
  std::string text;
  std::vector<TomlValue> items;    ///< array
  std::vector<TomlEntry> entries;  ///< table
  Location where;

  bool is_number() const { return kind == Kind::integer || kind == Kind::number; }
  /// The entry called `key` of a table, or null.
  const TomlEntry* find(const std::string& key) const;
};

struct TomlEntry {
  std::string key;
  Location where;  ///< of the key
  TomlValue value;
};

/// Parses `text`; `file` is the name used in locations. Throws Error(input) with file, line and column (syntax, duplicate keys).
TomlValue parse_toml(const std::string& text, const std::string& file);

/// "a whole number", "a list" and so on, for messages.
std::string kind_name(TomlValue::Kind kind);

}  // namespace bump
