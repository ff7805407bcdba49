#include "oracle.h"

#include <algorithm>
#include <cmath>

namespace bump_test {

using namespace bump;

namespace {

Wide power(int exponent) {
  Wide result = 1;
  for (int i = 0; i < exponent; ++i) result *= 2;
  return result;
}

Wide floor_half(Wide n) {
  return (n % 2 == 0 ? n : n - 1) / 2;
}

std::int64_t modulo(Wide n, const Format& to) {
  const Wide size = power(to.width);
  Wide rest = n % size;
  if (rest < 0) rest += size;
  if (to.is_signed && rest >= size / 2) rest -= size;
  return static_cast<std::int64_t>(rest);
}

Wide shifted(Wide n, int places) {
  for (; places > 0; --places) n *= 2;
  for (; places < 0; ++places) n = floor_half(n);
  return n;
}

bool folds_sign(const Table& table, const Column& column) {
  if (table.folding == Folding::magnitude) return column.symmetry.odd_about_zero;
  return table.folding == Folding::quarter && (column.symmetry.odd_about_zero || column.symmetry.odd_about_quarter);
}

/// What an index code reads: address, signs, and whether it got there by saturation.
struct Place {
  std::int64_t address = 0;
  bool below_zero = false, past_quarter = false, saturated = false;
  double code = 0;  // after folding
};

Place place_of(const Table& t, std::int64_t index) {
  Place p;
  const int w = t.index.width;
  const double size = std::ldexp(1.0, t.address_bits);
  const auto i = static_cast<double>(index);
  if (t.folding == Folding::none) {
    p.code = i;
    p.address = static_cast<std::int64_t>(std::floor((t.index.is_signed ? i / std::ldexp(1.0, w) + 0.5 : i / std::ldexp(1.0, w)) * size));
  } else if (t.folding == Folding::magnitude) {
    const double top = std::ldexp(1.0, w - 1);
    p.below_zero = index < 0;
    p.saturated = std::fabs(i) == top;
    p.code = p.saturated ? top - 1 : std::fabs(i);
    p.address = static_cast<std::int64_t>(std::floor(p.code / top * size));
  } else if (t.folding == Folding::quarter) {
    const double quarter = std::ldexp(1.0, w - 2);
    p.below_zero = index < 0;
    p.past_quarter = i >= quarter || i < -quarter;
    double distance = std::fabs(i) > quarter ? 2 * quarter - std::fabs(i) : std::fabs(i);
    p.saturated = distance == quarter;
    if (p.saturated) distance = quarter - 1;
    p.code = distance;
    p.address = static_cast<std::int64_t>(std::floor(distance / quarter * size));
  } else {
    const int mantissa_bits = t.address_bits - t.exponent_bits;
    p.code = i;
    int exponent = 0;
    const double mantissa = 2 * std::frexp(std::ldexp(i, -t.index.fraction), &exponent) - 1;
    exponent -= 1;
    const int step = exponent - t.min_exponent;
    if (index == 0 || step < 0) {
      p.saturated = true;
      p.address = 0;
    } else if (step >= (1 << t.exponent_bits)) {
      p.saturated = true;
      p.address = (std::int64_t{1} << t.address_bits) - 1;
    } else {
      p.address = step * (std::int64_t{1} << mantissa_bits) + static_cast<std::int64_t>(std::floor(std::ldexp(mantissa, mantissa_bits)));
    }
  }
  return p;
}

}  // namespace

std::int64_t oracle_round(Wide numerator, int fraction, const Format& to) {
  for (; fraction > to.fraction; --fraction) numerator = floor_half(numerator);
  for (; fraction < to.fraction; ++fraction) numerator = numerator * 2 % power(100);
  return modulo(numerator, to);
}

std::int64_t oracle_quantise(double value, const Format& to) {
  int exponent = 0;
  const Wide mantissa = static_cast<Wide>(std::ldexp(std::frexp(value, &exponent), 53));
  const int places = exponent - 53 + to.fraction;
  const bool wraps = to.is_angle && to.is_signed && to.width == to.fraction;
  const Wide lowest = to.is_signed ? -power(to.width - 1) : 0, highest = power(to.is_signed ? to.width - 1 : to.width) - 1;
  if (places > 70) return mantissa == 0 || wraps ? 0 : static_cast<std::int64_t>(mantissa < 0 ? lowest : highest);
  if (places < -120) return 0;
  const Wide nearest = places >= 0 ? shifted(mantissa, places) : shifted(mantissa + power(-places - 1), places);
  if (wraps) return modulo(nearest, to);
  return static_cast<std::int64_t>(nearest < lowest ? lowest : nearest > highest ? highest : nearest);
}

std::int64_t oracle_divide(std::int64_t a, const Format& fa, std::int64_t b, const Format& fb, const Format& to) {
  const int magnitude = to.is_signed ? to.width - 1 : to.width;
  const Wide dividend = shifted(a < 0 ? -static_cast<Wide>(a) : a, to.fraction + fb.fraction - fa.fraction);
  Wide quotient = power(magnitude) - 1;
  if (b != 0) {
    quotient = 0;  // the largest number whose product does not exceed the dividend, bit by bit from the top
    for (int bit = 63; bit >= 0; --bit)
      if ((quotient + power(bit)) * b <= dividend) quotient += power(bit);
    quotient = std::min(quotient, power(magnitude) - 1);
  }
  return static_cast<std::int64_t>(a < 0 ? -quotient : quotient);
}

std::int64_t oracle_root(std::int64_t a, const Format& fa, const Format& to) {
  const Wide radicand = shifted(a, 2 * to.fraction - fa.fraction);
  Wide low = 0, high = power(32);
  while (high - low > 1) {
    const Wide middle = (low + high) / 2;
    (middle * middle <= radicand ? low : high) = middle;
  }
  return static_cast<std::int64_t>(low % power(to.is_signed ? to.width - 1 : to.width));
}

namespace {

/// Lowest and highest code of every address of one index word.
using Runs = std::map<std::int64_t, std::pair<double, double>>;

void extend(Runs& runs, std::int64_t address, double code) {
  const auto place = runs.emplace(address, std::make_pair(code, code)).first;
  place->second.first = std::min(place->second.first, code);
  place->second.second = std::max(place->second.second, code);
}

std::vector<std::int64_t> codes_of(const Format& index) {
  const std::int64_t size = std::int64_t{1} << index.width, first = index.is_signed ? -size / 2 : 0;
  std::vector<std::int64_t> codes;
  for (std::int64_t i = first; i < first + size; ++i) codes.push_back(i);
  return codes;
}

/// The place of every code by the rule of folding `none`.
std::int64_t field_address(const MapField& field, std::int64_t code) {
  const double size = std::ldexp(1.0, field.index.width);
  return static_cast<std::int64_t>(
      std::floor((static_cast<double>(code) / size + (field.index.is_signed ? 0.5 : 0)) * std::ldexp(1.0, field.address_bits)));
}

/// Middle of the codes of an address of the first index word.
double middle_code(const Table& table, const Runs& runs, std::int64_t address) {
  if (runs.count(address) != 0) return (runs.at(address).first + runs.at(address).second) / 2;
  // A floating address that only saturated codes read: the codes that a wide enough index would have there.
  const double mantissas = std::ldexp(1.0, table.address_bits - table.exponent_bits);
  const auto place = static_cast<double>(address);
  const double binade = std::floor(place / mantissas);
  const int binade_in_codes = static_cast<int>(binade) + table.min_exponent + table.index.fraction;
  return std::ldexp(1 + place / mantissas - binade, binade_in_codes) + (std::max(1.0, std::ldexp(1 / mantissas, binade_in_codes)) - 1) / 2;
}

}  // namespace

std::map<std::vector<std::int64_t>, OracleRead> oracle_table(const Table& table) {
  Runs runs;
  for (const std::int64_t code : codes_of(table.index)) {
    const Place p = place_of(table, code);
    if (!p.saturated) extend(runs, p.address, p.code);
  }
  std::vector<Runs> field_runs(table.fields.size());
  std::vector<std::vector<std::int64_t>> combinations;
  for (const std::int64_t code : codes_of(table.index)) combinations.push_back({code});
  for (std::size_t i = 0; i < table.fields.size(); ++i) {
    std::vector<std::vector<std::int64_t>> longer;
    for (const std::int64_t code : codes_of(table.fields[i].index)) {
      extend(field_runs[i], field_address(table.fields[i], code), static_cast<double>(code));
      for (std::vector<std::int64_t> combination : combinations) {
        combination.push_back(code);
        longer.push_back(combination);
      }
    }
    combinations = longer;
  }
  std::map<std::vector<std::int64_t>, OracleRead> reads;
  for (const std::vector<std::int64_t>& codes : combinations) {
    const Place p = place_of(table, codes[0]);
    OracleRead read;
    read.address = p.address;
    std::vector<double> others;
    for (std::size_t i = 0; i < table.fields.size(); ++i) {
      const std::int64_t place = field_address(table.fields[i], codes[i + 1]);
      const std::pair<double, double>& run = field_runs[i].at(place);
      others.push_back((run.first + run.second) / 2 / std::ldexp(1.0, table.fields[i].index.fraction));
      read.address = read.address * (std::int64_t{1} << table.fields[i].address_bits) + place;
    }
    for (const Column& column : table.columns) {
      const Column& held = column.mirrors_first ? table.columns.front() : column;
      const std::int64_t place = column.mirrors_first ? (std::int64_t{1} << table.address_bits) - 1 - p.address : p.address;
      std::vector<double> index{middle_code(table, runs, place) / std::ldexp(1.0, table.index.fraction)};
      index.insert(index.end(), others.begin(), others.end());
      Format stored = held.format;
      if (folds_sign(table, held)) {
        stored.is_signed = false;
        stored.width -= 1;
      }
      std::int64_t w = oracle_quantise(table.is_map() ? held.map_function(index.data()) : held.function(index[0]), stored);
      if (folds_sign(table, column)) {
        if (column.symmetry.odd_about_zero && p.below_zero) w = -w;
        if (table.folding == Folding::quarter && column.symmetry.odd_about_quarter && p.past_quarter) w = -w;
      }
      read.words.push_back(w);
    }
    reads[codes] = read;
  }
  return reads;
}

namespace {

std::vector<std::int64_t> index_words(const Node& read, const std::vector<std::int64_t>& words) {
  std::vector<std::int64_t> index;
  for (const int operand : read.operands) index.push_back(words[static_cast<std::size_t>(operand)]);
  return index;
}

}  // namespace

Oracle::Oracle(const Netlist& netlist) : netlist_(netlist) {
  for (const TablePtr& table : netlist.tables()) tables_.push_back(oracle_table(*table));
}

std::vector<std::int64_t> Oracle::evaluate(const std::vector<double>& inputs) const {
  std::vector<std::int64_t> words;
  std::size_t port = 0;
  for (const Node& node : netlist_.nodes()) {
    const auto operand = [&](std::size_t j) { return words[static_cast<std::size_t>(node.operands[j])]; };
    const auto format = [&](std::size_t j) -> const Format& { return netlist_.nodes()[static_cast<std::size_t>(node.operands[j])].format; };
    const Format& to = node.format;
    std::int64_t word = 0;
    switch (node.op) {
      case Op::input:
        word = oracle_quantise(inputs[port++], to);
        break;
      case Op::constant:
        word = oracle_quantise(node.value, to);
        break;
      case Op::add:
      case Op::sub: {
        const int common = std::max(format(0).fraction, format(1).fraction);
        const Wide a = shifted(operand(0), common - format(0).fraction), b = shifted(operand(1), common - format(1).fraction);
        word = oracle_round(node.op == Op::add ? a + b : a - b, common, to);
        break;
      }
      case Op::add_sub: {
        const int common = std::max(format(1).fraction, format(2).fraction);
        const Wide a = shifted(operand(1), common - format(1).fraction), b = shifted(operand(2), common - format(2).fraction);
        word = oracle_round(operand(0) == 1 ? a - b : a + b, common, to);
        break;
      }
      case Op::join: {  // bit by bit
        word = oracle_round(operand(0), format(0).fraction, to);
        const Wide low = oracle_round(operand(1), format(1).fraction, to);
        word = modulo(static_cast<Wide>(word) + low, to);
        break;
      }
      case Op::mul:
        word = oracle_round(static_cast<Wide>(operand(0)) * operand(1), format(0).fraction + format(1).fraction, to);
        break;
      case Op::div:
        word = oracle_divide(operand(0), format(0), operand(1), format(1), to);
        break;
      case Op::sqrt:
        word = oracle_root(operand(0), format(0), to);
        break;
      case Op::table:
        word = tables_[static_cast<std::size_t>(node.table)].at(index_words(node, words)).address;
        break;
      case Op::column: {
        const Node& read = netlist_.nodes()[static_cast<std::size_t>(node.operands[0])];
        word = tables_[static_cast<std::size_t>(read.table)].at(index_words(read, words)).words[static_cast<std::size_t>(node.amount)];
        break;
      }
      case Op::shift:
        word = oracle_round(operand(0), format(0).fraction - node.amount, to);
        break;
      case Op::shift_by: {  // to the result's fraction, then one halving a place
        const int places = static_cast<int>(std::min<std::int64_t>(operand(1), 200));
        word = modulo(shifted(operand(0), to.fraction - format(0).fraction - places), to);
        break;
      }
      case Op::negate:
        word = oracle_round(-static_cast<Wide>(operand(0)), format(0).fraction, to);
        break;
      case Op::absolute:
        word = oracle_round(operand(0) < 0 ? -static_cast<Wide>(operand(0)) : operand(0), format(0).fraction, to);
        break;
      case Op::half_turn:
        word = modulo(operand(0) + power(to.width - 1), to);
        break;
      case Op::clamp: {
        Format plain = to;
        plain.is_angle = false;
        const Wide exact = shifted(operand(0), to.fraction - format(0).fraction);
        const Wide low = oracle_quantise(node.low, plain), high = oracle_quantise(node.high, plain);
        word = static_cast<std::int64_t>(exact < low ? low : exact > high ? high : exact);
        break;
      }
      case Op::select:
        word = operand(0) != 0 ? oracle_round(operand(1), format(1).fraction, to) : oracle_round(operand(2), format(2).fraction, to);
        break;
      case Op::is_negative:
        word = operand(0) < 0 ? 1 : 0;
        break;
      case Op::is_beyond_quarter: {
        const Wide quarter = power(format(0).width - 2);
        word = operand(0) > quarter || operand(0) < -quarter ? 1 : 0;
        break;
      }
      case Op::exclusive_or:
        word = operand(0) + operand(1) == 1 ? 1 : 0;
        break;
    }
    words.push_back(word);
  }
  return words;
}

}  // namespace bump_test
