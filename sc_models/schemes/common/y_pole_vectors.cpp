#include "schemes/common/y_pole_vectors.h"

#include "datapath/invariant.h"

namespace bump {

PolarWires chart_angles(Netlist& n, const std::string& name, const VectorWires& normal, const VectorWires& tangent, InPlane frame,
                        const PolarFormats& f, const Format& product, double axis_limit) {
  BUMP_ASSERT(frame == InPlane::parallel || frame == InPlane::meridian);
  const Netlist::Scope scope(n, name);
  const Format component = n.format(normal.x);
  const bool parallel = frame == InPlane::parallel;
  PolarWires p = distance_from_axis(n, normal, f, axis_limit);
  // On the axis e_phi = (-sin phi, cos phi) = T, or e_theta = +-(cos phi, sin phi) = T.
  const Wire axis_x = parallel ? tangent.y : tangent.x;
  const Wire axis_y = parallel ? n.negate("minus_tx", tangent.x, component) : tangent.y;
  const Wire x = n.select("x", p.on_axis, axis_x, normal.x, component), y = n.select("y", p.on_axis, axis_y, normal.y, component);
  const auto times = [&](const char* result, Wire a, Wire b) { return n.mul(result, a, b, product); };
  Wire along;
  if (parallel) {
    const Wire x_ty = times("x_ty", x, tangent.y), y_tx = times("y_tx", y, tangent.x);
    along = n.sub("east", x_ty, y_tx, product);
  } else {
    const Wire x_tx = times("x_tx", x, tangent.x), y_ty = times("y_ty", y, tangent.y);
    const Wire radial = n.add("radial", x_tx, y_ty, product);
    const Wire z_radial = times("z_radial", radial, normal.z), axis_tz = times("axis_tz", p.axis_squared, tangent.z);
    along = n.sub("south", z_radial, axis_tz, product);
  }
  const Wire turned = n.is_negative("turned", along);
  const auto turned_if = [&](const std::string& result, Wire wire, const Format& format) {
    return n.select(result, turned, n.negate(result + "_negated", wire, format), wire, format);
  };
  const Wire turned_x = turned_if("turned_x", x, component), turned_y = turned_if("turned_y", y, component);
  p.phi = polar_angle(n, "azimuth", turned_y, turned_x, f);
  p.theta = turned_if("theta", polar_angle(n, "polar", p.axis_distance, normal.z, f, true), f.angle);
  return p;
}

}  // namespace bump
