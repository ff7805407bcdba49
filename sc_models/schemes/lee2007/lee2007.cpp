// The scheme of Lee et al. 2007 as one Design: see README.md of this folder.

#include <algorithm>
#include <cmath>

#include "schemes/lee2007/illumination.h"
#include "schemes/lee2007/lee_parameters.h"
#include "schemes/lee2007/polar_vectors.h"
#include "schemes/lee2007/rotation.h"
#include "schemes/scheme.h"

namespace bump::lee2007 {

namespace {

constexpr double two_pi = 6.283185307179586476925;

BumpEncoding polar_map(const LeeParameters& p) {
  BumpEncoding map;
  map.channels = {{"phi", p.texel_phi(), ChannelKind::angle}, {"theta", p.texel_theta(), ChannelKind::linear}};
  map.encode = [](const glm::dvec3& normal, double* channels) {
    channels[0] = normal.x == 0 && normal.y == 0 ? 0.0 : std::atan2(normal.y, normal.x) / two_pi;
    channels[1] = std::atan2(std::hypot(normal.x, normal.y), normal.z) / two_pi;
  };
  map.filterable = p.linear_filter;
  map.note = p.linear_filter ? "filtered as two angles: speckles where a texel is flat, since phi is undefined there"
                             : "nearest texel: phi wraps and is undefined on flat texels, so (phi, theta) does not filter";
  return map;
}

class Lee2007 : public Scheme {
 public:
  const SchemePage& page() const override {
    static const SchemePage page{"lee2007", "Angular rotation and law-of-cosines illumination",
                                 "Lee et al., An Effective Bump Mapping Hardware Architecture Using Polar Coordinate System, 2007",
                                 "reconstruction from the equations, with the sign corrections that they need",
                                 "L and H are turned into the reference space by two rotations on polar angles, through tables and 3 "
                                 "multipliers a vector; dot products follow "
                                 "from the law of cosines. The rotation is approximate: up to 60 degrees off, 16 on average. The in-plane "
                                 "angle that general meshes need "
                                 "is an addition to the paper, one adder."};
    return page;
  }

  void declare(Parameters& parameters) const override { declare_parameters(parameters); }

  Design design(const Configuration& configuration, const Material& material) const override {
    const LeeParameters p = read_parameters(configuration);
    Design design;
    record_polar_vectors(p, design);
    design.environment = environment_unit(p);
    design.illumination = illumination_unit(p, material);
    design.map = polar_map(p);
    using Of = DeliveredDirection::Of;
    design.directions = {{Of::light, DeliveredDirection::Frame::polar, {"L_ref.phi", "L_ref.theta"}},
                         {Of::half, DeliveredDirection::Frame::polar, {"H_ref.phi", "H_ref.theta"}}};
    design.quantisation_floor_db = quantisation_floor_db(p, material);
    return design;
  }
};

BUMP_REGISTER_SCHEME(Lee2007);

}  // namespace

}  // namespace bump::lee2007
