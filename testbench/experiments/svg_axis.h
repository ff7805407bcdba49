#pragma once
// An axis of a plot: its range, where its ticks stand, and where on the paper a value falls. No model of hardware.

#include <string>
#include <vector>

namespace bump {

class SvgAxis {
 public:
  /// For finite values, positive ones if logarithmic; a little room is left on both sides. `begin`, `end`: paper positions of the least and
  /// the greatest value. Without values the range is 0 to 1 (1 to 10).
  SvgAxis(const std::vector<double>& values, bool logarithmic, double begin, double end);

  /// Infinite values, and others beyond the range, fall on its ends.
  double position(double value) const;
  /// Round values inside the range, about as many as can be read.
  const std::vector<double>& ticks() const { return ticks_; }

 private:
  double scaled(double value) const;
  void add_linear_ticks();
  void add_logarithmic_ticks();

  bool logarithmic_;
  double low_ = 0, high_ = 1;  ///< of the range, scaled
  double begin_, end_;
  std::vector<double> ticks_;
};

/// "12,500", "0.25", "2e+09".
std::string tick_text(double value);

}  // namespace bump
