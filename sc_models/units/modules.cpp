#include "units/modules.h"

namespace bump {

void UnitModule::guard() {
  try {
    work();
  } catch (const Error&) {
    if (!failure_.what) failure_.what = std::current_exception();
    sc_core::sc_stop();
  }
}

void VertexProcessorModule::work() {
  auto block = std::make_unique<TriangleBlock>();
  while (unit_.next(*block)) {
    out_triangles_.write(std::move(block));
    if (progress_) progress_(unit_.counters().triangles);
    block = std::make_unique<TriangleBlock>();
  }
  out_triangles_.close();
}

void RasterizerModule::work() {
  while (const std::unique_ptr<TriangleBlock> block = in_triangles_.read()) unit_.process(*block);
  unit_.finish();
  out_fragments_.close();
}

void FrameSinkModule::work() {
  while (std::unique_ptr<FragmentBlock> block = in_fragments_.read()) {
    unit_.process(*block);
    if (retire_) retire_(*block);
    pool_->give_back(std::move(block));
  }
}

}  // namespace bump
