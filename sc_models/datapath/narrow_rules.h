#pragma once
// Decides, from formats alone, when an operator may run on 32-bit lanes, and prepares its constants. What does not qualify runs on 64-bit
// lanes; both give the same words.

#include <algorithm>
#include <cstdint>
#include <optional>

#include "datapath/narrow_kernels.h"

namespace bump {

/// Least and greatest exact value of a word or an intermediate result, in units of its own last place.
struct WordRange {
  std::int64_t low = 0, high = 0;

  bool fits(const WordRange& in) const { return low >= in.low && high <= in.high; }
  bool fits_narrow_lane() const { return fits({INT32_MIN, INT32_MAX}); }
};

/// Of every word of a format that fits a narrow lane.
WordRange range_of(const Format& format);
WordRange shifted(const WordRange& range, int left);
inline WordRange sum(const WordRange& a, const WordRange& b) {
  return {a.low + b.low, a.high + b.high};
}
inline WordRange negated(const WordRange& a) {
  return {-a.high, -a.low};
}
/// Of values from one range or the other.
inline WordRange either(const WordRange& a, const WordRange& b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}
inline WordRange magnitude(const WordRange& a) {
  return {0, std::max(-a.low, a.high)};
}
/// Of words that fit narrow lanes.
WordRange product(const WordRange& a, const WordRange& b);

/// The rule that takes exact values in `exact`, of which the low 32 bits are at hand, to the format; none if those do not suffice.
std::optional<NarrowRule> narrow_rule(int from_fraction, const Format& to, const WordRange& exact);

}  // namespace bump
