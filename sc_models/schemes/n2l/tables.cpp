#include "schemes/n2l/tables.h"

#include <algorithm>
#include <cmath>

#include "schemes/common/log_reads.h"

namespace bump::n2l {

namespace {

constexpr double two_pi = 6.283185307179586476925;
constexpr double smallest = 1e-300;  // keeps the double evaluation finite; a word saturates long before

double log2_of(double value) {
  return std::log2(std::max(std::abs(value), smallest));
}

TablePtr quarter_table(const std::string& name, const std::string& formula, const Format& index, int table_bits, RealFunction function,
                       const Format& format) {
  Table table;
  table.name = name;
  table.formula = formula;
  table.index = index;
  table.folding = Folding::quarter;
  table.address_bits = table_bits;
  Column column;
  column.name = "log";
  column.function = std::move(function);
  column.format = format;
  table.columns = {column};
  return std::make_shared<const Table>(table);
}

}  // namespace

TablePtr log_tangent_table(const std::string& name, const Format& index, int table_bits, int log_bits) {
  return quarter_table(
      name, "-log2 |tan 2 pi x|", index, table_bits,
      [](double turns) { return log2_of(std::cos(two_pi * turns)) - log2_of(std::sin(two_pi * turns)); },
      sfixed(1 + log_whole_bits + log_bits, log_bits));
}

TablePtr log_sine_table(const std::string& name, const Format& index, int table_bits, int log_bits) {
  return quarter_table(
      name, "-log2 |sin 2 pi x|", index, table_bits, [](double turns) { return -log2_of(std::sin(two_pi * turns)); },
      ufixed(log_whole_bits + log_bits, log_bits));
}

TablePtr arc_tangent_of_power_table(const std::string& name, const Format& index, int address_bits, const Format& angle_format) {
  Table table;
  table.name = name;
  table.formula = "atan(2^-x) / 2 pi, x >= 0";
  table.index = index;
  table.folding = Folding::floating;
  table.address_bits = address_bits;
  table.exponent_bits = 4;
  table.min_exponent = -10;
  Column column;
  column.name = "angle";
  column.function = [](double x) { return std::atan(std::exp2(-x)) / two_pi; };
  column.format = angle_format;
  table.columns = {column};
  return std::make_shared<const Table>(table);
}

}  // namespace bump::n2l
