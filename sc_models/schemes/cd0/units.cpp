#include "schemes/cd0/units.h"

#include <utility>

#include "schemes/common/object_angles_tables.h"
#include "schemes/common/polar_rotation.h"
#include "schemes/common/rom_ports.h"

namespace bump::cd0 {

namespace {

constexpr int guard_bits = 4;  // of components and angles: every stage floors once

/// Tables whose words lack what the rotations behind them lengthen a vector by.
struct Roms {
  RomPorts sine_cosine;  ///< sines pass both rotations, cosines (of K) the second
  RomPorts cosine;       ///< of theta_A: both
};

Roms roms(const Cd0Parameters& p) {
  const double once = 1 / cordic_gain(p.stages), twice = once * once;
  const Format in = p.input_angle();
  return {RomPorts(scaled_sine_cosine_table("SC", in, p.table_bits, {p.word_bits, twice}, {p.word_bits, once}), p.ports),
          RomPorts(scaled_cosine_table("COS_THETA", in, p.table_bits, {p.word_bits, twice}), p.ports)};
}

}  // namespace

CordicWidths Cd0Parameters::cordic() const {
  const int fraction = word_bits + 1 + guard_bits;
  return {stages, sfixed(fraction + 2, fraction), turns(word_bits + 2 + guard_bits)};
}

Netlist environment_unit(const Cd0Parameters& p) {
  Netlist n("environment");
  const Format in = p.input_angle();
  const int w = p.word_bits;
  const CordicWidths cordic = p.cordic();
  const PolarDirection normal = input_direction(n, "N", in), light = input_direction(n, "L", in), half = input_direction(n, "H", in);
  const YPoleWires texel = y_pole_texel(n, p, p.turn());
  const Wire Psi = n.add("N.Psi", texel.psi, normal.theta, in, "CD0 step 2");
  const CordicDirections directions = cordic_directions(n, "Psi_turn", Psi, cordic);
  Roms tables = roms(p);
  for (const auto& [name, a] : {std::pair<std::string, PolarDirection>{"L", light}, {"H", half}}) {
    const Netlist::Scope scope(n, name);
    const Format sum = sfixed(w + 2, w), half_sum = sfixed(w + 2, w + 1);
    const Wire d = n.sub("d", a.phi, normal.phi, in, "Lee Eq 6");
    const std::vector<Wire> of_X = tables.sine_cosine.read(n, "SC_X", n.add("X", a.theta, d, in, "Lee Eq 6"), "Lee Eqs 7, 9"),
                            of_Y = tables.sine_cosine.read(n, "SC_Y", n.sub("Y", a.theta, d, in, "Lee Eq 6"), "Lee Eqs 7, 9");
    const Wire G = n.shift("G", n.add("twice_G", of_X[0], of_Y[0], sum, "Lee Eq 7"), -1, half_sum, "Lee Eq 7");
    const Wire K = n.shift("K", n.sub("twice_K", of_Y[1], of_X[1], sum, "Lee Eq 9"), -1, half_sum, "Lee Eq 9");
    const Wire z = tables.cosine.read(n, "COS_THETA", a.theta, "CD0 step 1").front();
    n.output("w", cordic_projection(n, "by_Psi", z, G, directions, cordic));
    n.output("K", n.shift("K_component", K, 0, cordic.component, "CD0 step 3"));
  }
  n.output("bump.latitude", texel.latitude);
  return n;
}

Netlist illumination_unit(const Cd0Parameters& p, const Material& material) {
  Netlist n("illumination");
  const CordicWidths cordic = p.cordic();
  const CordicDirections directions = cordic_directions(n, "b_turn", n.input("bump.latitude", p.input_angle()), cordic);
  const auto dot = [&](const std::string& name, const std::string& vector) {
    const Wire w = n.input(vector + ".w", cordic.component), K = n.input(vector + ".K", cordic.component);
    const Wire projection = cordic_projection(n, name, w, K, directions, cordic);
    return n.shift(name + ".dot", projection, 0, cordic.component, "CD0 step 3");
  };
  const Wire n_l = dot("N_L", "L"), n_h = dot("N_H", "H");
  output_intensity(n, n_l, n_h, p, material);
  return n;
}

}  // namespace bump::cd0
