#include "units/tap_block.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "datapath/invariant.h"
#include "datapath/lane_clones.h"
#include "memory/level_of_detail.h"

namespace bump {

namespace {

/// Coordinates below this many texels are found with vectors: their integers are exact in every step below.
constexpr double far_away = 1 << 24;

/// index modulo size for whole numbers, |index| <= far_away. The product with the reciprocal is off by one turn at most.
inline double wrapped(double index, double size, double inverse_size) {
  const double rest = index - std::floor(index * inverse_size) * size;
  const double above = rest < 0 ? rest + size : rest;
  return above >= size ? above - size : above;
}

inline double clamped(double index, double size) {
  const double below = index < size - 1 ? index : size - 1;
  return below > 0 ? below : 0;
}

/// True if all coordinates (in texels, moved by `offset`) are near enough to the origin, and numbers.
BUMP_LANE_LOOP bool all_near(const double* __restrict coordinate, double size, double offset, int lanes) {
  int near = 0;
  for (int i = 0; i < lanes; ++i) near += std::fabs(coordinate[i] * size - offset) < far_away ? 1 : 0;
  return near == lanes;
}

BUMP_LANE_LOOP void nearest_texels(const double* __restrict coordinate, double size, bool repeats, int lanes, std::int32_t* __restrict at) {
  const double inverse = 1 / size;
  if (repeats)
    for (int i = 0; i < lanes; ++i) at[i] = static_cast<std::int32_t>(wrapped(std::floor(coordinate[i] * size), size, inverse));
  else
    for (int i = 0; i < lanes; ++i) at[i] = static_cast<std::int32_t>(clamped(std::floor(coordinate[i] * size), size));
}

/// The texels on both sides of each coordinate, and the weight of the second.
BUMP_LANE_LOOP void texel_pairs(const double* __restrict coordinate, double size, bool repeats, int lanes, std::int32_t* __restrict first,
                                std::int32_t* __restrict second, double* __restrict weight) {
  const double inverse = 1 / size;
  if (repeats) {
    for (int i = 0; i < lanes; ++i) {
      const double x = coordinate[i] * size - 0.5, below = std::floor(x), at = wrapped(below, size, inverse);
      weight[i] = x - below;
      first[i] = static_cast<std::int32_t>(at);
      second[i] = static_cast<std::int32_t>(at + 1 >= size ? 0.0 : at + 1);
    }
    return;
  }
  for (int i = 0; i < lanes; ++i) {
    const double x = coordinate[i] * size - 0.5, below = std::floor(x);
    weight[i] = x - below;
    first[i] = static_cast<std::int32_t>(clamped(below, size));
    second[i] = static_cast<std::int32_t>(clamped(below + 1, size));
  }
}

/// What a column or a row adds to the place of a texel: among the values of its level, and among texels in tiles (TextureLayout).
BUMP_LANE_LOOP void number_axis(const std::int32_t* __restrict at, std::int32_t values, std::uint32_t tile_step, std::uint32_t inside_step,
                                int lanes, std::int32_t* __restrict value, std::uint32_t* __restrict tiled) {
  constexpr std::uint32_t tile = TextureLayout::tile;
  for (int i = 0; i < lanes; ++i) {
    const auto index = static_cast<std::uint32_t>(at[i]);
    value[i] = at[i] * values;
    tiled[i] = index / tile * tile_step + index % tile * inside_step;
  }
}

BUMP_LANE_LOOP void number_tap(const std::int32_t* __restrict value_x, const std::int32_t* __restrict value_y,
                               const std::uint32_t* __restrict tiled_x, const std::uint32_t* __restrict tiled_y, std::uint32_t bytes,
                               int line_shift, int lanes, std::int32_t* __restrict texel, std::uint32_t* __restrict line) {
  for (int i = 0; i < lanes; ++i) {
    texel[i] = value_x[i] + value_y[i];
    line[i] = ((tiled_x[i] + tiled_y[i]) * bytes) >> line_shift;
  }
}

BUMP_LANE_LOOP void bilinear_weights(const double* __restrict right, const double* __restrict high, int lanes, double* __restrict weight0,
                                     double* __restrict weight1, double* __restrict weight2, double* __restrict weight3) {
  for (int i = 0; i < lanes; ++i) {
    const double left = 1 - right[i], low = 1 - high[i];
    weight0[i] = left * low;
    weight1[i] = right[i] * low;
    weight2[i] = left * high[i];
    weight3[i] = right[i] * high[i];
  }
}

/// Whether the longer side of every footprint is a texel or less: the level of detail is 0 or less then (level_of_detail.h).
BUMP_LANE_LOOP bool all_magnified(const double* __restrict dudx, const double* __restrict dvdx, const double* __restrict dudy,
                                  const double* __restrict dvdy, double w, double h, int lanes) {
  int minified = 0;
  for (int i = 0; i < lanes; ++i) {
    const double across = (dudx[i] * w) * (dudx[i] * w) + (dvdx[i] * h) * (dvdx[i] * h);
    const double down = (dudy[i] * w) * (dudy[i] * w) + (dvdy[i] * h) * (dvdy[i] * h);
    minified += across > 1 || down > 1 ? 1 : 0;
  }
  return minified == 0;
}

/// An angle in turns as filter_texels() leaves it when it is its only tap.
BUMP_LANE_LOOP void filter_lone_angles(double* __restrict angle, int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const double nothing = angle[i] - angle[i];  // not a number if the angle is none
    const double sum = angle[i] + (nothing - std::floor(nothing + 0.5));
    angle[i] = sum - std::floor(sum + 0.5);
  }
}

/// Weighted sums of `Taps` texels of `Channels` values, lane by lane: neighbouring values share a vector, and every sum keeps its order.
template <std::size_t Channels, std::size_t Taps>
void weigh_channels(const double* texels, const std::array<TapBlock::Words, TapBlock::most_taps>& texel,
                    const std::array<Lanes, TapBlock::most_taps>& weight, int lanes, Lanes* out) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(lanes); ++i) {
    double sum[Channels] = {};
    for (std::size_t tap = 0; tap < Taps; ++tap) {
      const double* values = texels + texel[tap][i];
      const double share = Taps == 1 ? 1.0 : weight[tap][i];
      for (std::size_t c = 0; c < Channels; ++c) sum[c] += share * values[c];
    }
    for (std::size_t c = 0; c < Channels; ++c) out[c][i] = sum[c];
  }
}

}  // namespace

bool TapBlock::can_hold(const Texture& texture, const TextureLayout& layout) {
  constexpr double most_values = std::numeric_limits<std::int32_t>::max(), most_bytes = std::numeric_limits<std::uint32_t>::max();
  const TextureLevel& base = texture.levels.front();
  const double values = static_cast<double>(base.width) * base.height * texture.channels;
  return values <= most_values && static_cast<double>(layout.end() - layout.start(0)) <= most_bytes;
}

void TapBlock::find(const Texture& texture, const TextureLayout& layout, int line_shift, Filter filter, const AccessLanes& at, int lanes) {
  const TextureLevel& base = texture.levels.front();
  const bool on_base = filter != Filter::trilinear || texture.levels.size() == 1 ||
                       all_magnified(at.dudx, at.dvdx, at.dudy, at.dvdy, base.width, base.height, lanes);
  const bool is_nearest = filter == Filter::nearest || !texture.filterable;
  uniform_ = on_base && (is_nearest ? find_nearest(texture, at, lanes) : find_bilinear(texture, at, lanes));
  if (uniform_)
    number_texels(texture, layout, line_shift, lanes);
  else
    find_one_by_one(texture, layout, line_shift, filter, at, lanes);
}

bool TapBlock::find_nearest(const Texture& texture, const AccessLanes& at, int lanes) {
  const double width = texture.levels.front().width, height = texture.levels.front().height;
  if (!all_near(at.u, width, 0, lanes) || !all_near(at.v, height, 0, lanes)) return false;
  taps_ = 1;
  weight_[0].fill(1.0);
  nearest_texels(at.u, width, texture.wrap_u == WrapMode::repeat, lanes, column_[0].data());
  nearest_texels(at.v, height, texture.wrap_v == WrapMode::repeat, lanes, row_[0].data());
  return true;
}

bool TapBlock::find_bilinear(const Texture& texture, const AccessLanes& at, int lanes) {
  const double width = texture.levels.front().width, height = texture.levels.front().height;
  if (!all_near(at.u, width, 0.5, lanes) || !all_near(at.v, height, 0.5, lanes)) return false;
  taps_ = 4;
  texel_pairs(at.u, width, texture.wrap_u == WrapMode::repeat, lanes, column_[0].data(), column_[1].data(), right_.data());
  texel_pairs(at.v, height, texture.wrap_v == WrapMode::repeat, lanes, row_[0].data(), row_[1].data(), high_.data());
  bilinear_weights(right_.data(), high_.data(), lanes, weight_[0].data(), weight_[1].data(), weight_[2].data(), weight_[3].data());
  return true;
}

void TapBlock::number_texels(const Texture& texture, const TextureLayout& layout, int line_shift, int lanes) {
  constexpr std::uint32_t tile = TextureLayout::tile;
  const std::size_t sides = taps_ == 1 ? 1 : 2;
  std::array<Words, 2> value_x, value_y;
  std::array<Lines, 2> tiled_x, tiled_y;
  for (std::size_t side = 0; side < sides; ++side) {
    number_axis(column_[side].data(), texture.channels, tile * tile, 1, lanes, value_x[side].data(), tiled_x[side].data());
    number_axis(row_[side].data(), texture.levels.front().width * texture.channels, layout.tiles_across(0) * tile * tile, tile, lanes,
                value_y[side].data(), tiled_y[side].data());
  }
  for (std::size_t tap = 0; tap < taps_; ++tap) {
    const std::size_t x = tap % 2, y = tap / 2;
    number_tap(value_x[x].data(), value_y[y].data(), tiled_x[x].data(), tiled_y[y].data(),
               static_cast<std::uint32_t>(texture.bytes_per_texel), line_shift, lanes, texel_[tap].data(), line_[tap].data());
  }
}

void TapBlock::find_one_by_one(const Texture& texture, const TextureLayout& layout, int line_shift, Filter filter, const AccessLanes& at,
                               int lanes) {
  taps_ = 1;
  for (std::size_t lane = 0; lane < static_cast<std::size_t>(lanes); ++lane) {
    double level_of_detail = 0;
    if (filter == Filter::trilinear)
      level_of_detail = lod_of_access(texture, filter, {at.dudx[lane], at.dvdx[lane], at.dudy[lane], at.dvdy[lane]});
    TexelTap found[most_taps];
    const int count = texel_taps(texture, filter, at.u[lane], at.v[lane], level_of_detail, found);
    count_[lane] = static_cast<std::uint8_t>(count);
    taps_ = std::max(taps_, static_cast<std::size_t>(count));
    level_[0][lane] = found[0].level;
    level_[1][lane] = found[count - 1].level;
    for (std::size_t tap = 0; tap < most_taps; ++tap) {
      const TexelTap& one = found[tap < static_cast<std::size_t>(count) ? tap : 0];
      texel_[tap][lane] = (one.y * texture.levels[static_cast<std::size_t>(one.level)].width + one.x) * texture.channels;
      weight_[tap][lane] = one.weight;
      line_[tap][lane] = static_cast<std::uint32_t>((layout.address(one.level, one.x, one.y) - layout.start(0)) >> line_shift);
    }
  }
}

void TapBlock::weigh(const Texture& texture, int lanes, Lanes* out) const {
  const bool has_angles = std::find(texture.kinds.begin(), texture.kinds.end(), ChannelKind::angle) != texture.kinds.end();
  const double* texels = texture.levels.front().texels.data();
  if (!uniform_ || taps_ > 4 || texture.channels > 4 || (has_angles && taps_ > 1)) return weigh_one_by_one(texture, lanes, out);
  using Weigh = void (*)(const double*, const std::array<Words, most_taps>&, const std::array<Lanes, most_taps>&, int, Lanes*);
  constexpr Weigh weigh_one[4] = {weigh_channels<1, 1>, weigh_channels<2, 1>, weigh_channels<3, 1>, weigh_channels<4, 1>};
  constexpr Weigh weigh_four[4] = {weigh_channels<1, 4>, weigh_channels<2, 4>, weigh_channels<3, 4>, weigh_channels<4, 4>};
  const auto channels = static_cast<std::size_t>(texture.channels);
  (taps_ == 1 ? weigh_one : weigh_four)[channels - 1](texels, texel_, weight_, lanes, out);
  for (std::size_t c = 0; c < channels; ++c)
    if (texture.kinds[c] == ChannelKind::angle) filter_lone_angles(out[c].data(), lanes);
}

void TapBlock::weigh_one_by_one(const Texture& texture, int lanes, Lanes* out) const {
  const auto short_way = [](double turns) { return turns - std::floor(turns + 0.5); };
  const auto channels = static_cast<std::size_t>(texture.channels);
  for (std::size_t lane = 0; lane < static_cast<std::size_t>(lanes); ++lane) {
    const auto count = static_cast<std::size_t>(taps_of(lane));
    const double* values[most_taps];
    for (std::size_t tap = 0; tap < count; ++tap) {
      const int level = uniform_ ? 0 : level_[tap / 4][lane];
      values[tap] = texture.levels[static_cast<std::size_t>(level)].texels.data() + texel_[tap][lane];
    }
    for (std::size_t c = 0; c < channels; ++c) {
      const double first = values[0][c];
      double sum = 0;
      if (texture.kinds[c] == ChannelKind::linear) {
        for (std::size_t tap = 0; tap < count; ++tap) sum += weight_[tap][lane] * values[tap][c];
      } else {
        for (std::size_t tap = 0; tap < count; ++tap) sum += weight_[tap][lane] * short_way(values[tap][c] - first);
        sum = short_way(first + sum);
      }
      out[c][lane] = sum;
    }
  }
}

}  // namespace bump
