#pragma once
// One simulation with its picture measured: what a single run and every row of a comparison are made of, so that the two say the same. The
// references are drawn apart: they depend on the scene, on the filter and on culling, not on the scheme. No model of hardware.

#include <atomic>
#include <string>
#include <vector>

#include "channels/parameters.h"
#include "schemes/scheme.h"
#include "system/simulation.h"
#include "testbench/reference/reference_renderer.h"
#include "testbench/reference/row_bands.h"
#include "testbench/results/run_report.h"
#include "units/frame_buffer.h"
#include "units/scene.h"

namespace bump {

/// "dated" or "stepped"; throws Error(input) for anything else.
Engine engine_of(const std::string& name);

/// Draws the references of a scene, with the filter and the culling of the configuration: beside other work, or at once.
class ReferenceDrawing {
 public:
  /// Draws nothing yet. Scene and flag must outlive it; `cancelled` may be null.
  ReferenceDrawing(const Scene& scene, const Configuration& configuration, const std::atomic<bool>* cancelled);
  /// Gives up what is not drawn yet.
  ~ReferenceDrawing();

  /// Sets `threads` threads to work beside the caller. Call it once.
  void begin(int threads) { bands_.begin(threads); }
  /// The caller works along until everything is drawn; no thread is left. Throws Error(cancelled) when the flag is set.
  References finish();

 private:
  const std::atomic<bool>* cancelled_;
  std::atomic<bool> abandoned_{false};
  ReferenceRenderer renderer_;
  RowBands bands_;
};

/// At once, on `threads` threads, of which none is left.
References draw_references(const Scene& scene, const Configuration& configuration, const std::atomic<bool>* cancelled, int threads = 1);

/// What can be said of a scheme on a scene before it is simulated: mirrored charts that it shades wrongly, and tangents that its settings
/// are not made for. One sentence each.
std::vector<std::string> warnings_of(const Scene& scene, const SchemePage& page, const Configuration& configuration);

/// Keeps the result beside the report that refers to it; scene, scheme and configuration must outlive it.
class MeasuredRun {
 public:
  MeasuredRun(const Scene& scene, const Scheme& scheme, const Configuration& configuration, const std::string& engine);
  MeasuredRun(const MeasuredRun&) = delete;
  MeasuredRun& operator=(const MeasuredRun&) = delete;

  /// `options.engine` is overruled. Throws what simulate() throws.
  void simulate(SimulationOptions options);
  /// Measures the picture. Throws Error(self_check) if it is not within the bound that the scheme states for its own quantisation.
  /// `threads` share the work.
  void measure(const References& references, int threads = 1);
  /// After measuring: the error picture of the report, in place of the reference. Frames that only measuring needs are dropped.
  void draw_error_picture(FrameBuffer reference, int threads);

  const SimulationResult& result() const { return result_; }
  RunReport& report() { return report_; }
  double wall_s() const { return wall_s_; }  ///< of the simulation alone
  /// After the simulation: that nothing is seen, and why.
  std::vector<std::string> warnings() const;

 private:
  SimulationResult result_;
  RunReport report_;
  double wall_s_ = 0;
};

}  // namespace bump
