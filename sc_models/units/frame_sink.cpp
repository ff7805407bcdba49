#include "units/frame_sink.h"

#include <algorithm>
#include <utility>

#include "datapath/lane_clones.h"
#include "units/large_pages.h"

namespace bump {

namespace {

BUMP_LANE_LOOP int count_nearer(const double* __restrict depth, const double* __restrict stored, int count) {
  int nearer = 0;
  for (int i = 0; i < count; ++i) nearer += depth[i] < stored[i] ? 1 : 0;
  return nearer;
}

BUMP_LANE_LOOP void interleave(const double* __restrict red, const double* __restrict green, const double* __restrict blue, int count,
                               double* __restrict colour) {
  for (int i = 0; i < count; ++i) {
    colour[3 * i] = red[i];
    colour[3 * i + 1] = green[i];
    colour[3 * i + 2] = blue[i];
  }
}

}  // namespace

FrameBuffer empty_frame(const Scene& scene) {
  FrameBuffer frame;
  frame.width = scene.width;
  frame.height = scene.height;
  const std::size_t pixels = static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height);
  reserve_large(frame.object, pixels);
  reserve_large(frame.depth, pixels);
  reserve_large(frame.colour, 3 * pixels);
  frame.object.assign(pixels, -1);
  frame.depth.assign(pixels, 1.0);
  std::vector<double> row;
  for (int x = 0; x < scene.width; ++x)
    for (int c = 0; c < 3; ++c) row.push_back(scene.background[c]);
  for (int y = 0; y < scene.height; ++y) frame.colour.insert(frame.colour.end(), row.begin(), row.end());
  return frame;
}

FrameSink::FrameSink(std::shared_ptr<const PipelineContext> context)
    : context_(std::move(context)), hardware_(empty_frame(*context_->scene)) {
  if (context_->separate_exact()) exact_ = empty_frame(*context_->scene);
  diverged_.assign(hardware_.object.size(), 0);
  colour_plane_ = context_->planes.index("colour.r");
}

void FrameSink::process(const FragmentBlock& block) {
  const auto lanes = static_cast<std::size_t>(block.lanes), width = static_cast<std::size_t>(hardware_.width);
  retired_ += block.lanes;
  // Fragments come in runs of neighbours in a row.
  for (std::size_t begin = 0, end = 0; begin < lanes; begin = end) {
    const std::int32_t x = block.x[begin], y = block.y[begin];
    for (end = begin + 1; end < lanes && block.y[end] == y && block.x[end] == x + static_cast<std::int32_t>(end - begin); ++end) {
    }
    const std::size_t pixel = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
    const int count = static_cast<int>(end - begin), seen = count_nearer(&block.depth[begin], &hardware_.depth[pixel], count);
    hidden_ += count - seen;
    if (seen == count) {
      write(block, begin, pixel, end - begin);
    } else if (seen > 0) {
      for (std::size_t i = 0; i < end - begin; ++i)
        if (block.depth[begin + i] < hardware_.depth[pixel + i]) write(block, begin + i, pixel + i, 1);
    }
  }
}

void FrameSink::write(const FragmentBlock& block, std::size_t lane, std::size_t pixel, std::size_t count) {
  const auto first = static_cast<std::size_t>(colour_plane_);
  const auto write_to = [&](FrameBuffer& frame, const std::vector<Lanes>& planes) {
    std::copy_n(&block.depth[lane], count, &frame.depth[pixel]);
    std::fill_n(&frame.object[pixel], count, block.object);
    interleave(&planes[first][lane], &planes[first + 1][lane], &planes[first + 2][lane], static_cast<int>(count), &frame.colour[3 * pixel]);
  };
  write_to(hardware_, block.hardware);
  if (context_->separate_exact()) write_to(exact_, block.exact);
  std::copy_n(&block.diverged[lane], count, &diverged_[pixel]);
}

FrameSink::Drawn FrameSink::release(bool with_exact) {
  Drawn drawn;
  if (with_exact) drawn.exact = context_->separate_exact() ? std::move(exact_) : hardware_;
  drawn.hardware = std::move(hardware_);
  drawn.diverged = std::move(diverged_);
  return drawn;
}

}  // namespace bump
