#pragma once
// The look-up tables of Lee 2007, sections 5.1 and 6: SC, ASIN, RECIP, ATAN, T_prop a vector. The
// paper gives their number and "8 Kbytes"; shapes are a reconstruction: 256 words of 16 bits a column, sine and cosine one table of two
// columns, the two reciprocals one column read twice, since 1/(2 cos Z) = 1/(2 sin(90 - Z)). So twelve tables are 8192 bytes exactly.
// Leaves out interpolation between entries (the paper has none).

#include "datapath/table.h"
#include "schemes/lee2007/lee_parameters.h"

namespace bump::lee2007 {

struct RotationTables {
  TablePtr sine_cosine;  ///< of X and Y (input angles): Eqs 7, 9
  TablePtr arc_sine;     ///< sin -> angle within a quarter turn: Eq 7
  TablePtr reciprocal;   ///< Z -> |1/(2 sin Z)|, |1/(2 cos Z)|: Eqs 9, 27
  TablePtr arc_tangent;  ///< |tan| -> angle in the first quarter, floating index: Eq 9
  TablePtr proportion;   ///< |y_k| -> asin(y_k) / 90 degrees: Eq 26
  // Only for the exact variants:
  TablePtr cosine_input;      ///< of an input angle
  TablePtr arc_sine_quarter;  ///< |y_k| -> asin(y_k) in turns
  TablePtr cosine_inner;      ///< of an inner angle
};
RotationTables rotation_tables(const LeeParameters& p);

/// Formats on the edges that the tables prescribe.
Format half_sum_format(const LeeParameters& p);    ///< (sin X + sin Y)/2, the index of ASIN
Format arc_format(const LeeParameters& p);         ///< what ASIN delivers: signed, within a quarter turn
Format tangent_format(const LeeParameters& p);     ///< products of |cos Y - cos X| and a reciprocal
Format proportion_format(const LeeParameters& p);  ///< a fraction of one in word_bits bits

}  // namespace bump::lee2007
