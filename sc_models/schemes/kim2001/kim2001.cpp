// The scheme of Kim, Lee and Park 2001 as one Design: see README.md of this folder.

#include <algorithm>
#include <cmath>

#include "schemes/common/light_tables.h"
#include "schemes/common/polar_error.h"
#include "schemes/common/polar_map.h"
#include "schemes/common/polar_vectors.h"
#include "schemes/kim2001/environment.h"
#include "schemes/kim2001/illumination.h"
#include "schemes/kim2001/kim_parameters.h"
#include "schemes/scheme.h"

namespace bump::kim2001 {

namespace {

constexpr double two_pi = 6.283185307179586476925;

/// Changes of the object's angles that tilt N to N': right where N is on the object's equator, and to first order in theta elsewhere.
BumpEncoding map_of_changes(const KimParameters& p) {
  BumpEncoding map;
  map.channels = {{"dphi", p.change_of_phi(), ChannelKind::linear}, {"dtheta", p.change_of_theta(), ChannelKind::linear}};
  map.encode = [tangent = p.tangent](const glm::dvec3& normal, double* channels) {
    const double along_phi = tangent == Tangent::phi ? normal.x : normal.y, along_theta = tangent == Tangent::phi ? -normal.y : normal.x;
    channels[0] = along_phi == 0 && normal.z == 0 ? 0.0 : std::atan2(along_phi, normal.z) / two_pi;
    channels[1] = std::asin(std::clamp(along_theta, -1.0, 1.0)) / two_pi;
  };
  map.filterable = p.map_filter == MapFilter::linear;
  map.note = map.filterable ? "changes of two angles, 0 on flat texels: they filter as they are" : "nearest texel";
  return map;
}

class Kim2001 : public Scheme {
 public:
  const SchemePage& page() const override {
    static const SchemePage page{"kim2001",
                                 "Dot products of polar vectors",
                                 "J. S. Kim, J. H. Lee, K. H. Park, Computers & Graphics 25(3), 2001, as Lee et al. 2007 compares it",
                                 "illumination as Lee 2007 gives it; environment a reconstruction of its operator counts",
                                 "N', L and H are polar angles, dot products of them cost 3 multipliers and 5 tables each. L and H are "
                                 "taken to the space of the map by a matrix, which is Lee 2007's estimate and exact, or not at all.",
                                 {"environment"}};
    return page;
  }

  void declare(Parameters& parameters) const override { declare_parameters(parameters); }

  Design design(const Configuration& configuration, const Material& material) const override {
    const KimParameters p = read_parameters(configuration);
    const bool matrix = p.transform == Transform::matrix;
    Design design;
    record_polar_vectors(p, matrix ? NormalAs::matrix : NormalAs::angles, design);
    design.environment = environment_unit(p);
    design.illumination = illumination_unit(p, material);
    design.map = matrix ? polar_map(p) : map_of_changes(p);
    using Of = DeliveredDirection::Of;
    if (matrix)
      design.directions = {{Of::light, DeliveredDirection::Frame::tangent, {"L_ref.phi", "L_ref.theta"}},
                           {Of::half, DeliveredDirection::Frame::tangent, {"H_ref.phi", "H_ref.theta"}}};
    design.quantisation_floor_db =
        light_word_floor_db(polar_floor_db(p, {p.table_bits, p.word_bits, 0, p.light_table_bits}, material), p.light_word_bits);
    return design;
  }
};

BUMP_REGISTER_SCHEME(Kim2001);

}  // namespace

}  // namespace bump::kim2001
