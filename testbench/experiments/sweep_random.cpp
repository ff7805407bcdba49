#include "testbench/experiments/sweep_random.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace bump {

namespace {

std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

double six_digits(double value) {
  const std::string text = fmt::format("{:.6g}", value);
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

RandomDraws::RandomDraws(std::uint64_t seed, const std::string& key) : state_(mixed(seed + 0x9e3779b97f4a7c15U)) {
  for (const char letter : key) state_ = mixed(state_ ^ static_cast<unsigned char>(letter));
}

double RandomDraws::unit(std::size_t index) const {
  return std::ldexp(static_cast<double>(mixed(state_ + (index + 1) * 0x9e3779b97f4a7c15U) >> 11), -53);
}

std::size_t RandomDraws::below(std::size_t index, std::size_t count) const {
  return std::min(count - 1, static_cast<std::size_t>(unit(index) * static_cast<double>(count)));
}

ParameterValue RandomDraws::in_range(std::size_t index, const RandomRange& range) const {
  const double part = unit(index);
  const double high = range.whole ? range.high + 1 : range.high;  // every whole number has a width of its own
  double value = range.logarithmic ? range.low * std::exp(part * std::log(high / range.low)) : range.low + part * (high - range.low);
  if (range.logarithmic || !range.whole) value = six_digits(value);
  value = std::clamp(range.whole ? std::floor(value) : value, range.low, range.high);
  return range.whole ? ParameterValue(static_cast<std::int64_t>(value)) : ParameterValue(value);
}

}  // namespace bump
