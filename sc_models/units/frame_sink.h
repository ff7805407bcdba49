#pragma once
// The frame sink: writes colour, object and depth of arriving fragments into the frame buffer, unrounded, and counts them. With early z off
// it is the one that tests depth; with early z on its test always passes. It leaves out blending and the traffic of the frame buffer. One
// fragment a cycle.

#include <cstdint>
#include <memory>
#include <vector>

#include "units/frame_buffer.h"
#include "units/pipeline_context.h"

namespace bump {

class FrameSink {
 public:
  explicit FrameSink(std::shared_ptr<const PipelineContext> context);
  void process(const FragmentBlock& block);

  std::int64_t retired() const { return retired_; }
  /// Fragments that failed the depth test here.
  std::int64_t hidden() const { return hidden_; }
  /// What the hardware drew.
  const FrameBuffer& hardware() const { return hardware_; }
  /// Per pixel, FragmentBlock::diverged of the fragment that is seen.
  const std::vector<std::uint8_t>& diverged() const { return diverged_; }
  /// The double-precision evaluation; the hardware's frame where blocks carry none of their own.
  const FrameBuffer& exact() const { return context_->separate_exact() ? exact_ : hardware_; }

  /// Everything drawn, handed over without a copy; the sink is of no use afterwards. `exact` stays empty unless `with_exact`.
  struct Drawn {
    FrameBuffer hardware, exact;
    std::vector<std::uint8_t> diverged;
  };
  Drawn release(bool with_exact);

 private:
  /// `count` lanes into neighbouring pixels.
  void write(const FragmentBlock& block, std::size_t lane, std::size_t pixel, std::size_t count);

  std::shared_ptr<const PipelineContext> context_;
  FrameBuffer hardware_, exact_;
  std::vector<std::uint8_t> diverged_;
  int colour_plane_ = 0;
  std::int64_t retired_ = 0, hidden_ = 0;
};

/// A frame of the scene's size that shows nothing but its background.
FrameBuffer empty_frame(const Scene& scene);

}  // namespace bump
