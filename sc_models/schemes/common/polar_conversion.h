#pragma once
// From Cartesian vectors to polar angles, recorded: what feeds a scheme that works on angles. Lee 2007 takes polar N, L, H as given; this
// is what giving them costs. The angle of (x, y) is the two-argument arc tangent by octants: the smaller over the larger component, one
// divider, one table over [0, 1], and reflections. Source: geometry; conventions of Lee 2007, Eqs 19-21 (phi from +x, theta from +z).
// Total: the angle of (0, 0) is 0 and nothing ever divides by zero. Timing: that of the operators recorded.

#include <string>

#include "schemes/common/vectors.h"

namespace bump {

/// Formats and table of one arc tangent unit.
struct PolarFormats {
  Format magnitude;   ///< unsigned (or real): |x|, |y|
  Format difference;  ///< signed: their comparison
  Format ratio;       ///< unsigned, holds 1: smaller over larger
  Format angle;       ///< turns: the result
  TablePtr octant;    ///< arc tangent over [0, 1] in turns; its index may be the ratio less its top bit (then the ratio is clamped below 1)
  double smallest = 0;  ///< the larger component is raised to this, which keeps 0/0 away
  Format square;        ///< unsigned: squares of components and their sum, for the distance from the axis
};

/// Double precision, for vertex programs.
PolarFormats vertex_polar_formats();
/// Fixed point for vectors in sfixed(component_bits, component_bits - 1): angles in turns(angle_bits) from a table of 2^address_bits words.
/// `table` names the ROM, as formats differ from unit to unit. The words are rounded to the angle's last place and reflections are exact,
/// so no rounding is left over.
PolarFormats pixel_polar_formats(int component_bits, int address_bits, int angle_bits, const std::string& table = "ATAN_OCTANT");

/// The angle of (x, y) in turns, in [-1/2, 1/2): 1 divider, 3 adders (a comparison, two reflections), 1 table. `y_is_positive` omits the
/// sign logic of y.
Wire polar_angle(Netlist& netlist, const std::string& name, Wire y, Wire x, const PolarFormats& formats, bool y_is_positive = false);

struct PolarWires {
  Wire phi, theta;
  Wire axis_distance;  ///< sqrt(x^2 + y^2)
  Wire axis_squared;   ///< x^2 + y^2
  Wire on_axis;        ///< flag: closer to the z axis than can be told; phi is then 0
};

/// What polar_angles() finds of a vector before any angle: axis_distance, axis_squared, on_axis. 2 multipliers, 2 adders, 1 square root.
PolarWires distance_from_axis(Netlist& netlist, const VectorWires& v, const PolarFormats& formats, double axis_limit);

/// Polar angles of a vector of any length: 2 multipliers, 8 adders, 1 square root, 2 dividers, 2 tables. `axis_limit`: the distance from
/// the axis below which phi is 0 (1e-6 of a unit vector is far below any angle word).
PolarWires polar_angles(Netlist& netlist, const std::string& name, const VectorWires& v, const PolarFormats& formats, double axis_limit);

/// The angle from e_theta (growing theta at N) to the tangent T, about N: by it a map made in (T, B, N) turns into the frame
/// (e_theta, e_phi, N) that Lee's rotation delivers. On the axis e_theta is the x axis, as phi = 0 there. N need not have unit length when
/// `normal_is_unit` is false (2 multipliers, 1 adder and 1 square root more). 6 multipliers, 6 adders, 1 divider, 1 table.
/// `product` is the signed format of the intermediate products.
Wire in_plane_angle(Netlist& netlist, const std::string& name, const VectorWires& normal, const PolarWires& polar,
                    const VectorWires& tangent, const PolarFormats& formats, const Format& product, bool normal_is_unit);

}  // namespace bump
