#pragma once
// The vertex processor: reads indexed triangles, transforms each vertex to clip space and runs the scheme's vertex program on it, for every
// light, behind a small post-transform cache. It leaves out vertex fetch from memory and the instruction set: the program is a recorded
// netlist whose operators are executed one per arithmetic unit and cycle. A token is a triangle; its interval is the number of vertices
// that had to be transformed times ceil(operations of a vertex / arithmetic units), at least 1. Source: the vertex work of each scheme's
// own paper.

#include <cstdint>
#include <memory>
#include <vector>

#include "channels/parameters.h"
#include "datapath/inventory.h"
#include "units/counters.h"
#include "units/pipeline_context.h"
#include "units/triangle_block.h"
#include "units/vertex_cache.h"

namespace bump {

struct VertexProcessorConfig {
  int alus = 4;                               ///< arithmetic units, one operation a cycle each
  int cache_entries = 16;                     ///< post-transform cache, 0 for none
  int latency = 8;                            ///< cycles behind the last operation
  ShadingSpace space = ShadingSpace::object;  ///< axes of the vectors that the scheme's vertex program reads

  static void declare(Parameters& parameters);
  VertexProcessorConfig() = default;
  explicit VertexProcessorConfig(const Configuration& configuration);
};

/// Operations of one vertex. Additions, subtractions, multiplications, divisions, square roots and table reads weigh 1, all else 0.
struct VertexWork {
  std::int64_t transform = 0;  ///< clip position, and whatever brings the vectors that the program reads into the axes of shading
  std::int64_t once = 0;       ///< nodes of the program that do not depend on the light
  std::int64_t per_light = 0;  ///< nodes that do
  int lights = 0;
  std::int64_t total() const { return transform + once + per_light * lights; }
};

std::int64_t operations(const Inventory& inventory);
/// What the transform delivers beside the clip position.
struct TransformNeeds {
  bool towards_eye = false;  ///< V
  int point_lights = 0;      ///< an L each; directional lights come in the axes of shading already
  std::string frame;         ///< of "NTB", those that the program reads; in object space they pass as they are
  ShadingSpace space = ShadingSpace::object;
};
/// The transform every scheme shares, as hardware: homogeneous matrix times vector (16 multipliers, 12 adders), and the differences towards
/// the eye and each point light (3 adders). In eye space each vector of the frame takes a rotation (9, 6); the position, if V or a point
/// light needs it, a matrix and a shift (9, 9); and V is its negation. Real-valued; inputs P (w = 1), N, T, B, the matrices M.clip, M.eye
/// and R, and "from.V", "from.L", "from.L#1" ..., eye and point lights in the axes of shading.
Netlist vertex_transform(const TransformNeeds& needs);
/// In object space.
Netlist vertex_transform(bool towards_eye, int point_lights);
/// With what the scheme's vertex program reads.
Netlist vertex_transform(const PipelineContext& context);
VertexWork vertex_work(const PipelineContext& context);

class VertexProcessor {
 public:
  VertexProcessor(std::shared_ptr<const PipelineContext> context, const VertexProcessorConfig& config);

  /// Fills the block with the next triangles of the scene, in order, at most block_triangles of one object, with their records. False, and
  /// an empty block, when there are none left.
  bool next(TriangleBlock& block);

  /// vertices, vertex_reuses and triangles are counted here.
  const GeometryCounters& counters() const { return counters_; }
  const VertexWork& work() const { return work_; }
  /// The transform that every scheme shares, as hardware.
  const Netlist& transform() const { return transform_; }

 private:
  void start_object();
  void run_program(int first, int count);
  void emit_triangle(TriangleBlock& block, int index, std::uint32_t source);

  std::shared_ptr<const PipelineContext> context_;
  VertexProcessorConfig config_;
  Netlist transform_;
  VertexWork work_;
  std::vector<std::unique_ptr<Evaluator>> programs_;  ///< one per design
  GeometryCounters counters_;
  int object_ = -1;
  std::size_t triangle_ = 0;
  VertexCache cache_{0, 0};
  std::vector<glm::dvec4> clip_;    ///< per vertex of the object
  std::vector<double> attributes_;  ///< per vertex, context stride each
};

}  // namespace bump
