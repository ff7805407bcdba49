#include "schemes/common/polar_settings.h"

namespace bump {

void declare_polar_settings(Parameters& p, const std::string& id, const PolarSettings& defaults) {
  p.integer(id + ".angle_bits", defaults.angle_bits, 5, 16, "bits", "bits of a full turn in the interpolated angles");
  p.integer(id + ".texel_phi_bits", defaults.texel_phi_bits, 3, 12, "bits", "bits of phi in a bump texel, for a full turn");
  p.integer(id + ".texel_theta_bits", defaults.texel_theta_bits, 3, 12, "bits", "bits of theta in a bump texel, for a quarter turn");
  p.integer(id + ".texel_vector_bits", defaults.texel_vector_bits, 3, 16, "bits",
            "bits of a component of a bump texel (map_filter = vector)");
  p.choice(id + ".map_filter", "nearest", {"nearest", "linear", "vector"},
           "bump texel: nearest, or filtered as two angles (phi is undefined on flat texels), or a vector that is filtered and then "
           "converted per pixel");
  p.choice(id + ".angles", "vertex", {"vertex", "pixel"},
           "polar angles: interpolated from the vertices, or formed per pixel from interpolated vectors");
}

void declare_in_plane_settings(Parameters& p, const std::string& id) {
  p.choice(id + ".frame", "pixel", {"none", "face", "pixel"},
           "angle from e_theta to the tangent, added to phi of the map: none as the paper, one a face, or interpolated");
  p.boolean(id + ".mirror", false, "carry one flag a triangle for mirrored texture charts, and negate phi of the map where it is set");
}

void read_polar_settings(const Configuration& c, const std::string& id, PolarSettings& s) {
  s.angle_bits = static_cast<int>(c.integer(id + ".angle_bits"));
  s.texel_phi_bits = static_cast<int>(c.integer(id + ".texel_phi_bits"));
  s.texel_theta_bits = static_cast<int>(c.integer(id + ".texel_theta_bits"));
  s.texel_vector_bits = static_cast<int>(c.integer(id + ".texel_vector_bits"));
  const std::string& filter = c.choice(id + ".map_filter");
  s.map_filter = filter == "nearest" ? MapFilter::nearest : filter == "linear" ? MapFilter::linear : MapFilter::vector;
  s.angles = c.choice(id + ".angles") == "vertex" ? Angles::vertex : Angles::pixel;
}

void read_in_plane_settings(const Configuration& c, const std::string& id, PolarSettings& s) {
  const std::string& frame = c.choice(id + ".frame");
  s.frame = frame == "none" ? InPlane::none : frame == "face" ? InPlane::face : InPlane::pixel;
  s.mirror = c.boolean(id + ".mirror");
}

}  // namespace bump
