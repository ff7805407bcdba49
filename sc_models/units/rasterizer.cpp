#include "units/rasterizer.h"

#include <algorithm>

#include "datapath/invariant.h"

namespace bump {

namespace {

/// A block without many fragments is handed on when this many triangles have left their records in it.
constexpr std::size_t many_records = 4 * block_lanes;

constexpr std::uint8_t first_port = 1, nothing = 0;

}  // namespace

void RasterizerConfig::declare(Parameters& p) {
  p.choice("rasterizer.order", "scanline", {"scanline", "tiled"}, "order in which the pixels of a triangle are visited");
  p.integer("rasterizer.tile", 8, 1, 256, "pixels", "side of a tile in tiled order");
  p.integer("rasterizer.subpixel_bits", 8, 1, 12, "bits", "fraction bits of screen coordinates");
  p.boolean("rasterizer.early_z", true, "test depth in front of shading; otherwise the frame sink tests it");
  p.integer("rasterizer.latency", 4, 1, 4096, "cycles", "from a raster triangle to its first fragment");
}

RasterizerConfig::RasterizerConfig(const Configuration& c)
    : order(c.choice("rasterizer.order") == "tiled" ? Order::tiled : Order::scanline),
      tile(static_cast<int>(c.integer("rasterizer.tile"))),
      subpixel_bits(static_cast<int>(c.integer("rasterizer.subpixel_bits"))),
      early_z(c.boolean("rasterizer.early_z")),
      latency(static_cast<int>(c.integer("rasterizer.latency"))) {}

Rasterizer::Rasterizer(std::shared_ptr<const PipelineContext> context, const RasterizerConfig& config, std::shared_ptr<BlockPool> pool,
                       Emit emit)
    : context_(std::move(context)), config_(config), pool_(std::move(pool)), emit_(std::move(emit)) {
  depth_.assign(static_cast<std::size_t>(context_->scene->width) * static_cast<std::size_t>(context_->scene->height), 1.0);
}

void Rasterizer::start_block() {
  block_ = pool_->take();
  block_->object = object_;
  run_begin_ = 0;
  if (piece_) block_->triangles.push_back(piece_);
}

void Rasterizer::hand_over() {
  interpolate_run();
  emit_(std::move(block_));
}

void Rasterizer::process(const TriangleBlock& triangles) {
  if (block_ && triangles.object != object_ && (block_->lanes > 0 || !block_->raster_records.empty())) hand_over();
  object_ = triangles.object;
  if (!block_) start_block();
  block_->object = object_;
  block_->vertex_records.insert(block_->vertex_records.end(), triangles.vertex_records.begin(), triangles.vertex_records.end());
  block_->setup_records.insert(block_->setup_records.end(), triangles.setup_records.begin(), triangles.setup_records.end());
  for (int i = 0; i < triangles.triangles; ++i) {
    token_fragments_ = 0;
    hidden_ = 0;
    const auto index = static_cast<std::size_t>(i);
    for (int piece = triangles.first_piece[index]; piece < triangles.first_piece[index + 1]; ++piece)
      walk(triangles.pieces[static_cast<std::size_t>(piece)]);
    const bool rasterized = triangles.first_piece[index] < triangles.first_piece[index + 1];
    // Without a fragment, hidden_ counts every position that the triangle covers.
    if (token_fragments_ > 0)
      ++counters_.triangles_drawn;
    else if (hidden_ > 0)
      ++counters_.triangles_hidden;
    else if (rasterized)
      ++counters_.triangles_empty;
    end_triangle();
  }
}

void Rasterizer::walk(const std::shared_ptr<const SetupTriangle>& piece) {
  const EdgeFunctions edges(*piece, config_.subpixel_bits);
  const int left = std::max(0, edges.left()), right = std::min(context_->scene->width - 1, edges.right());
  const int top = std::max(0, edges.top()), bottom = std::min(context_->scene->height - 1, edges.bottom());
  if (left > right || top > bottom) return;
  piece_ = piece;
  edges_ = &edges;
  block_->triangles.push_back(piece);
  run_begin_ = block_->lanes;
  if (config_.order == RasterizerConfig::Order::scanline) {
    for (int y = top; y <= bottom; ++y) row(edges, edges.span(y, left, right), y);
  } else {
    const int n = config_.tile;
    std::vector<PixelSpan> spans(static_cast<std::size_t>(n));
    for (int tile_y = top / n * n; tile_y <= bottom; tile_y += n) {
      const int begin = std::max(top, tile_y), end = std::min(bottom, tile_y + n - 1);
      for (int y = begin; y <= end; ++y) spans[static_cast<std::size_t>(y - tile_y)] = edges.span(y, left, right);
      for (int tile_x = left / n * n; tile_x <= right; tile_x += n) {
        for (int y = begin; y <= end; ++y) {
          const PixelSpan& span = spans[static_cast<std::size_t>(y - tile_y)];
          row(edges, {std::max(span.first, tile_x), std::min(span.last, tile_x + n - 1)}, y);
        }
      }
    }
  }
  interpolate_run();
  piece_.reset();
  edges_ = nullptr;
}

void Rasterizer::row(const EdgeFunctions& edges, const PixelSpan& span, int y) {
  if (span.first > span.last) return;
  const double scale = 1 / static_cast<double>(edges.area());
  const std::array<double, 3> depth = piece_->depth;
  std::int64_t edge1 = edges.at(1, span.first, y), edge2 = edges.at(2, span.first, y);
  double* stored = &depth_[static_cast<std::size_t>(y) * static_cast<std::size_t>(context_->scene->width)];
  counters_.fragments_generated += span.last - span.first + 1;
  for (int x = span.first; x <= span.last; ++x) {
    const double weight1 = static_cast<double>(edge1) * scale, weight2 = static_cast<double>(edge2) * scale;
    const double z = depth[0] + weight1 * (depth[1] - depth[0]) + weight2 * (depth[2] - depth[0]);
    edge1 += edges.across(1);
    edge2 += edges.across(2);
    if (config_.early_z) {
      if (!(z < stored[x])) {
        ++hidden_;
        continue;
      }
      stored[x] = z;
    }
    add_fragment(x, y, z, weight1, weight2);
  }
}

void Rasterizer::add_fragment(int x, int y, double depth, double weight1, double weight2) {
  // A full block waits for the next fragment: only then is it known whether its last one ends its triangle.
  if (block_->lanes == block_lanes) {
    hand_over();
    start_block();
  }
  const auto lane = static_cast<std::size_t>(block_->lanes++);
  block_->x[lane] = x;
  block_->y[lane] = y;
  block_->depth[lane] = depth;
  block_->triangle[lane] = static_cast<std::int32_t>(block_->triangles.size()) - 1;
  block_->weight1[lane] = weight1;
  block_->weight2[lane] = weight2;
  TokenRecord record;
  record.interval = 1 + hidden_;
  record.lead = hidden_;
  record.take = first_port;
  record.release = nothing;
  record.give = first_port;
  block_->raster_records.push_back(record);
  counters_.fragments_hidden += hidden_;
  hidden_ = 0;
  ++token_fragments_;
}

void Rasterizer::end_triangle() {
  if (token_fragments_ > 0) {
    TokenRecord& record = block_->raster_records.back();
    record.release = first_port;
    record.interval += hidden_;
  } else {
    TokenRecord record;
    record.interval = std::max<std::uint32_t>(1, hidden_);
    record.lead = record.interval - 1;
    record.take = first_port;
    record.release = first_port;
    record.give = nothing;
    block_->raster_records.push_back(record);
  }
  counters_.fragments += token_fragments_;
  counters_.fragments_hidden += hidden_;
  hidden_ = 0;
  if (block_->raster_records.size() >= many_records) {
    hand_over();
    start_block();
  }
}

void Rasterizer::interpolate_run() {
  const int end = block_->lanes;
  if (run_begin_ >= end || !piece_) {
    run_begin_ = end;
    return;
  }
  const SetupTriangle& t = *piece_;
  const EdgeFunctions& edges = *edges_;
  const double scale = 1 / static_cast<double>(edges.area());
  const double b1x = static_cast<double>(edges.across(1)) * scale, b2x = static_cast<double>(edges.across(2)) * scale;
  const double b1y = static_cast<double>(edges.down(1)) * scale, b2y = static_cast<double>(edges.down(2)) * scale;
  const double q0 = t.inverse_w[0], q1 = t.inverse_w[1], q2 = t.inverse_w[2];
  const double dqx = b1x * (q1 - q0) + b2x * (q2 - q0), dqy = b1y * (q1 - q0) + b2y * (q2 - q0);
  const std::size_t stride = t.attributes.size() / 3;
  const double u0 = t.attributes[0], v0 = t.attributes[1];
  const double u1 = t.attributes[stride] - u0, v1 = t.attributes[stride + 1] - v0;
  const double u2 = t.attributes[2 * stride] - u0, v2 = t.attributes[2 * stride + 1] - v0;
  FragmentBlock& block = *block_;
  for (auto lane = static_cast<std::size_t>(run_begin_); lane < static_cast<std::size_t>(end); ++lane) {
    const double b1 = block.weight1[lane], b2 = block.weight2[lane];
    const double w = 1 / (q0 + b1 * (q1 - q0) + b2 * (q2 - q0));
    const double w1 = b1 * q1 * w, w2 = b2 * q2 * w;
    // Quotient rule: the weights are b_i q_i over the interpolated 1 / w.
    const double w1x = (b1x * q1 - w1 * dqx) * w, w2x = (b2x * q2 - w2 * dqx) * w;
    const double w1y = (b1y * q1 - w1 * dqy) * w, w2y = (b2y * q2 - w2 * dqy) * w;
    block.weight1[lane] = w1;
    block.weight2[lane] = w2;
    block.u[lane] = u0 + w1 * u1 + w2 * u2;
    block.v[lane] = v0 + w1 * v1 + w2 * v2;
    block.dudx[lane] = w1x * u1 + w2x * u2;
    block.dvdx[lane] = w1x * v1 + w2x * v2;
    block.dudy[lane] = w1y * u1 + w2y * u2;
    block.dvdy[lane] = w1y * v1 + w2y * v2;
  }
  run_begin_ = end;
}

void Rasterizer::finish() {
  piece_.reset();
  if (!block_) start_block();
  block_->last = true;
  hand_over();
}

}  // namespace bump
