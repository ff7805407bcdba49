#include "rtl/operator_text.h"

#include <fmt/core.h>

#include <algorithm>

#include "datapath/arithmetic.h"
#include "datapath/invariant.h"
#include "rtl/verilog.h"

namespace bump {

namespace {

/// Bits behind the last place of `word` up to the common fraction.
int zeros_of(const WordText& word, int fraction) {
  return fraction - word.fraction;
}

std::string with_rule(const std::string& result, const std::string& exact_value, const WordText& exact, const Format& to) {
  return wire_text(exact.name, exact.width, exact_value) + wire_text(result, to.width, rounded(exact, to));
}

/// a + b or a - b at their common fraction, with a bit for the carry.
std::string sum_text(const Node& node, const std::string& result, const WordText& a, const WordText& b, const std::string& sign) {
  WordText exact;
  exact.name = result + "_exact";
  exact.fraction = std::max(a.fraction, b.fraction);
  exact.is_signed = a.is_signed || b.is_signed || sign == "-";
  const auto bits = [&](const WordText& word) {
    return word.width + zeros_of(word, exact.fraction) + (exact.is_signed && !word.is_signed ? 1 : 0);
  };
  exact.width = std::max(bits(a), bits(b)) + 1;
  const std::string value =
      widened(a, exact.width, zeros_of(a, exact.fraction)) + " " + sign + " " + widened(b, exact.width, zeros_of(b, exact.fraction));
  return with_rule(result, value, exact, node.format);
}

std::string join_text(const Node& node, const std::string& result, const WordText& high, const WordText& low) {
  WordText exact;
  exact.name = result + "_exact";
  exact.fraction = std::max(high.fraction, low.fraction);
  exact.is_signed = high.is_signed;
  exact.width = std::max(high.width + zeros_of(high, exact.fraction), low.width + zeros_of(low, exact.fraction) + (high.is_signed ? 1 : 0));
  const std::string value =
      widened(high, exact.width, zeros_of(high, exact.fraction)) + " | " + widened(low, exact.width, zeros_of(low, exact.fraction));
  return with_rule(result, value, exact, node.format);
}

std::string product_text(const Node& node, const std::string& result, const WordText& a, const WordText& b) {
  const WordText exact = product_word(result + "_exact", a, b);
  return with_rule(result, product_value(a, b), exact, node.format);
}

/// -a, or |a|: one bit more than a.
std::string negated_text(const Node& node, const std::string& result, const WordText& a) {
  const WordText exact = {result + "_exact", a.width + 1, true, a.fraction};
  const std::string wide = widened(a, exact.width);
  const std::string negated = fmt::format("-{}", wide);
  if (node.op == Op::negate) return with_rule(result, negated, exact, node.format);
  if (!a.is_signed) return wire_text(result, node.format.width, rounded(a, node.format));
  return with_rule(result, fmt::format("{}[{}] ? {} : {}", a.name, a.width - 1, negated, wide), exact, node.format);
}

std::string shift_by_text(const Node& node, const std::string& result, const WordText& a, const WordText& places) {
  const int zeros = std::max(0, node.format.fraction - a.fraction);
  const WordText full = {result + "_full", a.width + zeros, a.is_signed, a.fraction + zeros};
  const WordText exact = {result + "_exact", full.width, full.is_signed, full.fraction};
  const std::string value =
      a.is_signed ? fmt::format("$signed({}) >>> {}", full.name, places.name) : fmt::format("{} >> {}", full.name, places.name);
  return wire_text(full.name, full.width, widened(a, full.width, zeros)) + with_rule(result, value, exact, node.format);
}

/// Compared at the result's fraction, floored, and saturated to the two words.
std::string clamp_text(const Node& node, const std::string& result, const WordText& a) {
  const Format& to = node.format;
  Format whole = to;  // wide enough for the floored word and both bounds, signed
  whole.is_signed = true;
  whole.is_angle = false;
  whole.width = std::max(a.width + (a.is_signed ? 0 : 1) + std::max(0, to.fraction - a.fraction), to.width + 1);
  const std::string word = result + "_word";
  const auto bound = [&](double value) { return verilog_word(bound_word(value, to), whole.width); };
  const std::string low = bound(node.low), high = bound(node.high);
  const auto narrow = [&](double value) { return verilog_word(bound_word(value, to), to.width); };
  return wire_text(word, whole.width, rounded(a, whole)) +
         wire_text(result, to.width,
                   fmt::format("$signed({}) < $signed({}) ? {} : $signed({}) > $signed({}) ? {} : {}", word, low, narrow(node.low), word,
                               high, narrow(node.high), rounded({word, whole.width, true, to.fraction}, to)));
}

std::string select_text(const Node& node, const std::string& result, const WordText& flag, const WordText& a, const WordText& b) {
  return wire_text(result, node.format.width, fmt::format("{}[0] ? {} : {}", flag.name, rounded(a, node.format), rounded(b, node.format)));
}

std::string half_turn_text(const Node& node, const std::string& result, const WordText& a) {
  const std::string top = fmt::format("~{}[{}]", a.name, a.width - 1);
  WordText turned = a;
  turned.name = result + "_exact";
  const std::string value = a.width == 1 ? top : fmt::format("{{{}, {}[{}:0]}}", top, a.name, a.width - 2);
  return with_rule(result, value, turned, node.format);
}

std::string beyond_quarter_text(const std::string& result, const WordText& a) {
  return wire_text(result, 1,
                   fmt::format("({0}[{1}] ^ {0}[{2}]) & ({0} != {3})", a.name, a.width - 1, a.width - 2,
                               verilog_word(std::int64_t{1} << (a.width - 2), a.width)));
}

}  // namespace

std::string wire_text(const std::string& name, int width, const std::string& value) {
  return fmt::format("  wire {}{} = {};\n", verilog_range(width), name, value);
}

WordText product_word(const std::string& exact, const WordText& a, const WordText& b) {
  return {exact, a.width + b.width, a.is_signed || b.is_signed, a.fraction + b.fraction};
}

std::string product_value(const WordText& a, const WordText& b) {
  if (!a.is_signed && !b.is_signed) return a.name + " * " + b.name;
  const auto factor = [](const WordText& word) {
    return word.is_signed ? fmt::format("$signed({})", word.name) : fmt::format("$signed({{1'd0, {}}})", word.name);
  };
  return factor(a) + " * " + factor(b);
}

std::string operator_text(const Node& node, const std::string& result, const std::vector<WordText>& operands) {
  const WordText& a = operands.at(0);
  switch (node.op) {
    case Op::add:
      return sum_text(node, result, a, operands.at(1), "+");
    case Op::sub:
      return sum_text(node, result, a, operands.at(1), "-");
    case Op::mul:
      return product_text(node, result, a, operands.at(1));
    case Op::join:
      return join_text(node, result, a, operands.at(1));
    case Op::shift: {
      WordText moved = a;
      moved.fraction -= node.amount;
      return wire_text(result, node.format.width, rounded(moved, node.format));
    }
    case Op::shift_by:
      return shift_by_text(node, result, a, operands.at(1));
    case Op::negate:
    case Op::absolute:
      return negated_text(node, result, a);
    case Op::half_turn:
      return half_turn_text(node, result, a);
    case Op::clamp:
      return clamp_text(node, result, a);
    case Op::select:
      return select_text(node, result, a, operands.at(1), operands.at(2));
    case Op::is_negative:
      return wire_text(result, 1, a.is_signed ? fmt::format("{}[{}]", a.name, a.width - 1) : "1'd0");
    case Op::is_beyond_quarter:
      return beyond_quarter_text(result, a);
    case Op::exclusive_or:
      return wire_text(result, 1, a.name + " ^ " + operands.at(1).name);
    default:
      BUMP_ASSERT(false);
      return "";
  }
}

}  // namespace bump
