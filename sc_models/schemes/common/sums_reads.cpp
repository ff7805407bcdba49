#include "schemes/common/sums_reads.h"

#include "datapath/invariant.h"
#include "schemes/common/trigonometric_tables.h"

namespace bump {

Format half_sum_format(int word_bits) {
  return sfixed(word_bits + 3, word_bits + 1);
}

SineReads::SineReads(Netlist& netlist, const SumWidths& widths)
    : netlist_(netlist),
      widths_(widths),
      both_(sine_cosine_table("SC" + widths.suffix, widths.index, widths.table_bits, widths.word_bits), widths.ports),
      sine_(sine_table("SIN" + widths.suffix, widths.index, widths.table_bits, widths.word_bits), widths.ports),
      cosine_(cosine_table("COS" + widths.suffix, widths.index, widths.table_bits, widths.word_bits), widths.ports) {}

SineCosine SineReads::both(const std::string& name, Wire angle, const std::string& equation) {
  const std::vector<Wire> columns = both_.read(netlist_, name, angle, equation);
  return {columns[0], columns[1]};
}

Wire SineReads::sine(const std::string& name, Wire angle, const std::string& equation) {
  return sine_.read(netlist_, name, angle, equation).front();
}

Wire SineReads::cosine(const std::string& name, Wire angle, const std::string& equation) {
  return cosine_.read(netlist_, name, angle, equation).front();
}

Wire SineReads::half_sum(const std::string& name, Wire a, Wire b, const std::string& equation) {
  return sum(name, {a, b}, {}, 1, equation);
}

Wire SineReads::half_difference(const std::string& name, Wire a, Wire b, const std::string& equation) {
  return sum(name, {a}, {b}, 1, equation);
}

Wire SineReads::sum(const std::string& name, const std::vector<Wire>& added, const std::vector<Wire>& subtracted, int halvings,
                    const std::string& equation) {
  BUMP_ASSERT(!added.empty() && added.size() + subtracted.size() <= 16);
  std::vector<Wire> level = added;
  std::vector<bool> negative(added.size(), false);
  level.insert(level.end(), subtracted.begin(), subtracted.end());
  negative.resize(level.size(), true);
  const int fraction = widths_.word_bits;
  // A balanced tree; subtracted words stand at the end, so that a pair is a sum, a difference, or a sum that is subtracted later.
  for (int rank = 1; level.size() > 1; ++rank) {
    const Format format = sfixed(fraction + 1 + rank, fraction);
    std::vector<Wire> next;
    std::vector<bool> next_negative;
    for (std::size_t i = 0; i + 1 < level.size(); i += 2) {
      const std::string step = name + ".sum_" + std::to_string(rank) + "_" + std::to_string(i / 2);
      const bool differ = negative[i] != negative[i + 1];
      next.push_back(differ ? netlist_.sub(step, level[i], level[i + 1], format, equation)
                            : netlist_.add(step, level[i], level[i + 1], format, equation));
      next_negative.push_back(negative[i]);
    }
    if (level.size() % 2 != 0) {
      next.push_back(level.back());
      next_negative.push_back(negative.back());
    }
    level = next;
    negative = next_negative;
  }
  // The result lies within the words' range times 2^-halvings times their number, and is a value of a cosine's size by the identity.
  return netlist_.shift(name, level.front(), -halvings, sfixed(fraction + halvings + 2, fraction + halvings), equation);
}

Wire SineReads::plus(const std::string& name, Wire a, Wire b, const std::string& equation) {
  return netlist_.add(name, a, b, widths_.index, equation);
}

Wire SineReads::minus(const std::string& name, Wire a, Wire b, const std::string& equation) {
  return netlist_.sub(name, a, b, widths_.index, equation);
}

Format SineReads::word() const {
  return sine_format(widths_.word_bits);
}

Format SineReads::half_word() const {
  return half_sum_format(widths_.word_bits);
}

}  // namespace bump
