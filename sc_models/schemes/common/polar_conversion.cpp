#include "schemes/common/polar_conversion.h"

#include <cmath>

#include "datapath/real_tables.h"

namespace bump {

namespace {

constexpr double two_pi = 6.283185307179586476925;

TablePtr octant_table(const std::string& name, const Format& index, int address_bits, const Format& angle) {
  Table table;
  table.name = name;
  table.formula = "atan(x) / 2 pi, 0 <= x <= 1";
  table.index = index;
  table.address_bits = address_bits;
  Column column;
  column.name = "angle";
  column.function = [](double x) { return std::atan(x) / two_pi; };
  column.format = angle;
  table.columns.push_back(column);
  // Vertex angles become words of the hardware: the bits of the C library, whatever the arithmetic of the units.
  if (!index.is_real) table.block = real_tables::arc_tangent();
  return std::make_shared<const Table>(table);
}

}  // namespace

PolarFormats vertex_polar_formats() {
  PolarFormats f;
  f.magnitude = f.difference = f.ratio = f.angle = f.square = real();
  f.octant = octant_table("VERTEX_ATAN", real(), 8, real());
  f.smallest = 1e-300;
  return f;
}

PolarFormats pixel_polar_formats(int component_bits, int address_bits, int angle_bits, const std::string& table) {
  const int fraction = component_bits - 1;
  PolarFormats f;
  f.magnitude = ufixed(component_bits, fraction);
  f.difference = sfixed(component_bits + 1, fraction);
  f.ratio = ufixed(component_bits + 1, component_bits);
  f.angle = turns(angle_bits);
  f.octant = octant_table(table, ufixed(component_bits, component_bits), address_bits, uangle(angle_bits - 2, angle_bits));
  f.smallest = std::ldexp(1.0, -fraction);
  f.square = ufixed(2 * component_bits, 2 * fraction);
  return f;
}

Wire polar_angle(Netlist& n, const std::string& name, Wire y, Wire x, const PolarFormats& f, bool y_is_positive) {
  const Netlist::Scope scope(n, name);
  const Wire abs_x = n.absolute("abs_x", x, f.magnitude);
  const Wire abs_y = y_is_positive ? y : n.absolute("abs_y", y, f.magnitude);
  const Wire steep = n.is_negative("steep", n.sub("comparison", abs_x, abs_y, f.difference));
  const Wire smaller = n.select("smaller", steep, abs_x, abs_y, f.magnitude);
  const Wire larger = n.select("larger", steep, abs_y, abs_x, f.magnitude);
  const Wire divisor = n.clamp("divisor", larger, f.smallest, f.magnitude.is_real ? 1e300 : f.magnitude.highest(), f.magnitude);
  Wire index = n.div("ratio", smaller, divisor, f.ratio);
  if (f.ratio != f.octant->index) index = n.clamp("index", index, 0, 1, f.octant->index);
  const Wire octant = n.shift("octant", n.table("ATAN", f.octant, index).front(), 0, f.angle);
  const Wire reflected = n.sub("quarter_less", n.constant("quarter", 0.25, f.angle), octant, f.angle);
  const Wire quadrant = n.select("quadrant", steep, reflected, octant, f.angle);
  const Wire opposite = n.sub("half_less", n.constant("half", 0.5, f.angle), quadrant, f.angle);
  const Wire upper = n.select("upper", n.is_negative("x_negative", x), opposite, quadrant, f.angle);
  if (y_is_positive) return upper;
  return n.select("angle", n.is_negative("y_negative", y), n.negate("lower", upper, f.angle), upper, f.angle);
}

PolarWires distance_from_axis(Netlist& n, const VectorWires& v, const PolarFormats& f, double axis_limit) {
  PolarWires p;
  const Wire xx = n.mul("xx", v.x, v.x, f.square);
  const Wire yy = n.mul("yy", v.y, v.y, f.square);
  p.axis_squared = n.add("axis_squared", xx, yy, f.square);
  p.axis_distance = n.sqrt("axis_distance", p.axis_squared, f.magnitude);
  const Wire limit = n.constant("axis_limit", axis_limit, f.magnitude);
  p.on_axis = n.is_negative("on_axis", n.sub("axis_margin", p.axis_distance, limit, f.difference));
  return p;
}

PolarWires polar_angles(Netlist& n, const std::string& name, const VectorWires& v, const PolarFormats& f, double axis_limit) {
  const Netlist::Scope scope(n, name);
  PolarWires p = distance_from_axis(n, v, f, axis_limit);
  const Wire azimuth = polar_angle(n, "azimuth", v.y, v.x, f);
  p.phi = n.select("phi", p.on_axis, n.constant("no_azimuth", 0, f.angle), azimuth, f.angle);
  p.theta = polar_angle(n, "polar", p.axis_distance, v.z, f, true);
  return p;
}

Wire in_plane_angle(Netlist& n, const std::string& name, const VectorWires& normal, const PolarWires& polar, const VectorWires& tangent,
                    const PolarFormats& f, const Format& product, bool normal_is_unit) {
  const Netlist::Scope scope(n, name);
  const Format component = n.format(normal.x);
  // (x, y) of N, or of the x axis where N is on the z axis: e_phi is (-y, x, 0) and e_theta (z x, z y, -(x^2 + y^2)), both up to a length.
  const Wire x =
      n.select("x", polar.on_axis, n.constant("one", component.is_real ? 1 : component.highest(), component), normal.x, component);
  const Wire y = n.select("y", polar.on_axis, n.constant("zero", 0, component), normal.y, component);
  Wire east = n.sub("east", n.mul("x_ty", x, tangent.y, product), n.mul("y_tx", y, tangent.x, product), product);
  const Wire radial = n.add("radial", n.mul("x_tx", x, tangent.x, product), n.mul("y_ty", y, tangent.y, product), product);
  const Wire south =
      n.sub("south", n.mul("z_radial", radial, normal.z, product), n.mul("axis_tz", polar.axis_squared, tangent.z, product), product);
  if (!normal_is_unit) {
    const Wire squared = n.add("squared", polar.axis_squared, n.mul("zz", normal.z, normal.z, f.square), f.square);
    east = n.mul("east_scaled", east, n.sqrt("length", squared, f.magnitude), product);
  }
  return polar_angle(n, "alpha", east, south, f);
}

}  // namespace bump
