#include "schemes/lee2007/tables.h"

#include <algorithm>
#include <cmath>

#include "datapath/lane_clones.h"
#include "datapath/real_tables.h"
#include "datapath/real_turns.h"
#include "schemes/common/inverse_tables.h"
#include "schemes/common/trigonometric_tables.h"

namespace bump::lee2007 {

namespace {

constexpr double two_pi = 6.283185307179586476925;
constexpr double largest_reciprocal = 1e12;  // keeps the double evaluation finite at the poles; a word saturates long before

Table make_table(const char* name, const char* formula, const Format& index, Folding folding, int address_bits) {
  Table table;
  table.name = name;
  table.formula = formula;
  table.index = index;
  table.folding = folding;
  table.address_bits = address_bits;
  return table;
}

Column make_column(const char* name, RealFunction function, const Format& format) {
  Column column;
  column.name = name;
  column.function = std::move(function);
  column.format = format;
  return column;
}

TablePtr share(Table table) {
  return std::make_shared<const Table>(std::move(table));
}

/// Integer bits of a reciprocal word. Half an address step from the pole it is about 2^k / 1.6, but it is better saturated earlier: large
/// values meet small |y| only, while the small ones, near 1/2, decide theta' and need the fraction. Six of sixteen bits measured best.
int reciprocal_integer_bits(const LeeParameters& p) {
  return std::min(p.table_bits, (p.word_bits - 4) / 2);
}

double half_over(double x) {
  return std::min(largest_reciprocal, 0.5 / std::max(std::abs(x), 0.1 / largest_reciprocal));
}

BUMP_LANE_LOOP void reciprocals(const double* __restrict x, double* __restrict of_sine, double* __restrict of_cosine, int lanes) {
  // The bounds of half_over(), written so that the loop vectorises.
  constexpr double smallest = 0.1 / largest_reciprocal;
  for (int i = 0; i < lanes; ++i) {
    const SineCosine both = sine_cosine_of_turns(x[i]);
    const double sine = std::fabs(both.sine), cosine = std::fabs(both.cosine);
    const double over_sine = 0.5 / (sine < smallest ? smallest : sine), over_cosine = 0.5 / (cosine < smallest ? smallest : cosine);
    of_sine[i] = over_sine > largest_reciprocal ? largest_reciprocal : over_sine;
    of_cosine[i] = over_cosine > largest_reciprocal ? largest_reciprocal : over_cosine;
  }
}

/// Magnitudes only: the signs of sin Z and cos Z are the top bits of Z.
TablePtr reciprocal_table(const LeeParameters& p) {
  Table table = make_table("RECIP", "|1 / (2 sin 2 pi x)|, |1 / (2 cos 2 pi x)|", p.inner_angle(), Folding::quarter, p.table_bits);
  const Format word = ufixed(p.word_bits, p.word_bits - reciprocal_integer_bits(p));
  Column of_cosine = make_column(
      "half_over_cos", [](double x) { return half_over(std::cos(two_pi * x)); }, word);
  of_cosine.mirrors_first = true;
  table.columns = {make_column(
                       "half_over_sin", [](double x) { return half_over(std::sin(two_pi * x)); }, word),
                   of_cosine};
  table.block = [](const double* const* x, double* const* y, int lanes) { reciprocals(x[0], y[0], y[1], lanes); };
  return share(table);
}

double arc_sine_of_fraction(double x) {
  return std::asin(std::clamp(x, 0.0, 1.0));
}

}  // namespace

Format half_sum_format(const LeeParameters& p) {
  return sfixed(p.word_bits + 2, p.word_bits + 1);
}
Format arc_format(const LeeParameters& p) {
  return angle(p.word_bits + 1, p.word_bits + 2);
}
Format tangent_format(const LeeParameters& p) {
  return ufixed(p.word_bits + reciprocal_integer_bits(p) + 1, p.word_bits);
}
Format proportion_format(const LeeParameters& p) {
  return ufixed(p.word_bits, p.word_bits);
}

RotationTables rotation_tables(const LeeParameters& p) {
  RotationTables t;
  t.sine_cosine = sine_cosine_table("SC", p.input_angle(), p.table_bits, p.word_bits);
  t.arc_sine = arc_sine_table("ASIN", half_sum_format(p), p.inverse_table_bits, arc_format(p));
  t.reciprocal = reciprocal_table(p);
  t.arc_tangent = arc_tangent_table("ATAN", tangent_format(p), p.inverse_table_bits, uangle(p.word_bits, p.word_bits + 2));
  Table proportion = make_table("T_prop", "asin(x) / 90 deg", proportion_format(p), Folding::none, p.inverse_table_bits);
  proportion.columns = {make_column(
      "prop", [](double x) { return arc_sine_of_fraction(x) * 4 / two_pi; }, proportion_format(p))};
  proportion.block = real_tables::arc_sine(4, 0);
  t.proportion = share(proportion);
  t.cosine_input = cosine_table("COS_INPUT", p.input_angle(), p.table_bits, p.word_bits);
  Table quarter = make_table("ASIN_YK", "asin(x) / 2 pi, 0 <= x <= 1", proportion_format(p), Folding::none, p.inverse_table_bits);
  quarter.columns = {make_column(
      "angle", [](double x) { return arc_sine_of_fraction(x) / two_pi; }, uangle(p.word_bits, p.word_bits + 2))};
  quarter.block = real_tables::arc_sine(1, 0);
  t.arc_sine_quarter = share(quarter);
  t.cosine_inner = cosine_table("COS", p.inner_angle(), p.table_bits, p.word_bits);
  return t;
}

}  // namespace bump::lee2007
