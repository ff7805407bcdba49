#pragma once
// What exact rotations of polar vectors have in common: parameters, ports, and everything of a Design around the environment unit: polar
// angles at the vertices (polar_vectors.h), the bump map (polar_map.h), the law of cosines (law_of_cosines.h). A scheme adds its
// environment unit, which takes L and H to the reference space of N: x' along e_theta, y' along e_phi, z' along N. Timing: that of the
// operators recorded.

#include <string>

#include "schemes/common/inverse_tables.h"
#include "schemes/common/law_of_cosines.h"
#include "schemes/common/polar_settings.h"
#include "schemes/scheme.h"

namespace bump {

struct RotationParameters : PolarSettings {
  int form = 11;              ///< adders of the illumination unit
  int table_bits = 10;        ///< k: address bits of a quarter turn of sine and cosine
  int word_bits = 12;         ///< w: bits of a table word
  int light_table_bits = 10;  ///< address bits of the light tables
  int light_word_bits = 16;   ///< bits of an intensity

  LawOfCosines illumination() const { return {form, word_bits, table_bits, light_table_bits, light_word_bits}; }
  Format inner_angle() const { return illumination().inner_angle(); }
};

/// Declares "<id>.form", ".table_bits", ".inverse_table_bits", ".word_bits", ".light_table_bits", ".light_word_bits" and what polar_settings.h declares.
void declare_rotation_parameters(Parameters& parameters, const std::string& id);
RotationParameters read_rotation_parameters(const Configuration& configuration, const std::string& id);

/// A direction in polar angles: phi from +x, theta from +z, turns.
struct PolarDirection {
  Wire phi, theta;
};
PolarDirection input_direction(Netlist& netlist, const std::string& name, const Format& format);

/// Tables and formats of the way back from a Cartesian vector to angles, the same in every unit of a scheme.
struct RotationTables {
  TablePtr sine_cosine;    ///< "SC", of an arriving angle
  TablePtr arc_cosine;     ///< "ACOS", of z'
  AzimuthFormats azimuth;  ///< "RECIP", "ATAN"
};
RotationTables rotation_tables(const RotationParameters& p);

/// Records "<name>_ref.phi" = atan2(y', x') and "<name>_ref.theta" = acos z' and makes them outputs, called without the netlist's scope:
/// 1 multiplier, 3 tables.
void output_reference(Netlist& netlist, const std::string& name, Wire x, Wire y, Wire z, const RotationParameters& p,
                      const RotationTables& tables);

/// The whole design around an environment unit that takes "N", "L", "H" (.phi, .theta) to "L_ref", "H_ref".
Design rotation_design(const RotationParameters& p, Netlist environment, const Material& material);

}  // namespace bump
