#include "testbench/experiments/fit_noise.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bump {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double noise_of(double quality) {
  return std::pow(10.0, -quality / 10);
}
double quality_of(double noise) {
  return -10 * std::log10(noise);
}

}  // namespace

NoiseModel::NoiseModel(const std::vector<WidthRange>& ranges, const Widths& base, double base_quality)
    : ranges_(ranges), base_(base), base_noise_(noise_of(base_quality)) {
  for (const WidthRange& range : ranges) noise_.emplace_back(static_cast<std::size_t>(range.high - range.low + 1), infinity);
}

void NoiseModel::set(std::size_t index, int value, double quality) {
  noise_[index][static_cast<std::size_t>(value - ranges_[index].low)] = std::max(0.0, noise_of(quality) - base_noise_);
}

void NoiseModel::fade(std::size_t index, int value) {
  for (int wider = value + 1; wider < base_[index]; ++wider) {
    const auto place = static_cast<std::size_t>(wider - ranges_[index].low);
    noise_[index][place] = noise_[index][place - 1] / 4;
  }
}

double NoiseModel::of(std::size_t index, int value) const {
  return value >= base_[index] ? 0 : noise_[index][static_cast<std::size_t>(value - ranges_[index].low)];
}

double NoiseModel::amount(const Widths& widths) const {
  double sum = base_noise_;
  for (std::size_t i = 0; i < widths.size(); ++i) sum += of(i, widths[i]);
  return sum;
}

double NoiseModel::quality(const Widths& widths) const {
  return quality_of(amount(widths));
}

double NoiseModel::quality(const Widths& widths, const Widths& measured, double measured_quality) const {
  const double predicted = amount(widths), error = noise_of(measured_quality) - amount(measured);
  if (!std::isfinite(error)) return quality_of(predicted);
  return quality_of(std::max(predicted + error, predicted / 10));
}

Widths NoiseModel::narrowest(double target) const {
  Widths widths;
  for (std::size_t i = 0; i < base_.size(); ++i) {
    int value = base_[i];
    while (value > ranges_[i].low && quality_of(base_noise_ + of(i, value - 1)) >= target) --value;
    widths.push_back(value);
  }
  return widths;
}

}  // namespace bump
