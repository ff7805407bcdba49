#include "datapath/narrow_rules.h"

#include "datapath/invariant.h"

namespace bump {

WordRange range_of(const Format& format) {
  BUMP_ASSERT(fits_narrow_lane(format));
  if (format.is_signed) return {-(std::int64_t{1} << (format.width - 1)), (std::int64_t{1} << (format.width - 1)) - 1};
  return {0, (std::int64_t{1} << format.width) - 1};
}

WordRange shifted(const WordRange& range, int left) {
  return {range.low * (std::int64_t{1} << left), range.high * (std::int64_t{1} << left)};
}

WordRange product(const WordRange& a, const WordRange& b) {
  const auto [least, greatest] = std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
  return {least, greatest};
}

std::optional<NarrowRule> narrow_rule(int from_fraction, const Format& to, const WordRange& exact) {
  NarrowRule rule;
  const int right = from_fraction - to.fraction;
  if (right == 0 && exact.fits(range_of(to))) {
    rule.is_identity = true;
    return rule;
  }
  if (!to.is_signed) rule.keep = static_cast<std::int32_t>((std::int64_t{1} << to.width) - 1);
  if (right + to.width <= 32 && right > -to.width) {
    rule.up = 32 - right - to.width;
    rule.down = 32 - to.width;
    return rule;
  }
  // The word reaches beyond the low 32 bits: what the shift leaves of an exact value that fits is the whole of it.
  if (right < 0 || !exact.fits_narrow_lane()) return std::nullopt;
  rule.down = std::min(right, 31);
  return rule;
}

}  // namespace bump
