#pragma once
// The illumination unit of Kim, Lee and Park 2001 as Lee 2007, Eqs 3-4 and Table 1, gives it: two dot products of polar vectors,
//   N'.V = cos theta_V cos theta_N' + sin theta_V sin theta_N' cos(phi_V - phi_N'),
// each with 3 multipliers, 2 adders and 5 tables, then the light tables and their sum: 6 multipliers, 5 adders, 12 tables. Sines and
// cosines of one angle are separate tables in that count. Leaves out ambient light and colour, which all schemes share. Timing: that of
// the operators recorded.

#include "datapath/netlist.h"
#include "schemes/kim2001/kim_parameters.h"
#include "units/scene.h"

namespace bump::kim2001 {

/// Inputs as environment_unit delivers them (of "N_L", "N_H" only the first for tables = shared). Output "intensity".
Netlist illumination_unit(const KimParameters& p, const Material& material);

}  // namespace bump::kim2001
