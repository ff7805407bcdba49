// TL2 as one Design: see README.md of this folder.

#include "schemes/tl2/units.h"

namespace bump::tl2 {

namespace {

class Tl2 : public Scheme {
 public:
  const SchemePage& page() const override {
    static const SchemePage page{"tl2", "Law of cosines on longitude and latitude in tangent space, two multipliers",
                                 "this project; in no paper", "this project's",
                                 "L and H are turned into tangent space at the vertices and interpolated as longitude and latitude about "
                                 "the y axis, where the map has "
                                 "its pole, too. A pixel needs the law of cosines and no rotation. For any mesh."};
    return page;
  }

  void declare(Parameters& parameters) const override { declare_tangent_angle_parameters(parameters, "tl2"); }

  Design design(const Configuration& configuration, const Material& material) const override {
    const TangentAngleParameters p = read_tangent_angle_parameters(configuration, "tl2");
    return tangent_angle_design(p, environment_unit(p), illumination_unit(p, material), material);
  }
};

BUMP_REGISTER_SCHEME(Tl2);

}  // namespace

}  // namespace bump::tl2
