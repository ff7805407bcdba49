#pragma once
// CORDIC, unrolled: a rotation as a chain of turns by atan(2^-i), each of which takes an adder-subtractor a component and shifts that are
// wires. Rotation: an angle is taken down to 0, and the signs met on the way, the directions, turn any number of vectors. Vectoring: a
// vector is turned onto the x axis, and the turns make its angle. n stages leave an angle of at most atan(2^-(n-1)), and lengthen a vector
// by cordic_gain(n), which tables in front take away. Source: Volder 1959, Walther 1971. Timing: an adder a stage.

#include <string>
#include <vector>

#include "datapath/netlist.h"

namespace bump {

struct CordicWidths {
  int stages = 12;     ///< n
  Format component{};  ///< of x and y: signed, up to +-2
  Format angle{};      ///< of angles: a full turn
};

double cordic_gain(int stages);

/// Per stage: flags for turning backwards and forwards, one the opposite of the other; the last stage needs the second only.
struct CordicDirections {
  std::vector<Wire> backward, forward;
  Wire half_turn;  ///< flag: the vector is to be turned by a half turn in front
};

/// The directions of an angle in any quadrant: n - 1 adders.
CordicDirections cordic_directions(Netlist& netlist, const std::string& name, Wire angle, const CordicWidths& widths);

/// x cos + y sin, the x component of (x, y) turned back by the angle, times the gain: 2 n - 1 adders.
Wire cordic_projection(Netlist& netlist, const std::string& name, Wire x, Wire y, const CordicDirections& directions,
                       const CordicWidths& widths);

struct CordicPolar {
  Wire angle;   ///< in widths.angle
  Wire length;  ///< times the gain
};

/// start + atan2(y, x), and the length of (x, y) times the gain: 3 n - 1 adders.
CordicPolar cordic_polar(Netlist& netlist, const std::string& name, Wire x, Wire y, Wire start, const CordicWidths& widths);
/// atan2(y, x) of y >= 0, within half a turn: 3 n - 4 adders, as the first stage always turns back.
Wire cordic_angle(Netlist& netlist, const std::string& name, Wire x, Wire y, const CordicWidths& widths);

}  // namespace bump
