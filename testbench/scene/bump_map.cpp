#include "testbench/scene/bump_map.h"

#include <algorithm>
#include <cmath>

#include "channels/parameters.h"
#include "datapath/invariant.h"

namespace bump {

namespace {

Texture empty_texture(const std::string& name, int channels, int bytes_per_texel, const Wrap& wrap, int width, int height) {
  Texture texture;
  texture.name = name;
  texture.channels = channels;
  texture.kinds.assign(static_cast<std::size_t>(channels), ChannelKind::linear);
  texture.bytes_per_texel = bytes_per_texel;
  texture.wrap_u = wrap.u;
  texture.wrap_v = wrap.v;
  TextureLevel level{width, height, {}};
  level.texels.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * static_cast<std::size_t>(channels));
  texture.levels.push_back(std::move(level));
  return texture;
}

/// Neighbour at a distance of one texel; -1 <= index <= size.
std::size_t neighbour(int index, int size, WrapMode mode) {
  if (mode == WrapMode::clamp) return static_cast<std::size_t>(std::clamp(index, 0, size - 1));
  return static_cast<std::size_t>((index + size) % size);
}

/// Three values to unit length; +z if they have none. Returns the length they had.
double make_unit(double* n) {
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  if (length < 1e-6) {
    n[0] = n[1] = 0;
    n[2] = 1;
  } else {
    for (int i = 0; i < 3; ++i) n[i] /= length;
  }
  return length;
}

void build_normal_levels(Texture& normals) {
  build_mip_levels(normals);
  for (std::size_t level = 1; level < normals.levels.size(); ++level) {
    auto& texels = normals.levels[level].texels;
    for (std::size_t i = 0; i < texels.size(); i += 3) make_unit(&texels[i]);
  }
}

std::string rounded(double value) {
  return to_string(ParameterValue(std::floor(value * 1000 + 0.5) / 1000));
}

/// Correlation through the origin: slopes of a relief that wraps have mean zero anyway.
struct Correlation {
  double ab = 0, aa = 0, bb = 0;
  void add(double a, double b) {
    ab += a * b;
    aa += a * a;
    bb += b * b;
  }
  double value() const { return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0; }
};

/// Central differences of plane values (`stride` apart) at (x, y).
struct Differences {
  const double* values;
  std::size_t stride;
  int width, height;
  Wrap wrap;
  double at(std::size_t x, std::size_t y) const { return values[(y * static_cast<std::size_t>(width) + x) * stride]; }
  double along_x(int x, int y) const {
    const std::size_t row = static_cast<std::size_t>(y);
    return (at(neighbour(x + 1, width, wrap.u), row) - at(neighbour(x - 1, width, wrap.u), row)) / 2;
  }
  double along_y(int x, int y) const {
    const std::size_t column = static_cast<std::size_t>(x);
    return (at(column, neighbour(y + 1, height, wrap.v)) - at(column, neighbour(y - 1, height, wrap.v))) / 2;
  }
};

Differences differences_of(const Texture& heights) {
  const auto& level = heights.levels.front();
  return {level.texels.data(), static_cast<std::size_t>(heights.channels), level.width, level.height, {heights.wrap_u, heights.wrap_v}};
}

}  // namespace

Texture colour_texture(const Image& image, const FileName& name, const Wrap& wrap, std::vector<std::string>& warnings) {
  Texture texture = empty_texture(name.shown, 3, image.bits == 8 ? 4 : 8, wrap, image.width, image.height);
  auto& texels = texture.levels.front().texels;
  if (image.channels == 3) {
    texels = image.values;
  } else {
    for (const double value : image.values) texels.insert(texels.end(), 3, value);
  }
  std::size_t clamped = 0;
  for (double& texel : texels) {
    const double value = texel;
    texel = std::clamp(value, 0.0, 1.0);
    clamped += texel != value ? 1 : 0;
  }
  if (clamped > 0) warnings.push_back("'" + name.shown + "': " + std::to_string(clamped) + " colour values outside [0, 1] were clamped");
  build_mip_levels(texture);
  return texture;
}

Texture constant_colour(double red, double green, double blue) {
  Texture texture = empty_texture("constant colour", 3, 4, {}, 1, 1);
  texture.levels.front().texels = {red, green, blue};
  return texture;
}

Texture height_texture(const Image& image, const FileName& name, double scale, const Wrap& wrap, const Location& from,
                       std::vector<std::string>& warnings) {
  if (looks_like_normal_map(image)) {
    throw Error({"'" + name.path + "' looks like a normal map", from, "nearly all of its texels are unit vectors coded as colours",
                 "normal = \"...\" instead of height"});
  }
  if (!is_grey(image)) warnings.push_back("'" + name.shown + "' is a height map in colour: the mean of red, green and blue is used");
  Texture texture = empty_texture(name.shown, 1, image.bits / 8, wrap, image.width, image.height);
  const std::size_t channels = static_cast<std::size_t>(image.channels);
  for (std::size_t i = 0; i < image.values.size(); i += channels) {
    const double value = channels == 1 ? image.values[i] : (image.values[i] + image.values[i + 1] + image.values[i + 2]) / 3;
    texture.levels.front().texels.push_back(value * scale);
  }
  build_mip_levels(texture);
  return texture;
}

Texture normals_from_heights(const Texture& heights) {
  const auto& level = heights.levels.front();
  const Differences slopes = differences_of(heights);
  Texture normals = empty_texture(heights.name, 3, 4, slopes.wrap, level.width, level.height);
  auto& texels = normals.levels.front().texels;
  texels.resize(3 * level.texels.size());
  double* n = texels.data();
  for (int y = 0; y < level.height; ++y) {
    for (int x = 0; x < level.width; ++x, n += 3) {
      n[0] = -slopes.along_x(x, y);
      n[1] = -slopes.along_y(x, y);
      n[2] = 1;
      make_unit(n);
    }
  }
  build_normal_levels(normals);
  return normals;
}

Texture normals_from_map(const Image& image, const FileName& name, bool green_down, const Wrap& wrap, const Location& from,
                         std::vector<std::string>& warnings, NamedBy named_by) {
  const bool by_scene = named_by == NamedBy::scene;
  if (is_grey(image)) {
    throw Error({"'" + name.path + "' is grey and cannot be a normal map", from, "a normal needs three different channels",
                 by_scene ? "height = \"...\" instead of normal" : "map_Bump instead of norm"});
  }
  Texture normals = empty_texture(name.shown, 3, 4, wrap, image.width, image.height);
  auto& texels = normals.levels.front().texels;
  std::size_t inward = 0, without_length = 0;
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < image.values.size(); i += 3) {
    double n[3] = {2 * image.values[i] - 1, (2 * image.values[i + 1] - 1) * (green_down ? -1 : 1), 2 * image.values[i + 2] - 1};
    if (n[2] < 0) ++inward;
    const double length = make_unit(n);
    // Half a step of 8 bits off zero is what a stored zero vector looks like.
    if (length < 0.02) {
      ++without_length;
      n[0] = n[1] = 0;
      n[2] = 1;
    }
    sum += length;
    squares += length * length;
    texels.insert(texels.end(), n, n + 3);
  }
  const double count = static_cast<double>(image.values.size()) / 3;
  const double mean = sum / count, deviation = std::sqrt(std::max(0.0, squares / count - mean * mean));
  if (std::abs(mean - 1) > 0.01 || deviation > 0.01) {
    warnings.push_back("'" + name.shown + "': normals have mean length " + rounded(mean) + ", standard deviation " + rounded(deviation) +
                       "; made unit");
  }
  if (without_length > 0)
    warnings.push_back("'" + name.shown + "': " + std::to_string(without_length) + " normals without length became flat");
  if (inward > 0)
    warnings.push_back("'" + name.shown + "': " + std::to_string(inward) + " normals point into the surface; kept as they are");
  build_normal_levels(normals);
  const double agreement = integrability(normals);
  if (agreement < -0.2) {
    const std::string green = green_down ? "up" : "down", advice = "green = \"" + green + "\"";
    warnings.push_back("'" + name.shown + "': no relief has these slopes (correlation " + rounded(agreement) + "), green seems to point " +
                       green + "; try " +
                       (by_scene ? advice
                                 : "a scene file with [[object]], shape = \"mesh\", mesh, normal and " + advice +
                                       " (see scenes/README.md), since a material library cannot say so"));
  }
  return normals;
}

Texture flat_normals() {
  Texture texture = empty_texture("flat", 3, 4, {}, 1, 1);
  texture.levels.front().texels = {0, 0, 1};
  return texture;
}

Texture stud_heights() {
  constexpr int side = 256, cell = 32;
  constexpr double radius = 12, height = 6;
  Texture texture = empty_texture("built-in studs", 1, 1, {}, side, side);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const double dx = x % cell + 0.5 - cell / 2.0, dy = y % cell + 0.5 - cell / 2.0;
      const double rest = std::max(0.0, 1 - (dx * dx + dy * dy) / (radius * radius));
      texture.levels.front().texels.push_back(height * rest * rest);
    }
  }
  build_mip_levels(texture);
  return texture;
}

double integrability(const Texture& normals) {
  const auto& level = normals.levels.front();
  std::vector<double> slopes;  // nx/nz, ny/nz, interleaved
  slopes.reserve(level.texels.size() / 3 * 2);
  for (std::size_t i = 0; i < level.texels.size(); i += 3) {
    const double z = std::max(level.texels[i + 2], 0.1);  // steep texels would drown the others
    slopes.push_back(level.texels[i] / z);
    slopes.push_back(level.texels[i + 1] / z);
  }
  const Wrap wrap{normals.wrap_u, normals.wrap_v};
  const Differences p{slopes.data(), 2, level.width, level.height, wrap}, q{slopes.data() + 1, 2, level.width, level.height, wrap};
  Correlation correlation;
  for (int y = 0; y < level.height; ++y) {
    for (int x = 0; x < level.width; ++x) correlation.add(p.along_y(x, y), q.along_x(x, y));
  }
  return correlation.value();
}

double green_correlation(const Texture& normals, const Texture& heights) {
  const auto& level = normals.levels.front();
  BUMP_ASSERT(level.width == heights.levels.front().width && level.height == heights.levels.front().height);
  const Differences slopes = differences_of(heights);
  Correlation correlation;
  std::size_t texel = 0;
  for (int y = 0; y < level.height; ++y) {
    for (int x = 0; x < level.width; ++x) correlation.add(level.texels[3 * texel++ + 1], -slopes.along_y(x, y));
  }
  return correlation.value();
}

}  // namespace bump
