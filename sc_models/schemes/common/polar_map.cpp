#include "schemes/common/polar_map.h"

#include <algorithm>
#include <cmath>

#include "schemes/common/polar_conversion.h"

namespace bump {

namespace {

constexpr double two_pi = 6.283185307179586476925;
constexpr int filter_bits = 4;  // that a filtered component has more than a texel's

BumpEncoding vector_map(int bits) {
  BumpEncoding map;
  for (const char* component : {"x", "y", "z"}) map.channels.push_back({component, sfixed(bits, bits - 1), ChannelKind::linear});
  map.encode = [](const glm::dvec3& normal, double* channels) {
    for (int i = 0; i < 3; ++i) channels[i] = normal[i];
  };
  map.note = "a vector, filtered as any texture and converted to angles per pixel";
  return map;
}

}  // namespace

BumpEncoding polar_map(const PolarSettings& s) {
  if (s.map_filter == MapFilter::vector) return vector_map(s.texel_vector_bits);
  BumpEncoding map;
  map.channels = {{"phi", s.map_phi(), ChannelKind::angle}, {"theta", s.map_theta(), ChannelKind::linear}};
  map.encode = [](const glm::dvec3& normal, double* channels) {
    channels[0] = normal.x == 0 && normal.y == 0 ? 0.0 : std::atan2(normal.y, normal.x) / two_pi;
    channels[1] = std::atan2(std::hypot(normal.x, normal.y), normal.z) / two_pi;
  };
  map.filterable = s.map_filter == MapFilter::linear;
  map.note = map.filterable ? "filtered as two angles: speckles where a texel is flat, since phi is undefined there"
                            : "nearest texel: phi wraps and is undefined on flat texels, so (phi, theta) does not filter";
  return map;
}

MapAngles map_angles(Netlist& n, const PolarSettings& s) {
  if (s.map_filter != MapFilter::vector) {
    const Wire phi = n.input("map.phi", s.map_phi());
    return {phi, n.input("map.theta", s.map_theta())};
  }
  const int bits = s.texel_vector_bits + filter_bits;
  const PolarFormats formats = pixel_polar_formats(bits, s.inverse_table_bits, s.angle_bits, "ATAN_MAP");
  const VectorWires texel = input_vector(n, "map", sfixed(bits, bits - 1));
  const Netlist::Label label(n, "phi, theta of a vector texel");
  n.begin_addition();
  const PolarWires polar = polar_angles(n, "map_polar", texel, formats, formats.magnitude.step());
  n.end_addition();
  return {polar.phi, polar.theta};
}

void output_map_angles(Netlist& n, const PolarSettings& s) {
  if (s.map_filter != MapFilter::vector) return;
  const MapAngles map = map_angles(n, s);
  n.output("map.phi", map.phi);
  n.output("map.theta", map.theta);
}

Wire turned_azimuth(Netlist& n, Wire phi, const PolarSettings& s) {
  const Format map_phi = s.map_phi();
  Netlist::Label label(n, "mirror flag");
  n.begin_addition();
  if (s.mirror)
    phi = n.select("phi_unmirrored", n.is_negative("is_mirrored", n.input("mirror", turns(2))), n.negate("phi_mirrored", phi, map_phi), phi,
                   map_phi);
  label.next("in-plane angle alpha");
  if (s.frame != InPlane::none)
    phi = n.add("phi_turned", phi, n.input("alpha", s.input_angle()), turns(std::max(map_phi.width, s.angle_bits)));
  n.end_addition();
  return phi;
}

}  // namespace bump
