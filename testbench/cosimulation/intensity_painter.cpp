#include "testbench/cosimulation/intensity_painter.h"

#include "datapath/invariant.h"
#include "units/frame_sink.h"

namespace bump {

namespace {

const std::array<const char*, 3> channels = {"r", "g", "b"};

}  // namespace

IntensityPainter::IntensityPainter(std::shared_ptr<const PipelineContext> context, const ColourUnitConfig& config)
    : context_(std::move(context)), frame_(empty_frame(*context_->scene)) {
  const LightSum lights = context_->designs.front().light_maps ? LightSum::in_light_maps : LightSum::in_colour_unit;
  for (const SceneObject& object : context_->scene->objects) {
    netlists_.push_back(std::make_unique<Netlist>(colour_netlist(*context_->scene, object.material, config, lights)));
    evaluators_.push_back(make_evaluator(*netlists_.back(), context_->options.arithmetic));
  }
  const auto& inputs = netlists_.front()->inputs();
  BUMP_ASSERT(inputs.size() == 4 && inputs.front().name == "intensity");
  for (std::size_t c = 0; c < 3; ++c) BUMP_ASSERT(inputs[c + 1].name == std::string("tex.") + channels[c]);
}

void IntensityPainter::add(const FragmentBlock& block) {
  std::array<const double*, 3> texels{};
  for (std::size_t c = 0; c < 3; ++c)
    texels[c] = block.hardware[static_cast<std::size_t>(context_->planes.index(std::string("tex.") + channels[c]))].data();
  for (std::size_t lane = 0; lane < static_cast<std::size_t>(block.lanes); ++lane)
    waiting_.push_back(
        {block.x[lane], block.y[lane], block.object, block.depth[lane], {texels[0][lane], texels[1][lane], texels[2][lane]}});
}

void IntensityPainter::paint(double intensity) {
  BUMP_ASSERT(!waiting_.empty());
  if (!lit_.empty() && (lit_.size() == block_lanes || lit_.front().object != waiting_.front().object)) flush();
  lit_.push_back(waiting_.front());
  waiting_.pop_front();
  intensities_.push_back(intensity);
}

void IntensityPainter::flush() {
  if (lit_.empty()) return;
  const std::size_t count = lit_.size();
  std::array<std::vector<double>, 3> texels, colours;
  for (std::size_t c = 0; c < 3; ++c) {
    for (const Fragment& fragment : lit_) texels[c].push_back(fragment.texel[c]);
    colours[c].resize(count);
  }
  const std::array<const double*, 4> inputs = {intensities_.data(), texels[0].data(), texels[1].data(), texels[2].data()};
  const std::array<double*, 3> outputs = {colours[0].data(), colours[1].data(), colours[2].data()};
  evaluators_[static_cast<std::size_t>(lit_.front().object)]->evaluate(inputs.data(), static_cast<int>(count), outputs.data());
  for (std::size_t i = 0; i < count; ++i) {
    const Fragment& fragment = lit_[i];
    const std::size_t pixel =
        static_cast<std::size_t>(fragment.y) * static_cast<std::size_t>(frame_.width) + static_cast<std::size_t>(fragment.x);
    if (fragment.depth >= frame_.depth[pixel]) continue;
    frame_.depth[pixel] = fragment.depth;
    frame_.object[pixel] = fragment.object;
    for (std::size_t c = 0; c < 3; ++c) frame_.colour[3 * pixel + c] = colours[c][i];
  }
  lit_.clear();
  intensities_.clear();
}

FrameBuffer IntensityPainter::finish() {
  flush();
  BUMP_ASSERT(waiting_.empty());
  return std::move(frame_);
}

}  // namespace bump
