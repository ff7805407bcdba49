#pragma once
// What schemes with a y-pole bump map have in common around their formula: parameters, the interpolated angles, the map, dot products, and
// the light tables behind them. A scheme adds the netlists that make N'.L and N'.H. Leaves out ambient light and colour, which all schemes
// share. This project's. Timing: that of the operators recorded.

#include <string>

#include "schemes/common/sums_reads.h"
#include "schemes/common/vectors.h"
#include "schemes/common/y_pole_map.h"
#include "schemes/scheme.h"

namespace bump {

struct YPoleParameters : YPoleSettings {
  int table_bits = 10;        ///< k: address bits of a quarter turn of sine and cosine
  int word_bits = 12;         ///< w: bits of a table word
  int light_table_bits = 10;  ///< address bits of the light tables
  int light_word_bits = 16;   ///< of their words, one before the point
  int ports = 1;              ///< of a sine or cosine ROM

  SumWidths sums() const { return {input_angle(), table_bits, word_bits, ports}; }
  TurnWidths turn() const { return {table_bits, word_bits}; }
  /// Of words read, and of half their sums: SineReads::word(), half_word().
  Format word() const { return sfixed(word_bits + 1, word_bits); }
  Format half_word() const { return half_sum_format(word_bits); }
  /// Of products that are summed, and of dot products: two guard bits.
  int product_fraction() const { return word_bits + 2; }
  Format product() const { return sfixed(product_fraction() + 2, product_fraction()); }
};

/// Declares "<id>.table_bits", ".word_bits", ".light_table_bits", ".light_word_bits", ".ports".
void declare_sum_widths(Parameters& parameters, const std::string& id);
/// The same and what y_pole_map.h declares.
void declare_y_pole_parameters(Parameters& parameters, const std::string& id, TexelAs texel = TexelAs::angles);
YPoleParameters read_y_pole_parameters(const Configuration& configuration, const std::string& id, TexelAs texel = TexelAs::angles);

/// a.x b.x + a.y b.y + a.z b.z as "<name>.dot": 3 multipliers, 2 adders.
Wire dot_of(Netlist& netlist, const std::string& name, const VectorWires& a, const VectorWires& b, const YPoleParameters& p);

/// a.x b.x + a.y b.y - a.z b.z as "<name>.dot": 3 multipliers, 2 adders.
Wire dot_less_last(Netlist& netlist, const std::string& name, const VectorWires& a, const VectorWires& b, const YPoleParameters& p);

/// N'.L and N'.H as dot products, and their light tables: inputs "L_turned.G", "L_turned.K", "L_turned.z", the same of H, and "N_turned.a",
/// "N_turned.s", "N_turned.c" in the formats of `normal`. 6 multipliers, 4 adders; 1 adder and 2 tables for the light.
struct NormalFormats {
  Format a, s, c;
};
Netlist projected_illumination_unit(const YPoleParameters& p, const NormalFormats& normal, const Material& material);

/// DIFF[N'.L] + SPEC[N'.H] as output "intensity", dot products clamped to [0, 1): 1 adder, 2 tables.
void output_intensity(Netlist& netlist, Wire n_l, Wire n_h, const YPoleParameters& p, const Material& material);

/// Everything but the two units: vertex program, interpolants, conversion, map, the bound of the self-check.
double y_pole_floor_db(const YPoleParameters& p, const Material& material);
Design y_pole_design(const YPoleParameters& p, Netlist environment, Netlist illumination, const Material& material);

}  // namespace bump
