// The exact polar rotation as one Design: see README.md of this folder.

#include "schemes/exact_polar/rotation.h"
#include "schemes/scheme.h"

namespace bump::exact_polar {

namespace {

class ExactPolar : public Scheme {
 public:
  const SchemePage& page() const override {
    static const SchemePage page{"exact_polar", "Exact rotation of polar vectors, law-of-cosines illumination",
                                 "this project's baseline for Lee et al. 2007; in no paper",
                                 "this project's: the rotation that the paper approximates, done exactly",
                                 "L and H are turned into the reference space by multiplying both rotations out: 7 multipliers and 3 "
                                 "adders a vector instead of Lee 2007's 3 and 8, "
                                 "and the result is right. Illumination, map and in-plane angle as Lee 2007."};
    return page;
  }

  void declare(Parameters& parameters) const override { declare_rotation_parameters(parameters, "exact_polar"); }

  Design design(const Configuration& configuration, const Material& material) const override {
    const RotationParameters p = read_rotation_parameters(configuration, "exact_polar");
    return rotation_design(p, environment_unit(p), material);
  }
};

BUMP_REGISTER_SCHEME(ExactPolar);

}  // namespace

}  // namespace bump::exact_polar
