#pragma once
// What travels from the vertex processor to triangle setup and on to the rasterizer: a block of up to 64 mesh triangles of one object. The
// vertex processor fills in clip positions and attributes, triangle setup the raster triangles that it cut each of them into. Timing
// records ride along, one per mesh triangle and stage.

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "units/fragment_block.h"

namespace bump {

constexpr int block_triangles = 64;

struct TriangleBlock {
  int object = 0;                                       ///< index into Scene::objects
  int triangles = 0;                                    ///< mesh triangles in the block, at most block_triangles
  int stride = 0;                                       ///< attributes of a corner: texture coordinates, then PipelineContext::attributes
  std::array<std::uint32_t, block_triangles> source{};  ///< index into Mesh::triangles
  std::vector<glm::dvec4> clip;                         ///< 3 corners a triangle
  std::vector<double> attributes;                       ///< 3 corners x stride a triangle
  std::vector<std::shared_ptr<const SetupTriangle>> pieces;  ///< raster triangles, in order of their mesh triangle
  std::array<int, block_triangles + 1> first_piece{};        ///< pieces of triangle i: [first_piece[i], first_piece[i + 1])
  TokenRecords vertex_records, setup_records;

  /// Makes room for `count` triangles of `object` with `stride` attributes a corner; nothing is filled in.
  void resize(int object_index, int count, int attribute_stride);
};

}  // namespace bump
