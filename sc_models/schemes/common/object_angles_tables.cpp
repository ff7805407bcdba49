#include "schemes/common/object_angles_tables.h"

#include <algorithm>
#include <cmath>

#include "schemes/common/trigonometric_tables.h"

namespace bump {

namespace {

constexpr double two_pi = 6.283185307179586476925;

Column sine_column(const ScaledColumn& c) {
  Column column;
  column.name = "sin";
  column.function = [factor = c.factor](double turns) { return factor * std::sin(two_pi * turns); };
  column.format = sine_format(c.word_bits);
  column.symmetry.odd_about_zero = true;
  return column;
}

Column cosine_column(const ScaledColumn& c) {
  Column column;
  column.name = "cos";
  column.function = [factor = c.factor](double turns) { return factor * std::cos(two_pi * turns); };
  column.format = sine_format(c.word_bits);
  column.symmetry.odd_about_quarter = true;
  return column;
}

TablePtr quarter_table(const std::string& name, const std::string& formula, const Format& index, int table_bits,
                       std::vector<Column> columns) {
  Table table;
  table.name = name;
  table.formula = formula;
  table.index = index;
  table.folding = Folding::quarter;
  table.address_bits = table_bits;
  table.columns = std::move(columns);
  return std::make_shared<const Table>(table);
}

std::string scaled(const char* function, const ScaledColumn& c) {
  return c.factor == 1 ? std::string(function) : std::to_string(c.factor) + " " + function;
}

}  // namespace

TablePtr scaled_sine_cosine_table(const std::string& name, const Format& index, int table_bits, const ScaledColumn& sine,
                                  const ScaledColumn& cosine) {
  return quarter_table(name, scaled("sin 2 pi x", sine) + ", " + scaled("cos 2 pi x", cosine), index, table_bits,
                       {sine_column(sine), cosine_column(cosine)});
}

TablePtr scaled_sine_table(const std::string& name, const Format& index, int table_bits, const ScaledColumn& sine) {
  return quarter_table(name, scaled("sin 2 pi x", sine), index, table_bits, {sine_column(sine)});
}

TablePtr scaled_cosine_table(const std::string& name, const Format& index, int table_bits, const ScaledColumn& cosine) {
  return quarter_table(name, scaled("cos 2 pi x", cosine), index, table_bits, {cosine_column(cosine)});
}

TablePtr complement_arc_cosine_table(const std::string& name, const Format& index, int address_bits, const Format& angle_format) {
  Table table;
  table.name = name;
  table.formula = "acos(1 - x) / 2 pi, 0 <= x <= 1";
  table.index = index;
  table.folding = Folding::floating;
  table.address_bits = address_bits;
  table.exponent_bits = 4;
  table.min_exponent = -16;
  Column column;
  column.name = "angle";
  column.function = [](double x) { return std::acos(std::clamp(1 - x, -1.0, 1.0)) / two_pi; };
  column.format = angle_format;
  table.columns = {column};
  return std::make_shared<const Table>(table);
}

Wire opposite_if(Netlist& n, const std::string& name, Wire flag, Wire angle) {
  const Format format = n.format(angle);
  const Wire opposite = n.half_turn(name + "_opposite", n.negate(name + "_negated", angle, format));
  return n.select(name, flag, opposite, angle, format);
}

Wire arc_cosine_of_complement(Netlist& n, const std::string& name, Wire x, const TablePtr& table, const Format& angle_format) {
  const Netlist::Scope scope(n, name);
  const Format index = table->index;
  const Wire complement = n.sub("complement", n.constant("one", 1, index), n.absolute("abs_x", x, index), index);
  const Wire first = n.shift("first", n.table("ACOS", table, complement).front(), 0, angle_format);
  return opposite_if(n, "angle", n.is_negative("x_negative", x), first);
}

Wire polar_arc_cosine(Netlist& n, const std::string& name, Wire half_sum, int address_bits, int word_bits, const Format& angle_format) {
  const int fraction = n.format(half_sum).fraction;
  const TablePtr table =
      complement_arc_cosine_table("ACOS", ufixed(fraction + 1, fraction), address_bits, uangle(word_bits + 2, word_bits + 4));
  return arc_cosine_of_complement(n, name, half_sum, table, angle_format);
}

}  // namespace bump
