#include "schemes/common/inverse_tables.h"

#include <algorithm>
#include <cmath>

#include "datapath/real_tables.h"

namespace bump {

namespace {

constexpr double two_pi = 6.283185307179586476925;
constexpr double smallest_divisor = 1e-13;  // keeps the double evaluation finite; a word saturates long before
constexpr int reciprocal_integer_bits = 8;

Table one_column(const std::string& name, const char* formula, const Format& index, Folding folding, int address_bits,
                 RealFunction function, const Format& format) {
  Table table;
  table.name = name;
  table.formula = formula;
  table.index = index;
  table.folding = folding;
  table.address_bits = address_bits;
  Column column;
  column.name = "angle";
  column.function = std::move(function);
  column.format = format;
  table.columns = {column};
  return table;
}

TablePtr share(Table table) {
  return std::make_shared<const Table>(std::move(table));
}

/// Half a turn less the angle: sign logic.
Wire opposite(Netlist& n, const std::string& name, Wire x, const Format& angle_format) {
  return n.half_turn(name + "_opposite", n.negate(name + "_negated", x, angle_format));
}

}  // namespace

TablePtr arc_sine_table(const std::string& name, const Format& index, int address_bits, const Format& angle_format) {
  Table table = one_column(
      name, "asin(x) / 2 pi", index, Folding::magnitude, address_bits,
      [](double x) { return std::asin(std::clamp(x, -1.0, 1.0)) / two_pi; }, angle_format);
  table.columns.front().symmetry.odd_about_zero = true;
  table.block = real_tables::arc_sine();
  return share(std::move(table));
}

TablePtr arc_cosine_table(const std::string& name, const Format& index, int address_bits, const Format& angle_format) {
  Table table = one_column(
      name, "acos(|x|) / 2 pi", index, Folding::magnitude, address_bits,
      [](double x) { return std::acos(std::min(std::abs(x), 1.0)) / two_pi; }, angle_format);
  table.block = real_tables::arc_cosine();
  return share(std::move(table));
}

TablePtr arc_tangent_table(const std::string& name, const Format& index, int address_bits, const Format& angle_format) {
  Table table = one_column(
      name, "atan(x) / 2 pi, x >= 0", index, Folding::floating, address_bits, [](double x) { return std::atan(x) / two_pi; }, angle_format);
  table.exponent_bits = 4;
  table.min_exponent = -8;
  table.block = real_tables::arc_tangent();
  return share(std::move(table));
}

TablePtr reciprocal_table(const std::string& name, const Format& index, int address_bits, const Format& word) {
  Table table = one_column(
      name, "1 / x, x >= 0", index, Folding::floating, address_bits, [](double x) { return 1 / std::max(x, smallest_divisor); }, word);
  table.exponent_bits = 3;
  table.min_exponent = -reciprocal_integer_bits;
  table.block = real_tables::reciprocal(smallest_divisor);
  table.columns.front().name = "value";
  return share(std::move(table));
}

Wire arc_cosine(Netlist& n, const std::string& name, Wire x, const TablePtr& table, const Format& angle_format,
                const std::string& equation) {
  const Netlist::Scope scope(n, name);
  const Netlist::Label label(n, equation);
  const Wire index = n.clamp("index", x, -1, 1, table->index);
  const Wire first = n.shift("first", n.table("ACOS", table, index).front(), 0, angle_format);
  return n.select("angle", n.is_negative("x_negative", index), opposite(n, "first", first, angle_format), first, angle_format);
}

AzimuthFormats azimuth_formats(int fraction, int address_bits, int word_bits, const Format& angle_format) {
  AzimuthFormats f;
  f.magnitude = ufixed(fraction + 1, fraction);
  f.tangent = ufixed(word_bits + reciprocal_integer_bits + 1, word_bits);
  f.angle = angle_format;
  f.reciprocal =
      reciprocal_table("RECIP", ufixed(fraction, fraction), address_bits, ufixed(word_bits + 4, word_bits + 4 - reciprocal_integer_bits));
  f.arc_tangent = arc_tangent_table("ATAN", f.tangent, address_bits, uangle(word_bits, word_bits + 2));
  return f;
}

Wire azimuth(Netlist& n, const std::string& name, Wire y, Wire x, const AzimuthFormats& f, const std::string& equation) {
  const Netlist::Scope scope(n, name);
  const Netlist::Label label(n, equation);
  const Wire divisor = n.clamp("divisor", n.absolute("abs_x", x, f.magnitude), 0, 1, f.reciprocal->index);
  const Wire reciprocal = n.table("RECIP", f.reciprocal, divisor).front();
  const Wire tangent = n.mul("tangent", n.absolute("abs_y", y, f.magnitude), reciprocal, f.tangent);
  const Wire first = n.shift("first", n.table("ATAN", f.arc_tangent, tangent).front(), 0, f.angle);
  const Wire upper = n.select("upper", n.is_negative("x_negative", x), opposite(n, "first", first, f.angle), first, f.angle);
  return n.select("angle", n.is_negative("y_negative", y), n.negate("lower", upper, f.angle), upper, f.angle);
}

}  // namespace bump
