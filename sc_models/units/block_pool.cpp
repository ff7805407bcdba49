#include "units/block_pool.h"

namespace bump {

std::unique_ptr<FragmentBlock> BlockPool::take() {
  if (free_.empty()) {
    auto block = std::make_unique<FragmentBlock>();
    block->hardware.resize(hardware_planes_);
    block->exact.resize(exact_planes_);
    return block;
  }
  std::unique_ptr<FragmentBlock> block = std::move(free_.back());
  free_.pop_back();
  block->lanes = 0;
  block->object = 0;
  block->last = false;
  block->triangles.clear();
  block->vertex_records.clear();
  block->setup_records.clear();
  block->raster_records.clear();
  block->texture_records.clear();
  block->light_map_records.clear();
  return block;
}

void BlockPool::give_back(std::unique_ptr<FragmentBlock> block) {
  free_.push_back(std::move(block));
}

}  // namespace bump
