#include "schemes/common/cordic_rotation.h"

#include <cmath>

#include "schemes/common/object_angles_tables.h"

namespace bump {

namespace {

constexpr double two_pi = 6.283185307179586476925;

double stage_turns(int stage) {
  return std::atan(std::ldexp(1.0, -stage)) / two_pi;
}

/// Label of what a turn beyond a quarter takes before and behind the stages.
constexpr const char* half_turn_label = "CORDIC half turn";

std::string stage_label(int stage) {
  return "CORDIC stage " + std::to_string(stage);
}

std::string indexed(const std::string& name, int stage) {
  return name + std::to_string(stage);
}

Wire stage_angle(Netlist& n, int stage, const CordicWidths& w) {
  return n.constant(indexed("atan", stage), stage_turns(stage), w.angle);
}

Wire down(Netlist& n, const std::string& name, Wire a, int stage, const CordicWidths& w) {
  return stage == 0 ? a : n.shift(name, a, -stage, w.component);
}

Wire negated_if(Netlist& n, const std::string& name, Wire flag, Wire a, const Format& format) {
  return n.select(name, flag, n.negate(name + "_negated", a, format), a, format);
}

/// Turns (x, y) towards the x axis from stage `first` on and the angle along with it.
CordicPolar turn_onto_axis(Netlist& n, Wire x, Wire y, Wire angle, int first, bool with_length, const CordicWidths& w) {
  Netlist::Label label(n, stage_label(first));
  const Wire one = n.constant("one", 1, flag());
  for (int i = first; i < w.stages; ++i) {
    label.next(stage_label(i));
    const bool last = i + 1 == w.stages;
    const Wire below = n.is_negative(indexed("below", i), y), above = n.exclusive_or(indexed("above", i), below, one);
    angle = n.add_sub(indexed("angle", i + 1), below, angle, stage_angle(n, i, w), w.angle);
    // x is read by the y of the next stage but the last, and by who asks for the length.
    const Wire turned_x = i + 2 >= w.stages && !with_length
                              ? x
                              : n.add_sub(indexed("x", i + 1), below, x, down(n, indexed("y_down", i), y, i, w), w.component);
    if (!last) y = n.add_sub(indexed("y", i + 1), above, y, down(n, indexed("x_down", i), x, i, w), w.component);
    x = turned_x;
  }
  return {angle, x};
}

}  // namespace

double cordic_gain(int stages) {
  double gain = 1;
  for (int i = 0; i < stages; ++i) gain *= std::sqrt(1 + std::ldexp(1.0, -2 * i));
  return gain;
}

CordicDirections cordic_directions(Netlist& n, const std::string& name, Wire angle, const CordicWidths& w) {
  const Netlist::Scope scope(n, name);
  Netlist::Label label(n, half_turn_label);
  CordicDirections d;
  d.half_turn = n.is_beyond_quarter("beyond", angle);
  const Wire arriving = n.shift("arriving", angle, 0, w.angle);
  Wire rest = n.select("rest0", d.half_turn, n.half_turn("opposite", arriving), arriving, w.angle);
  label.next(stage_label(0));
  const Wire one = n.constant("one", 1, flag());
  for (int i = 0; i < w.stages; ++i) {
    label.next(stage_label(i));
    d.forward.push_back(n.is_negative(indexed("forward", i), rest));
    if (i + 1 == w.stages) break;
    d.backward.push_back(n.exclusive_or(indexed("backward", i), d.forward.back(), one));
    rest = n.add_sub(indexed("rest", i + 1), d.backward.back(), rest, stage_angle(n, i, w), w.angle);
  }
  return d;
}

Wire cordic_projection(Netlist& n, const std::string& name, Wire x, Wire y, const CordicDirections& d, const CordicWidths& w) {
  const Netlist::Scope scope(n, name);
  Netlist::Label label(n, stage_label(0));
  x = n.shift("x0", x, 0, w.component);
  y = n.shift("y0", y, 0, w.component);
  for (int i = 0; i < w.stages; ++i) {
    const auto stage = static_cast<std::size_t>(i);
    label.next(stage_label(i));
    const Wire turned_x = n.add_sub(indexed("x", i + 1), d.forward[stage], x, down(n, indexed("y_down", i), y, i, w), w.component);
    if (i + 1 < w.stages) y = n.add_sub(indexed("y", i + 1), d.backward[stage], y, down(n, indexed("x_down", i), x, i, w), w.component);
    x = turned_x;
  }
  label.next(half_turn_label);
  return negated_if(n, "projection", d.half_turn, x, w.component);
}

CordicPolar cordic_polar(Netlist& n, const std::string& name, Wire x, Wire y, Wire start, const CordicWidths& w) {
  const Netlist::Scope scope(n, name);
  const Netlist::Label label(n, half_turn_label);
  const Wire behind = n.is_negative("behind", x);
  const Wire from = n.shift("from", start, 0, w.angle);
  const Wire angle = n.select("angle0", behind, n.half_turn("opposite", from), from, w.angle);
  return turn_onto_axis(n, negated_if(n, "x0", behind, x, w.component), negated_if(n, "y0", behind, y, w.component), angle, 0, true, w);
}

Wire cordic_angle(Netlist& n, const std::string& name, Wire x, Wire y, const CordicWidths& w) {
  const Netlist::Scope scope(n, name);
  Netlist::Label label(n, half_turn_label);
  const Wire behind = n.is_negative("behind", x);
  label.next(stage_label(0));
  const Wire abs_x = n.absolute("x0", x, w.component), y0 = n.shift("y0", y, 0, w.component);
  const Wire x1 = n.add("x1", abs_x, y0, w.component), y1 = n.sub("y1", y0, abs_x, w.component);
  const CordicPolar polar = turn_onto_axis(n, x1, y1, n.constant("angle1", stage_turns(0), w.angle), 1, false, w);
  label.next(half_turn_label);
  return opposite_if(n, "angle", behind, polar.angle);
}

}  // namespace bump
