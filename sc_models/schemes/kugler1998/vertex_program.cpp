#include "schemes/kugler1998/vertex_program.h"

#include "schemes/common/polar_conversion.h"
#include "schemes/common/vertex_vectors.h"

namespace bump::kugler1998 {

namespace {

/// What psi needs of N's polar angles: the distance from the axis.
PolarWires axis_distance(Netlist& n, const VectorWires& normal, const Format& square, const Format& difference, double limit) {
  PolarWires polar;
  polar.axis_squared = n.add("axis_squared", n.mul("xx", normal.x, normal.x, square), n.mul("yy", normal.y, normal.y, square), square);
  polar.on_axis =
      n.is_negative("on_axis", n.sub("axis_margin", polar.axis_squared, n.constant("axis_limit", limit * limit, square), difference));
  return polar;
}

/// psi per pixel from the interpolated vectors.
Netlist conversion_unit(const KuglerParameters& p) {
  Netlist n("conversion");
  const Netlist::Label label(n, "psi, from e_theta to T");
  constexpr int bits = KuglerParameters::component_bits;
  const PolarFormats formats = pixel_polar_formats(bits, p.table_bits, p.angle_bits, "ATAN_PSI");
  const VectorWires normal = input_vector(n, "N", p.component());
  n.begin_addition();
  const PolarWires polar = axis_distance(n, normal, formats.square, sfixed(2 * bits + 1, 2 * bits - 2), KuglerParameters::axis);
  n.output("psi", in_plane_angle(n, "psi", normal, polar, input_vector(n, "T", p.component()), formats, sfixed(bits + 3, bits + 1), false));
  n.end_addition();
  return n;
}

}  // namespace

void record_vertex_program(const KuglerParameters& p, Design& design) {
  Netlist& n = design.vertex;
  VectorWires normal = input_vector(n, "N", real());
  if (p.frame == Frame::none || p.frame == Frame::pixel) {
    interpolate_vector(design, "N", normal);
    if (p.frame == Frame::none) return;
    interpolate_vector(design, "T", input_vector(n, "T", real()));
    design.conversion = conversion_unit(p);
    return;
  }
  const PolarWires polar = axis_distance(n, normal, real(), real(), KuglerParameters::axis);
  // A normal that the pixel could take for either, on the axis or beside it, would turn psi by any angle: it is put onto the axis.
  const Wire zero = n.constant("zero", 0, real());
  normal.x = n.select("N_x", polar.on_axis, zero, normal.x, real());
  normal.y = n.select("N_y", polar.on_axis, zero, normal.y, real());
  interpolate_vector(design, "N", normal);
  const VectorWires tangent = input_vector(n, "T", real());
  n.output("psi", in_plane_angle(n, "psi", normal, polar, tangent, vertex_polar_formats(), real(), true));
  design.interpolants.push_back({"psi", p.frame == Frame::face ? InterpolantKind::flat_angle : InterpolantKind::angle});
}

}  // namespace bump::kugler1998
