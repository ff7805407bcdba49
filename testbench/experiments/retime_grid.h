#pragma once
// The points of a sweep: the full product of the values given for each key, the last key varying fastest. No model of hardware.

#include <string>
#include <vector>

#include "channels/parameters.h"

namespace bump {

struct SweepAxis {
  std::string key;
  std::vector<ParameterValue> values;  ///< distinct, in the order given
};

class SweepGrid {
 public:
  static constexpr std::size_t most_points = 200'000;

  /// Each text is "key=a,b,c". Throws Error(input): no such key or value, a key or value given twice, more than `most_points` points.
  SweepGrid(const std::vector<std::string>& texts, const Parameters& parameters);

  const std::vector<SweepAxis>& axes() const { return axes_; }
  /// 1 without axes.
  std::size_t points() const { return points_; }
  /// Sets the values of a point.
  void apply(std::size_t point, Configuration& configuration) const;
  /// They as text, one for each axis.
  std::vector<std::string> values(std::size_t point) const;

 private:
  const ParameterValue& value(std::size_t point, std::size_t axis) const;

  std::vector<SweepAxis> axes_;
  std::vector<std::size_t> stride_;  ///< points between two values of an axis
  std::size_t points_ = 1;
};

}  // namespace bump
