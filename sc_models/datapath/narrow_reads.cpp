#include "datapath/narrow_reads.h"

#include <algorithm>
#include <cstring>

#include "datapath/invariant.h"
#include "datapath/lane_clones.h"

namespace bump {

namespace {

constexpr int float_mantissa_bits = 23, float_bias = 127;

int folded_bits(const Table& table) {
  return table.index.width - (table.folding == Folding::magnitude ? 1 : table.folding == Folding::quarter ? 2 : 0);
}

NarrowRead::Column prepared(const Table& table, const Column& column, bool pair, bool high_half) {
  NarrowRead::Column c;
  if (table.folding == Folding::magnitude || table.folding == Folding::quarter) c.odd_zero = column.symmetry.odd_about_zero ? -1 : 0;
  if (table.folding == Folding::quarter) c.odd_quarter = column.symmetry.odd_about_quarter ? -1 : 0;
  if (!pair) return c;
  c.up = high_half ? 0 : 16;
  c.down = 16;
  const bool is_negative_possible = column.format.is_signed && table.stored_width(column) == column.format.width;
  if (!is_negative_possible) c.keep = 0xffff;
  return c;
}

}  // namespace

bool has_narrow_reads(const Table& table) {
  if (table.is_map() || !fits_narrow_lane(table.index) || table.address_bits > 30) return false;
  const int bits = folded_bits(table);
  if (table.folding == Folding::none && table.address_bits > bits + 31) return false;
  if (table.folding == Folding::quarter && table.index.width < 2) return false;
  if (table.folding == Folding::floating) {
    const int mantissa_bits = table.address_bits - table.exponent_bits;
    const int lowest_exponent = float_bias + table.min_exponent + table.index.fraction;
    const int highest_exponent = lowest_exponent + (1 << std::min(table.exponent_bits, 20));
    if (mantissa_bits > float_mantissa_bits || lowest_exponent < 1 || highest_exponent > 250) return false;
  }
  return std::all_of(table.columns.begin(), table.columns.end(), [](const Column& c) { return fits_narrow_lane(c.format); });
}

bool packs(const Table& table, std::size_t first) {
  if (first + 1 >= table.columns.size()) return false;
  return table.stored_width(table.columns[first]) <= 16 && table.stored_width(table.columns[first + 1]) <= 16;
}

NarrowRead narrow_read(const Table& table, const TableContents& contents, std::size_t first, bool pair) {
  BUMP_ASSERT(has_narrow_reads(table) && (!pair || packs(table, first)));
  NarrowRead r;
  r.folding = table.folding;
  r.index_bits = table.index.width;
  const int bits = folded_bits(table);
  r.origin = table.index.is_signed ? static_cast<std::int32_t>(std::uint32_t{1} << (table.index.width - 1)) : 0;
  r.highest = static_cast<std::int32_t>((std::int64_t{1} << std::min(bits, 31)) - 1);
  r.left = std::max(0, table.address_bits - bits);
  r.right = std::max(0, bits - table.address_bits);
  if (table.folding == Folding::floating) {
    r.mantissa_bits = table.address_bits - table.exponent_bits;
    r.lowest_code = static_cast<std::int32_t>(std::int64_t{float_bias + table.min_exponent + table.index.fraction} << r.mantissa_bits);
    r.last = static_cast<std::int32_t>((std::int64_t{1} << table.address_bits) - 1);
  }
  r.is_pair = pair;
  r.first = prepared(table, table.columns[first], pair, false);
  const std::vector<std::int64_t>& low = contents.words[first];
  for (std::size_t i = 0; i < low.size(); ++i) {
    std::uint64_t word = static_cast<std::uint64_t>(low[i]);
    if (pair) word = (word & 0xffff) | static_cast<std::uint64_t>(contents.words[first + 1][i]) << 16;
    r.words.push_back(static_cast<std::int32_t>(static_cast<std::uint32_t>(word)));
  }
  if (pair) r.second = prepared(table, table.columns[first + 1], pair, true);
  return r;
}

namespace narrow {

namespace {

#define BUMP_INLINE inline __attribute__((always_inline))

/// Where an index reads, and all ones where it was reflected.
struct Place {
  std::int32_t address, negative, beyond;
};

struct Plain {
  std::int32_t origin;
  int left, right;
  BUMP_INLINE Place operator()(std::int32_t index) const {
    return {static_cast<std::int32_t>(((static_cast<std::uint32_t>(index) + static_cast<std::uint32_t>(origin)) << left) >> right), 0, 0};
  }
};

struct Magnitude {
  std::int32_t highest;
  int left, right;
  BUMP_INLINE Place operator()(std::int32_t index) const {
    const std::int32_t sign = index >> 31;
    const std::uint32_t magnitude = static_cast<std::uint32_t>(index ^ sign) - static_cast<std::uint32_t>(sign);
    const std::uint32_t limit = static_cast<std::uint32_t>(highest);
    return {static_cast<std::int32_t>(((magnitude < limit ? magnitude : limit) << left) >> right), sign, 0};
  }
};

struct Quarter {
  std::int32_t highest;  // a quarter turn less one
  int left, right;
  BUMP_INLINE Place operator()(std::int32_t index) const {
    const std::int32_t sign = index >> 31;
    const std::int32_t less_one = index ^ sign;  // the magnitude, of negative indices less one
    const std::int32_t beyond = less_one > highest ? -1 : 0;
    const std::int32_t from_quarter = static_cast<std::int32_t>(static_cast<std::uint32_t>(less_one) - static_cast<std::uint32_t>(sign) -
                                                                static_cast<std::uint32_t>(highest) - 1);
    const std::int32_t side = from_quarter >> 31;
    const std::int32_t distance = highest + 1 - ((from_quarter ^ side) - side);
    const std::int32_t folded = distance < highest ? distance : highest;
    return {static_cast<std::int32_t>(static_cast<std::uint32_t>(folded) << left) >> right, sign, beyond};
  }
};

struct Floating {
  int shift;  // of a float's bits to exponent and mantissa of the code
  std::int32_t lowest_code, last;
  BUMP_INLINE Place operator()(std::int32_t index) const {
    // Clears what would round up: with the leading one at place p > 23, the bit that decides is p - 24.
    const auto exact = static_cast<float>(index & ~(index >> 24));
    std::int32_t bits = 0;
    std::memcpy(&bits, &exact, sizeof bits);
    const std::int32_t code = (bits >> shift) - lowest_code;
    const std::int32_t above = code > 0 ? code : 0;
    return {above < last ? above : last, 0, 0};
  }
};

BUMP_INLINE std::int32_t with_sign(std::int32_t word, const Place& place, std::int32_t odd_zero, std::int32_t odd_quarter) {
  const std::int32_t sign = (place.negative & odd_zero) ^ (place.beyond & odd_quarter);
  return (word ^ sign) - sign;
}

template <class Fold>
BUMP_INLINE void read_one(const Fold fold, const std::int32_t* __restrict words, NarrowRead::Column c, const std::int32_t* __restrict index,
                          std::int32_t* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const Place place = fold(index[i]);
    out[i] = with_sign(words[place.address], place, c.odd_zero, c.odd_quarter);
  }
}

template <class Fold>
BUMP_INLINE void read_pair(const Fold fold, const std::int32_t* __restrict words, NarrowRead::Column c, NarrowRead::Column d,
                           const std::int32_t* __restrict index, std::int32_t* __restrict first, std::int32_t* __restrict second,
                           int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const Place place = fold(index[i]);
    const auto both = static_cast<std::uint32_t>(words[place.address]);
    first[i] = with_sign((static_cast<std::int32_t>(both << 16) >> 16) & c.keep, place, c.odd_zero, c.odd_quarter);
    second[i] = with_sign((static_cast<std::int32_t>(both) >> 16) & d.keep, place, d.odd_zero, d.odd_quarter);
  }
}

BUMP_LANE_LOOP void read_plain(Plain fold, const std::int32_t* __restrict words, NarrowRead::Column c, const std::int32_t* __restrict index,
                               std::int32_t* __restrict out, int lanes) {
  read_one(fold, words, c, index, out, lanes);
}
BUMP_LANE_LOOP void read_magnitude(Magnitude fold, const std::int32_t* __restrict words, NarrowRead::Column c,
                                   const std::int32_t* __restrict index, std::int32_t* __restrict out, int lanes) {
  read_one(fold, words, c, index, out, lanes);
}
BUMP_LANE_LOOP void read_quarter(Quarter fold, const std::int32_t* __restrict words, NarrowRead::Column c,
                                 const std::int32_t* __restrict index, std::int32_t* __restrict out, int lanes) {
  read_one(fold, words, c, index, out, lanes);
}
BUMP_LANE_LOOP void read_floating(Floating fold, const std::int32_t* __restrict words, NarrowRead::Column c,
                                  const std::int32_t* __restrict index, std::int32_t* __restrict out, int lanes) {
  read_one(fold, words, c, index, out, lanes);
}
BUMP_LANE_LOOP void read_plain_pair(Plain fold, const std::int32_t* __restrict words, NarrowRead::Column c, NarrowRead::Column d,
                                    const std::int32_t* __restrict index, std::int32_t* __restrict first, std::int32_t* __restrict second,
                                    int lanes) {
  read_pair(fold, words, c, d, index, first, second, lanes);
}
BUMP_LANE_LOOP void read_magnitude_pair(Magnitude fold, const std::int32_t* __restrict words, NarrowRead::Column c, NarrowRead::Column d,
                                        const std::int32_t* __restrict index, std::int32_t* __restrict first,
                                        std::int32_t* __restrict second, int lanes) {
  read_pair(fold, words, c, d, index, first, second, lanes);
}
BUMP_LANE_LOOP void read_quarter_pair(Quarter fold, const std::int32_t* __restrict words, NarrowRead::Column c, NarrowRead::Column d,
                                      const std::int32_t* __restrict index, std::int32_t* __restrict first, std::int32_t* __restrict second,
                                      int lanes) {
  read_pair(fold, words, c, d, index, first, second, lanes);
}
BUMP_LANE_LOOP void read_floating_pair(Floating fold, const std::int32_t* __restrict words, NarrowRead::Column c, NarrowRead::Column d,
                                       const std::int32_t* __restrict index, std::int32_t* __restrict first,
                                       std::int32_t* __restrict second, int lanes) {
  read_pair(fold, words, c, d, index, first, second, lanes);
}

}  // namespace

void read(const NarrowRead& r, ConstNarrowWords index, NarrowWords first, NarrowWords second, int lanes) {
  const std::int32_t* words = r.words.data();
  const Plain plain{r.origin, r.left, r.right};
  const Magnitude magnitude{r.highest, r.left, r.right};
  const Quarter quarter{r.highest, r.left, r.right};
  const Floating floating{float_mantissa_bits - r.mantissa_bits, r.lowest_code, r.last};
  switch (r.folding) {
    case Folding::none:
      return r.is_pair ? read_plain_pair(plain, words, r.first, r.second, index, first, second, lanes)
                       : read_plain(plain, words, r.first, index, first, lanes);
    case Folding::magnitude:
      return r.is_pair ? read_magnitude_pair(magnitude, words, r.first, r.second, index, first, second, lanes)
                       : read_magnitude(magnitude, words, r.first, index, first, lanes);
    case Folding::quarter:
      return r.is_pair ? read_quarter_pair(quarter, words, r.first, r.second, index, first, second, lanes)
                       : read_quarter(quarter, words, r.first, index, first, lanes);
    case Folding::floating:
      return r.is_pair ? read_floating_pair(floating, words, r.first, r.second, index, first, second, lanes)
                       : read_floating(floating, words, r.first, index, first, lanes);
  }
}

}  // namespace narrow

}  // namespace bump
