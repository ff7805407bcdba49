#include "schemes/common/tangent_angles.h"

#include <algorithm>
#include <utility>

#include "schemes/common/cartesian_units.h"
#include "schemes/common/polar_conversion.h"
#include "schemes/common/polar_error.h"
#include "schemes/common/tangent_conversion.h"
#include "schemes/common/vertex_vectors.h"

namespace bump {

namespace {

constexpr double vertex_axis_limit = 1e-9;  // distance from the y axis below which the longitude is 0

void interpolate(Design& design, const std::string& name, Wire wire, InterpolantKind kind) {
  design.vertex.output(name, wire);
  design.interpolants.push_back({name, kind});
}

/// The latitude stays within a quarter turn, so that it needs no short way round.
void interpolate_angles(Design& design, const std::string& name, const VectorWires& v) {
  Netlist& n = design.vertex;
  const PolarFormats formats = vertex_polar_formats();
  // (z, x, y): the pole on the last axis, longitudes from the first.
  const PolarWires axis = [&] {
    const Netlist::Scope scope(n, name);
    return distance_from_axis(n, {v.z, v.x, v.y}, formats, vertex_axis_limit);
  }();
  const Wire psi = polar_angle(n, name + ".longitude", v.x, v.z, formats);
  const Wire zero = n.constant(name + ".no_longitude", 0, real());
  interpolate(design, name + ".psi", n.select(name + ".psi", axis.on_axis, zero, psi, real()), InterpolantKind::angle);
  interpolate(design, name + ".b", polar_angle(n, name + ".latitude", v.y, axis.axis_distance, formats), InterpolantKind::linear);
}

}  // namespace

void declare_tangent_angle_parameters(Parameters& p, const std::string& id) {
  const TangentAngleParameters defaults;
  p.integer(id + ".angle_bits", defaults.angle_bits, 5, 16, "bits", "bits of a full turn in the interpolated angles");
  p.integer(id + ".texel_psi_bits", defaults.texel_psi_bits, 3, 14, "bits", "bits of the longitude in a bump texel, for half a turn");
  p.integer(id + ".texel_latitude_bits", defaults.texel_latitude_bits, 3, 14, "bits",
            "bits of the latitude in a bump texel, for half a turn");
  p.choice(id + ".map_filter", "linear", {"linear", "nearest"}, "bump texel: filtered channel by channel, or the nearest");
  p.choice(id + ".angles", "vertex", {"vertex", "pixel"},
           "longitude and latitude of L and H: interpolated from the vertices, or formed per pixel from interpolated vectors");
  p.integer(id + ".component_bits", defaults.component_bits, 6, 14, "bits",
            "bits of a component of an interpolated vector (angles = pixel)");
  p.integer(id + ".inverse_table_bits", defaults.inverse_table_bits, 4, 12, "bits", "address bits of arc tangents (angles = pixel)");
  p.integer(id + ".half_turn_table_bits", defaults.half_turn_table_bits, 3, 12, "bits",
            "address bits of the table of the difference of longitudes, for half a turn");
  declare_sum_widths(p, id);
}

TangentAngleParameters read_tangent_angle_parameters(const Configuration& c, const std::string& id) {
  const auto integer = [&](const char* key) { return static_cast<int>(c.integer(id + "." + key)); };
  TangentAngleParameters p;
  p.angle_bits = integer("angle_bits");
  p.texel_psi_bits = integer("texel_psi_bits");
  p.texel_latitude_bits = integer("texel_latitude_bits");
  p.filtered = c.choice(id + ".map_filter") == "linear";
  p.angles = c.choice(id + ".angles") == "vertex" ? Angles::vertex : Angles::pixel;
  p.component_bits = integer("component_bits");
  p.inverse_table_bits = integer("inverse_table_bits");
  p.half_turn_table_bits = integer("half_turn_table_bits");
  p.table_bits = integer("table_bits");
  p.word_bits = integer("word_bits");
  p.light_table_bits = integer("light_table_bits");
  p.light_word_bits = integer("light_word_bits");
  p.ports = integer("ports");
  return p;
}

LongitudeLatitude input_tangent_angles(Netlist& n, const std::string& name, const TangentAngleParameters& p) {
  const Wire psi = n.input(name + ".psi", p.input_angle());
  return {psi, n.input(name + ".b", p.input_angle())};
}

Design tangent_angle_design(const TangentAngleParameters& p, Netlist environment, Netlist illumination, const Material& material) {
  Design design;
  const VertexVectors v = record_vertex_vectors(design);
  const TangentFrame frame{v.tangent, v.binormal, v.normal};
  const VectorWires light = to_tangent_space(design.vertex, "L_ts", v.light, frame, real());
  const VectorWires half = to_tangent_space(design.vertex, "H_ts", v.half, frame, real());
  if (p.angles == Angles::vertex) {
    interpolate_angles(design, "L", light);
    interpolate_angles(design, "H", half);
  } else {
    interpolate_vector(design, "L", light);
    interpolate_vector(design, "H", half);
    const TangentConversion widths{p.component_bits, p.inverse_table_bits, p.input_angle()};
    design.conversion = tangent_conversion_unit(widths);
  }
  design.environment = std::move(environment);
  design.illumination = std::move(illumination);
  design.map = y_pole_map(p);
  // Longitude and latitude are read in steps of their tables, and are no finer than the components that they are made of.
  TangentAngleParameters steps = p;
  steps.table_bits = std::min(p.table_bits, p.half_turn_table_bits - 1);
  if (p.angles == Angles::pixel) steps.angle_bits = std::min(p.angle_bits, p.component_bits - 1);
  design.quantisation_floor_db = y_pole_floor_db(steps, material);
  return design;
}

}  // namespace bump
