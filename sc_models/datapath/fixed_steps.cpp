#include "datapath/fixed_steps.h"

#include <algorithm>

#include "datapath/arithmetic.h"
#include "datapath/invariant.h"
#include "datapath/lane_math.h"
#include "datapath/narrow_rules.h"

namespace bump {

namespace {

/// Constants for 64-bit lanes, which every operator has.
void prepare_wide(const Node& node, const Format& a, const Format& b, const Format& c, FixedStep& s) {
  const Format& to = node.format;
  s.width = a.width;
  s.rule = rounding_rule(a.fraction, to);
  switch (node.op) {
    case Op::add:
    case Op::sub:
    case Op::join: {
      const int common = std::max(a.fraction, b.fraction);
      s.left_a = common - a.fraction;
      s.left_b = common - b.fraction;
      s.rule = rounding_rule(common, to);
      break;
    }
    case Op::add_sub: {
      const int common = std::max(b.fraction, c.fraction);
      s.left_a = common - b.fraction;
      s.left_b = common - c.fraction;
      s.rule = rounding_rule(common, to);
      break;
    }
    case Op::mul:
      s.rule = rounding_rule(a.fraction + b.fraction, to);
      break;
    case Op::div:
      s.divider = divider_shape(a, b, to);
      s.by_doubles = s.divider.dividend <= narrow_bits && a.width <= narrow_bits && b.width <= narrow_bits;
      break;
    case Op::sqrt:
      s.root = root_shape(a, to);
      s.by_doubles = std::max(s.width, s.width + s.root.shift) <= narrow_bits && s.root.magnitude <= narrow_bits;
      break;
    case Op::shift:
      s.rule = rounding_rule(a.fraction - node.amount, to);
      break;
    case Op::shift_by:
      s.left_a = std::max(0, to.fraction - a.fraction);
      s.rule = rounding_rule(a.fraction + s.left_a, to);
      break;
    case Op::clamp:
      s.left_a = std::max(0, to.fraction - a.fraction);
      s.right = std::clamp(a.fraction - to.fraction, 0, 62);
      s.low = bound_word(node.low, to);
      s.high = bound_word(node.high, to);
      break;
    case Op::select:
      s.rule = rounding_rule(b.fraction, to);
      s.other_rule = rounding_rule(c.fraction, to);
      break;
    default:
      break;
  }
}

/// Constants for 32-bit lanes, if all words and what must be exact between them fit.
void prepare_narrow(const Node& node, const Format& a, const Format& b, const Format& c, FixedStep& s) {
  const Format& to = node.format;
  for (const Format* format : {&a, &b, &c, &to})
    if (!fits_narrow_lane(*format)) return;
  const WordRange range_a = range_of(a), range_b = range_of(b);
  std::optional<NarrowRule> rule, other = NarrowRule{};
  switch (node.op) {
    case Op::add:
    case Op::sub:
    case Op::join: {
      if (s.left_a > 29 || s.left_b > 29) return;
      const WordRange left = shifted(range_a, s.left_a), right = shifted(range_b, s.left_b);
      rule = narrow_rule(std::max(a.fraction, b.fraction), to, sum(left, node.op == Op::sub ? negated(right) : right));
      break;
    }
    case Op::add_sub: {
      if (s.left_a > 29 || s.left_b > 29) return;
      const WordRange left = shifted(range_b, s.left_a), right = shifted(range_of(c), s.left_b);
      rule = narrow_rule(std::max(b.fraction, c.fraction), to, either(sum(left, right), sum(left, negated(right))));
      break;
    }
    case Op::mul: {
      const WordRange exact = product(range_a, range_b);
      const int fraction = a.fraction + b.fraction, right = fraction - to.fraction;
      rule = narrow_rule(fraction, to, exact);
      if (!rule && right >= 0 && right <= 32) {
        s.wide_right = right;
        rule = narrow_rule(to.fraction, to, {exact.low >> right, exact.high >> right});
      }
      break;
    }
    case Op::div:
      if (!s.by_doubles || s.divider.shift < 0) return;
      rule = NarrowRule{};
      break;
    case Op::sqrt:
      if (!s.by_doubles || s.root.shift < 0) return;
      rule = NarrowRule{};
      break;
    case Op::shift:
      rule = narrow_rule(a.fraction - node.amount, to, range_a);
      break;
    case Op::shift_by: {
      if (s.left_a > 29) return;
      const WordRange exact = shifted(range_a, s.left_a);
      if (!exact.fits_narrow_lane()) return;
      rule = narrow_rule(a.fraction + s.left_a, to, exact);
      break;
    }
    case Op::negate:
      rule = narrow_rule(a.fraction, to, negated(range_a));
      break;
    case Op::absolute:
      rule = narrow_rule(a.fraction, to, magnitude(range_a));
      break;
    case Op::clamp:
      if (s.left_a > 29 || !shifted(range_a, s.left_a).fits_narrow_lane()) return;
      rule = NarrowRule{};
      break;
    case Op::select:
      rule = narrow_rule(b.fraction, to, range_b);
      other = narrow_rule(c.fraction, to, range_of(c));
      break;
    case Op::half_turn:
    case Op::is_negative:
    case Op::is_beyond_quarter:
    case Op::exclusive_or:
      rule = NarrowRule{};
      break;
    default:
      return;
  }
  if (!rule || !other) return;
  s.narrow = true;
  s.narrow_rule = *rule;
  s.narrow_other = *other;
}

void run_narrow(const FixedStep& s, int lanes) {
  const ConstNarrowWords a = s.in[0].narrow, b = s.in[1].narrow, c = s.in[2].narrow;
  const NarrowWords out = s.out.narrow;
  switch (s.op) {
    case Op::add:
    case Op::join:
      return narrow::add(a, s.left_a, b, s.left_b, s.narrow_rule, out, lanes);
    case Op::sub:
      return narrow::subtract(a, s.left_a, b, s.left_b, s.narrow_rule, out, lanes);
    case Op::add_sub:
      return narrow::add_or_subtract(a, b, s.left_a, c, s.left_b, s.narrow_rule, out, lanes);
    case Op::mul:
      return narrow::multiply(a, b, s.wide_right, s.narrow_rule, out, lanes);
    case Op::div:
      return narrow::divide(a, b, s.divider, out, lanes);
    case Op::sqrt:
      return narrow::root(a, s.root, out, lanes);
    case Op::column:
      return narrow::read(*s.read, a, out, s.second_out.narrow, lanes);
    case Op::shift:
      return narrow::move(a, s.narrow_rule, out, lanes);
    case Op::shift_by:
      return narrow::move_by(a, s.left_a, b, s.narrow_rule, out, lanes);
    case Op::negate:
      return narrow::negate(a, s.narrow_rule, out, lanes);
    case Op::absolute:
      return narrow::absolute(a, s.narrow_rule, out, lanes);
    case Op::half_turn:
      return narrow::half_turn(a, s.width, out, lanes);
    case Op::clamp:
      return narrow::clamp(a, s.left_a, std::min(s.right, 31), static_cast<std::int32_t>(s.low), static_cast<std::int32_t>(s.high), out,
                           lanes);
    case Op::select:
      return narrow::select(a, b, s.narrow_rule, c, s.narrow_other, out, lanes);
    case Op::is_negative:
      return narrow::is_negative(a, out, lanes);
    case Op::is_beyond_quarter:
      return narrow::is_beyond_quarter(a, s.width, out, lanes);
    case Op::exclusive_or:
      return narrow::exclusive_or(a, b, out, lanes);
    case Op::input:
    case Op::constant:
    case Op::table:
      return;
  }
}

void run_wide(const FixedStep& s, ConstWords a, ConstWords b, ConstWords c, Words out, int lanes) {
  switch (s.op) {
    case Op::add:
    case Op::join:
      return lanes::add(a, s.left_a, b, s.left_b, s.rule, out, lanes);
    case Op::sub:
      return lanes::subtract(a, s.left_a, b, s.left_b, s.rule, out, lanes);
    case Op::add_sub:
      return lanes::add_or_subtract(a, b, s.left_a, c, s.left_b, s.rule, out, lanes);
    case Op::mul:
      return lanes::multiply(a, b, s.rule, out, lanes);
    case Op::div:
      return lanes::divide(a, b, s.divider, s.by_doubles, out, lanes);
    case Op::sqrt:
      return lanes::root(a, s.root, s.by_doubles, out, lanes);
    case Op::table:
      return lanes::addresses(*s.table, {a, b, c}, out, s.reflections->negative.words.data(), s.reflections->beyond.words.data(), lanes);
    case Op::column:
      return lanes::read(s.words, a, s.reflections->negative.words.data(), s.odd_zero, s.reflections->beyond.words.data(), s.odd_quarter,
                         out, lanes);
    case Op::shift:
      return lanes::move(a, s.rule, out, lanes);
    case Op::shift_by:
      return lanes::move_by(a, s.left_a, b, s.rule, out, lanes);
    case Op::negate:
      return lanes::negate(a, s.rule, out, lanes);
    case Op::absolute:
      return lanes::absolute(a, s.rule, out, lanes);
    case Op::half_turn:
      return lanes::half_turn(a, s.width, out, lanes);
    case Op::clamp:
      return lanes::clamp(a, s.left_a, s.right, s.low, s.high, out, lanes);
    case Op::select:
      return lanes::select(a, b, s.rule, c, s.other_rule, out, lanes);
    case Op::is_negative:
      return lanes::is_negative(a, out, lanes);
    case Op::is_beyond_quarter:
      return lanes::is_beyond_quarter(a, s.width, out, lanes);
    case Op::exclusive_or:
      return lanes::exclusive_or(a, b, out, lanes);
    case Op::input:
    case Op::constant:
      return;
  }
}

}  // namespace

void FixedStep::run(std::array<WideLane, 4>& scratch, int lanes) const {
  if (narrow) return run_narrow(*this, lanes);
  std::array<ConstWords, 3> words_in{};
  for (std::size_t j = 0; j < in.size(); ++j) {
    words_in[j] = in[j].wide;
    if (in[j].narrow == nullptr) continue;
    narrow::widen(in[j].narrow, scratch[j].words.data(), lanes);
    words_in[j] = scratch[j].words.data();
  }
  const Words result = out.wide != nullptr ? out.wide : scratch[3].words.data();
  run_wide(*this, words_in[0], words_in[1], words_in[2], result, lanes);
  if (out.narrow != nullptr) narrow::shrink(result, out.narrow, lanes);
}

FixedStep arithmetic_step(const Netlist& netlist, int index) {
  const Node& node = netlist.nodes()[static_cast<std::size_t>(index)];
  FixedStep step;
  step.op = node.op;
  step.node = index;
  std::array<Format, 3> formats;
  for (std::size_t j = 0; j < formats.size(); ++j) {
    const int operand = node.operands[std::min(j, node.operands.size() - 1)];
    formats[j] = netlist.nodes()[static_cast<std::size_t>(operand)].format;
    if (j < node.operands.size()) step.operands[j] = operand;
  }
  prepare_wide(node, formats[0], formats[1], formats[2], step);
  prepare_narrow(node, formats[0], formats[1], formats[2], step);
  return step;
}

bool is_same_word(const Netlist& netlist, int index) {
  const Node& node = netlist.nodes()[static_cast<std::size_t>(index)];
  if (node.op != Op::shift) return false;
  const Format& from = netlist.nodes()[static_cast<std::size_t>(node.operands[0])].format;
  if (!fits_narrow_lane(from) || !fits_narrow_lane(node.format)) return false;
  const std::optional<NarrowRule> rule = narrow_rule(from.fraction - node.amount, node.format, range_of(from));
  return rule && rule->is_identity;
}

}  // namespace bump
