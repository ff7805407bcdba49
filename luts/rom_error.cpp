#include "luts/rom_error.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bump {

namespace {

constexpr int enumerable_bits = 20;
constexpr std::int64_t samples = 16, field_samples = 2;

struct Range {
  std::int64_t first, last;
};

Range all_codes(const Format& index) {
  const std::int64_t half = std::int64_t{1} << (index.width - 1);
  return index.is_signed ? Range{-half, half - 1} : Range{0, 2 * half - 1};
}

/// Up to `count` + 1 codes from first to last, both included.
std::vector<std::int64_t> spread(std::int64_t first, std::int64_t last, std::int64_t count) {
  const std::int64_t steps = std::min(count, last - first);
  std::vector<std::int64_t> codes;
  for (std::int64_t i = 0; i <= steps; ++i)
    codes.push_back(steps == 0 ? first : first + (last - first) / steps * i + (last - first) % steps * i / steps);
  return codes;
}

/// Pieces of the index range on which the address only rises or only falls.
std::vector<Range> monotonic_pieces(const Table& table) {
  const Range all = all_codes(table.index);
  if (table.folding == Folding::magnitude) return {{all.first, -1}, {0, all.last}};
  if (table.folding == Folding::quarter) {
    const std::int64_t quarter = std::int64_t{1} << (table.index.width - 2);
    return {{all.first, -quarter - 1}, {-quarter, -1}, {0, quarter - 1}, {quarter, all.last}};
  }
  return {all};
}

class Checker {
 public:
  Checker(const Table& table, const TableContents& contents) : table_(table), contents_(contents) {
    result_.columns.resize(table.columns.size());
  }

  /// A code of the first index word, with codes of every address field behind it.
  void check(std::int64_t code) {
    codes_[0] = code;
    check_fields(0);
  }

  void check_all(const Range& range) {
    for (std::int64_t code = range.first; code <= range.last; ++code) check(code);
  }

  void check_some(const Range& piece) {
    result_.all_codes = false;
    for (std::int64_t first = piece.first; first <= piece.last;) {
      const std::int64_t last = end_of_run(first, piece.last);
      for (const std::int64_t code : spread(first, last, samples)) check(code);
      first = last + 1;
    }
  }

  RomError result() const { return result_; }

 private:
  /// A code per index word.
  void check_one() {
    ++result_.codes;
    std::array<double, 3> index{to_double(codes_[0], table_.index)};
    for (std::size_t i = 0; i < table_.fields.size(); ++i) index[i + 1] = to_double(codes_[i + 1], table_.fields[i].index);
    for (std::size_t i = 0; i < table_.columns.size(); ++i) {
      const Column& column = table_.columns[i];
      const double exact = table_.value(column, index.data());
      const double held = to_double(look_up(table_, contents_, i, codes_), column.format);
      const double error = std::fabs(wrap_turns(held - exact, column.format));
      ColumnError& errors = result_.columns[i];
      errors.largest = std::max(errors.largest, error);
      const double half_step = column.format.step() / 2;
      if (column.format.wraps() || (exact >= column.format.lowest() - half_step && exact <= column.format.highest() + half_step))
        errors.largest_in_range = std::max(errors.largest_in_range, error);
      else
        ++errors.out_of_range;
    }
  }

  /// Codes of the index words behind the first, from `field` on.
  void check_fields(std::size_t field) {
    if (field == table_.fields.size()) return check_one();
    const MapField& f = table_.fields[field];
    const Range all = all_codes(f.index);
    const std::int64_t run = std::max(std::int64_t{1}, (all.last - all.first + 1) >> f.address_bits);
    for (std::int64_t start = all.first; start <= all.last; start += run)
      for (const std::int64_t code : spread(start, start + run - 1, field_samples)) {
        codes_.at(field + 1) = code;
        check_fields(field + 1);
      }
  }

  /// The last code up to `bound` that reads the same address as `first`.
  std::int64_t end_of_run(std::int64_t first, std::int64_t bound) const {
    const std::int64_t address = address_of(table_, first).address;
    std::int64_t inside = first, outside = bound + 1;
    while (outside - inside > 1) {
      const std::int64_t middle = inside + (outside - inside) / 2;
      (address_of(table_, middle).address == address ? inside : outside) = middle;
    }
    return inside;
  }

  const Table& table_;
  const TableContents& contents_;
  IndexWords codes_{};
  RomError result_;
};

}  // namespace

RomError rom_error(const Table& table, const TableContents& contents) {
  Checker checker(table, contents);
  if (table.index.width <= enumerable_bits && !table.is_map()) {
    checker.check_all(all_codes(table.index));
  } else {
    for (const Range& piece : monotonic_pieces(table)) checker.check_some(piece);
  }
  return checker.result();
}

}  // namespace bump
