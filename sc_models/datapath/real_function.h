#pragma once
// A function of one number that is called for a lane or for a whole block: any callable, wrapped once, so that a block costs one indirect
// call and the compiler sees the loop together with the function. Both ways compute the same.

#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>

namespace bump {

class RealFunction {
 public:
  RealFunction() = default;
  RealFunction(std::nullptr_t) {}
  template <class F, class = std::enable_if_t<!std::is_same_v<std::decay_t<F>, RealFunction> && std::is_invocable_r_v<double, F, double>>>
  RealFunction(F function)
      : lane_(function), block_([f = std::move(function)](const double* x, double* y, int lanes) mutable {
          for (int i = 0; i < lanes; ++i) y[i] = f(x[i]);
        }) {}

  explicit operator bool() const { return static_cast<bool>(lane_); }
  double operator()(double x) const { return lane_(x); }
  /// y[i] = f(x[i]) for every lane; the arrays do not overlap.
  void block(const double* x, double* y, int lanes) const { block_(x, y, lanes); }

 private:
  std::function<double(double)> lane_;
  std::function<void(const double*, double*, int)> block_;
};

}  // namespace bump
