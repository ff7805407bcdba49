#include "datapath/real_steps.h"

#include <algorithm>

#include "datapath/evaluate.h"
#include "datapath/real_kernels.h"

namespace bump {

namespace {

void read_table(const RealStep& s, int lanes) {
  std::array<const double*, 3> index = s.in;
  alignas(64) std::array<std::array<double, block_lanes>, 2> turned;
  for (std::size_t j = 1; j < index.size(); ++j) {
    if (!s.wraps_index[j]) continue;
    double* values = turned[j - 1].data();
    std::copy(index[j], index[j] + lanes, values);
    real_lanes::wrap(values, lanes);
    index[j] = values;
  }
  if (s.table->block) return s.table->block(index.data(), s.out.data(), lanes);
  const Column& column = s.table->columns[static_cast<std::size_t>(s.node->amount)];
  if (!s.table->is_map()) return column.function.block(index[0], s.out[0], lanes);
  for (int i = 0; i < lanes; ++i) {
    std::array<double, 3> at{};
    for (std::size_t j = 0; j < static_cast<std::size_t>(s.table->index_words()); ++j) at[j] = index[j][i];
    s.out[0][i] = column.map_function(at.data());
  }
}

void run_operator(const RealStep& s, int lanes) {
  const auto [a, b, c] = s.in;
  double* out = s.out.front();
  switch (s.node->op) {
    case Op::add:
    case Op::join:
      return s.of_turns ? real_lanes::add_turns(a, b, out, lanes) : real_lanes::add(a, b, out, lanes);
    case Op::sub:
      return s.of_turns ? real_lanes::subtract_turns(a, b, out, lanes) : real_lanes::subtract(a, b, out, lanes);
    case Op::add_sub:
      return real_lanes::add_or_subtract(a, b, c, out, lanes);
    case Op::mul:
      return real_lanes::multiply(a, b, out, lanes);
    case Op::div:
      return real_lanes::divide(a, b, out, lanes);
    case Op::sqrt:
      return real_lanes::root(a, out, lanes);
    case Op::table:
      std::copy(a, a + lanes, out);
      return;
    case Op::column:
      return read_table(s, lanes);
    case Op::shift:
      return real_lanes::scale(a, s.factor, out, lanes);
    case Op::shift_by:
      return real_lanes::scale_down_by(a, b, out, lanes);
    case Op::negate:
      return s.of_turns ? real_lanes::negate_turns(a, out, lanes) : real_lanes::negate(a, out, lanes);
    case Op::absolute:
      return real_lanes::absolute(a, out, lanes);
    case Op::half_turn:
      return s.of_turns ? real_lanes::add_half_turn(a, out, lanes) : real_lanes::add_half(a, out, lanes);
    case Op::clamp:
      return real_lanes::clamp(a, s.node->low, s.node->high, out, lanes);
    case Op::select:
      return real_lanes::select(a, b, c, out, lanes);
    case Op::is_negative:
      return real_lanes::is_negative(a, out, lanes);
    case Op::is_beyond_quarter:
      return real_lanes::is_beyond_quarter(a, out, lanes);
    case Op::exclusive_or:
      return real_lanes::exclusive_or(a, b, out, lanes);
    case Op::input:
    case Op::constant:
      return;
  }
}

}  // namespace

void run_real_step(const RealStep& step, int lanes) {
  run_operator(step, lanes);
  for (std::size_t i = 0; i < step.out.size(); ++i)
    if (step.wraps[i]) real_lanes::wrap(step.out[i], lanes);
}

}  // namespace bump
