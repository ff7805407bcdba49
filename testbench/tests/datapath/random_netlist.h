#pragma once
// Random netlists that obey the rules of the netlist, for properties that must hold for all of them.

#include <cstdint>
#include <random>
#include <vector>

#include "datapath/netlist.h"

namespace bump_test {

class Random {
 public:
  explicit Random(std::uint64_t seed) : generator_(seed) {}
  /// Uniform in [low, high].
  int integer(int low, int high) { return low + static_cast<int>(generator_() % static_cast<std::uint64_t>(high - low + 1)); }
  std::uint64_t bits() { return generator_(); }
  bool coin() { return (generator_() & 1) != 0; }
  /// Uniform in [low, high).
  double real(double low, double high) { return low + (high - low) * static_cast<double>(generator_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 generator_;
};

/// Mostly short words, now and then up to 62 bits.
bump::Format random_format(Random& random);
/// A double for a port: words of the format (the extreme ones often), values between words and values out of range.
double random_value(Random& random, const bump::Format& format);
/// A table of up to 2^8 words with an index of up to 10 bits that obeys its folding, or a map of two or three short index words.
bump::TablePtr random_table(Random& random, const std::string& name);
/// A netlist of about `size` operators over a few ports; every node that nobody reads is an output.
bump::Netlist random_netlist(Random& random, int size);

}  // namespace bump_test
