#pragma once
// The clocked timing plane: every stage and memory port is a SystemC module, every FIFO a channel, evaluated once per clock edge; every
// decision is taken cycle by cycle, nothing runs ahead. Slow, small, obviously right: the oracle for Timeline, the source of waveforms,
// and the host for RTL. Registers are updated between evaluations (request_update), so the order of processes within a cycle cannot
// matter.

#include <functional>
#include <memory>
#include <string>
#include <systemc>

#include "channels/clocked_stage.h"
#include "channels/timing_plane.h"

namespace bump {

class SteppedEngine : public sc_core::sc_module, public TimingPlane {
 public:
  /// `refill` is called between clock edges while any stage has no unread record and more may come: it must append records (it may wait
  /// on SystemC events, zero time) and return false once there are no more, ever. Construct before simulation starts. Cycle 0 is the
  /// first rising edge, one period after the start of simulation. `on_done` is called once at the end, in place of sc_stop(), so that
  /// several engines can share a simulation. `stand_in`, if given, is asked for every stage, in the order of the graph.
  SteppedEngine(sc_core::sc_module_name name, const TimingGraph& graph, sc_core::sc_time period, std::function<bool()> refill,
                std::function<void()> on_done = {}, const StageFactory& stand_in = {});
  ~SteppedEngine() override;

  void append(int stage, const TokenRecord* records, std::size_t count) override;
  void append_uniform(int stage, const TokenRecord& record, std::size_t count) override;

  /// Writes a VCD: occupancy, valid and ready of every FIFO; busy, in-flight count and state of every stage. Call before simulation starts.
  /// The path has no ".vcd" suffix (SystemC adds it).
  void trace(const std::string& path);
  using sc_core::sc_module::trace;

  /// Valid once the simulation has ended: sc_start() returned because every token was delivered (the engine calls sc_stop()).
  /// Throws Error(deadlock) if the watchdog stopped the simulation, and whatever `refill` threw.
  TimingResult result() const;
  /// Cycles simulated so far.
  Cycle now() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bump
