#include "datapath/checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "datapath/arithmetic.h"
#include "datapath/error.h"

namespace bump {

namespace {

constexpr int widest_word = 62;

bool any_real(const Node& node, const std::vector<Format>& operands) {
  return node.format.is_real || std::any_of(operands.begin(), operands.end(), [](const Format& f) { return f.is_real; });
}

void check_sum(const Node& node, const Format& a, const Format& b, const std::string& whose) {
  const int fraction = std::max(a.fraction, b.fraction);
  for (const Format& operand : {a, b})
    require(operand.width + fraction - operand.fraction <= widest_word - 1,
            fmt::format("{}: operands {} and {} of {} need more than {} bits when their points are aligned", whose, to_string(a),
                        to_string(b), name_of(node.op), widest_word - 1));
}

void check_barrel_shift(const Node& node, const std::vector<Format>& operands, const std::string& whose) {
  require(!operands[1].is_signed && operands[1].fraction == 0,
          whose + ": the places must be an unsigned whole number, not " + to_string(operands[1]));
  require(
      operands[0].width + std::max(0, node.format.fraction - operands[0].fraction) <= widest_word - 1,
      fmt::format("{}: the operand {} needs more than {} bits at the result's fraction", whose, to_string(operands[0]), widest_word - 1));
}

void check_flags(const std::vector<Format>& operands, std::size_t count, const std::string& whose) {
  const char* const which[] = {"first", "second"};
  for (std::size_t i = 0; i < count; ++i)
    require(operands[i] == flag(), fmt::format("{}: the {} operand must be a flag, not {}", whose, which[i], to_string(operands[i])));
}

void check_quotient(const Node& node, const std::vector<Format>& operands, const std::string& whose) {
  require(!operands[1].is_signed, whose + ": the divisor must be unsigned, it is " + to_string(operands[1]));
  require(node.format.is_signed || !operands[0].is_signed,
          whose + ": the quotient takes the sign of its signed dividend, its format is " + to_string(node.format));
  const DividerShape shape = divider_shape(operands[0], operands[1], node.format);
  require(shape.magnitude >= 1, whose + ": the quotient has no magnitude bits");
  require(shape.dividend <= widest_word,
          fmt::format("{}: the shifted dividend has {} bits, at most {} are possible", whose, shape.dividend, widest_word));
}

void check_root(const Node& node, const std::vector<Format>& operands, const std::string& whose) {
  require(!operands[0].is_signed, whose + ": the radicand must be unsigned, it is " + to_string(operands[0]));
  const RootShape shape = root_shape(operands[0], node.format);
  require(shape.magnitude >= 1, whose + ": the root has no magnitude bits");
  require(operands[0].width + shape.shift <= widest_word, fmt::format("{}: the shifted radicand has {} bits, at most {} are possible",
                                                                      whose, operands[0].width + shape.shift, widest_word));
}

void check_clamp(const Node& node, const std::vector<Format>& operands, const std::string& whose) {
  require(operands[0].width + std::max(0, node.format.fraction - operands[0].fraction) <= widest_word,
          whose + ": the operand does not fit when shifted to the result's fraction");
}

void check_column(const Table& table, const Column& column, const std::string& whose) {
  check_format(column.format, whose);
  require(static_cast<bool>(column.function) != static_cast<bool>(column.map_function) &&
              static_cast<bool>(column.map_function) == table.is_map(),
          whose + (table.is_map() ? ": a map has a function of all its index words" : ": has no function"));
  const bool folds = table.folding == Folding::magnitude || table.folding == Folding::quarter;
  const bool odd = column.symmetry.odd_about_zero || (table.folding == Folding::quarter && column.symmetry.odd_about_quarter);
  require(!folds || !odd || column.format.is_real || (column.format.is_signed && column.format.width >= 2),
          whose + ": an odd column needs a signed format");
  if (!column.mirrors_first) return;
  require(&column != &table.columns.front(), whose + ": the first column cannot mirror itself");
  require(table.folding != Folding::floating, whose + ": a floating index has no mirror");
  require(!table.is_map(), whose + ": a map has no mirror");
  require(column.format == table.columns.front().format && table.stored_width(column) == table.stored_width(table.columns.front()),
          whose + ": a mirrored column has the format and the stored width of the first");
}

}  // namespace

void require(bool condition, const std::string& what) {
  if (!condition)
    throw Error(
        ErrorKind::internal,
        {what, {}, "a scheme recorded a datapath that breaks the rules of the netlist", "report this with the command that led to it"});
}

void check_format(const Format& format, const std::string& whose) {
  if (format.is_real) return;
  require(format.width >= 1 && format.width <= widest_word,
          fmt::format("{}: words have 1 to {} bits, not {}", whose, widest_word, format.width));
  require(std::abs(format.fraction) <= 128, fmt::format("{}: the last place weighs 2^-128 to 2^128, not 2^{}", whose, -format.fraction));
}

void check_table(const Table& table) {
  const std::string whose = "table '" + table.name + "'";
  check_format(table.index, whose);
  require(!table.name.empty(), "a table has no name");
  require(table.address_bits >= 1 && table.address_bits <= 24, fmt::format("{}: 1 to 24 address bits, not {}", whose, table.address_bits));
  require(table.fields.size() <= 2, whose + ": a map has two or three index words");
  for (const MapField& field : table.fields) {
    check_format(field.index, whose);
    require(field.address_bits >= 1, whose + ": an index word has at least one bit of the address");
  }
  require(table.address_bits + table.field_bits() <= 24, whose + ": 1 to 24 address bits together");
  require(!table.columns.empty(), whose + ": has no columns");
  if (!table.index.is_real) {
    if (table.folding == Folding::quarter)
      require(table.index.wraps() && table.index.width >= 2, whose + ": quarter folding needs a full-turn angle");
    if (table.folding == Folding::magnitude)
      require(table.index.is_signed && table.index.width >= 2, whose + ": magnitude folding needs a signed index");
    if (table.folding == Folding::floating) require(!table.index.is_signed, whose + ": a floating index is unsigned");
  }
  if (table.folding == Folding::floating)
    require(table.exponent_bits >= 0 && table.exponent_bits <= table.address_bits, whose + ": exponent bits are part of the address bits");
  std::set<std::string> names;
  for (const Column& column : table.columns) {
    const std::string name = whose + ", column '" + column.name + "'";
    require(!column.name.empty() && names.insert(column.name).second, name + ": column names are distinct and not empty");
    check_column(table, column, name);
  }
}

void check_operator(const Node& node, const std::vector<Format>& operands, const std::string& whose) {
  check_format(node.format, whose);
  const bool is_real = any_real(node, operands);
  switch (node.op) {
    case Op::add:
    case Op::sub:
      if (!is_real) check_sum(node, operands[0], operands[1], whose);
      break;
    case Op::add_sub:
      check_flags(operands, 1, whose);
      if (!is_real) check_sum(node, operands[1], operands[2], whose);
      break;
    case Op::mul:
      require(is_real || operands[0].width + operands[1].width <= widest_word,
              fmt::format("{}: the factors {} and {} have more than {} bits together", whose, to_string(operands[0]),
                          to_string(operands[1]), widest_word));
      break;
    case Op::div:
      if (!is_real) check_quotient(node, operands, whose);
      break;
    case Op::sqrt:
      if (!is_real) check_root(node, operands, whose);
      break;
    case Op::clamp:
      require(node.low <= node.high, fmt::format("{}: the bounds {} and {} are the wrong way round", whose, node.low, node.high));
      if (!is_real) check_clamp(node, operands, whose);
      break;
    case Op::shift:
      require(std::abs(node.amount) <= 128, fmt::format("{}: shifts by at most 128 places, not {}", whose, node.amount));
      break;
    case Op::join:
      if (!is_real)
        require(!operands[1].is_signed && operands[1].width - operands[1].fraction <= -operands[0].fraction,
                fmt::format("{}: the bits of {} overlap those of {}", whose, to_string(operands[1]), to_string(operands[0])));
      if (!is_real) check_sum(node, operands[0], operands[1], whose);
      break;
    case Op::shift_by:
      if (!is_real) check_barrel_shift(node, operands, whose);
      break;
    case Op::half_turn:
    case Op::is_beyond_quarter:
      require(operands[0].wraps(), whose + ": needs a full-turn angle, not " + to_string(operands[0]));
      require(node.op == Op::half_turn || operands[0].width >= 2, whose + ": needs an angle of at least two bits");
      break;
    case Op::select:
      check_flags(operands, 1, whose);
      break;
    case Op::is_negative:
      require(operands[0].is_real || operands[0].is_signed, whose + ": an unsigned word is never negative");
      break;
    case Op::exclusive_or:
      check_flags(operands, 2, whose);
      break;
    default:
      break;
  }
}

}  // namespace bump
