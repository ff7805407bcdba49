#pragma once
// The rasterizer: walks the covered pixels of each raster triangle, row by row or tile by tile, tests depth before anything is shaded, and
// hands fragments on with perspective-correct weights, texture coordinates and their derivatives. Depth is held in double precision;
// finding covered positions among uncovered ones costs no time (ideal traversal). A token is a surviving fragment; positions that are
// covered but hidden cost a cycle each and delay the next one. Source: Pineda 1988 (edge functions); Heckbert and Moreton, "Interpolation
// for polygon texture mapping and shading", 1991 (perspective and derivatives).

#include <functional>
#include <memory>
#include <vector>

#include "channels/parameters.h"
#include "units/block_pool.h"
#include "units/counters.h"
#include "units/edge_function.h"
#include "units/pipeline_context.h"
#include "units/triangle_block.h"

namespace bump {

struct RasterizerConfig {
  enum class Order { scanline, tiled } order = Order::scanline;
  int tile = 8;           ///< pixels of a tile's side
  int subpixel_bits = 8;  ///< fraction bits of screen coordinates
  bool early_z = true;
  int latency = 4;  ///< cycles

  static void declare(Parameters& parameters);
  RasterizerConfig() = default;
  explicit RasterizerConfig(const Configuration& configuration);
};

class Rasterizer {
 public:
  using Emit = std::function<void(std::unique_ptr<FragmentBlock>)>;

  /// Blocks come from the pool; full ones go to `emit`, which may block.
  Rasterizer(std::shared_ptr<const PipelineContext> context, const RasterizerConfig& config, std::shared_ptr<BlockPool> pool, Emit emit);

  /// Rasterizes the raster triangles of a block that triangle setup has processed.
  void process(const TriangleBlock& triangles);
  /// Hands out what is left, marked as the last block (it may have no lanes).
  void finish();

  /// fragments_generated, fragments_hidden, fragments, triangles_drawn and triangles_hidden are counted here; triangles_empty counts those
  /// that were set up but cover no pixel centre.
  const GeometryCounters& counters() const { return counters_; }

 private:
  void walk(const std::shared_ptr<const SetupTriangle>& piece);
  void row(const EdgeFunctions& edges, const PixelSpan& span, int y);
  /// At most block_lanes neighbours from pixel `first` on.
  void visit(const EdgeFunctions& edges, int first, int count, int y);
  /// Those at [begin, end) of weight1_, weight2_ and new_depth_, which belong to the pixels from `first_x` on.
  void add_fragments(int first_x, int y, std::size_t begin, std::size_t end);
  void interpolate_run();
  void start_block();
  void hand_over();
  void end_triangle();

  std::shared_ptr<const PipelineContext> context_;
  RasterizerConfig config_;
  std::shared_ptr<BlockPool> pool_;
  Emit emit_;
  GeometryCounters counters_;
  std::vector<double> depth_;  ///< the z buffer, row 0 on top

  Lanes weight1_{}, weight2_{}, new_depth_{};  ///< of the pixels being visited

  std::unique_ptr<FragmentBlock> block_;
  std::shared_ptr<const SetupTriangle> piece_;  ///< being walked
  const EdgeFunctions* edges_ = nullptr;        ///< of the piece being walked
  int run_begin_ = 0;                           ///< first lane of the block that still holds screen-space weights
  int object_ = 0;
  std::int64_t token_fragments_ = 0;  ///< of the mesh triangle so far
  std::uint32_t hidden_ = 0;          ///< positions scanned in vain since its last fragment
};

}  // namespace bump
