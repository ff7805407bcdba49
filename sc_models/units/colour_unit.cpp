#include "units/colour_unit.h"

#include <algorithm>
#include <cmath>

namespace bump {

namespace {

/// Integer bits that hold every sum of lights in the scene; the same for all materials, so that one unit serves them.
int integer_bits(const Scene& scene) {
  double lights = 0, brightest = 1;
  for (const Light& light : scene.lights) lights += std::fabs(light.intensity);
  for (const SceneObject& object : scene.objects) {
    const Material& m = object.material;
    brightest = std::max(brightest, std::fabs(m.ambient) + lights * (std::fabs(m.diffuse) + std::fabs(m.specular)));
  }
  return std::max(1, static_cast<int>(std::ceil(std::log2(brightest + 1))));
}

}  // namespace

void ColourUnitConfig::declare(Parameters& p) {
  p.integer("colour_unit.bits", 12, 8, 24, "bits", "fraction bits of intensities, texels and colours in the colour unit");
}

ColourUnitConfig::ColourUnitConfig(const Configuration& c) : bits(static_cast<int>(c.integer("colour_unit.bits"))) {}

Netlist colour_netlist(const Scene& scene, const Material& material, const ColourUnitConfig& config, LightSum lights) {
  Netlist n("colour");
  const int whole = integer_bits(scene);
  const Format wide = sfixed(config.bits + whole + 1, config.bits), unit = ufixed(config.bits + 1, config.bits);
  const bool summed = lights == LightSum::in_light_maps;
  const bool gains =
      !summed && std::any_of(scene.lights.begin(), scene.lights.end(), [](const Light& light) { return light.intensity != 1; });
  // The gain has a word of its own: intensities may be large where materials are dark, so that no sum is.
  double brightest = 1;
  for (const Light& light : scene.lights) brightest = std::max(brightest, std::fabs(light.intensity));
  const Format gain = sfixed(config.bits + static_cast<int>(std::ceil(std::log2(brightest + 1))) + 1, config.bits);
  Wire sum = n.constant("ambient", material.ambient, wide);
  for (std::size_t l = 0; l < (summed ? 1 : scene.lights.size()); ++l) {
    const int light = static_cast<int>(l);
    Wire intensity = n.input(plane_of_light("intensity", light), wide);
    if (gains)
      intensity =
          n.mul(plane_of_light("lit", light), intensity, n.constant(plane_of_light("gain", light), scene.lights[l].intensity, gain), wide);
    sum = n.add(plane_of_light("sum", light), sum, intensity, wide, "Lee 2007 Eq 2");
  }
  for (const char* channel : {"r", "g", "b"}) {
    const Wire texel = n.input(std::string("tex.") + channel, unit);
    const Wire product = n.mul(std::string("lit.") + channel, sum, texel, wide);
    n.output(std::string("colour.") + channel, n.clamp(std::string("colour.") + channel, product, 0, 1, unit));
  }
  return n;
}

ColourUnit::ColourUnit(std::shared_ptr<const PipelineContext> context, const ColourUnitConfig& config) : context_(std::move(context)) {
  const LightSum lights = context_->designs.front().light_maps ? LightSum::in_light_maps : LightSum::in_colour_unit;
  for (const SceneObject& object : context_->scene->objects) {
    netlists_.push_back(std::make_unique<Netlist>(colour_netlist(*context_->scene, object.material, config, lights)));
    hardware_.push_back(make_evaluator(*netlists_.back(), context_->options.arithmetic));
    if (context_->separate_exact()) exact_.push_back(make_evaluator(*netlists_.back(), Arithmetic::real));
  }
  if (netlists_.empty()) return;
  for (const Netlist::Port& port : netlists_.front()->inputs()) inputs_.push_back(context_->planes.index(port.name));
  for (const Netlist::Port& port : netlists_.front()->outputs()) outputs_.push_back(context_->planes.index(port.name));
}

void ColourUnit::process(FragmentBlock& block) {
  if (block.lanes == 0) return;
  const auto object = static_cast<std::size_t>(block.object);
  std::vector<const double*> inputs;
  std::vector<double*> outputs;
  for (const int plane : inputs_) inputs.push_back(block.hardware[static_cast<std::size_t>(plane)].data());
  for (const int plane : outputs_) outputs.push_back(block.hardware[static_cast<std::size_t>(plane)].data());
  hardware_[object]->evaluate(inputs.data(), block.lanes, outputs.data());
  executions_ += block.lanes;
  if (exact_.empty()) return;
  for (std::size_t i = 0; i < inputs_.size(); ++i) inputs[i] = context_->exact_plane(block, inputs_[i]).data();
  for (std::size_t i = 0; i < outputs_.size(); ++i) outputs[i] = block.exact[static_cast<std::size_t>(outputs_[i])].data();
  exact_[object]->evaluate(inputs.data(), block.lanes, outputs.data());
}

}  // namespace bump
