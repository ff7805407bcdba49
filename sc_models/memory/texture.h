#pragma once
// Textures as the texture unit sees them: planes of channel values with mip levels, wrap modes and filters. Values are doubles;
// a texel's stored width (for cache and memory traffic, and for quantised texels) is declared beside them.

#include <string>
#include <vector>

#include "datapath/format.h"

namespace bump {

enum class WrapMode { repeat, clamp };
enum class Filter { nearest, bilinear, trilinear };

/// How a channel is averaged. `angle` takes the short way round (values in turns).
enum class ChannelKind { linear, angle };

struct TextureLevel {
  int width = 0, height = 0;
  std::vector<double> texels;  ///< row-major, row 0 is v = 0 (bottom of the picture), channels interleaved
};

struct Texture {
  std::string name;
  int channels = 0;
  std::vector<ChannelKind> kinds;  ///< one per channel
  int bytes_per_texel = 4;         ///< as stored in memory
  WrapMode wrap_u = WrapMode::repeat, wrap_v = WrapMode::repeat;
  bool filterable = true;          ///< false: the nearest texel of the chosen level whatever the filter asked for
  std::vector<TextureLevel> levels;  ///< level 0 first; each level half of the one before, at least 1
};

/// One texel access: level and texel coordinates after wrapping, with its weight.
struct TexelTap {
  int level, x, y;
  double weight;
};

/// The taps of one filtered access at (u, v) with level of detail `lod` (log2 of texels per pixel). At most 8. Returns the count.
/// Texel centres are at half-integers; nearest takes floor(u * width).
int texel_taps(const Texture& texture, Filter filter, double u, double v, double lod, TexelTap taps[8]);

/// Weighted sum of taps for every channel (`out` holds texture.channels values). Angles are unwrapped to the first tap, then wrapped.
void filter_texels(const Texture& texture, const TexelTap* taps, int count, double* out);

/// Both at once.
void sample(const Texture& texture, Filter filter, double u, double v, double lod, double* out);

/// Appends levels down to 1 x 1 by 2 x 2 box averaging (odd sizes: the last row or column is repeated).
void build_mip_levels(Texture& texture);

}  // namespace bump
