// YP4 as one Design: see README.md of this folder.

#include "schemes/yp4/units.h"

namespace bump::yp4 {

namespace {

class Yp4 : public Scheme {
 public:
  const SchemePage& page() const override {
    static const SchemePage page{"yp4", "Exact dot products of angles, four multipliers (pole on y)", "this project; in no paper",
                                 "this project's",
                                 "With the bump map's pole on y only the latitude is multiplied; everything else of both dot products is "
                                 "cosines of sums of angles."};
    return page;
  }

  void declare(Parameters& parameters) const override { declare_y_pole_parameters(parameters, "yp4"); }

  Design design(const Configuration& configuration, const Material& material) const override {
    const YPoleParameters p = read_y_pole_parameters(configuration, "yp4");
    return y_pole_design(p, environment_unit(p), illumination_unit(p, material), material);
  }
};

BUMP_REGISTER_SCHEME(Yp4);

}  // namespace

}  // namespace bump::yp4
