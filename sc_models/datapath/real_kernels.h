#pragma once
// The loops of evaluation in double precision: one operator over an array of lanes, values in and out. Branch-free and free of calls, so
// that the compiler vectorises them; every lane is the same sequence of IEEE operations on any machine. `out` never overlaps an operand.

namespace bump::real_lanes {

using Values = double*;
using ConstValues = const double*;

/// Brings turns to [-0.5, 0.5), in place.
void wrap(Values x, int lanes);
void add(ConstValues a, ConstValues b, Values out, int lanes);
void subtract(ConstValues a, ConstValues b, Values out, int lanes);
/// The difference where the flag is set, else the sum.
void add_or_subtract(ConstValues flags, ConstValues a, ConstValues b, Values out, int lanes);
void multiply(ConstValues a, ConstValues b, Values out, int lanes);
void divide(ConstValues a, ConstValues b, Values out, int lanes);
void root(ConstValues a, Values out, int lanes);
/// Of turns in [-0.5, 0.5), and so is the result.
void add_turns(ConstValues a, ConstValues b, Values out, int lanes);
void subtract_turns(ConstValues a, ConstValues b, Values out, int lanes);
void negate_turns(ConstValues a, Values out, int lanes);
void add_half_turn(ConstValues a, Values out, int lanes);
void scale(ConstValues a, double factor, Values out, int lanes);
/// a * 2^-floor(k), to the last bit while numbers are normal; k that is no number gives none.
void scale_down_by(ConstValues a, ConstValues k, Values out, int lanes);
void negate(ConstValues a, Values out, int lanes);
void absolute(ConstValues a, Values out, int lanes);
void add_half(ConstValues a, Values out, int lanes);
/// 0/0 goes to the upper bound, as the all-ones quotient of the hardware does.
void clamp(ConstValues a, double low, double high, Values out, int lanes);
void select(ConstValues flags, ConstValues a, ConstValues b, Values out, int lanes);
void is_negative(ConstValues a, Values out, int lanes);
void is_beyond_quarter(ConstValues a, Values out, int lanes);
void exclusive_or(ConstValues a, ConstValues b, Values out, int lanes);

}  // namespace bump::real_lanes
