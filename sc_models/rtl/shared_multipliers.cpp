#include "rtl/shared_multipliers.h"

#include <fmt/core.h>

#include <algorithm>

#include "datapath/invariant.h"
#include "rtl/operator_text.h"
#include "rtl/verilog.h"

namespace bump {

std::string SharedMultiplier::product_name(int index) {
  return fmt::format("multiplier{}_product", index);
}

std::string SharedMultiplier::declaration(int index) const {
  return fmt::format("  wire {}{};  // shared by {} products\n", verilog_range(width_a + width_b), product_name(index), products.size());
}

std::string SharedMultiplier::steering(int index, const std::vector<Turn>& turns, int bits_of_phase) const {
  std::string text = fmt::format("\n  // multiplier {}:", index);
  for (const Turn& turn : turns) text += fmt::format("{} {} in phase {}", &turn == &turns.front() ? "" : ",", turn.product, turn.phase);
  text += "\n";
  for (const std::size_t factor : {std::size_t{0}, std::size_t{1}}) {
    const int width = factor == 0 ? width_a : width_b;
    std::string value;
    for (std::size_t i = 0; i + 1 < turns.size(); ++i)
      value += fmt::format("phase == {} ? {} : ", verilog_word(turns[i].phase, bits_of_phase), widened(turns[i].factors[factor], width));
    value += widened(turns.back().factors[factor], width);
    text += wire_text(fmt::format("multiplier{}_{}_steered", index, factor == 0 ? 'a' : 'b'), width, value);
  }
  return text;
}

std::string SharedMultiplier::product(int index) const {
  const WordText a = {fmt::format("multiplier{}_a", index), width_a, is_signed, 0},
                 b = {fmt::format("multiplier{}_b", index), width_b, is_signed, 0};
  return fmt::format("  assign {} = {};\n", product_name(index), product_value(a, b));
}

std::vector<SharedMultiplier> shared_multipliers(const Netlist& netlist, const Schedule& schedule) {
  const auto node = [&](int i) -> const Node& { return netlist.nodes()[static_cast<std::size_t>(i)]; };
  const auto format = [&](int product, std::size_t factor) -> const Format& { return node(node(product).operands[factor]).format; };
  const auto size = [&](int product) { return format(product, 0).width * format(product, 1).width; };
  std::vector<std::vector<int>> phases(static_cast<std::size_t>(schedule.initiation_interval));
  for (int i = 0; i < static_cast<int>(netlist.nodes().size()); ++i)
    if (node(i).op == Op::mul)
      phases[static_cast<std::size_t>(schedule.start[static_cast<std::size_t>(i)] % schedule.initiation_interval)].push_back(i);
  std::vector<SharedMultiplier> multipliers(static_cast<std::size_t>(schedule.multipliers_built));
  for (std::vector<int>& phase : phases) {
    std::stable_sort(phase.begin(), phase.end(), [&](int a, int b) { return size(a) > size(b); });
    for (std::size_t m = 0; m < phase.size(); ++m) multipliers[m].products.push_back(phase[m]);
  }
  for (SharedMultiplier& multiplier : multipliers) {
    BUMP_ASSERT(!multiplier.products.empty());
    for (const int product : multiplier.products)
      multiplier.is_signed = multiplier.is_signed || format(product, 0).is_signed || format(product, 1).is_signed;
    const auto width = [&](std::size_t factor) {
      int widest = 0;
      for (const int product : multiplier.products) {
        const Format& word = format(product, factor);
        widest = std::max(widest, word.width + (multiplier.is_signed && !word.is_signed ? 1 : 0));
      }
      return widest;
    };
    multiplier.width_a = width(0);
    multiplier.width_b = width(1);
  }
  return multipliers;
}

}  // namespace bump
