#pragma once
// The sections of a sweep's specification that say which points there are: the full product of lists of values, points one by one, random
// points, and one factor at a time. Each gives assignments of keys; what they leave open is the base's. No model of hardware.

#include <string>
#include <vector>

#include "channels/parameters.h"
#include "testbench/scene/toml_document.h"

namespace bump {

/// Keys of a sweep besides the declared parameters: which scene and scheme, and the size of the frame in place of the scene's own.
constexpr const char *scene_key = "scene", *scheme_key = "scheme", *width_key = "frame.width", *height_key = "frame.height";
constexpr int largest_frame = 16384;                ///< pixels of a side, as in scene files
constexpr std::size_t most_sweep_points = 200'000;  ///< of a whole sweep

/// A value of a key: of the parameter's type; of scene and scheme the name, of the frame's sides a whole number.
struct Assignment {
  std::string key;
  ParameterValue value;
};
using Assignments = std::vector<Assignment>;  ///< keys differ

/// Checks keys and values, for everything in a specification that sets something.
class SweepKeys {
 public:
  explicit SweepKeys(const Parameters& parameters) : scratch_(parameters) {}

  /// A leaf of a table of settings: "fifos.depth" for [fifos] depth and for fifos.depth.
  struct Leaf {
    std::string key;
    Location where;  ///< of the key
    const TomlValue* value = nullptr;
  };
  /// Of a table, in the order of the file, but for `skipped` keys of its own. Tables below it are modules, or, with `ranges`, ranges.
  std::vector<Leaf> leaves(const TomlValue& table, const std::vector<std::string>& skipped, bool ranges) const;

  /// The value as the key takes it. Throws Error(input), with the nearest key, word or range.
  ParameterValue value(const Leaf& leaf, const TomlValue& given);
  ParameterValue value(const Leaf& leaf, const ParameterValue& given, const Location& where);
  /// One value or a list of them, each once; of schemes also "all".
  std::vector<ParameterValue> values(const Leaf& leaf);
  /// True if the key takes numbers; `whole` says which.
  bool is_numeric(const std::string& key, bool& whole) const;
  const Parameters& parameters() const { return scratch_.parameters(); }

 private:
  void refuse_unknown(const Leaf& leaf) const;
  Configuration scratch_;
};

/// The points of section `kind` (grid, list, random, one_at_a_time), in order: of grids the last key fastest, of one factor at a time the
/// base first. Throws Error(input).
std::vector<Assignments> section_points(const std::string& kind, const TomlEntry& section, SweepKeys& keys);

/// Throws Error(input): the sweep has more than `most_sweep_points`.
[[noreturn]] void refuse_size(const Location& where);

}  // namespace bump
