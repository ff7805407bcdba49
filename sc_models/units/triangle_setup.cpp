#include "units/triangle_setup.h"

#include <algorithm>
#include <cmath>

#include "datapath/invariant.h"
#include "units/projection.h"

namespace bump {

namespace {

/// Nearest point of the subpixel grid, halves up.
double snap(double pixels, int subpixel_bits) {
  return std::ldexp(std::floor(std::ldexp(pixels, subpixel_bits) + 0.5), -subpixel_bits);
}

bool all_outside(const ClipPolygon& polygon, const ClipPlane& plane) {
  return std::all_of(polygon.begin(), polygon.end(), [&](const ClipCorner& corner) { return plane.distance(corner.position) < 0; });
}

bool any_outside(const ClipPolygon& polygon, const ClipPlane& plane) {
  return std::any_of(polygon.begin(), polygon.end(), [&](const ClipCorner& corner) { return plane.distance(corner.position) < 0; });
}

}  // namespace

void TriangleSetupConfig::declare(Parameters& p) {
  p.integer("triangle_setup.latency", 8, 1, 4096, "cycles", "from transformed corners to the raster triangle").timing_only = true;
  p.integer("triangle_setup.interval", 4, 1, 4096, "cycles", "a raster triangle: three edge equations and the reciprocal of the area");
  p.choice("triangle_setup.cull", "back", {"back", "none"}, "which triangles are dropped by their facing");
  p.integer("triangle_setup.guard_band", 8192, 0, 32768, "pixels", "around the frame, within which triangles are not clipped");
}

TriangleSetupConfig::TriangleSetupConfig(const Configuration& c)
    : latency(static_cast<int>(c.integer("triangle_setup.latency"))),
      interval(static_cast<int>(c.integer("triangle_setup.interval"))),
      cull_back(c.choice("triangle_setup.cull") == "back"),
      guard_band(static_cast<int>(c.integer("triangle_setup.guard_band"))),
      subpixel_bits(static_cast<int>(c.integer("rasterizer.subpixel_bits"))) {}

std::int64_t twice_area(const SetupTriangle& t, int subpixel_bits) {
  const auto grid = [&](double value) { return static_cast<std::int64_t>(std::ldexp(value, subpixel_bits)); };
  return (grid(t.x[1]) - grid(t.x[0])) * (grid(t.y[2]) - grid(t.y[0])) - (grid(t.x[2]) - grid(t.x[0])) * (grid(t.y[1]) - grid(t.y[0]));
}

TriangleSetup::TriangleSetup(std::shared_ptr<const PipelineContext> context, const TriangleSetupConfig& config)
    : context_(std::move(context)),
      config_(config),
      frame_(bump::guard_band(context_->scene->width, context_->scene->height, 0)),
      guard_(bump::guard_band(context_->scene->width, context_->scene->height, config.guard_band)),
      near_(near_plane(context_->scene->camera.near)) {
  // Edge functions multiply two differences of coordinates: 64 bits must hold them.
  const double reach =
      std::ldexp(2.0 * config.guard_band + std::max(context_->scene->width, context_->scene->height) + 2, config.subpixel_bits);
  if (reach > 1.0e9)
    throw Error({"screen coordinates of more than 30 bits",
                 {},
                 "triangle_setup.guard_band and rasterizer.subpixel_bits are large for this frame",
                 "a smaller guard band or fewer subpixel bits"});
}

void TriangleSetup::unwrap(double* corners) const {
  const auto stride = static_cast<std::size_t>(context_->stride());
  for (std::size_t a = 0; a < context_->attributes.size(); ++a) {
    const InterpolantKind kind = context_->attributes[a].kind;
    if (kind == InterpolantKind::linear) continue;
    const double first = corners[2 + a];
    for (std::size_t corner = 1; corner < 3; ++corner) {
      double& value = corners[corner * stride + 2 + a];
      const double difference = value - first;
      value = kind == InterpolantKind::flat_angle ? first : first + (difference - std::floor(difference + 0.5));
    }
  }
}

std::vector<std::shared_ptr<SetupTriangle>> TriangleSetup::fan(const ClipPolygon& polygon, std::uint32_t source) const {
  std::vector<std::shared_ptr<SetupTriangle>> pieces;
  std::vector<ScreenPosition> screen;
  for (const ClipCorner& corner : polygon) screen.push_back(to_screen(corner.position, context_->scene->width, context_->scene->height));
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    auto piece = std::make_shared<SetupTriangle>();
    piece->source = source;
    piece->attributes.reserve(3 * polygon[0].attributes.size());
    const std::size_t corners[3] = {0, i, i + 1};
    for (std::size_t c = 0; c < 3; ++c) {
      const ScreenPosition& at = screen[corners[c]];
      piece->x[c] = snap(at.x, config_.subpixel_bits);
      piece->y[c] = snap(at.y, config_.subpixel_bits);
      piece->depth[c] = at.depth;
      piece->inverse_w[c] = at.inverse_w;
      const std::vector<double>& values = polygon[corners[c]].attributes;
      piece->attributes.insert(piece->attributes.end(), values.begin(), values.end());
    }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

void TriangleSetup::set_up(TriangleBlock& block, int index) {
  const auto stride = static_cast<std::size_t>(block.stride);
  const auto first = 3 * static_cast<std::size_t>(index);
  unwrap(&block.attributes[first * stride]);
  ClipPolygon polygon(3);
  for (std::size_t corner = 0; corner < 3; ++corner) {
    polygon[corner].position = block.clip[first + corner];
    const double* values = &block.attributes[(first + corner) * stride];
    polygon[corner].attributes.assign(values, values + stride);
  }
  bool clipped = false;
  if (any_outside(polygon, near_)) {
    polygon = clip(polygon, near_);
    clipped = true;
  }
  const bool beside =
      polygon.size() < 3 || std::any_of(frame_.begin(), frame_.end(), [&](const ClipPlane& plane) { return all_outside(polygon, plane); });
  if (beside) {
    ++counters_.triangles_empty;
    return;
  }
  if (std::any_of(guard_.begin(), guard_.end(), [&](const ClipPlane& plane) { return any_outside(polygon, plane); })) {
    for (const ClipPlane& plane : guard_) polygon = clip(polygon, plane);
    clipped = true;
  }
  if (clipped) ++counters_.triangles_clipped;

  // The pieces of one triangle face the same way; one that snapping has turned over is a sliver that its neighbours cover.
  const std::vector<std::shared_ptr<SetupTriangle>> pieces = fan(polygon, block.source[static_cast<std::size_t>(index)]);
  std::int64_t facing = 0;
  for (const auto& piece : pieces) facing += twice_area(*piece, config_.subpixel_bits);
  if (facing == 0) {
    ++counters_.triangles_empty;
    return;
  }
  if (facing > 0 && config_.cull_back) {
    ++counters_.triangles_culled;
    return;
  }
  for (const auto& piece : pieces) {
    const std::int64_t area = twice_area(*piece, config_.subpixel_bits);
    if (area != 0 && (area > 0) == (facing > 0)) block.pieces.push_back(piece);
  }
}

void TriangleSetup::process(TriangleBlock& block) {
  block.pieces.clear();
  block.setup_records.clear();
  for (int i = 0; i < block.triangles; ++i) {
    const std::size_t before = block.pieces.size();
    block.first_piece[static_cast<std::size_t>(i)] = static_cast<int>(before);
    set_up(block, i);
    TokenRecord record;
    record.interval =
        static_cast<std::uint32_t>(config_.interval) * static_cast<std::uint32_t>(std::max<std::size_t>(1, block.pieces.size() - before));
    block.setup_records.push_back(record);
  }
  block.first_piece[static_cast<std::size_t>(block.triangles)] = static_cast<int>(block.pieces.size());
}

}  // namespace bump
