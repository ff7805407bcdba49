#include "units/frame_sink.h"

namespace bump {

FrameBuffer empty_frame(const Scene& scene) {
  FrameBuffer frame;
  frame.width = scene.width;
  frame.height = scene.height;
  const std::size_t pixels = static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height);
  frame.object.assign(pixels, -1);
  frame.depth.assign(pixels, 1.0);
  frame.colour.resize(3 * pixels);
  for (std::size_t i = 0; i < frame.colour.size(); ++i) frame.colour[i] = scene.background[static_cast<int>(i % 3)];
  return frame;
}

FrameSink::FrameSink(std::shared_ptr<const PipelineContext> context)
    : context_(std::move(context)), hardware_(empty_frame(*context_->scene)) {
  if (context_->separate_exact()) exact_ = hardware_;
  diverged_.assign(hardware_.object.size(), 0);
  colour_plane_ = context_->planes.index("colour.r");
}

void FrameSink::process(const FragmentBlock& block) {
  const auto first = static_cast<std::size_t>(colour_plane_);
  const bool exact = context_->separate_exact();
  for (std::size_t lane = 0; lane < static_cast<std::size_t>(block.lanes); ++lane) {
    const auto pixel =
        static_cast<std::size_t>(block.y[lane]) * static_cast<std::size_t>(hardware_.width) + static_cast<std::size_t>(block.x[lane]);
    ++retired_;
    if (!(block.depth[lane] < hardware_.depth[pixel])) {
      ++hidden_;
      continue;
    }
    hardware_.depth[pixel] = block.depth[lane];
    hardware_.object[pixel] = block.object;
    diverged_[pixel] = block.diverged[lane];
    for (std::size_t c = 0; c < 3; ++c) hardware_.colour[3 * pixel + c] = block.hardware[first + c][lane];
    if (!exact) continue;
    exact_.depth[pixel] = block.depth[lane];
    exact_.object[pixel] = block.object;
    for (std::size_t c = 0; c < 3; ++c) exact_.colour[3 * pixel + c] = block.exact[first + c][lane];
  }
}

}  // namespace bump
