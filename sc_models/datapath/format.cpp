#include "datapath/format.h"

#include <cmath>

#include "datapath/invariant.h"
#include "datapath/lane_math.h"

namespace bump {

namespace {

double power_of_two(int exponent) {
  constexpr int bias = 1023;
  if (exponent <= -bias || exponent > bias) return std::ldexp(1.0, exponent);
  return double_from_bits(static_cast<std::int64_t>(exponent + bias) << 52);  // asked for with every word that is looked at
}

std::int64_t lowest_word(const Format& f) {
  return f.is_signed ? -(std::int64_t{1} << (f.width - 1)) : 0;
}
std::int64_t highest_word(const Format& f) {
  return (std::int64_t{1} << (f.is_signed ? f.width - 1 : f.width)) - 1;
}

/// The nearest word of a number in units of the last place, halves up, saturated; for words too wide for the vectorised path.
std::int64_t nearest_wide_word(double scaled, const Format& to) {
  if (scaled != scaled) return 0;
  const double whole = std::floor(scaled);
  const double rounded = scaled - whole >= 0.5 ? whole + 1.0 : whole;
  // The bounds are compared as powers of two: the highest word itself may have too many bits for a double.
  if (rounded >= power_of_two(to.is_signed ? to.width - 1 : to.width)) return highest_word(to);
  if (rounded <= static_cast<double>(lowest_word(to))) return lowest_word(to);
  return static_cast<std::int64_t>(rounded);
}

Format fixed_point(int width, int fraction, bool is_signed, bool is_angle) {
  Format format;
  format.width = width;
  format.fraction = fraction;
  format.is_signed = is_signed;
  format.is_angle = is_angle;
  return format;
}

}  // namespace

double Format::step() const {
  return is_real ? 0.0 : power_of_two(-fraction);
}

double Format::lowest() const {
  return is_real ? -HUGE_VAL : static_cast<double>(lowest_word(*this)) * step();
}

double Format::highest() const {
  return is_real ? HUGE_VAL : static_cast<double>(highest_word(*this)) * step();
}

bool operator==(const Format& a, const Format& b) {
  return a.width == b.width && a.fraction == b.fraction && a.is_signed == b.is_signed && a.is_angle == b.is_angle && a.is_real == b.is_real;
}

Format sfixed(int width, int fraction) {
  return fixed_point(width, fraction, true, false);
}
Format ufixed(int width, int fraction) {
  return fixed_point(width, fraction, false, false);
}
Format turns(int bits) {
  return fixed_point(bits, bits, true, true);
}
Format angle(int width, int fraction) {
  return fixed_point(width, fraction, true, true);
}
Format uangle(int width, int fraction) {
  return fixed_point(width, fraction, false, true);
}
Format flag() {
  return fixed_point(1, 0, false, false);
}

Format real() {
  Format format;
  format.is_real = true;
  return format;
}

std::string to_string(const Format& format) {
  if (format.is_real) return "real";
  if (format == flag()) return "flag";
  if (format.wraps()) return "turn" + std::to_string(format.width);
  const std::string word = (format.is_signed ? "s" : "u") + std::to_string(format.width) + "." + std::to_string(format.fraction);
  return format.is_angle ? "angle " + word : word;
}

std::int64_t wrap(std::int64_t raw, const Format& to) {
  const int unused = 64 - to.width;
  const std::uint64_t top = static_cast<std::uint64_t>(raw) << unused;
  return to.is_signed ? static_cast<std::int64_t>(top) >> unused : static_cast<std::int64_t>(top >> unused);
}

std::int64_t truncate(std::int64_t raw, int from_fraction, const Format& to) {
  const int right = from_fraction - to.fraction;
  if (right >= 0) return wrap(raw >> (right < 63 ? right : 63), to);
  if (right <= -64) return 0;
  return wrap(static_cast<std::int64_t>(static_cast<std::uint64_t>(raw) << -right), to);
}

std::int64_t quantise(double value, const Format& to) {
  BUMP_ASSERT(!to.is_real && to.width >= 1 && to.width <= 62);
  const double scale = power_of_two(to.fraction);
  if (to.wraps()) {
    const double turn = to_half_open_turn(value);
    if (turn != turn) return 0;
    if (to.width > narrow_bits) {
      const double scaled = turn * scale, whole = std::floor(scaled);
      return wrap(static_cast<std::int64_t>(scaled - whole >= 0.5 ? whole + 1.0 : whole), to);
    }
    return wrap(narrow_of_double(round_half_up(turn * scale)), to);
  }
  if (to.width > narrow_bits) return nearest_wide_word(value * scale, to);
  return quantise_narrow(value, scale, static_cast<double>(lowest_word(to)), static_cast<double>(highest_word(to)));
}

double to_double(std::int64_t raw, const Format& format) {
  return static_cast<double>(raw) * power_of_two(-format.fraction);
}

double wrap_turns(double value, const Format& format) {
  return format.wraps() ? to_half_open_turn(value) : value;
}

}  // namespace bump
