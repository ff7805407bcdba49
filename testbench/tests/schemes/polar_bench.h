#pragma once
// A bench for rotations on polar vectors: the exact rotation by matrices, in double precision, to compare an environment unit with.

#include <string>

#include "datapath/inventory.h"
#include "testbench/tests/schemes/scheme_bench.h"

namespace bump::bench {

/// Turns; phi from +x, theta from +z.
struct Polar {
  double phi, theta;
};
Polar polar_of(const glm::dvec3& v);
/// Sets planes "name.phi", "name.theta".
void set_polar(Planes& planes, const std::string& name, std::size_t lane, Polar p);

/// Ry(-theta_N) Rz(-phi_N) A, by matrices.
glm::dvec3 rotated(const glm::dvec3& a, Polar normal);

/// The largest distance between L' and H' as an environment unit delivers them ("L_ref", "H_ref" from "N", "L", "H") and the unit vectors
/// that they are; random directions over the whole sphere.
double worst_rotation_error(const Netlist& environment, Arithmetic arithmetic, int blocks = 40);

struct GoldenRotation {
  Polar a, normal, expected;  ///< degrees
};
/// Exact rotations computed once by a program of its own, to 0.01 degrees.
const std::vector<GoldenRotation>& golden_rotations();
/// Requires the golden rotations of an environment unit in double precision, for L and for H.
void require_golden_rotations(const Netlist& environment);

/// Requires that a netlist's portion has these operators and no others of Table 1 of Lee 2007.
void require_counts(const Netlist& netlist, Portion portion, int multipliers, int adders, int tables, int dividers = 0,
                    int square_roots = 0);

/// Requires that the scheme `id` in double precision is Eq 2 of Lee 2007 for these settings, wherever N and L point.
void require_exact_illumination(const std::string& id, Settings settings);
/// Requires six decibels a bit, all widths tied to that of the angles, against exact shading.
void require_six_decibels_a_bit(const std::string& id);

/// A point anywhere.
Point anywhere(Random& random);
/// B = T x N.
Point mirrored_point(Random& random);
/// A point whose N is on the object's z axis, within rounding noise; `side` is 1 or -1.
Point point_on_axis(Random& random, double side);
/// A point whose L and V are within about 9 degrees of N, as in a highlight.
Point point_in_highlight(Random& random);

}  // namespace bump::bench
