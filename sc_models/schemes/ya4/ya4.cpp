// YA4 as one Design: see README.md of this folder.

#include "schemes/ya4/units.h"

namespace bump::ya4 {

namespace {

class Ya4 : public Scheme {
 public:
  const SchemePage& page() const override {
    static const SchemePage page{"ya4", "Law of cosines about the y axis, four multipliers", "this project; in no paper", "this project's",
                                 "L and H are given longitude and latitude about the y axis, where the second rotation of Lee 2007 is one "
                                 "addition; the law of cosines does the rest. Two inverse functions a vector."};
    return page;
  }

  void declare(Parameters& parameters) const override { declare_y_pole_parameters(parameters, "ya4"); }

  Design design(const Configuration& configuration, const Material& material) const override {
    const YPoleParameters p = read_y_pole_parameters(configuration, "ya4");
    return y_pole_design(p, environment_unit(p), illumination_unit(p, material), material);
  }
};

BUMP_REGISTER_SCHEME(Ya4);

}  // namespace

}  // namespace bump::ya4
