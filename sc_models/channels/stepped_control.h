#pragma once
// What the modules of one clocked engine share: the clock, and the end of the run. After the end the modules sleep for good, so that
// several engines can live in one simulation. No hardware.

#include <systemc>

namespace bump {

struct SteppedControl {
  sc_core::sc_clock& clock;
  bool done = false;
  sc_core::sc_event never{"never"};  ///< is not notified

  /// For the first line of a clocked method: true if the run is over and the method shall return.
  bool asleep() {
    if (done) sc_core::next_trigger(never);
    return done;
  }
};

}  // namespace bump
