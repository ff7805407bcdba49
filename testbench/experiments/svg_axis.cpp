#include "testbench/experiments/svg_axis.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace bump {

namespace {

constexpr double ticks_wanted = 6;
constexpr double room = 0.05;  ///< share of the range that is left free on either side

/// 1, 2 or 5 times a power of ten, such that `span` holds about as many as wanted.
double round_step(double span) {
  const double rough = span / ticks_wanted, power = std::pow(10.0, std::floor(std::log10(rough)));
  const double ratio = rough / power;
  return power * (ratio < 1.5 ? 1 : ratio < 3.5 ? 2 : ratio < 7.5 ? 5 : 10);
}

}  // namespace

SvgAxis::SvgAxis(const std::vector<double>& values, bool logarithmic, double begin, double end)
    : logarithmic_(logarithmic), begin_(begin), end_(end) {
  bool first = true;
  for (const double value : values) {
    if (!std::isfinite(value) || (logarithmic && value <= 0)) continue;
    low_ = first ? scaled(value) : std::min(low_, scaled(value));
    high_ = first ? scaled(value) : std::max(high_, scaled(value));
    first = false;
  }
  if (high_ - low_ < 1e-9 * std::max(std::abs(low_), std::abs(high_)) || high_ == low_) {
    const double around = logarithmic_ ? 0.3 : std::max(1e-9, 0.1 * std::abs(low_));
    low_ -= around;
    high_ += around;
  }
  const double free = room * (high_ - low_);
  const bool from_zero = !logarithmic_ && low_ >= 0 && low_ < 3 * free;
  low_ = from_zero ? 0 : low_ - free;
  high_ += free;
  if (logarithmic_)
    add_logarithmic_ticks();
  else
    add_linear_ticks();
}

double SvgAxis::scaled(double value) const {
  return logarithmic_ ? std::log10(value) : value;
}

double SvgAxis::position(double value) const {
  double share = value > 0 ? 1 : 0;
  if (std::isfinite(value) && !(logarithmic_ && value <= 0)) share = std::clamp((scaled(value) - low_) / (high_ - low_), 0.0, 1.0);
  return begin_ + share * (end_ - begin_);
}

void SvgAxis::add_linear_ticks() {
  const double step = round_step(high_ - low_);
  for (double count = std::ceil(low_ / step); count * step <= high_; ++count) ticks_.push_back(count * step);
}

void SvgAxis::add_logarithmic_ticks() {
  const double decades = high_ - low_;
  const double every = std::max(1.0, std::ceil(decades / ticks_wanted));
  for (double power = std::floor(low_); power <= high_; ++power) {
    for (const double digit : {1.0, 2.0, 5.0}) {
      if (digit != 1 && decades > 2.5) continue;
      if (digit == 1 && std::fmod(power, every) != 0) continue;
      const double value = digit * std::pow(10.0, power);
      if (std::log10(value) >= low_ && std::log10(value) <= high_) ticks_.push_back(value);
    }
  }
  if (ticks_.size() >= 2) return;
  // A part of a decade: round values of a linear axis over it.
  ticks_.clear();
  const double low = std::pow(10.0, low_), high = std::pow(10.0, high_), step = round_step(high - low);
  for (double count = std::ceil(low / step); count * step <= high; ++count) ticks_.push_back(count * step);
}

std::string tick_text(double value) {
  const double rounded = std::round(value * 1e9) / 1e9;
  if (std::abs(value) >= 1e9 || (value != 0 && std::abs(value) < 1e-4)) return fmt::format("{:.6g}", value);
  std::string text = fmt::format("{:.10g}", rounded == 0 ? 0.0 : rounded);
  const std::size_t point = std::min(text.find('.'), text.size()), first = text[0] == '-' ? 1 : 0;
  for (std::size_t at = point; at > first + 3;) text.insert(at -= 3, ",");
  return text;
}

}  // namespace bump
