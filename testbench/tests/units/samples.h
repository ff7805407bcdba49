#pragma once
// Small scenes and a small design for the tests of the units: a Cartesian tangent-space scheme with one linear and one angular extra.

#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <random>
#include <vector>

#include "memory/texture.h"
#include "units/block_pool.h"
#include "units/pipeline_context.h"
#include "units/rasterizer.h"
#include "units/triangle_setup.h"
#include "units/vertex_processor.h"

namespace bump::samples {

inline std::shared_ptr<Texture> texture(int width, int height, int channels, unsigned seed) {
  auto result = std::make_shared<Texture>();
  result->channels = channels;
  result->kinds.assign(static_cast<std::size_t>(channels), ChannelKind::linear);
  TextureLevel level{width, height, {}};
  std::mt19937 random(seed);
  for (int i = 0; i < width * height * channels; ++i) level.texels.push_back(static_cast<double>(random() % 256) / 255.0);
  result->levels.push_back(level);
  build_mip_levels(*result);
  return result;
}

/// Unit normals, tilted up to 45 degrees.
inline std::shared_ptr<Texture> normals(int width, int height, unsigned seed) {
  auto result = texture(width, height, 3, seed);
  result->levels.resize(1);
  std::vector<double>& texels = result->levels[0].texels;
  for (std::size_t i = 0; i < texels.size(); i += 3) {
    const glm::dvec3 n = glm::normalize(glm::dvec3(texels[i] - 0.5, texels[i + 1] - 0.5, 0.7));
    for (int c = 0; c < 3; ++c) texels[i + static_cast<std::size_t>(c)] = n[c];
  }
  build_mip_levels(*result);
  return result;
}

/// A sphere of radius 1 around the origin, cells x cells quadrilaterals.
inline std::shared_ptr<Mesh> sphere(int cells) {
  constexpr double pi = 3.14159265358979323846;
  auto mesh = std::make_shared<Mesh>();
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const double phi = 2 * pi * i / cells, theta = pi * (1.0 - static_cast<double>(j) / cells);
      Vertex v;
      v.normal = {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
      v.position = v.normal;
      v.tangent = {-std::sin(phi), std::cos(phi), 0};
      v.uv = {static_cast<double>(i) / cells, static_cast<double>(j) / cells};
      mesh->vertices.push_back(v);
    }
  }
  const auto at = [&](int i, int j) { return static_cast<unsigned>(j * (cells + 1) + i); };
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      mesh->triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh->triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

/// The square [-1, 1] x [-1, 1] in z = 0, facing +z, cells x cells quadrilaterals.
inline std::shared_ptr<Mesh> plane(int cells) {
  auto mesh = std::make_shared<Mesh>();
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      Vertex v;
      v.uv = {static_cast<double>(i) / cells, static_cast<double>(j) / cells};
      v.position = {2 * v.uv.x - 1, 2 * v.uv.y - 1, 0};
      mesh->vertices.push_back(v);
    }
  }
  const auto at = [&](int i, int j) { return static_cast<unsigned>(j * (cells + 1) + i); };
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      mesh->triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh->triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

inline SceneObject object(std::shared_ptr<const Mesh> mesh, const glm::dmat4& to_world = glm::dmat4(1)) {
  SceneObject result;
  result.mesh = std::move(mesh);
  result.to_world = to_world;
  result.colour = texture(32, 32, 3, 7);
  result.normals = normals(32, 32, 8);
  return result;
}

/// A scene of width x height pixels with one directional and one point light.
inline Scene scene(std::vector<SceneObject> objects, int width = 96, int height = 64) {
  Scene result;
  result.width = width;
  result.height = height;
  result.objects = std::move(objects);
  result.lights.push_back({true, glm::normalize(glm::dvec3(0.3, 0.4, 1)), 1});
  result.lights.push_back({false, {1, 2, 4}, 1});
  return result;
}

/// A plane behind a sphere behind which another sphere is hidden in part.
inline Scene crowded_scene(int width = 96, int height = 64) {
  return scene({object(plane(3), glm::scale(glm::translate(glm::dmat4(1), {0.0, 0.0, -1.5}), glm::dvec3(2))), object(sphere(10)),
                object(sphere(8), glm::translate(glm::dmat4(1), {0.6, 0.2, -0.5}))},
               width, height);
}

/// Interpolants n (no light), l (tangent space, per light), "turn" (angle), "flat" (flat angle); environment doubles l into e, illumination
/// is e . map / 2.
inline Design design() {
  Design d;
  const Format r = real();
  std::vector<std::vector<Wire>> in;
  for (const char* vector : {"N", "T", "B", "L"}) {
    in.emplace_back();
    for (const char* axis : {".x", ".y", ".z"}) in.back().push_back(d.vertex.input(std::string(vector) + axis, r));
  }
  const char* axes[3] = {"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i) d.vertex.output(std::string("n.") + axes[i], in[0][i]);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string name = std::string("l.") + axes[i];
    const std::vector<Wire>& row = in[i == 2 ? 0 : i + 1];
    Wire sum = d.vertex.mul(name + ".0", row[0], in[3][0], r);
    sum = d.vertex.add(name + ".01", sum, d.vertex.mul(name + ".1", row[1], in[3][1], r), r);
    d.vertex.output(name, d.vertex.add(name, sum, d.vertex.mul(name + ".2", row[2], in[3][2], r), r));
  }
  const Wire half = d.vertex.constant("half", 0.5, r);
  d.vertex.output("turn", d.vertex.mul("turn", in[0][0], half, r));
  d.vertex.output("flat", d.vertex.mul("flat", in[0][1], half, r));
  for (const char* name : {"n.x", "n.y", "n.z", "l.x", "l.y", "l.z"}) d.interpolants.push_back({name, InterpolantKind::linear});
  d.interpolants.push_back({"turn", InterpolantKind::angle});
  d.interpolants.push_back({"flat", InterpolantKind::flat_angle});

  const Format wide = sfixed(20, 14), texel = sfixed(10, 8);
  for (const char* axis : axes) {
    const std::string e = std::string("e.") + axis;
    const Wire l = d.environment.input(std::string("l.") + axis, wide);
    d.environment.output(e, d.environment.add(e, l, l, wide));
    d.map.channels.push_back({axis, texel, ChannelKind::linear});
  }
  Wire sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string axis = axes[i];
    const Wire product =
        d.illumination.mul("p." + axis, d.illumination.input("e." + axis, wide), d.illumination.input("map." + axis, texel), wide);
    sum = i == 0 ? product : d.illumination.add("s." + axis, sum, product, wide);
  }
  sum = d.illumination.shift("halved", sum, -1, wide);
  d.illumination.output("intensity", d.illumination.clamp("intensity", sum, 0, 1, wide));
  d.map.encode = [](const glm::dvec3& n, double* out) {
    for (int c = 0; c < 3; ++c) out[c] = n[c];
  };
  d.directions.push_back({DeliveredDirection::Of::light, DeliveredDirection::Frame::tangent, {"e.x", "e.y", "e.z"}});
  return d;
}

inline std::shared_ptr<const PipelineContext> context(const Scene& scene, const ContextOptions& options = {}) {
  std::vector<Design> designs;
  designs.push_back(design());
  return make_context(scene, std::move(designs), std::vector<int>(scene.objects.size(), 0), options);
}

std::shared_ptr<const PipelineContext> context(const Scene&& scene, const ContextOptions& options = {}) = delete;

inline std::shared_ptr<BlockPool> pool(const PipelineContext& context) {
  return std::make_shared<BlockPool>(context.planes.size(), context.separate_exact() ? context.planes.size() : 0);
}

/// Everything up to the rasterizer's blocks.
struct Geometry {
  std::vector<std::unique_ptr<FragmentBlock>> blocks;
  GeometryCounters vertex, setup, raster;
};

inline Geometry rasterize(const std::shared_ptr<const PipelineContext>& context, const RasterizerConfig& config = {},
                          const TriangleSetupConfig& setup_config = {}) {
  Geometry geometry;
  VertexProcessor vertices(context, {});
  TriangleSetup setup(context, setup_config);
  Rasterizer rasterizer(context, config, pool(*context),
                        [&](std::unique_ptr<FragmentBlock> block) { geometry.blocks.push_back(std::move(block)); });
  TriangleBlock block;
  while (vertices.next(block)) {
    setup.process(block);
    rasterizer.process(block);
  }
  rasterizer.finish();
  geometry.vertex = vertices.counters();
  geometry.setup = setup.counters();
  geometry.raster = rasterizer.counters();
  return geometry;
}

}  // namespace bump::samples
