#include "units/interpolators.h"

#include <cmath>

#include "datapath/lane_clones.h"

namespace bump {

namespace {

const Netlist* conversion_of(const Design& design) {
  return design.conversion ? &*design.conversion : nullptr;
}

/// One plane of `count` lanes of a triangle, from the first corner's value and the differences of the others.
BUMP_LANE_LOOP void interpolate(const double* __restrict w1, const double* __restrict w2, double a0, double a1, double a2, int count,
                                double* __restrict plane) {
  for (int i = 0; i < count; ++i) plane[i] = a0 + w1[i] * a1 + w2[i] * a2;
}

/// The same for angles, in turns.
BUMP_LANE_LOOP void interpolate_angle(const double* __restrict w1, const double* __restrict w2, double a0, double a1, double a2, int count,
                                      double* __restrict plane) {
  for (int i = 0; i < count; ++i) {
    const double angle = a0 + w1[i] * a1 + w2[i] * a2;
    plane[i] = angle - std::floor(angle + 0.5);
  }
}

}  // namespace

void InterpolatorsConfig::declare(Parameters& p) {
  p.integer("interpolators.latency", 4, 1, 4096, "cycles", "interpolation of a fragment, beside the latency of a conversion netlist")
      .timing_only = true;
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
      const double* corner = &triangle.attributes[2 + a];
      const double a0 = corner[0];
      const auto along = attribute.kind == InterpolantKind::linear ? interpolate : interpolate_angle;
      along(&block.weight1[begin], &block.weight2[begin], a0, corner[stride] - a0, corner[2 * stride] - a0, static_cast<int>(end - begin),
            &block.hardware[static_cast<std::size_t>(attribute.plane)][begin]);
    }
  }
  conversion_.process(block);
}

}  // namespace bump
