#include "datapath/lane_kernels.h"

#include <algorithm>
#include <cmath>

#include "datapath/lane_clones.h"
#include "datapath/lane_math.h"

namespace bump {

RoundingRule rounding_rule(int from_fraction, const Format& to) {
  RoundingRule rule;
  const int right = from_fraction - to.fraction;
  rule.right = std::clamp(right, 0, 63);
  rule.left = std::clamp(-right, 0, 63);
  if (right <= -64) return rule;  // everything is shifted out: mask 0
  const auto ones = [](int bits) { return bits >= 64 ? std::int64_t{-1} : (std::int64_t{1} << bits) - 1; };
  const int remaining = 64 - rule.right;
  const int width = std::min(to.width, remaining);
  rule.mask = ones(width);
  // When the shift leaves fewer bits than the word has, the topmost of them is the sign of the exact value, whatever the format.
  if (to.is_signed || remaining < to.width) rule.sign = static_cast<std::int64_t>(std::uint64_t{1} << (width - 1));
  if (!to.is_signed) rule.keep = ones(to.width);
  return rule;
}

namespace lanes {

namespace {

BUMP_LANE_LOOP void quantise_turns(const double* __restrict values, double scale, std::int64_t mask, std::int64_t sign,
                                   std::int64_t* __restrict words, int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const double turn = to_half_open_turn(values[i]);
    const double number = turn == turn ? turn : 0.0;
    words[i] = ((narrow_of_double(round_half_up(number * scale)) & mask) ^ sign) - sign;
  }
}

BUMP_LANE_LOOP void quantise_numbers(const double* __restrict values, double scale, double lowest, double highest,
                                     std::int64_t* __restrict words, int lanes) {
  for (int i = 0; i < lanes; ++i) words[i] = quantise_narrow(values[i], scale, lowest, highest);
}

BUMP_LANE_LOOP void to_double_narrow(const std::int64_t* __restrict words, double step, double* __restrict values, int lanes) {
  for (int i = 0; i < lanes; ++i) values[i] = double_of_narrow(words[i]) * step;
}

BUMP_LANE_LOOP void divide_narrow(const std::int64_t* __restrict a, const std::int64_t* __restrict b, int left, int right, double highest,
                                  std::int64_t* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const std::int64_t sign = a[i] < 0 ? -1 : 0;
    const auto magnitude = static_cast<std::uint64_t>((a[i] ^ sign) - sign);
    const double dividend = double_of_narrow(static_cast<std::int64_t>((magnitude << left) >> right));
    const double divisor = double_of_narrow(b[i]);
    const double nearest = (dividend / divisor + two_to_52) - two_to_52;
    const double quotient = dividend - nearest * divisor < 0 ? nearest - 1.0 : nearest;  // the product is an integer below 2^53: exact
    const double bounded = quotient < highest ? quotient : highest;                      // also by 0: infinite, or not a number
    const std::int64_t word = bits_from_double(bounded + two_to_52) - bits_of_two_to_52;
    out[i] = (word ^ sign) - sign;
  }
}

BUMP_LANE_LOOP void root_narrow(const std::int64_t* __restrict a, int left, int right, std::int64_t mask, std::int64_t* __restrict out,
                                int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const double radicand = double_of_narrow(static_cast<std::int64_t>((static_cast<std::uint64_t>(a[i]) << left) >> right));
    const double nearest = (std::sqrt(radicand) + two_to_52) - two_to_52;
    const double floor = nearest * nearest > radicand ? nearest - 1.0 : nearest;
    out[i] = bits_from_double(floor + two_to_52) & mask;
  }
}

BUMP_LANE_LOOP void plain_addresses(const std::int64_t* __restrict index, std::int64_t origin, int left, int right,
                                    std::int64_t* __restrict address, int lanes) {
  for (int i = 0; i < lanes; ++i) address[i] = static_cast<std::int64_t>((static_cast<std::uint64_t>(index[i] + origin) << left) >> right);
}

/// Puts the address field of a further index word below the address so far.
BUMP_LANE_LOOP void append_addresses(const std::int64_t* __restrict index, std::int64_t origin, int left, int right, int field_bits,
                                     std::int64_t* __restrict address, int lanes) {
  for (int i = 0; i < lanes; ++i)
    address[i] = (address[i] << field_bits) | static_cast<std::int64_t>((static_cast<std::uint64_t>(index[i] + origin) << left) >> right);
}

BUMP_LANE_LOOP void magnitude_addresses(const std::int64_t* __restrict index, std::int64_t highest, int left, int right,
                                        std::int64_t* __restrict address, std::int64_t* __restrict negative, int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const std::int64_t sign = index[i] < 0 ? -1 : 0;
    const std::int64_t magnitude = (index[i] ^ sign) - sign;
    const std::int64_t folded = magnitude < highest ? magnitude : highest;
    address[i] = static_cast<std::int64_t>((static_cast<std::uint64_t>(folded) << left) >> right);
    negative[i] = sign;
  }
}

BUMP_LANE_LOOP void quarter_addresses(const std::int64_t* __restrict index, int rest_bits, int left, int right,
                                      std::int64_t* __restrict address, std::int64_t* __restrict negative, std::int64_t* __restrict beyond,
                                      int lanes) {
  const std::int64_t quarter = std::int64_t{1} << rest_bits;
  for (int i = 0; i < lanes; ++i) {
    const auto word = static_cast<std::uint64_t>(index[i]);
    const std::int64_t rest = index[i] & (quarter - 1);
    const std::int64_t odd = -static_cast<std::int64_t>((word >> rest_bits) & 1);
    const std::int64_t high = -static_cast<std::int64_t>((word >> (rest_bits + 1)) & 1);
    const std::int64_t distance = ((rest ^ odd) - odd) + (quarter & odd);  // odd ? quarter - rest : rest
    const std::int64_t folded = distance < quarter - 1 ? distance : quarter - 1;
    address[i] = static_cast<std::int64_t>((static_cast<std::uint64_t>(folded) << left) >> right);
    negative[i] = high;
    beyond[i] = odd ^ high;
  }
}

/// The bits of a double are a leading-one detector: exponent and mantissa side by side.
BUMP_LANE_LOOP void floating_addresses(const std::int64_t* __restrict index, int mantissa_bits, std::int64_t lowest_code, std::int64_t last,
                                       std::int64_t* __restrict address, int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const auto bits = static_cast<std::uint64_t>(bits_from_double(double_of_narrow(index[i])));
    const std::int64_t code = static_cast<std::int64_t>(bits >> (52 - mantissa_bits)) - lowest_code;
    const std::int64_t above = code > 0 ? code : 0;
    address[i] = above < last ? above : last;
  }
}

BUMP_LANE_LOOP void read_plain(const std::int64_t* __restrict words, const std::int64_t* __restrict address, std::int64_t* __restrict out,
                               int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = words[address[i]];
}

BUMP_LANE_LOOP void read_folded(const std::int64_t* __restrict words, const std::int64_t* __restrict address,
                                const std::int64_t* __restrict negative, std::int64_t odd_zero, const std::int64_t* __restrict beyond,
                                std::int64_t odd_quarter, std::int64_t* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const std::int64_t sign = (negative[i] & odd_zero) ^ (beyond[i] & odd_quarter);
    out[i] = (words[address[i]] ^ sign) - sign;
  }
}

}  // namespace

void quantise(const double* values, const Format& to, Words words, int lanes) {
  if (to.width > narrow_bits) {
    for (int i = 0; i < lanes; ++i) words[i] = bump::quantise(values[i], to);
    return;
  }
  const double scale = std::ldexp(1.0, to.fraction);
  const RoundingRule rule = rounding_rule(to.fraction, to);
  if (to.wraps()) return quantise_turns(values, scale, rule.mask, rule.sign, words, lanes);
  quantise_numbers(values, scale, to.lowest() * scale, to.highest() * scale, words, lanes);
}

void to_double(ConstWords words, const Format& format, double* values, int lanes) {
  if (format.width <= narrow_bits) return to_double_narrow(words, format.step(), values, lanes);
  for (int i = 0; i < lanes; ++i) values[i] = bump::to_double(words[i], format);
}

BUMP_LANE_LOOP void add(ConstWords a, int left_a, ConstWords b, int left_b, RoundingRule rule, Words out, int lanes) {
  for (int i = 0; i < lanes; ++i)
    out[i] =
        rule.apply(static_cast<std::int64_t>((static_cast<std::uint64_t>(a[i]) << left_a) + (static_cast<std::uint64_t>(b[i]) << left_b)));
}

BUMP_LANE_LOOP void subtract(ConstWords a, int left_a, ConstWords b, int left_b, RoundingRule rule, Words out, int lanes) {
  for (int i = 0; i < lanes; ++i)
    out[i] =
        rule.apply(static_cast<std::int64_t>((static_cast<std::uint64_t>(a[i]) << left_a) - (static_cast<std::uint64_t>(b[i]) << left_b)));
}

BUMP_LANE_LOOP void add_or_subtract(ConstWords flags, ConstWords a, int left_a, ConstWords b, int left_b, RoundingRule rule, Words out,
                                    int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const std::int64_t inverted = -flags[i];
    const auto second = static_cast<std::int64_t>(static_cast<std::uint64_t>(b[i]) << left_b);
    out[i] = rule.apply(static_cast<std::int64_t>(static_cast<std::uint64_t>(a[i]) << left_a) + ((second ^ inverted) - inverted));
  }
}

BUMP_LANE_LOOP void multiply(ConstWords a, ConstWords b, RoundingRule rule, Words out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = rule.apply(a[i] * b[i]);
}

void divide(ConstWords a, ConstWords b, DividerShape shape, bool narrow, Words out, int lanes) {
  if (narrow)
    return divide_narrow(a, b, std::max(0, shape.shift), std::clamp(-shape.shift, 0, 63), std::ldexp(1.0, shape.magnitude) - 1, out, lanes);
  for (int i = 0; i < lanes; ++i) out[i] = bump::divide(a[i], b[i], shape);
}

void root(ConstWords a, RootShape shape, bool narrow, Words out, int lanes) {
  if (narrow)
    return root_narrow(a, std::max(0, shape.shift), std::clamp(-shape.shift, 0, 63), (std::int64_t{1} << shape.magnitude) - 1, out, lanes);
  for (int i = 0; i < lanes; ++i) out[i] = bump::root(a[i], shape);
}

BUMP_LANE_LOOP void move(ConstWords a, RoundingRule rule, Words out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = rule.apply(a[i]);
}

BUMP_LANE_LOOP void move_by(ConstWords a, int left, ConstWords k, RoundingRule rule, Words out, int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const int places = static_cast<int>(k[i] < 62 ? k[i] : 62);  // all that is left of a word is its sign
    out[i] = rule.apply(floor_shift(static_cast<std::int64_t>(static_cast<std::uint64_t>(a[i]) << left), places));
  }
}

BUMP_LANE_LOOP void negate(ConstWords a, RoundingRule rule, Words out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = rule.apply(-a[i]);
}

BUMP_LANE_LOOP void absolute(ConstWords a, RoundingRule rule, Words out, int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const std::int64_t sign = a[i] < 0 ? -1 : 0;
    out[i] = rule.apply((a[i] ^ sign) - sign);
  }
}

BUMP_LANE_LOOP void half_turn(ConstWords a, int width, Words out, int lanes) {
  const std::int64_t half = std::int64_t{1} << (width - 1);
  for (int i = 0; i < lanes; ++i) out[i] = (((a[i] + half) & (2 * half - 1)) ^ half) - half;
}

BUMP_LANE_LOOP void clamp(ConstWords a, int left, int right, std::int64_t low, std::int64_t high, Words out, int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const std::int64_t word = floor_shift(static_cast<std::int64_t>(static_cast<std::uint64_t>(a[i]) << left), right);
    const std::int64_t above = word > low ? word : low;
    out[i] = above < high ? above : high;
  }
}

BUMP_LANE_LOOP void select(ConstWords flags, ConstWords a, RoundingRule rule_a, ConstWords b, RoundingRule rule_b, Words out, int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const std::int64_t set = -flags[i];
    out[i] = (rule_a.apply(a[i]) & set) | (rule_b.apply(b[i]) & ~set);
  }
}

BUMP_LANE_LOOP void is_negative(ConstWords a, Words out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = static_cast<std::int64_t>(static_cast<std::uint64_t>(a[i]) >> 63);
}

BUMP_LANE_LOOP void is_beyond_quarter(ConstWords a, int width, Words out, int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const auto word = static_cast<std::uint64_t>(a[i]);
    const std::uint64_t differ = ((word >> (width - 1)) ^ (word >> (width - 2))) & 1;
    const std::uint64_t exactly = a[i] == std::int64_t{1} << (width - 2) ? 1 : 0;
    out[i] = static_cast<std::int64_t>(differ & ~exactly);
  }
}

BUMP_LANE_LOOP void exclusive_or(ConstWords a, ConstWords b, Words out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = a[i] ^ b[i];
}

namespace {

std::int64_t origin_of(const Format& index) {
  return index.is_signed ? std::int64_t{1} << (index.width - 1) : 0;
}

/// Of the first index word.
void first_addresses(const Table& table, ConstWords index, Words address, Words negative, Words beyond, int lanes) {
  const int bits = table.index.width;
  const int folded_bits = table.folding == Folding::magnitude ? bits - 1 : table.folding == Folding::quarter ? bits - 2 : bits;
  const int left = std::max(0, table.address_bits - folded_bits), right = std::max(0, folded_bits - table.address_bits);
  switch (table.folding) {
    case Folding::none:
      return plain_addresses(index, origin_of(table.index), left, right, address, lanes);
    case Folding::magnitude:
      return magnitude_addresses(index, (std::int64_t{1} << (bits - 1)) - 1, left, right, address, negative, lanes);
    case Folding::quarter:
      return quarter_addresses(index, bits - 2, left, right, address, negative, beyond, lanes);
    case Folding::floating: {
      const int mantissa_bits = table.address_bits - table.exponent_bits;
      const std::int64_t lowest_code = std::int64_t{1023 + table.min_exponent + table.index.fraction} << mantissa_bits;
      if (bits <= narrow_bits && lowest_code > 0)
        return floating_addresses(index, mantissa_bits, lowest_code, (std::int64_t{1} << table.address_bits) - 1, address, lanes);
      for (int i = 0; i < lanes; ++i) address[i] = address_of(table, index[i]).address;
      return;
    }
  }
}

}  // namespace

void addresses(const Table& table, const std::array<ConstWords, 3>& index, Words address, Words negative, Words beyond, int lanes) {
  first_addresses(table, index[0], address, negative, beyond, lanes);
  for (std::size_t i = 0; i < table.fields.size(); ++i) {
    const MapField& field = table.fields[i];
    const int left = std::max(0, field.address_bits - field.index.width), right = std::max(0, field.index.width - field.address_bits);
    append_addresses(index[i + 1], origin_of(field.index), left, right, field.address_bits, address, lanes);
  }
}

void read(ConstWords words, ConstWords address, ConstWords negative, std::int64_t odd_zero, ConstWords beyond, std::int64_t odd_quarter,
          Words out, int lanes) {
  if ((odd_zero | odd_quarter) == 0) return read_plain(words, address, out, lanes);
  read_folded(words, address, negative, odd_zero, beyond, odd_quarter, out, lanes);
}

}  // namespace lanes

}  // namespace bump
