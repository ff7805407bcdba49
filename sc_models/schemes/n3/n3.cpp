// N3 as one Design: see README.md of this folder.

#include "schemes/n3/environment.h"

namespace bump::n3 {

namespace {

class N3 : public Scheme {
 public:
  const SchemePage& page() const override {
    static const SchemePage page{
        "n3", "The bumped normal to object angles, light left alone: three multipliers (pole on y)", "this project; in no paper",
        "this project's",
        "Instead of rotating L and H into the frame of N, the bumped normal is rotated out of it, once for both: one addition of "
        "longitudes, one arc tangent, one arc cosine. Then the law of cosines of Lee 2007 with the angles of L and H as they arrive."};
    return page;
  }

  void declare(Parameters& parameters) const override { declare_object_angles_parameters(parameters, "n3"); }

  Design design(const Configuration& configuration, const Material& material) const override {
    const ObjectAnglesParameters p = read_object_angles_parameters(configuration, "n3");
    return object_angles_design(p, environment_unit(p), material);
  }
};

BUMP_REGISTER_SCHEME(N3);

}  // namespace

}  // namespace bump::n3
