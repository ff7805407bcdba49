#include "units/interpolators.h"

#include <cmath>

namespace bump {

namespace {

const Netlist* conversion_of(const Design& design) {
  return design.conversion ? &*design.conversion : nullptr;
}

/// Lanes [begin, end) of one plane, all in one triangle; `corner` holds the component of corner 0, `stride` values apart from the next
/// corner's.
void interpolate(const FragmentBlock& block, std::size_t begin, std::size_t end, const double* corner, std::size_t stride,
                 InterpolantKind kind, Lanes& plane) {
  const double a0 = corner[0], a1 = corner[stride] - a0, a2 = corner[2 * stride] - a0;
  const Lanes &w1 = block.weight1, &w2 = block.weight2;
  for (std::size_t lane = begin; lane < end; ++lane) plane[lane] = a0 + w1[lane] * a1 + w2[lane] * a2;
  if (kind == InterpolantKind::linear) return;
  for (std::size_t lane = begin; lane < end; ++lane) plane[lane] -= std::floor(plane[lane] + 0.5);
}

}  // namespace

void InterpolatorsConfig::declare(Parameters& p) {
  p.integer("interpolators.latency", 4, 1, 4096, "cycles", "interpolation of a fragment, beside the latency of a conversion netlist");
}

InterpolatorsConfig::InterpolatorsConfig(const Configuration& c) : latency(static_cast<int>(c.integer("interpolators.latency"))) {}

Netlist interpolator_netlist(const PipelineContext& context) {
  Netlist n("interpolators");
  const Format format = real();
  const Wire b1 = n.input("b1", format), b2 = n.input("b2", format);
  const auto affine = [&](const std::string& name, Wire weight1, Wire weight2) {
    const Wire first = n.mul(name + ".1", weight1, n.input(name + ".d1", format), format);
    const Wire second = n.mul(name + ".2", weight2, n.input(name + ".d2", format), format);
    return n.add(name, n.add(name + ".12", first, second, format), n.input(name + ".a0", format), format);
  };
  const Wire one = n.constant("one", 1, format);
  const Wire w = n.div("w", one, affine("inverse_w", b1, b2), format);
  const auto weight = [&](const std::string& corner, Wire b) {
    return n.mul("w" + corner, n.mul("b" + corner + ".q", b, n.input("q" + corner, format), format), w, format);
  };
  const Wire w1 = weight("1", b1), w2 = weight("2", b2);
  n.output("u", affine("u", w1, w2));
  n.output("v", affine("v", w1, w2));
  for (const Attribute& attribute : context.attributes) {
    if (attribute.probe >= 0) continue;
    const std::string& name = context.planes.names()[static_cast<std::size_t>(attribute.plane)];
    n.output(name, attribute.kind == InterpolantKind::flat_angle ? n.input(name + ".a0", format) : affine(name, w1, w2));
  }
  return n;
}

int interpolator_components(const PipelineContext& context) {
  int count = 0;
  for (const Attribute& attribute : context.attributes) count += attribute.probe < 0 ? 1 : 0;
  return count;
}

Interpolators::Interpolators(std::shared_ptr<const PipelineContext> context) : context_(context), conversion_(context, conversion_of) {}

void Interpolators::process(FragmentBlock& block) {
  const auto lanes = static_cast<std::size_t>(block.lanes);
  for (std::size_t begin = 0, end = 0; begin < lanes; begin = end) {
    const std::int32_t index = block.triangle[begin];
    for (end = begin + 1; end < lanes && block.triangle[end] == index; ++end) {
    }
    const SetupTriangle& triangle = *block.triangles[static_cast<std::size_t>(index)];
    const auto stride = static_cast<std::size_t>(context_->stride());
    for (std::size_t a = 0; a < context_->attributes.size(); ++a) {
      const Attribute& attribute = context_->attributes[a];
      interpolate(block, begin, end, &triangle.attributes[2 + a], stride, attribute.kind,
                  block.hardware[static_cast<std::size_t>(attribute.plane)]);
    }
  }
  conversion_.process(block);
}

}  // namespace bump
