// YP2 as one Design: see README.md of this folder.

#include "schemes/yp2/units.h"

namespace bump::yp2 {

namespace {

class Yp2 : public Scheme {
 public:
  const SchemePage& page() const override {
    static const SchemePage page{"yp2", "Exact dot products of angles, two multipliers (pole on y)", "this project; in no paper",
                                 "this project's",
                                 "YP6 with all products but one a vector taken apart into sines and cosines of sums of angles."};
    return page;
  }

  void declare(Parameters& parameters) const override { declare_y_pole_parameters(parameters, "yp2"); }

  Design design(const Configuration& configuration, const Material& material) const override {
    const YPoleParameters p = read_y_pole_parameters(configuration, "yp2");
    return y_pole_design(p, environment_unit(p), illumination_unit(p, material), material);
  }
};

BUMP_REGISTER_SCHEME(Yp2);

}  // namespace

}  // namespace bump::yp2
