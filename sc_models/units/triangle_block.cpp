#include "units/triangle_block.h"

#include "datapath/invariant.h"

namespace bump {

void TriangleBlock::resize(int object_index, int count, int attribute_stride) {
  BUMP_ASSERT(count >= 0 && count <= block_triangles);
  object = object_index;
  triangles = count;
  stride = attribute_stride;
  clip.resize(3 * static_cast<std::size_t>(count));
  attributes.resize(3 * static_cast<std::size_t>(count) * static_cast<std::size_t>(attribute_stride));
  pieces.clear();
  first_piece.fill(0);
  vertex_records.clear();
  setup_records.clear();
}

}  // namespace bump
