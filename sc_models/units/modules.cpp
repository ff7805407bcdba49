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
  const auto next = [this](TriangleBlock& block) {
    host_clock_.start();
    const bool any = unit_.next(block);
    host_clock_.stop();
    return any;
  };
  auto block = std::make_unique<TriangleBlock>();
  while (next(*block)) {
    out_triangles_.write(std::move(block));
    if (progress_) progress_(unit_.counters().triangles);
    block = std::make_unique<TriangleBlock>();
  }
  out_triangles_.close();
}

void RasterizerModule::work() {
  while (const std::unique_ptr<TriangleBlock> block = in_triangles_.read()) {
    host_clock_.start();
    unit_.process(*block);
    host_clock_.stop();
  }
  host_clock_.start();
  unit_.finish();
  host_clock_.stop();
  out_fragments_.close();
}

void FrameSinkModule::work() {
  while (std::unique_ptr<FragmentBlock> block = in_fragments_.read()) {
    host_clock_.start();
    unit_.process(*block);
    host_clock_.stop();
    if (retire_) retire_(*block);
    pool_->give_back(std::move(block));
  }
}

}  // namespace bump
