#pragma once
// What narrow words cost in quality, as noises that add up: each width's noise power at each value, as measured with the other widths wide.
// Roundings are not independent, so sums are predictions, good enough to choose what to measure next. No model of hardware.

#include <vector>

#include "testbench/experiments/fit_search.h"

namespace bump {

class NoiseModel {
 public:
  /// `base`: the wide design, whose quality in dB is given. Values at base and above add no noise, values never set are never good enough.
  NoiseModel(const std::vector<WidthRange>& ranges, const Widths& base, double base_quality);

  /// Quality with width `index` at `value` and all others as in the base.
  void set(std::size_t index, int value, double quality);

  /// What is known of width `index` at `value` fades by 6 dB a bit up to the base, as the power of roundings does.
  void fade(std::size_t index, int value);

  /// Power, where 0 dB is 1; infinite if one of the values is not known.
  double amount(const Widths& widths) const;
  /// dB.
  double quality(const Widths& widths) const;
  /// dB, given what was measured of another design.
  double quality(const Widths& widths, const Widths& measured, double measured_quality) const;
  /// Of each width the least value from which on, up to the base, it reaches the target alone.
  Widths narrowest(double target) const;

 private:
  double of(std::size_t index, int value) const;

  std::vector<WidthRange> ranges_;
  Widths base_;
  double base_noise_;
  std::vector<std::vector<double>> noise_;  ///< added to the base's; by width and value less its least
};

}  // namespace bump
