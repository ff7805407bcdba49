#include "schemes/common/log_reads.h"

#include <algorithm>
#include <cmath>

#include "datapath/invariant.h"

namespace bump {

namespace {

constexpr double two_pi = 6.283185307179586476925;
constexpr double smallest_factor = 1e-300;  // keeps the double evaluation finite; a word saturates long before

double negative_log2(double value) {
  return -std::log2(std::max(std::abs(value), smallest_factor));
}

/// Smallest signed format of `fraction` fraction bits for a sum of `terms` values within [-1, 1].
Format sum_format(std::size_t terms, int fraction) {
  int whole = 1;
  while ((std::size_t{1} << whole) <= terms) ++whole;
  return sfixed(whole + 1 + fraction, fraction);
}

}  // namespace

Format log_format(const LogWidths& widths, int whole) {
  return ufixed(whole + widths.log_bits, widths.log_bits);
}

void declare_log_whole_bits(Parameters& p, const std::string& id) {
  p.integer(id + ".log_whole_bits", log_whole_bits, 2, 4, "bits", "bits of a factor's logarithm before the point");
}

TablePtr log_sine_cosine_table(const std::string& name, const LogWidths& widths) {
  Table table;
  table.name = name;
  table.formula = "-log2 |sin 2 pi x|, -log2 |cos 2 pi x|";
  table.index = widths.index;
  table.folding = Folding::quarter;
  table.address_bits = widths.table_bits;
  Column sine;
  sine.name = "sin";
  sine.function = [](double turns) { return negative_log2(std::sin(two_pi * turns)); };
  sine.format = log_format(widths, widths.whole_bits);
  Column cosine = sine;
  cosine.name = "cos";
  cosine.function = [](double turns) { return negative_log2(std::cos(two_pi * turns)); };
  table.columns = {sine, cosine};
  return std::make_shared<const Table>(table);
}

TablePtr antilogarithm_table(const std::string& name, const LogWidths& widths) {
  Table table;
  table.name = name;
  table.formula = "2^-x, 0 <= x < 1";
  table.index = ufixed(widths.log_bits, widths.log_bits);
  table.address_bits = widths.antilog_bits;
  Column power;
  power.name = "power";
  power.function = [](double x) { return std::exp2(std::floor(x) - x); };
  power.format = ufixed(widths.word_bits, widths.word_bits);
  table.columns = {power};
  return std::make_shared<const Table>(table);
}

LogReads::LogReads(Netlist& netlist, const LogWidths& widths)
    : netlist_(netlist),
      widths_(widths),
      logarithm_(log_sine_cosine_table("LSC", widths), widths.ports),
      antilogarithm_(antilogarithm_table("ANTILOG", widths), widths.ports) {}

LogSineCosine LogReads::both(const std::string& name, Wire angle, const std::string& equation) {
  const Netlist::Label label(netlist_, equation);
  const std::vector<Wire> read = logarithm_.read(netlist_, name, angle);
  return {{read[0], netlist_.is_negative(name + ".sin_negative", angle)},
          {read[1], netlist_.is_beyond_quarter(name + ".cos_negative", angle)}};
}

LogValue LogReads::product(const std::string& name, const LogValue& a, const LogValue& b, const std::string& equation) {
  const Netlist::Label label(netlist_, equation);
  const auto whole = [&](Wire log) { return netlist_.format(log).width - widths_.log_bits; };
  const Format format = log_format(widths_, std::max(whole(a.log), whole(b.log)) + 1);
  return {netlist_.add(name, a.log, b.log, format), netlist_.exclusive_or(name + ".negative", a.negative, b.negative)};
}

Wire LogReads::magnitude(const std::string& name, const LogValue& value, const std::string& equation) {
  const Netlist::Scope scope(netlist_, name);
  const Netlist::Label label(netlist_, equation);
  const Format log = netlist_.format(value.log);
  const Wire part = netlist_.shift("fraction", value.log, 0, antilogarithm_.table().index);
  const Wire places = netlist_.shift("places", value.log, 0, ufixed(log.width - widths_.log_bits, 0));
  const Wire power = antilogarithm_.read(netlist_, "ANTILOG", part).front();
  return netlist_.shift_by("magnitude", power, places, ufixed(fraction(), fraction()));
}

Wire LogReads::sum(const std::string& name, const std::vector<LogValue>& terms, const std::string& equation) {
  BUMP_ASSERT(terms.size() >= 2);
  const Netlist::Scope scope(netlist_, name);
  const Netlist::Label label(netlist_, equation);
  Wire sum;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const std::string term = "term" + std::to_string(i + 1);
    const Wire size = magnitude(term, terms[i]);
    const Format format = sum_format(i + 1, fraction());
    if (i == 0)
      sum = netlist_.select(term + ".signed", terms[i].negative, netlist_.negate(term + ".negated", size, format), size, format);
    else
      sum = netlist_.add_sub(i + 1 < terms.size() ? "sum" + std::to_string(i + 1) : "dot", terms[i].negative, sum, size, format);
  }
  return sum;
}

void output_log(Netlist& n, const std::string& name, const LogValue& value) {
  n.output(name + ".log", value.log);
  n.output(name + ".negative", value.negative);
}

LogValue input_log(Netlist& n, const std::string& name, const LogWidths& widths, int whole) {
  const Wire log = n.input(name + ".log", log_format(widths, whole));
  return {log, n.input(name + ".negative", flag())};
}

}  // namespace bump
