#include "datapath/arithmetic.h"

#include <algorithm>
#include <cmath>

namespace bump {

namespace {

std::uint64_t magnitude_of(std::int64_t word) {
  return word < 0 ? std::uint64_t{0} - static_cast<std::uint64_t>(word) : static_cast<std::uint64_t>(word);
}

std::uint64_t ones(int bits) {
  return (std::uint64_t{1} << bits) - 1;
}

std::int64_t with_sign_of(std::int64_t sign, std::uint64_t magnitude) {
  const auto word = static_cast<std::int64_t>(magnitude);
  return sign < 0 ? -word : word;
}

}  // namespace

DividerShape divider_shape(const Format& a, const Format& b, const Format& quotient) {
  DividerShape shape;
  shape.shift = quotient.fraction + b.fraction - a.fraction;
  shape.magnitude = magnitude_bits(quotient);
  shape.dividend = std::max(shape.magnitude, a.width + shape.shift);
  return shape;
}

RootShape root_shape(const Format& a, const Format& root) {
  RootShape shape;
  shape.shift = 2 * root.fraction - a.fraction;
  shape.magnitude = magnitude_bits(root);
  shape.rows = std::max(0, (a.width + shape.shift + 1) / 2);
  return shape;
}

std::uint64_t restoring_division(std::uint64_t dividend, std::uint64_t divisor, int rows) {
  std::uint64_t remainder = dividend >> rows, quotient = 0;
  if (remainder >= divisor) return ones(rows);  // always so for divisor 0
  for (int bit = rows - 1; bit >= 0; --bit) {
    remainder = (remainder << 1) | ((dividend >> bit) & 1);
    if (remainder >= divisor) {
      remainder -= divisor;
      quotient |= std::uint64_t{1} << bit;
    }
  }
  return quotient;
}

std::uint64_t restoring_root(std::uint64_t radicand, int rows) {
  std::uint64_t remainder = 0, result = 0;
  for (int row = rows - 1; row >= 0; --row) {
    remainder = (remainder << 2) | ((radicand >> (2 * row)) & 3);
    const std::uint64_t trial = (result << 2) | 1;
    result <<= 1;
    if (remainder >= trial) {
      remainder -= trial;
      result |= 1;
    }
  }
  return result;
}

std::int64_t divide_by_array(std::int64_t a, std::int64_t b, const DividerShape& shape) {
  return with_sign_of(a, restoring_division(scaled(magnitude_of(a), shape.shift), static_cast<std::uint64_t>(b), shape.magnitude));
}

std::int64_t root_by_array(std::int64_t a, const RootShape& shape) {
  const std::uint64_t result = restoring_root(scaled(static_cast<std::uint64_t>(a), shape.shift), shape.rows);
  return static_cast<std::int64_t>(result & ones(shape.magnitude));
}

std::int64_t divide(std::int64_t a, std::int64_t b, const DividerShape& shape) {
  const auto divisor = static_cast<std::uint64_t>(b);
  const std::uint64_t quotient = divisor == 0 ? ~std::uint64_t{0} : scaled(magnitude_of(a), shape.shift) / divisor;
  return with_sign_of(a, std::min(quotient, ones(shape.magnitude)));
}

std::int64_t root(std::int64_t a, const RootShape& shape) {
  const std::uint64_t radicand = scaled(static_cast<std::uint64_t>(a), shape.shift);
  // The double root of a word below 2^62 is off by less than one; two comparisons make it the floor.
  auto result = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(radicand)));
  if (result * result > radicand) --result;
  if ((result + 1) * (result + 1) <= radicand) ++result;
  return static_cast<std::int64_t>(result & ones(shape.magnitude));
}

}  // namespace bump
