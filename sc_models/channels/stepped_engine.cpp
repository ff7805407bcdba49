#include "channels/stepped_engine.h"

#include <sysc/tracing/sc_tracing_ids.h>

#include <algorithm>
#include <exception>
#include <optional>

#include "channels/deadlock_analysis.h"
#include "channels/stepped_stage.h"

namespace bump {

namespace {

/// A cycle in which nothing moves and no counter runs repeats for ever; a few more let every registered total settle.
constexpr int quiet_cycles_of_a_deadlock = 4;

/// The kernel's remarks would mix with results on stdout.
void silence_kernel_remarks() {
  using namespace sc_core;
  sc_report_handler::set_actions("/OSCI/SystemC", SC_INFO, SC_DO_NOTHING);
  sc_report_handler::set_actions(SC_ID_TRACING_TIMESCALE_DEFAULT_, SC_INFO, SC_DO_NOTHING);
  sc_report_handler::set_actions(SC_ID_TRACING_CLOSE_EMPTY_FILE_, SC_WARNING, SC_DO_NOTHING);  // of a run that broke off at once
}

}  // namespace

struct SteppedEngine::State : public sc_core::sc_module {
  State(sc_core::sc_module_name name, const TimingGraph& specification, sc_core::sc_time period, std::function<bool()> refill_records,
        std::function<void()> done, const StageFactory& stand_in)
      : sc_module(name),
        graph(specification),
        clock("clock", period, 0.5, period, true),
        control{clock},
        refill(std::move(refill_records)),
        on_done(std::move(done)) {
    graph.validate();
    for (const FifoSpec& fifo : graph.fifos) fifos.push_back(std::make_unique<SteppedFifo>(fifo));
    for (const MemorySpec& memory : graph.memories)
      memories.push_back(std::make_unique<SteppedMemory>(memory.name.c_str(), memory, control));
    for (std::size_t i = 0; i < graph.stages.size(); ++i) stages.push_back(make_stage(static_cast<int>(i), stand_in));
    SC_HAS_PROCESS(State);
    SC_THREAD(supervise);
    SC_METHOD(sample);
    sensitive << clock.posedge_event();
    dont_initialize();
  }
  ~State() override {
    if (trace_file != nullptr) sc_core::sc_close_vcd_trace_file(trace_file);
  }

  std::unique_ptr<ClockedStage> make_stage(int index, const StageFactory& stand_in) {
    const StageSpec& spec = graph.stages[static_cast<std::size_t>(index)];
    StageParts parts{spec, {}, {}, spec.memory < 0 ? nullptr : memories[static_cast<std::size_t>(spec.memory)].get(), control};
    for (const int f : graph.inputs_of(index)) parts.inputs.push_back(fifos[static_cast<std::size_t>(f)].get());
    for (const int f : graph.outputs_of(index)) {
      const int consumer = graph.fifos[static_cast<std::size_t>(f)].to;
      parts.outputs.push_back({fifos[static_cast<std::size_t>(f)].get(), graph.stages[static_cast<std::size_t>(consumer)].batch > 1});
    }
    if (stand_in)
      if (std::unique_ptr<ClockedStage> other = stand_in(parts)) return other;
    return std::make_unique<SteppedStage>(spec.name.c_str(), parts);
  }

  ClockedStage& stage(int index) {
    BUMP_ASSERT(index >= 0 && static_cast<std::size_t>(index) < stages.size() && !control.done);
    return *stages[static_cast<std::size_t>(index)];
  }

  /// Every rising edge: counts the cycle and the state of the FIFOs at its beginning.
  void sample() {
    if (control.asleep()) return;
    if (refilling) {
      error = Error(ErrorKind::internal, {"the functional plane delivers no records and does not end"});
      end();
      return;
    }
    for (const auto& fifo : fifos) fifo->sample();
    ++cycles;
  }

  /// Between edges: hands out records, sees the end and the standstill.
  void supervise() {
    try {
      while (!settled()) wait(clock.negedge_event());
    } catch (const sc_core::sc_unwind_exception&) {
      throw;
    } catch (const Error& thrown) {
      error = thrown;
    } catch (...) {
      failure = std::current_exception();
    }
    if (!control.done) end();
  }

  /// Nothing will move any more: every token was delivered, or none can be.
  bool settled() {
    for (const auto& each : stages) each->check();
    supply([this] { return wants_records(); });
    if (std::all_of(stages.begin(), stages.end(), [](const auto& each) { return each->empty(); })) return true;
    stuck = stands_still();
    if (stuck) supply([] { return true; });  // the remedy must hold for the whole stream
    return stuck;
  }

  template <class Wanted>
  void supply(Wanted wanted) {
    refilling = true;
    while (!ended && wanted()) ended = !refill();
    refilling = false;
  }

  bool wants_records() const {
    return std::any_of(stages.begin(), stages.end(), [](const auto& each) { return each->wants_records(); });
  }

  /// Looks at the cycle that has just passed.
  bool stands_still() {
    const bool moved = std::any_of(stages.begin(), stages.end(), [](const auto& each) { return each->moved(); });
    if (moved) last_move = cycles - 1;
    const bool counting = std::any_of(stages.begin(), stages.end(), [](const auto& each) { return each->counting(); }) ||
                          std::any_of(memories.begin(), memories.end(), [](const auto& each) { return !each->idle(); });
    quiet_cycles = moved || counting || cycles == 0 ? 0 : quiet_cycles + 1;
    return quiet_cycles >= quiet_cycles_of_a_deadlock;
  }

  /// Whatever went wrong; on the caller's stack, as that of a SystemC thread is small.
  void throw_if_failed() const {
    if (error) throw Error(*error);
    if (failure) std::rethrow_exception(failure);
    BUMP_ASSERT(control.done);
    require_matching_items(graph, untimed());
    if (stuck) report_deadlock(analyse_deadlock(graph, untimed(), last_move));
  }

  void end() {
    control.done = true;
    on_done ? on_done() : sc_core::sc_stop();
  }

  UntimedState untimed() const {
    UntimedState state;
    for (const auto& each : stages) state.stages.push_back(each->untimed());
    for (const auto& fifo : fifos) state.fifos.push_back({fifo->written(), fifo->released()});
    return state;
  }

  TimingGraph graph;
  sc_core::sc_clock clock;
  SteppedControl control;
  std::function<bool()> refill;
  std::function<void()> on_done;
  std::vector<std::unique_ptr<SteppedFifo>> fifos;
  std::vector<std::unique_ptr<SteppedMemory>> memories;
  std::vector<std::unique_ptr<ClockedStage>> stages;
  sc_core::sc_trace_file* trace_file = nullptr;
  Cycle cycles = 0;  ///< edges so far
  Cycle last_move = -1;
  int quiet_cycles = 0;
  bool refilling = false, ended = false, stuck = false;
  std::optional<Error> error;
  std::exception_ptr failure;  ///< of any other type
};

SteppedEngine::SteppedEngine(sc_core::sc_module_name name, const TimingGraph& graph, sc_core::sc_time period, std::function<bool()> refill,
                             std::function<void()> on_done, const StageFactory& stand_in)
    : sc_module(name) {
  silence_kernel_remarks();
  state_ = std::make_unique<State>("pipeline", graph, period, std::move(refill), std::move(on_done), stand_in);
}

SteppedEngine::~SteppedEngine() = default;

void SteppedEngine::append(int stage, const TokenRecord* records, std::size_t count) {
  ClockedStage& target = state_->stage(stage);
  for (std::size_t i = 0; i < count; ++i) target.append(records[i], 1);
}

void SteppedEngine::append_uniform(int stage, const TokenRecord& record, std::size_t count) {
  state_->stage(stage).append(record, static_cast<std::int64_t>(count));
}

void SteppedEngine::trace(const std::string& path) {
  BUMP_ASSERT(state_->trace_file == nullptr);
  state_->trace_file = sc_core::sc_create_vcd_trace_file(path.c_str());
  for (const auto& fifo : state_->fifos) fifo->trace(state_->trace_file);
  for (const auto& stage : state_->stages) stage->trace(state_->trace_file);
  for (const auto& memory : state_->memories) memory->trace(state_->trace_file);
  sc_core::sc_trace(state_->trace_file, state_->clock, std::string(state_->clock.name()));
}

TimingResult SteppedEngine::result() const {
  const State& s = *state_;
  s.throw_if_failed();
  TimingResult result;
  for (const auto& stage : s.stages) result.cycles = std::max(result.cycles, stage->last_delivery() + 1);
  for (const auto& stage : s.stages) result.stages.push_back(stage->statistics());
  for (const auto& fifo : s.fifos) result.fifos.push_back(fifo->statistics());
  for (const auto& memory : s.memories) result.memories.push_back(memory->statistics());
  BUMP_ASSERT(result.cycles == s.cycles);
  return result;
}

Cycle SteppedEngine::now() const {
  return state_->cycles;
}

}  // namespace bump
