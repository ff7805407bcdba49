#pragma once
// The light tables: intensities indexed by a dot product, so that material coefficients and the power cost no multiplier (Lee 2007, section
// 6: scalar index, 2^8 to 2^10 words of 16 bits; power table of Ernst 1998 as Lee 2007 counts it). The dot product is clamped to [0, 1] in
// front, which is max(0, .) and lets the whole ROM serve lit pixels. Contents follow the material: one copy per material of a scene.

#include <string>

#include "datapath/netlist.h"
#include "units/scene.h"

namespace bump {

constexpr int default_light_word_bits = 16;
/// Format of the words and of everything behind them: 0 to just under 2.
Format light_format(int word_bits = default_light_word_bits);
/// Sum of a diffuse and a specular word.
Format intensity_format(int word_bits = default_light_word_bits);
/// Format of a clamped dot product: `fraction` bits, 0 to just under 1.
Format clamped_dot_format(int fraction);

/// kd * x, 0 <= x <= 1.
TablePtr diffuse_table(const Format& index, int address_bits, const Material& material, int word_bits = default_light_word_bits);
/// ks * x^n, 0 <= x <= 1; 0 at x = 0.
TablePtr specular_table(const Format& index, int address_bits, const Material& material, int word_bits = default_light_word_bits);

/// Largest change of diffuse plus specular intensity with an angle, per radian: kd + 0.61 ks sqrt(n), the slope of cos and of cos^n at
/// their steepest.
double angular_slope(const Material& material);
/// Largest error of both light tables by taking an entry for its neighbourhood: half an address step times kd + ks n.
double light_table_error(const Material& material, int address_bits);

/// A floor in dB lowered by words of fewer bits than the default's, which leaves it as it is; at least 3.
double light_word_floor_db(double floor_db, int word_bits);

/// max(0, dot): a clamp, no adder.
Wire clamp_dot(Netlist& netlist, const std::string& name, Wire dot, int fraction);

}  // namespace bump
