#pragma once
// Random values for sweeps: a function of seed, key and index alone, so that more points, or another key, leave the values of the others as
// they are. Logarithmic values and those of real parameters are rounded to six digits: what differs between mathematical libraries is far
// below. No model of hardware. Source of the mixing: Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014.

#include <cstdint>
#include <string>

#include "channels/parameters.h"

namespace bump {

struct RandomRange {
  double low = 0, high = 0;  ///< both may be drawn
  bool logarithmic = false;  ///< as likely between 1 and 10 as between 10 and 100; `low` is above 0
  bool whole = false;        ///< whole numbers
};

class RandomDraws {
 public:
  RandomDraws(std::uint64_t seed, const std::string& key);

  /// 0 to count - 1.
  std::size_t below(std::size_t index, std::size_t count) const;
  /// A whole number or a real one, as the range says.
  ParameterValue in_range(std::size_t index, const RandomRange& range) const;

 private:
  double unit(std::size_t index) const;  ///< [0, 1)
  std::uint64_t state_;
};

}  // namespace bump
