// Lee 2007 made right, as one Design: see README.md of this folder.

#include "schemes/lee2007_corrected/rotation.h"
#include "schemes/scheme.h"

namespace bump::lee2007_corrected {

namespace {

class Lee2007Corrected : public Scheme {
 public:
  const SchemePage& page() const override {
    static const SchemePage page{
        "lee2007_corrected", "Lee 2007 with both mistakes of its rotation mended", "this project's, from Lee et al. 2007; in no paper",
        "this project's",
        "The paper's rotation by sums of angles and tables, with the angle in the plane taken by both arguments and "
        "the law of cosines in place of its linear Eq 16: exact, with 2 multipliers a vector where the paper has 3. "
        "Illumination, map and in-plane angle as Lee 2007."};
    return page;
  }

  void declare(Parameters& parameters) const override { declare_rotation_parameters(parameters, "lee2007_corrected"); }

  Design design(const Configuration& configuration, const Material& material) const override {
    const RotationParameters p = read_rotation_parameters(configuration, "lee2007_corrected");
    return rotation_design(p, environment_unit(p), material);
  }
};

BUMP_REGISTER_SCHEME(Lee2007Corrected);

}  // namespace

}  // namespace bump::lee2007_corrected
