// YP0 as one Design: see README.md of this folder.

#include "schemes/yp0/units.h"

namespace bump::yp0 {

namespace {

class Yp0 : public Scheme {
 public:
  const SchemePage& page() const override {
    static const SchemePage page{
        "yp0", "Exact dot products of angles without a multiplier (pole on y)", "this project; in no paper", "this project's",
        "Both dot products are sums of 32 sines and cosines of sums of angles: no multiplier, no inverse function, no approximation."};
    return page;
  }

  void declare(Parameters& parameters) const override { declare_y_pole_parameters(parameters, "yp0"); }

  Design design(const Configuration& configuration, const Material& material) const override {
    const YPoleParameters p = read_y_pole_parameters(configuration, "yp0");
    return y_pole_design(p, environment_unit(p), illumination_unit(p, material), material);
  }
};

BUMP_REGISTER_SCHEME(Yp0);

}  // namespace

}  // namespace bump::yp0
