#pragma once
// Triangle setup: clips where it must (near plane always, guard band only if a corner lies beyond it), divides by w, snaps corners to the
// subpixel grid, drops what faces away, has no area or lies beside the frame, and prepares the attributes: angles are unwrapped to the
// short way round from the first corner, flat ones take its value. It leaves out the arithmetic of the edge equations, which the rasterizer
// does exactly. A mesh triangle stays one token whatever it is cut into; its interval is the setup interval times the raster triangles, at
// least one. Source: the usual setup engine, e.g. Pineda, "A parallel algorithm for polygon rasterization", SIGGRAPH 1988.

#include <memory>
#include <vector>

#include "channels/parameters.h"
#include "units/clipping.h"
#include "units/counters.h"
#include "units/pipeline_context.h"
#include "units/triangle_block.h"

namespace bump {

struct TriangleSetupConfig {
  int latency = 8;        ///< cycles
  int interval = 4;       ///< cycles a raster triangle: three edge equations and the reciprocal of the area
  bool cull_back = true;  ///< drop triangles that face away
  int guard_band = 8192;  ///< pixels around the frame within which nothing is clipped
  int subpixel_bits = 8;  ///< fraction bits of screen coordinates

  static void declare(Parameters& parameters);
  TriangleSetupConfig() = default;
  explicit TriangleSetupConfig(const Configuration& configuration);
};

class TriangleSetup {
 public:
  TriangleSetup(std::shared_ptr<const PipelineContext> context, const TriangleSetupConfig& config);

  /// Cuts every triangle of the block into raster triangles and leaves the setup records.
  void process(TriangleBlock& block);

  /// triangles_clipped and triangles_culled are counted here; triangles_empty counts those dropped for lying beside the frame or for having
  /// no area.
  const GeometryCounters& counters() const { return counters_; }

 private:
  void set_up(TriangleBlock& block, int index);
  std::vector<std::shared_ptr<SetupTriangle>> fan(const ClipPolygon& polygon, std::uint32_t source) const;
  void unwrap(double* corners) const;

  std::shared_ptr<const PipelineContext> context_;
  TriangleSetupConfig config_;
  std::vector<ClipPlane> frame_, guard_;
  ClipPlane near_;
  GeometryCounters counters_;
};

/// Twice the signed area of a raster triangle in units of the squared subpixel step; negative when it faces the viewer (counter-clockwise
/// with y upwards). Exact: corners are on the grid of `subpixel_bits`.
std::int64_t twice_area(const SetupTriangle& triangle, int subpixel_bits);

}  // namespace bump
