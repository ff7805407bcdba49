#include "datapath/real_tables.h"

#include <array>

#include "datapath/evaluate.h"
#include "datapath/lane_clones.h"
#include "datapath/real_power.h"
#include "datapath/real_turns.h"

namespace bump::real_tables {

namespace {

using In = const double* __restrict;
using Out = double* __restrict;

BUMP_LANE_LOOP void sine_cosine_lanes(In x, Out sine, Out cosine, int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const SineCosine both = sine_cosine_of_turns(x[i]);
    sine[i] = both.sine;
    cosine[i] = both.cosine;
  }
}

BUMP_LANE_LOOP void sine_lanes(In x, Out out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = sine_of_turns(x[i]);
}

BUMP_LANE_LOOP void cosine_lanes(In x, Out out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = cosine_of_turns(x[i]);
}

BUMP_LANE_LOOP void cosine_half_squared_lanes(In x, Out out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = 0.5 + 0.5 * cosine_of_turns(x[i]);
}

BUMP_LANE_LOOP void arc_sine_lanes(In x, double factor, double lowest, Out out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = factor * arc_sine_in_turns(x[i] < lowest ? lowest : x[i]);
}

BUMP_LANE_LOOP void arc_cosine_lanes(In x, Out out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = arc_cosine_of_magnitude_in_turns(x[i]);
}

BUMP_LANE_LOOP void arc_tangent_lanes(In x, Out out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = arc_tangent_in_turns(x[i]);
}

BUMP_LANE_LOOP void arc_tangent_and_code_lanes(In x, double factor, Out angle, Out code, int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const double turns = arc_tangent_in_turns(x[i]);
    angle[i] = turns;
    code[i] = factor * turns;
  }
}

BUMP_LANE_LOOP void proportion_lanes(In x, double factor, Out out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = factor * x[i];
}

BUMP_LANE_LOOP void logarithm_lanes(In x, Out top, Out rest, int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const BinaryLogarithm log = binary_logarithm(x[i]);
    top[i] = log.top;
    rest[i] = log.rest;
  }
}

BUMP_LANE_LOOP void scaled_power_of_logarithm_lanes(In top, In rest, In x, double factor, double n, Out out, int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const double power = power_by_logarithm({top[i], rest[i]}, x[i], n);
    out[i] = factor * (x[i] > 0 ? power : 0.0);
  }
}

/// Two loops: in one, a lane is a chain so long that the processor sees no second one to work on meanwhile.
void scaled_power_lanes(In x, double factor, double n, Out out, int lanes) {
  alignas(64) std::array<double, block_lanes> top, rest;
  logarithm_lanes(x, top.data(), rest.data(), lanes);
  scaled_power_of_logarithm_lanes(top.data(), rest.data(), x, factor, n, out, lanes);
}

BUMP_LANE_LOOP void reciprocal_lanes(In x, double smallest, Out out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = 1 / (x[i] < smallest ? smallest : x[i]);
}

BUMP_LANE_LOOP void reciprocal_root_lanes(In x, double smallest, Out out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = 1 / std::sqrt(x[i] < smallest ? smallest : x[i]);
}

using Index = const double* const*;
using Columns = double* const*;

}  // namespace

BlockFunction sine_cosine() {
  return [](Index x, Columns y, int lanes) { sine_cosine_lanes(x[0], y[0], y[1], lanes); };
}
BlockFunction sine() {
  return [](Index x, Columns y, int lanes) { sine_lanes(x[0], y[0], lanes); };
}
BlockFunction cosine() {
  return [](Index x, Columns y, int lanes) { cosine_lanes(x[0], y[0], lanes); };
}
BlockFunction cosine_half_squared() {
  return [](Index x, Columns y, int lanes) { cosine_half_squared_lanes(x[0], y[0], lanes); };
}
BlockFunction arc_sine(double factor, double lowest) {
  return [=](Index x, Columns y, int lanes) { arc_sine_lanes(x[0], factor, lowest, y[0], lanes); };
}
BlockFunction arc_cosine() {
  return [](Index x, Columns y, int lanes) { arc_cosine_lanes(x[0], y[0], lanes); };
}
BlockFunction arc_tangent() {
  return [](Index x, Columns y, int lanes) { arc_tangent_lanes(x[0], y[0], lanes); };
}
BlockFunction arc_tangent_and_code(double factor) {
  return [=](Index x, Columns y, int lanes) { arc_tangent_and_code_lanes(x[0], factor, y[0], y[1], lanes); };
}
BlockFunction proportion(double factor) {
  return [=](Index x, Columns y, int lanes) { proportion_lanes(x[0], factor, y[0], lanes); };
}
BlockFunction scaled_power(double factor, double n) {
  return [=](Index x, Columns y, int lanes) { scaled_power_lanes(x[0], factor, n, y[0], lanes); };
}
BlockFunction reciprocal(double smallest) {
  return [=](Index x, Columns y, int lanes) { reciprocal_lanes(x[0], smallest, y[0], lanes); };
}
BlockFunction reciprocal_root(double smallest) {
  return [=](Index x, Columns y, int lanes) { reciprocal_root_lanes(x[0], smallest, y[0], lanes); };
}

}  // namespace bump::real_tables
