// YP6 as one Design: see README.md of this folder.

#include "schemes/yp6/units.h"

namespace bump::yp6 {

namespace {

class Yp6 : public Scheme {
 public:
  const SchemePage& page() const override {
    static const SchemePage page{
        "yp6", "Exact dot products of angles, six multipliers (pole on y)", "this project; in no paper", "this project's",
        "The bump map's pole lies on y, so that the second rotation of Lee 2007 is one addition to a longitude. What is "
        "left of both dot products is six multipliers, sums, and sines of sums: exact, without inverse functions."};
    return page;
  }

  void declare(Parameters& parameters) const override { declare_y_pole_parameters(parameters, "yp6"); }

  Design design(const Configuration& configuration, const Material& material) const override {
    const YPoleParameters p = read_y_pole_parameters(configuration, "yp6");
    return y_pole_design(p, environment_unit(p), projected_illumination_unit(p, {p.half_word(), p.word(), p.half_word()}, material),
                         material);
  }
};

BUMP_REGISTER_SCHEME(Yp6);

}  // namespace

}  // namespace bump::yp6
