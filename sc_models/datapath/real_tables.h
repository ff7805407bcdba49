#pragma once
// Block functions of the tables that schemes have in common, by real_turns.h and real_power.h: what the double evaluation computes in place
// of reading a ROM. Each computes what its comment says for the columns in that order; angles are turns. Loops vectorise, for AVX2 where
// the machine has it, with the same bits. Timing: none, this is host arithmetic.

#include "datapath/real_block.h"

namespace bump::real_tables {

/// sin 2 pi x, cos 2 pi x
BlockFunction sine_cosine();
/// sin 2 pi x
BlockFunction sine();
/// cos 2 pi x
BlockFunction cosine();
/// 0.5 + 0.5 cos 2 pi x
BlockFunction cosine_half_squared();
/// factor * asin(x) / 2 pi, x held within [lowest, 1]
BlockFunction arc_sine(double factor = 1, double lowest = -1);
/// acos |x| / 2 pi, |x| at most 1
BlockFunction arc_cosine();
/// atan(x) / 2 pi
BlockFunction arc_tangent();
/// atan(x) / 2 pi, factor * atan(x) / 2 pi
BlockFunction arc_tangent_and_code(double factor);
/// factor * x
BlockFunction proportion(double factor);
/// factor * x^n for positive x, else 0
BlockFunction scaled_power(double factor, double n);
/// 1 / max(x, smallest)
BlockFunction reciprocal(double smallest);
/// 1 / sqrt(max(x, smallest))
BlockFunction reciprocal_root(double smallest);

}  // namespace bump::real_tables
