#include "datapath/table.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "datapath/checks.h"
#include "datapath/invariant.h"

namespace bump {

namespace {

std::int64_t scale_address(std::int64_t word, int word_bits, int address_bits) {
  return word_bits >= address_bits ? word >> (word_bits - address_bits) : word << (address_bits - word_bits);
}

std::int64_t plain_address(const Format& index, std::int64_t word, int address_bits) {
  return scale_address(index.is_signed ? word + (std::int64_t{1} << (index.width - 1)) : word, index.width, address_bits);
}

/// Position of the leading one; the word is positive.
int leading_one(std::int64_t word) {
  int position = 0;
  while (word >> (position + 1)) ++position;
  return position;
}

std::int64_t floating_address(const Table& table, std::int64_t index) {
  if (index <= 0) return 0;
  const int mantissa_bits = table.address_bits - table.exponent_bits;
  const int place = leading_one(index);
  const int exponent = place - table.index.fraction;
  if (exponent < table.min_exponent) return 0;
  if (exponent >= table.min_exponent + (1 << table.exponent_bits)) return (std::int64_t{1} << table.address_bits) - 1;
  const std::int64_t fraction = index - (std::int64_t{1} << place);
  return (std::int64_t{exponent - table.min_exponent} << mantissa_bits) | scale_address(fraction, place, mantissa_bits);
}

/// Centre, in index codes, of the codes that share an address of 2^address_bits; `bits` of index from `origin` upwards.
double centre_of_run(std::int64_t address, int bits, int address_bits, double origin) {
  const int weight = bits - address_bits;
  const double first = std::ldexp(static_cast<double>(address), weight) + origin;
  return weight > 0 ? first + (std::ldexp(1.0, weight) - 1.0) / 2 : first;
}

double origin_of(const Format& index) {
  return index.is_signed ? std::ldexp(-1.0, index.width - 1) : 0.0;
}

/// The centre, in codes of the first index word, of the codes that share an address; those that reach it only by saturation are left out.
double centre_code(const Table& table, std::int64_t address) {
  const int bits = table.index.width, k = table.address_bits;
  if (table.folding == Folding::floating) {
    const int mantissa_bits = k - table.exponent_bits;
    const auto exponent = static_cast<int>(address >> mantissa_bits) + table.min_exponent;
    const std::int64_t mantissa = (address & ((std::int64_t{1} << mantissa_bits) - 1)) + (std::int64_t{1} << mantissa_bits);
    const int weight = exponent + table.index.fraction - mantissa_bits;  // of the last mantissa bit, in codes
    const double first = std::ldexp(static_cast<double>(mantissa), weight);
    return weight > 0 ? first + (std::ldexp(1.0, weight) - 1.0) / 2 : first;
  }
  const int folded_bits = table.folding == Folding::magnitude ? bits - 1 : table.folding == Folding::quarter ? bits - 2 : bits;
  return centre_of_run(address, folded_bits, k, table.folding == Folding::none ? origin_of(table.index) : 0.0);
}

/// Index values at the centre of what reads an address.
std::array<double, 3> centre(const Table& table, std::int64_t address) {
  std::array<double, 3> index{};
  for (std::size_t i = table.fields.size(); i > 0; --i) {
    const MapField& field = table.fields[i - 1];
    const std::int64_t place = address & ((std::int64_t{1} << field.address_bits) - 1);
    index[i] = centre_of_run(place, field.index.width, field.address_bits, origin_of(field.index)) * field.index.step();
    address >>= field.address_bits;
  }
  index[0] = centre_code(table, address) * table.index.step();
  return index;
}

bool sign_is_folded(const Table& table, const Column& column) {
  if (table.folding == Folding::magnitude) return column.symmetry.odd_about_zero;
  if (table.folding == Folding::quarter) return column.symmetry.odd_about_zero || column.symmetry.odd_about_quarter;
  return false;
}

Format stored_format(const Table& table, const Column& column) {
  Format format = column.format;
  if (sign_is_folded(table, column)) {
    format.is_signed = false;
    format.width -= 1;
  }
  return format;
}

}  // namespace

int Table::field_bits() const {
  int bits = 0;
  for (const MapField& field : fields) bits += field.address_bits;
  return bits;
}

int Table::stored_width(const Column& column) const {
  if (column.format.is_real) return 0;
  return column.format.width - (sign_is_folded(*this, column) ? 1 : 0);
}

int Table::word_bits() const {
  int width = 0;
  for (const Column& column : columns)
    if (!column.mirrors_first) width += stored_width(column);
  return width;
}

TableAddress address_of(const Table& table, std::int64_t index) {
  const int bits = table.index.width, k = table.address_bits;
  TableAddress result;
  switch (table.folding) {
    case Folding::none:
      result.address = plain_address(table.index, index, k);
      break;
    case Folding::magnitude: {
      result.negative_index = index < 0;
      const std::int64_t highest = (std::int64_t{1} << (bits - 1)) - 1;
      result.address = scale_address(std::min(index < 0 ? -index : index, highest), bits - 1, k);
      break;
    }
    case Folding::quarter: {
      const std::int64_t quarter = std::int64_t{1} << (bits - 2);
      const std::int64_t quadrant = (index >> (bits - 2)) & 3;
      const std::int64_t rest = index & (quarter - 1);
      result.negative_index = quadrant >= 2;
      result.beyond_quarter = quadrant == 1 || quadrant == 2;
      result.address = scale_address(std::min((quadrant & 1) != 0 ? quarter - rest : rest, quarter - 1), bits - 2, k);
      break;
    }
    case Folding::floating:
      result.address = floating_address(table, index);
      break;
  }
  return result;
}

TableAddress address_of(const Table& table, const IndexWords& index) {
  TableAddress result = address_of(table, index[0]);
  for (std::size_t i = 0; i < table.fields.size(); ++i) {
    const MapField& field = table.fields[i];
    result.address = (result.address << field.address_bits) | plain_address(field.index, index[i + 1], field.address_bits);
  }
  return result;
}

TableContents tabulate(const Table& table) {
  check_table(table);
  require(!table.index.is_real && std::none_of(table.fields.begin(), table.fields.end(), [](const MapField& f) { return f.index.is_real; }),
          "table '" + table.name + "': a real index has no ROM");
  TableContents contents;
  for (const Column& column : table.columns) {
    const std::string whose = "table '" + table.name + "', column '" + column.name + "'";
    require(!column.format.is_real, whose + ": a real column has no words");
    if (column.mirrors_first) {
      contents.words.emplace_back(contents.words.front().rbegin(), contents.words.front().rend());
      continue;
    }
    const Format stored = stored_format(table, column);
    std::vector<std::int64_t> words(static_cast<std::size_t>(table.entries()));
    for (std::int64_t address = 0; address < table.entries(); ++address) {
      const double value = table.value(column, centre(table, address).data());
      require(!std::isnan(value), whose + ": the function is not a number at address " + std::to_string(address));
      require(!sign_is_folded(table, column) || value > -stored.step(), whose + ": an odd column must not be negative in the stored part");
      words[static_cast<std::size_t>(address)] = quantise(value, stored);
    }
    contents.words.push_back(std::move(words));
  }
  return contents;
}

std::int64_t look_up(const Table& table, const TableContents& contents, std::size_t column, std::int64_t index) {
  BUMP_ASSERT(!table.is_map());
  return look_up(table, contents, column, IndexWords{index});
}

std::int64_t look_up(const Table& table, const TableContents& contents, std::size_t column, const IndexWords& index) {
  BUMP_ASSERT(column < table.columns.size());
  const TableAddress place = address_of(table, index);
  const std::int64_t word = contents.words[column][static_cast<std::size_t>(place.address)];
  const Symmetry& symmetry = table.columns[column].symmetry;
  if (table.folding != Folding::magnitude && table.folding != Folding::quarter) return word;
  const bool negative = (symmetry.odd_about_zero && place.negative_index) !=
                        (table.folding == Folding::quarter && symmetry.odd_about_quarter && place.beyond_quarter);
  return negative ? -word : word;
}

}  // namespace bump
