#pragma once
// The illumination unit of Lee 2007, section 5.2 and Fig. 9: both dot products by the law of cosines (Eqs 24-25), intensities from light
// tables. 2 multipliers, 8 tables; 13 adders as section 5.2 writes, or 11 as Table 1 lists, by the identity N'.V = v + (u - v) cos^2((phi_V
// - phi_N') / 2) with u, v the cosines of difference and sum of the thetas (a reconstruction: the paper does not say where two adders
// went). In front, beside the published design, the in-plane angle is added to phi of the map. Leaves out ambient light and colour, which
// all schemes share. Timing: that of the operators recorded.

#include <string>

#include "datapath/netlist.h"
#include "schemes/common/polar_settings.h"
#include "units/scene.h"

namespace bump {

struct LawOfCosines {
  int form = 11;  ///< adders: 11 or 13
  int word_bits = 16, table_bits = 8, light_table_bits = 10, light_word_bits = 16;
  /// Angles inside the datapath: a table word resolves a quarter turn.
  Format inner_angle() const { return turns(word_bits + 2); }
};

struct CosineTables {
  TablePtr cosine;               ///< "COS", of an inner angle: Eqs 24-25
  TablePtr cosine_half_squared;  ///< "COS2HALF", cos^2(x/2), form 11
};
CosineTables cosine_tables(const LawOfCosines& form);

/// N'.V by Eq 24 or 25, node "dot", in [-1, 1]: 1 multiplier, 5 adders (6 in form 13), 3 tables.
Wire law_of_cosines(Netlist& netlist, Wire phi, Wire theta, Wire map_phi, Wire map_theta, const LawOfCosines& form,
                    const CosineTables& tables, const std::string& equation);

/// Inputs "L_ref.phi", "L_ref.theta", "H_ref.phi", "H_ref.theta" in inner_angle(), "map.phi", "map.theta", and "alpha", "mirror" where the
/// settings ask for them. Output "intensity".
Netlist law_of_cosines_unit(const LawOfCosines& form, const PolarSettings& settings, const Material& material);

}  // namespace bump
