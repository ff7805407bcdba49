#pragma once
// One table of a scene file, read strictly: a key that the table does not have is an error as soon as the table is opened (with the
// nearest key that it has), and every value is checked for type, size, finiteness and range as it is taken. All errors carry file,
// line and column.

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "testbench/scene/toml_document.h"

namespace bump {

class StrictTable {
 public:
  /// `name` is used in messages: "camera", or "the scene" for a whole file. `value` must outlive this. Throws Error(input) if it is no
  /// table or has another key than `keys`.
  StrictTable(const TomlValue& value, std::string name, std::vector<std::string> keys);

  bool has(const std::string& key) const { return value_.find(key) != nullptr; }
  /// Where the value of `key` stands, or the table itself if it is absent.
  Location where(const std::string& key) const;
  Location where() const { return value_.where; }
  const TomlValue* find(const std::string& key) const;

  // Each throws Error(input) if the value is absent (first form), of another type, not finite, or outside [low, high].
  double number(const std::string& key, double low, double high) const;
  double number(const std::string& key, double fallback, double low, double high) const;
  int integer(const std::string& key, int fallback, int low, int high) const;
  glm::dvec3 vector(const std::string& key, double low = -largest, double high = largest) const;
  glm::dvec3 vector(const std::string& key, const glm::dvec3& fallback, double low = -largest, double high = largest) const;
  /// Two numbers, or one number for both.
  std::pair<double, double> pair(const std::string& key, std::pair<double, double> fallback, double low, double high) const;
  std::pair<int, int> integer_pair(const std::string& key, std::pair<int, int> fallback, int low, int high) const;
  /// A non-empty text.
  std::string text(const std::string& key) const;
  /// One of `words`; the first is the default.
  std::string word(const std::string& key, const std::vector<std::string>& words) const;
  /// One word or two, each one of `words`.
  std::pair<std::string, std::string> word_pair(const std::string& key, std::pair<std::string, std::string> fallback,
                                                const std::vector<std::string>& words) const;

  /// Throws Error(input) at `key`: "<table>.<key> <problem>".
  [[noreturn]] void reject(const std::string& key, const std::string& problem, const std::string& why, const std::string& try_this) const;

  /// Coordinates beyond this are taken for a mistake.
  static constexpr double largest = 1e9;

 private:
  /// "camera.eye"; of a whole file ("the scene") the key alone.
  std::string full_name(const std::string& key) const;
  const TomlValue& required(const std::string& key) const;
  /// `list` is the list that the value is an item of, for the advice.
  double checked(const std::string& key, const TomlValue& value, double low, double high, bool whole,
                 const TomlValue* list = nullptr) const;
  std::string checked_word(const std::string& key, const TomlValue& value, const std::vector<std::string>& words) const;

  const TomlValue& value_;
  std::string name_;
};

}  // namespace bump
