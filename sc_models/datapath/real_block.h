#pragma once
// How a table computes a whole block of double-precision evaluation at once: all columns of it, for an array of lanes, in one indirect
// call, so that columns share what they have in common and the loop vectorises. Timing: none, this is host arithmetic.

#include <functional>

namespace bump {

/// index[j][i] is the j-th index value of lane i, columns[k][i] takes the value of column k; arrays do not overlap. The lanes of a block
/// are independent: a lane's bits depend on its index values alone.
using BlockFunction = std::function<void(const double* const* index, double* const* columns, int lanes)>;

}  // namespace bump
