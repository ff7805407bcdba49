#include "units/rasterizer.h"

#include <algorithm>
#include <numeric>

#include "datapath/invariant.h"
#include "units/large_pages.h"
#include "units/raster_lanes.h"

namespace bump {

namespace {

/// A block without many fragments is handed on when this many triangles have left their records in it.
constexpr std::size_t many_records = 4 * block_lanes;

constexpr std::uint8_t first_port = 1, nothing = 0;

/// Edge functions below this are whole numbers that doubles hold, and so are their differences within a triangle.
constexpr std::int64_t most_exact = std::int64_t{1} << 51;

}  // namespace

void RasterizerConfig::declare(Parameters& p) {
  p.choice("rasterizer.order", "scanline", {"scanline", "tiled"}, "order in which the pixels of a triangle are visited");
  p.integer("rasterizer.tile", 8, 1, 256, "pixels", "side of a tile in tiled order");
  p.integer("rasterizer.subpixel_bits", 8, 1, 12, "bits", "fraction bits of screen coordinates");
  p.boolean("rasterizer.early_z", true, "test depth in front of shading; otherwise the frame sink tests it");
  p.integer("rasterizer.latency", 4, 1, 4096, "cycles", "from a raster triangle to its first fragment").timing_only = true;
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
  const std::size_t pixels = static_cast<std::size_t>(context_->scene->width) * static_cast<std::size_t>(context_->scene->height);
  reserve_large(depth_, pixels);
  depth_.assign(pixels, 1.0);
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
  block_->vertex_records.append(triangles.vertex_records);
  block_->setup_records.append(triangles.setup_records);
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
  counters_.fragments_generated += span.last - span.first + 1;
  for (int first = span.first; first <= span.last; first += block_lanes)
    visit(edges, first, std::min(span.last - first + 1, block_lanes), y);
}

void Rasterizer::visit(const EdgeFunctions& edges, int first, int count, int y) {
  const double scale = 1 / static_cast<double>(edges.area());
  const std::array<double, 3>& depth = piece_->depth;
  const std::int64_t edge1 = edges.at(1, first, y), edge2 = edges.at(2, first, y);
  double* stored =
      &depth_[static_cast<std::size_t>(y) * static_cast<std::size_t>(context_->scene->width) + static_cast<std::size_t>(first)];
  const double depth1 = depth[1] - depth[0], depth2 = depth[2] - depth[0];
  const auto n = static_cast<std::size_t>(count);
  int visible = 0;
  if (edges.area() < most_exact) {
    visible = weigh_row({static_cast<double>(edge1), static_cast<double>(edge2), static_cast<double>(edges.across(1)),
                         static_cast<double>(edges.across(2)), scale, depth[0], depth1, depth2},
                        count, stored, weight1_.data(), weight2_.data(), new_depth_.data());
  } else {
    for (std::size_t i = 0; i < n; ++i) {
      const auto steps = static_cast<std::int64_t>(i);
      weight1_[i] = static_cast<double>(edge1 + steps * edges.across(1)) * scale;
      weight2_[i] = static_cast<double>(edge2 + steps * edges.across(2)) * scale;
      new_depth_[i] = depth[0] + weight1_[i] * depth1 + weight2_[i] * depth2;
      visible += new_depth_[i] < stored[i] ? 1 : 0;
    }
  }
  if (!config_.early_z) return add_fragments(first, y, 0, n);
  if (visible == count) {
    std::copy_n(new_depth_.begin(), n, stored);
    return add_fragments(first, y, 0, n);
  }
  if (visible == 0) {
    hidden_ += static_cast<std::uint32_t>(count);
    return;
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (!(new_depth_[i] < stored[i])) {
      ++hidden_;
      continue;
    }
    stored[i] = new_depth_[i];
    add_fragments(first, y, i, i + 1);
  }
}

void Rasterizer::add_fragments(int first_x, int y, std::size_t begin, std::size_t end) {
  while (begin < end) {
    // A full block waits for the next fragment: only then is it known whether its last one ends its triangle.
    if (block_->lanes == block_lanes) {
      hand_over();
      start_block();
    }
    FragmentBlock& block = *block_;
    const auto lane = static_cast<std::size_t>(block.lanes);
    const std::size_t count = std::min(end - begin, block_lanes - lane);
    std::iota(&block.x[lane], &block.x[lane] + count, first_x + static_cast<int>(begin));
    std::fill_n(&block.y[lane], count, y);
    std::fill_n(&block.triangle[lane], count, static_cast<std::int32_t>(block.triangles.size()) - 1);
    std::copy_n(&new_depth_[begin], count, &block.depth[lane]);
    std::copy_n(&weight1_[begin], count, &block.weight1[lane]);
    std::copy_n(&weight2_[begin], count, &block.weight2[lane]);
    block.lanes += static_cast<int>(count);
    TokenRecord record;
    record.interval = 1 + hidden_;
    record.lead = hidden_;
    record.take = first_port;
    record.release = nothing;
    record.give = first_port;
    block.raster_records.push_back(record);
    record.interval = 1;
    record.lead = 0;
    block.raster_records.append(record, static_cast<std::int64_t>(count) - 1);
    counters_.fragments_hidden += hidden_;
    hidden_ = 0;
    token_fragments_ += static_cast<std::int64_t>(count);
    begin += count;
  }
}

void Rasterizer::end_triangle() {
  if (token_fragments_ > 0) {
    TokenRecord record = block_->raster_records.back();
    record.release = first_port;
    record.interval += hidden_;
    block_->raster_records.replace_back(record);
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
  Perspective perspective;
  perspective.b1x = static_cast<double>(edges.across(1)) * scale;
  perspective.b2x = static_cast<double>(edges.across(2)) * scale;
  perspective.b1y = static_cast<double>(edges.down(1)) * scale;
  perspective.b2y = static_cast<double>(edges.down(2)) * scale;
  perspective.q0 = t.inverse_w[0];
  perspective.q1 = t.inverse_w[1];
  perspective.q2 = t.inverse_w[2];
  const std::size_t stride = t.attributes.size() / 3;
  const double u0 = t.attributes[0], v0 = t.attributes[1];
  perspective.u0 = u0;
  perspective.v0 = v0;
  perspective.u1 = t.attributes[stride] - u0;
  perspective.v1 = t.attributes[stride + 1] - v0;
  perspective.u2 = t.attributes[2 * stride] - u0;
  perspective.v2 = t.attributes[2 * stride + 1] - v0;
  FragmentBlock& block = *block_;
  const auto first = static_cast<std::size_t>(run_begin_);
  interpolate_lanes(perspective, end - run_begin_, &block.weight1[first], &block.weight2[first], &block.u[first], &block.v[first],
                    &block.dudx[first], &block.dvdx[first], &block.dudy[first], &block.dvdy[first]);
  run_begin_ = end;
}

void Rasterizer::finish() {
  piece_.reset();
  if (!block_) start_block();
  block_->last = true;
  hand_over();
}

}  // namespace bump
