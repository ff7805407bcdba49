#include "schemes/common/trigonometric_tables.h"

#include <cmath>

#include "datapath/real_tables.h"

namespace bump {

namespace {

constexpr double two_pi = 6.283185307179586476925;

Column sine_column(int word_bits) {
  Column column;
  column.name = "sin";
  column.function = [](double turns) { return std::sin(two_pi * turns); };
  column.format = sine_format(word_bits);
  column.symmetry.odd_about_zero = true;
  return column;
}

Column cosine_column(int word_bits) {
  Column column;
  column.name = "cos";
  column.function = [](double turns) { return std::cos(two_pi * turns); };
  column.format = sine_format(word_bits);
  column.symmetry.odd_about_quarter = true;
  return column;
}

Table quarter_table(const std::string& name, const std::string& formula, const Format& index, int address_bits) {
  Table table;
  table.name = name;
  table.formula = formula;
  table.index = index;
  table.folding = Folding::quarter;
  table.address_bits = address_bits;
  return table;
}

}  // namespace

Format sine_format(int word_bits) {
  return sfixed(word_bits + 1, word_bits);
}

TablePtr sine_cosine_table(const std::string& name, const Format& index, int address_bits, int word_bits) {
  Table table = quarter_table(name, "sin 2 pi x, cos 2 pi x", index, address_bits);
  table.columns = {sine_column(word_bits), cosine_column(word_bits)};
  table.block = real_tables::sine_cosine();
  return std::make_shared<const Table>(table);
}

TablePtr sine_table(const std::string& name, const Format& index, int address_bits, int word_bits) {
  Table table = quarter_table(name, "sin 2 pi x", index, address_bits);
  table.columns = {sine_column(word_bits)};
  table.block = real_tables::sine();
  return std::make_shared<const Table>(table);
}

TablePtr cosine_table(const std::string& name, const Format& index, int address_bits, int word_bits) {
  Table table = quarter_table(name, "cos 2 pi x", index, address_bits);
  table.columns = {cosine_column(word_bits)};
  table.block = real_tables::cosine();
  return std::make_shared<const Table>(table);
}

TablePtr cosine_half_squared_table(const std::string& name, const Format& index, int address_bits, int word_bits) {
  Table table = quarter_table(name, "cos^2(2 pi x / 2)", index, address_bits);
  table.folding = Folding::magnitude;
  Column column;
  column.name = "value";
  column.function = [](double turns) { return 0.5 + 0.5 * std::cos(two_pi * turns); };
  column.format = ufixed(word_bits, word_bits);
  table.columns = {column};
  table.block = real_tables::cosine_half_squared();
  return std::make_shared<const Table>(table);
}

TablePtr haversine_table(const std::string& name, const Format& index, int address_bits, int word_bits) {
  Table table = quarter_table(name, "(1 - cos 2 pi x) / 2", index, address_bits);
  table.folding = Folding::magnitude;
  Column column;
  column.name = "value";
  column.function = [](double turns) { return 0.5 - 0.5 * std::cos(two_pi * turns); };
  column.format = ufixed(word_bits, word_bits);
  table.columns = {column};
  return std::make_shared<const Table>(table);
}

}  // namespace bump
