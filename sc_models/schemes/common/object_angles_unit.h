#pragma once
// Schemes that bring N' to the object's polar angles once, and leave L and H as they arrive: with N' = (x, y, z) in the frame (e_theta,
// e_phi, N) turned back by theta_N about y, theta* = acos z and phi* = atan2(y, x) + phi_N are its angles in the object, and N'.V is the
// law of cosines (Lee 2007, Eqs 24-25) of (phi*, theta*) and (phi_V, theta_V). No light vector is rotated. A scheme adds the environment
// unit that makes phi* and theta*. This project's. Timing: that of the operators recorded.

#include <string>

#include "schemes/common/law_of_cosines.h"
#include "schemes/common/y_pole_design.h"

namespace bump {

struct ObjectAnglesParameters : YPoleParameters {
  int form = 11;  ///< adders of the illumination unit, as in law_of_cosines.h

  LawOfCosines illumination() const { return {form, word_bits, table_bits, light_table_bits, light_word_bits}; }
  Format inner_angle() const { return illumination().inner_angle(); }
};

/// Declares "<id>.form" and what y_pole_design.h declares.
void declare_object_angles_parameters(Parameters& parameters, const std::string& id);
ObjectAnglesParameters read_object_angles_parameters(const Configuration& configuration, const std::string& id);

/// Inputs "N_object.phi", "N_object.theta" in inner_angle(), "L.phi", "L.theta", "H.phi", "H.theta" as interpolated; output "intensity".
/// 2 multipliers, 11 or 13 adders, 8 tables.
Netlist object_angles_illumination(const ObjectAnglesParameters& p, const Material& material);

/// The whole design around an environment unit with outputs "N_object.phi" and "N_object.theta".
Design object_angles_design(const ObjectAnglesParameters& p, Netlist environment, const Material& material);

}  // namespace bump
