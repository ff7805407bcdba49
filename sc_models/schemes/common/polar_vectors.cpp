#include "schemes/common/polar_vectors.h"

#include <cmath>

#include "schemes/common/polar_conversion.h"
#include "schemes/common/vertex_vectors.h"
#include "schemes/common/y_pole_vectors.h"

namespace bump {

namespace {

constexpr double vertex_axis_limit = 1e-6;  // sine of theta_N below which phi_N is 0: normals of a flat face may carry rounding noise
constexpr int component_bits = 16;          // of interpolated vectors; their angles are as good as any angle word

struct VertexDirections {
  VectorWires normal, tangent, binormal, light, half;
};

/// Unit L and H from the vertex inputs. Only their directions matter to angles; interpolated as vectors they must be bounded.
VertexDirections vertex_directions(Netlist& n) {
  VertexDirections v;
  v.normal = input_vector(n, "N", real());
  v.tangent = input_vector(n, "T", real());
  v.binormal = input_vector(n, "B", real());
  const VectorWires to_light = input_vector(n, "L", real()), to_eye = input_vector(n, "V", real());
  v.light = normalise_vertex(n, "L_unit", to_light);
  v.half = half_vector(n, "H", v.light, normalise_vertex(n, "V_unit", to_eye));
  return v;
}

void interpolate(Design& design, const std::string& name, Wire wire, InterpolantKind kind) {
  design.vertex.output(name, wire);
  design.interpolants.push_back({name, kind});
}

/// theta stays within half a turn, so it needs no short way round, unless it has a sign.
void interpolate_direction(Design& design, const std::string& name, const PolarWires& polar, bool signed_theta = false) {
  interpolate(design, name + ".phi", polar.phi, InterpolantKind::angle);
  interpolate(design, name + ".theta", polar.theta, signed_theta ? InterpolantKind::angle : InterpolantKind::linear);
}

bool follows_chart(const PolarSettings& p) {
  return p.frame == InPlane::parallel || p.frame == InPlane::meridian;
}

/// -1/4 turn where B = T x N, +1/4 where B = N x T: its sign is the flag.
Wire mirror_flag(Netlist& n, const VertexDirections& v) {
  const Netlist::Scope scope(n, "mirror");
  const auto minor = [&](const std::string& name, Wire a, Wire b, Wire c, Wire d) {
    return n.sub(name, n.mul(name + "_1", a, b, real()), n.mul(name + "_2", c, d, real()), real());
  };
  const VectorWires cross{minor("x", v.normal.y, v.tangent.z, v.normal.z, v.tangent.y),
                          minor("y", v.normal.z, v.tangent.x, v.normal.x, v.tangent.z),
                          minor("z", v.normal.x, v.tangent.y, v.normal.y, v.tangent.x)};
  const Wire turn = dot_product(n, "handedness", cross, v.binormal, real(), real());
  return n.select("flag", n.is_negative("is_mirrored", turn), n.constant("mirrored", -0.25, real()), n.constant("straight", 0.25, real()),
                  real());
}

/// Fixed-point conversion of the interpolated vectors.
Netlist conversion_unit(const PolarSettings& p, NormalAs normal_as) {
  Netlist n("conversion");
  const Format component = sfixed(component_bits, component_bits - 1);
  const PolarFormats formats = pixel_polar_formats(component_bits, p.inverse_table_bits, p.angle_bits);
  const double axis_limit = 2 * formats.magnitude.step();
  const Format product = sfixed(component_bits + 3, component_bits + 1);
  const auto deliver = [&](const std::string& name, const PolarWires& polar) {
    n.output(name + ".phi", polar.phi);
    n.output(name + ".theta", polar.theta);
    return polar;
  };
  VectorWires normal;
  PolarWires polar_normal;
  Netlist::Label label(n, "phi, theta of N");
  if (normal_as == NormalAs::angles) {
    normal = input_vector(n, "N", component);
    if (follows_chart(p))
      deliver("N", chart_angles(n, "N_polar", normal, input_vector(n, "T", component), p.frame, formats, product, axis_limit));
    else
      polar_normal = deliver("N", polar_angles(n, "N_polar", normal, formats, axis_limit));
  }
  for (const std::string name : {"L", "H"}) {
    label.next("phi, theta of " + name);
    deliver(name, polar_angles(n, name + "_polar", input_vector(n, name, component), formats, axis_limit));
  }
  if (normal_as == NormalAs::matrix || p.frame != InPlane::pixel) return n;
  label.next("in-plane angle alpha");
  n.begin_addition();
  n.output("alpha", in_plane_angle(n, "frame", normal, polar_normal, input_vector(n, "T", component), formats, product, false));
  n.end_addition();
  return n;
}

}  // namespace

void record_polar_vectors(const PolarSettings& p, NormalAs normal_as, Design& design) {
  Netlist& n = design.vertex;
  const VertexDirections v = vertex_directions(n);
  const PolarFormats formats = vertex_polar_formats();
  const bool per_pixel = p.angles == Angles::pixel, matrix = normal_as == NormalAs::matrix;
  if (matrix) {
    interpolate_vector(design, "N", v.normal);
    interpolate_vector(design, "T", v.tangent);
    interpolate_vector(design, "B", v.binormal);
  }
  if (per_pixel) {
    if (!matrix) interpolate_vector(design, "N", v.normal);
    interpolate_vector(design, "L", v.light);
    interpolate_vector(design, "H", normalise_vertex(n, "H_unit", v.half));
    if (!matrix && (p.frame == InPlane::pixel || follows_chart(p))) interpolate_vector(design, "T", v.tangent);
  }
  const bool alpha_at_vertex = !matrix && (p.frame == InPlane::face || (p.frame == InPlane::pixel && !per_pixel));
  PolarWires normal;
  if (!matrix && !per_pixel && follows_chart(p))
    normal = chart_angles(n, "N_polar", v.normal, v.tangent, p.frame, formats, real(), vertex_axis_limit);
  else if (!matrix && (!per_pixel || alpha_at_vertex))
    normal = polar_angles(n, "N_polar", v.normal, formats, vertex_axis_limit);
  if (!per_pixel) {
    if (!matrix) interpolate_direction(design, "N", normal, follows_chart(p));
    interpolate_direction(design, "L", polar_angles(n, "L_polar", v.light, formats, vertex_axis_limit));
    interpolate_direction(design, "H", polar_angles(n, "H_polar", v.half, formats, vertex_axis_limit));
  }
  if (alpha_at_vertex) {
    n.begin_addition();
    const Wire alpha = in_plane_angle(n, "frame", v.normal, normal, v.tangent, formats, real(), true);
    n.end_addition();
    interpolate(design, "alpha", alpha, p.frame == InPlane::face ? InterpolantKind::flat_angle : InterpolantKind::angle);
  }
  if (!matrix && p.mirror) {
    n.begin_addition();
    interpolate(design, "mirror", mirror_flag(n, v), InterpolantKind::flat_angle);
    n.end_addition();
  }
  if (per_pixel) design.conversion = conversion_unit(p, normal_as);
}

}  // namespace bump
