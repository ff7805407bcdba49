#pragma once
// The environment unit of YP6G, YP6 for surfaces with any tangents: the map's pole is on z, where turning a texel by the in-plane angle
// alpha is one addition, and N' is rotated by theta_N through sums of angles. With ph = phi_N' + alpha, u = theta_N' + theta_N, v =
// theta_N' - theta_N,
//   a = (sin(u + ph) + sin(u - ph) + sin(v + ph) + sin(v - ph))/4 + (sin u - sin v)/2
//   s = (cos(theta_N' - ph) - cos(theta_N' + ph))/2
//   c = (cos(u + ph) + cos(u - ph) - cos(v + ph) - cos(v - ph))/4 + (cos u + cos v)/2
//   N'.A' = G a + K s + z c                                                                                        (YP6G)
// with G, K, z of a vector A in {L, H} (sums_projection.h). 28 adders, one of them for alpha, and 14 tables of 24 columns; the illumination
// unit, that of YP6, adds 6 multipliers, 4 adders. This project's; in no paper. Timing: that of the operators recorded.

#include "schemes/common/y_pole_design.h"

namespace bump::yp6g {

struct Yp6gParameters {
  PolarSettings polar;   ///< angles that arrive, map, in-plane angle
  YPoleParameters sums;  ///< widths
};

/// Inputs "N.phi", "N.theta", "L.phi" ... and "alpha" in input_angle(), the map's; outputs "L_turned.G", "L_turned.K", "L_turned.z", those
/// of H, "N_turned.a", "N_turned.s", "N_turned.c" in normal_formats().
Netlist environment_unit(const Yp6gParameters& p);
NormalFormats normal_formats(const Yp6gParameters& p);

}  // namespace bump::yp6g
