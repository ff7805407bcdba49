// CD0 as one Design: see README.md of this folder.

#include "schemes/cd0/units.h"
#include "schemes/common/cordic_error.h"

namespace bump::cd0 {

namespace {

class Cd0 : public Scheme {
 public:
  const SchemePage& page() const override {
    static const SchemePage page{"cd0", "Dot products of angles by unrolled CORDIC, no multiplier (pole on y)", "this project; in no paper",
                                 "this project's",
                                 "Both dot products as two rotations, by the normal's longitude and by its latitude, in stages of shifts "
                                 "and adders whose directions "
                                 "L and H share. As exact as its stages are many; few small tables, many adders."};
    return page;
  }

  void declare(Parameters& parameters) const override {
    declare_y_pole_parameters(parameters, "cd0");
    parameters.integer("cd0.stages", Cd0Parameters{}.stages, 4, 18, "stages", "of each CORDIC rotation");
  }

  Design design(const Configuration& configuration, const Material& material) const override {
    Cd0Parameters p;
    static_cast<YPoleParameters&>(p) = read_y_pole_parameters(configuration, "cd0");
    p.stages = static_cast<int>(configuration.integer("cd0.stages"));
    Design design = y_pole_design(p, environment_unit(p), illumination_unit(p, material), material);
    design.quantisation_floor_db = cordic_floor_db(design.quantisation_floor_db, p.stages, 2, material);
    return design;
  }
};

BUMP_REGISTER_SCHEME(Cd0);

}  // namespace

}  // namespace bump::cd0
