// The scheme of Kugler 1998 as one Design: see README.md of this folder.

#include <algorithm>
#include <cmath>

#include "schemes/common/light_tables.h"
#include "schemes/kugler1998/environment.h"
#include "schemes/kugler1998/illumination.h"
#include "schemes/kugler1998/vertex_program.h"
#include "schemes/scheme.h"

namespace bump::kugler1998 {

namespace {

constexpr double two_pi = 6.283185307179586476925;

double step(int bits) {
  return std::ldexp(1.0, -bits);
}

/// The tilt in codes of the map, the last of which is the largest.
BumpEncoding polar_bumps(const KuglerParameters& p) {
  BumpEncoding map;
  map.channels = {{"phi", p.map_phi(), ChannelKind::angle}, {"theta", p.tilt_code(), ChannelKind::linear}};
  map.encode = [largest = p.max_tilt / 360, last = last_code(p.map_tilt_bits)](const glm::dvec3& normal, double* channels) {
    const double axis = std::hypot(normal.x, normal.y);
    channels[0] = axis == 0 ? 0.0 : std::atan2(normal.y, normal.x) / two_pi;
    channels[1] = std::min(std::atan2(axis, normal.z) / two_pi / largest, 1.0) * last;
  };
  map.filterable = false;
  map.note = "nearest texel: phi wraps and is undefined on flat texels, so (phi, theta) does not filter";
  return map;
}

/// Sum of the largest errors of N' by cause, radians: each turns a unit vector by no more than itself.
double largest_error(const KuglerParameters& p) {
  const double quarter = two_pi / 4, tilt = std::min(1.0, std::sin(p.max_tilt / 360 * two_pi));
  const double table_mantissa = step(p.table_bits - 4 + 1);  // relative, of RECIP and ATAN: half of a binade's share
  // Of phi_N: components of N at the edge of the axis, both tables, and the words.
  const double azimuth = step(KuglerParameters::component_bits) * 1.5 / KuglerParameters::axis + 1.5 * table_mantissa + step(8) +
                         4 * quarter * step(p.angle_bits);
  // Of theta_N: two reciprocals, a secant, an arc tangent; then half a code.
  const double polar = 2 * table_mantissa + step(8) + 2 * step(p.table_bits - 1) + 2 * quarter * step(p.angle_bits) +
                       quarter / 2 / (std::ldexp(1.0, p.map_theta_bits) - 1);
  const double turned = tilt * (2 * quarter * step(p.map_phi_bits + 1) + 4 * quarter * (step(p.angle_bits) + step(p.texel_phi_bits + 1)));
  // A texel is rounded; a product is cut off, too.
  const double tilted = p.max_tilt / 360 * two_pi / (std::ldexp(1.0, p.map_tilt_bits) - 1) * (0.5 * p.strength + (p.strength == 1 ? 0 : 1));
  const double words = 2 * 2 * quarter * step(p.map_word_bits) + 2 * 4 * quarter * step(p.angle_bits);
  const double address = 2 * quarter * step(std::min(p.table_bits, p.angle_bits - 2)) + 6 * step(p.word_bits) + 2 * step(p.table_bits) +
                         2 * (step(p.row_bits()) + step(p.column_bits()));
  return azimuth + polar + turned + tilted + words + address;
}

double floor_db(const KuglerParameters& p, const Material& material) {
  const double words = (1 + material.specular) * p.light_word().step();
  return std::max(3.0, -20 * std::log10(largest_error(p) * angular_slope(material) + words));
}

class Kugler1998 : public Scheme {
 public:
  const SchemePage& page() const override {
    static const SchemePage page{
        "kugler1998",
        "Angles perturbed by a map, light maps in place of dot products",
        "A. Kugler, Graphics Hardware 1998 (IMEM), as Lee et al. 2007 compares it",
        "reconstruction of the operator counts that Lee 2007 gives; of the paper only the abstract was at hand",
        "The interpolated normal becomes polar angles and is perturbed in object space by two adders and one map of "
        "32 Kbytes. Its direction addresses a diffuse and a specular light map of 1 Mbyte each, filled every frame "
        "for all lights; no dot product per pixel.",
        {"environment", "illumination"},
        false};
    return page;
  }

  void declare(Parameters& parameters) const override { declare_parameters(parameters); }

  Design design(const Configuration& configuration, const Material& material) const override {
    const KuglerParameters p = read_parameters(configuration);
    Design design;
    record_vertex_program(p, design);
    design.environment = environment_unit(p);
    design.light_maps = light_maps(p, material);
    design.illumination = illumination_unit(p, material);
    design.map = polar_bumps(p);
    design.quantisation_floor_db = floor_db(p, material);
    design.jumps = {"off_axis"};
    return design;
  }
};

BUMP_REGISTER_SCHEME(Kugler1998);

}  // namespace

}  // namespace bump::kugler1998
