#pragma once
// A bench for schemes with a y-pole bump map: the dot products that they make of angles, against rotations by matrices in double precision;
// surface points whose tangents follow the axes.

#include <string>

#include "testbench/tests/schemes/polar_bench.h"

namespace bump::bench {

/// N' = (cos b sin psi, sin b, cos b cos psi), turns.
glm::dvec3 from_y_pole(double psi, double latitude);

/// One lane of inputs: directions over the whole sphere, theta_N with either sign, psi and b over full turns.
struct YPoleInputs {
  glm::dvec3 light, half;
  Polar normal;
  double psi, latitude;
  /// Ry(-theta_N) Rz(-phi_N) V . N'
  double dot(const glm::dvec3& v) const;
};

/// Sets a lane of the planes of interpolants and map.
void set_inputs(Planes& planes, std::size_t lane, const YPoleInputs& in);

/// The largest error of the nodes "N_L.dot" and "N_H.dot" (in either unit) against matrices; random inputs of all quadrants.
double worst_dot_error(const Design& design, int blocks = 20);

/// Requires dot products computed once by a program of its own, to 5e-6.
void require_golden_dots(const Design& design);

/// Requires exact shading in double precision: parallel and meridian charts, frame = pixel, angles = pixel, poles of the object.
void require_exact_charts(const std::string& id);
/// Requires that `mirror` shades mirrored charts right, in every frame, and that nothing else does.
void require_mirrored_charts(const std::string& id);
/// Requires six decibels a bit against exact shading: angles, tables, words and texels of a bits each.
void require_six_decibels_of_sums(const std::string& id);
/// Requires that two-ported ROMs give the same words, and that tables with a second port take half the bits, or a little more where a read
/// has no partner.
void require_ports_change_nothing(const std::string& id);

/// Columns of tables read by a netlist in a fragment.
int columns_read(const Netlist& netlist);

/// A point whose tangent runs along a parallel of the z axis, either way round, or towards a pole.
Point point_on_parallel(Random& random);
Point point_on_meridian(Random& random);

}  // namespace bump::bench
