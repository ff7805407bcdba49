#pragma once
// A second, slow definition of fixed-point evaluation, written from the rules on paper and sharing no arithmetic with the library: 128-bit
// integers, one halving at a time for the rounding rule, search instead of division and root, tables by grouping all index codes.

#include <cstdint>
#include <map>
#include <vector>

#include "datapath/netlist.h"

namespace bump_test {

__extension__ using Wide = __int128;

/// numerator * 2^-fraction, floored to the format and wrapped.
std::int64_t oracle_round(Wide numerator, int fraction, const bump::Format& to);
/// Nearest word of a finite double, halves up.
std::int64_t oracle_quantise(double value, const bump::Format& to);
std::int64_t oracle_divide(std::int64_t a, const bump::Format& fa, std::int64_t b, const bump::Format& fb, const bump::Format& to);
std::int64_t oracle_root(std::int64_t a, const bump::Format& fa, const bump::Format& to);

struct OracleRead {
  std::int64_t address;
  std::vector<std::int64_t> words;
};
/// Every combination of index codes of a table with its address and the words it reads; index words of at most 16 bits together.
std::map<std::vector<std::int64_t>, OracleRead> oracle_table(const bump::Table& table);

class Oracle {
 public:
  explicit Oracle(const bump::Netlist& netlist);
  /// Raw word of every node (for table nodes the address); inputs in port order.
  std::vector<std::int64_t> evaluate(const std::vector<double>& inputs) const;

 private:
  const bump::Netlist& netlist_;
  std::vector<std::map<std::vector<std::int64_t>, OracleRead>> tables_;
};

}  // namespace bump_test
