#include "schemes/tl0/tables.h"

#include <algorithm>
#include <cmath>

namespace bump::tl0 {

namespace {

constexpr double two_pi = 6.283185307179586476925;
constexpr double smallest = 1e-300;  // keeps the double evaluation finite; a word saturates long before

double negative_log2(double value) {
  return -std::log2(std::max(std::abs(value), smallest));
}

TablePtr log_table(const std::string& name, const std::string& formula, const Format& index, Folding folding, int address_bits,
                   const Format& word, RealFunction function) {
  Table table;
  table.name = name;
  table.formula = formula;
  table.index = index;
  table.folding = folding;
  table.address_bits = address_bits;
  Column column;
  column.name = "log";
  column.function = std::move(function);
  column.format = word;
  table.columns = {column};
  return std::make_shared<const Table>(table);
}

}  // namespace

TablePtr log_cosine_table(const std::string& name, const Format& index, int address_bits, const Format& word) {
  return log_table(name, "-log2 |cos 2 pi x|", index, Folding::quarter, address_bits, word,
                   [](double turns) { return negative_log2(std::cos(two_pi * turns)); });
}

TablePtr log_haversine_table(const std::string& name, const Format& index, int address_bits, const Format& word) {
  return log_table(name, "-log2 sin^2(2 pi x / 2)", index, Folding::magnitude, address_bits, word,
                   [](double turns) { return 2 * negative_log2(std::sin(two_pi * turns / 2)); });
}

}  // namespace bump::tl0
