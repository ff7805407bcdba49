// The scheme of Lee et al. 2007 as one Design: see README.md of this folder.

#include "schemes/common/law_of_cosines.h"
#include "schemes/common/polar_map.h"
#include "schemes/common/polar_vectors.h"
#include "schemes/lee2007/lee_parameters.h"
#include "schemes/lee2007/rotation.h"
#include "schemes/scheme.h"

namespace bump::lee2007 {

namespace {

class Lee2007 : public Scheme {
 public:
  const SchemePage& page() const override {
    static const SchemePage page{"lee2007",
                                 "Angular rotation and law-of-cosines illumination",
                                 "Lee et al., An Effective Bump Mapping Hardware Architecture Using Polar Coordinate System, 2007",
                                 "reconstruction from the equations, with the sign corrections that they need",
                                 "L and H are turned into the reference space by two rotations on polar angles, through tables and 3 "
                                 "multipliers a vector; dot products follow "
                                 "from the law of cosines. The rotation is approximate: 16 degrees off on average and up to 60 for random "
                                 "vectors within 90 degrees of N; "
                                 "angles interpolated across the polar axis add to that. The in-plane "
                                 "angle that general meshes need "
                                 "is an addition to the paper, one adder.",
                                 {"illumination"}};
    return page;
  }

  void declare(Parameters& parameters) const override { declare_parameters(parameters); }

  Design design(const Configuration& configuration, const Material& material) const override {
    const LeeParameters p = read_parameters(configuration);
    Design design;
    record_polar_vectors(p, NormalAs::angles, design);
    design.environment = environment_unit(p);
    design.illumination = law_of_cosines_unit({p.form, p.word_bits, p.table_bits, p.light_table_bits, p.light_word_bits}, p, material);
    design.map = polar_map(p);
    using Of = DeliveredDirection::Of;
    design.directions = {{Of::light, DeliveredDirection::Frame::polar, {"L_ref.phi", "L_ref.theta"}},
                         {Of::half, DeliveredDirection::Frame::polar, {"H_ref.phi", "H_ref.theta"}}};
    design.quantisation_floor_db = quantisation_floor_db(p, material);
    if (p.hemisphere_bit && !p.exact_x_prime) design.jumps = {"L.below_equator", "H.below_equator"};
    return design;
  }
};

BUMP_REGISTER_SCHEME(Lee2007);

}  // namespace

}  // namespace bump::lee2007
