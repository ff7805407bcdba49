// NC2 as one Design: see README.md of this folder.

#include "schemes/common/cordic_error.h"
#include "schemes/nc2/environment.h"

namespace bump::nc2 {

namespace {

class Nc2 : public Scheme {
 public:
  const SchemePage& page() const override {
    static const SchemePage page{
        "nc2", "The bumped normal to object angles by CORDIC: two multipliers (pole on y)", "this project; in no paper", "this project's",
        "As N3, with two vectoring CORDICs in place of arc tangent and arc cosine: stages of shifts and adders instead of inverse tables "
        "and the division. The law of cosines of Lee 2007 takes the two multipliers that are left."};
    return page;
  }

  void declare(Parameters& parameters) const override {
    declare_object_angles_parameters(parameters, "nc2");
    parameters.integer("nc2.stages", Nc2Parameters{}.stages, 4, 18, "stages", "of each CORDIC");
  }

  Design design(const Configuration& configuration, const Material& material) const override {
    Nc2Parameters p;
    static_cast<ObjectAnglesParameters&>(p) = read_object_angles_parameters(configuration, "nc2");
    p.stages = static_cast<int>(configuration.integer("nc2.stages"));
    Design design = object_angles_design(p, environment_unit(p), material);
    design.quantisation_floor_db = cordic_floor_db(design.quantisation_floor_db, p.stages, 2, material);
    return design;
  }
};

BUMP_REGISTER_SCHEME(Nc2);

}  // namespace

}  // namespace bump::nc2
