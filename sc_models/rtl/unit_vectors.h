#pragma once
// Test vectors of a unit: input words and the output words that the bit-accurate evaluation of its netlist gives for them, as text for
// $readmemh and for the harness: a line a vector in lower-case hexadecimal, {in_0, .., out_0, ..}, the first port in the highest bits,
// zeros in front up to a whole digit. The first vectors are corners: each port's words of few or many set bits, least and greatest, first
// all ports alike, then mixed; from a quarter of the vectors on all words are uniformly random over the whole word.

#include <cstdint>
#include <string>

#include "datapath/netlist.h"

namespace bump {

/// count >= 1. The same text for the same netlist, count and seed; the first vectors of a longer text begin with the corners of a longer
/// quarter, so a text is no prefix of another. Ports of at most 53 bits.
std::string unit_vectors(const Netlist& netlist, int count, std::uint64_t seed);

}  // namespace bump
