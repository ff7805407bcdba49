#pragma once
// Builds the pipeline for a scene, a scheme and a configuration, runs it under one of the two engines, and collects everything that was
// counted. One simulation per process (SystemC elaborates once).

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "channels/parameters.h"
#include "channels/timing_graph.h"
#include "datapath/inventory.h"
#include "schemes/scheme.h"
#include "units/counters.h"
#include "units/frame_buffer.h"
#include "units/host_clock.h"
#include "units/scene.h"

namespace bump {

/// `untimed` computes values only: a result without any cycle, to measure what dates cost.
enum class Engine { dated, stepped, untimed };

struct TimingRecords;
class AccessListener;
class StandIn;

struct SimulationOptions {
  Engine engine = Engine::dated;
  /// Evaluate the datapaths in double precision beside the fixed point, and measure the directions that the environment unit delivers.
  /// Without, a run is faster and has no exact frame, no angular errors and no diverged pixels.
  bool measure = true;
  bool measure_aside = false;  ///< what can be measured later is measured by a thread of its own
  std::string trace;           ///< path of a VCD, stepped engine only; empty for none
  /// Called with the timing records of every block that retires, in order, before they are dated.
  std::function<void(const TimingRecords&)> record;
  /// Told what the fetch units read, in order; null: nobody.
  AccessListener* accesses = nullptr;
  /// Hardware in the place of stages of the clocked engine; null: every stage is its model. Must outlive the simulation.
  StandIn* stand_in = nullptr;
  /// Called now and then with the share of triangles done, 0 to 1.
  std::function<void(double)> progress;
  /// Polled; when set, the simulation stops with an Error.
  const std::atomic<bool>* cancelled = nullptr;
};

/// Cost of one netlist of the pipeline.
struct UnitCost {
  /// "environment", "illumination", "conversion", "colour", "interpolators", "vertex", "vertex_transform"; with light maps also
  /// "light_map_address" (one `map` for each map that it addresses) and "frame" (what fills the maps, once for each entry, light and
  /// object)
  std::string name;
  Inventory published;          ///< what the paper's table lists
  Inventory addition;           ///< what the design needs beside it
  std::int64_t executions = 0;  ///< times the netlist was executed: fragments times passes, fragments, or vertices
  Inventory per_light;          ///< of a vertex program: the part that an execution repeats for every further light
  int lights = 1;               ///< times that part is executed in one execution
  /// Of a netlist that is a pipeline; a vertex program runs on arithmetic units instead, maps are filled by the host, and the
  /// interpolators' latency is configured.
  struct Pipeline {
    int latency = 0;              ///< cycles, from the schedule, with the wait for shared multipliers
    int initiation_interval = 1;  ///< cycles
    int multipliers = 0;          ///< in hardware, after sharing
  };
  std::optional<Pipeline> pipeline;
};

struct TableUse {
  std::string unit, name, formula;
  std::int64_t entries = 0;
  std::int64_t bits = 0;   ///< of one copy
  int copies = 1;          ///< reads in parallel (and materials, where contents follow the material)
  std::int64_t reads = 0;  ///< in the whole run
  bool addition = false;
};

/// One light map of the design, over all objects.
struct LightMapUse {
  std::string name;
  std::int64_t entries = 0;        ///< of one object's map
  std::int64_t bits = 0;           ///< of all objects' maps
  std::int64_t words_written = 0;  ///< each frame, of all objects' maps
  std::int64_t bytes_written = 0;
  LightMapCounters counters;  ///< what the pixels read
};

struct Bound {
  double cycles = 0;  ///< no configuration of the other parts can be faster
  std::string by;     ///< "environment: initiation interval", "memory: bandwidth", ...
};

struct SimulationResult {
  TimingResult timing;
  std::int64_t fragments = 0;
  Bound bound;
  std::vector<UnitCost> units;
  std::vector<TableUse> tables;
  std::vector<LightMapUse> light_maps;  ///< none without light maps
  TextureCounters texture;
  GeometryCounters geometry;
  FrameBuffer hardware;  ///< what the simulated hardware drew
  FrameBuffer exact;     ///< the same with the scheme's double evaluation (a copy when the arithmetic is double); empty if not measured
  std::vector<AngularError> angular_errors;        ///< of the hardware's vectors
  std::vector<AngularError> angular_errors_exact;  ///< of the scheme's double evaluation
  int interpolator_components = 0;                 ///< besides u, v
  double quantisation_floor_db = 0;                ///< PSNR that the scheme states for its widths, for this scene's lights and materials
  std::vector<std::uint8_t> diverged;  ///< per pixel, 1 where the two evaluations stand on different sides of a jump of the formula
  double clock_megahertz = 100;
  /// What the host did with its time: "preparation" (designs, tables, encoded maps), the units in order, "dates" (the dated engine only).
  std::vector<HostTime> host_times;
};

/// Declares the parameters of the pipeline, of every unit and of all registered schemes.
Parameters all_parameters();

/// Throws Error(deadlock) or Error(self_check).
SimulationResult simulate(const Scene& scene, const Scheme& scheme, const Configuration& configuration, const SimulationOptions& options);

}  // namespace bump
