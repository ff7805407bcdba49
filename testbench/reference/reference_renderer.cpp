#include "testbench/reference/reference_renderer.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>
#include <vector>

#include "datapath/error.h"
#include "testbench/reference/coverage.h"
#include "testbench/reference/perturbed_normal.h"
#include "units/projection.h"

namespace bump {

namespace {

/// What is constant over an object: lights and eye brought into its space.
struct ObjectContext {
  const SceneObject* object = nullptr;
  glm::dmat4 to_clip{1};
  glm::dvec3 eye{0};
  std::vector<Light> lights;
  double texel_size = 0;  ///< of the height map, perturbed_normal.h
};

ObjectContext make_context(const Scene& scene, const SceneObject& object, const glm::dmat4& to_clip) {
  ObjectContext context;
  context.object = &object;
  context.to_clip = to_clip * object.to_world;
  const glm::dmat4 to_object = glm::inverse(object.to_world);
  context.eye = glm::dvec3{to_object * glm::dvec4{scene.camera.eye, 1.0}};
  for (Light light : scene.lights) {
    const glm::dvec3 moved{to_object * glm::dvec4{light.vector, light.directional ? 0.0 : 1.0}};
    light.vector = light.directional ? glm::normalize(moved) : moved;
    context.lights.push_back(light);
  }
  context.texel_size = mean_texel_size(object);
  return context;
}

/// What is constant over a triangle; kept from pixel to pixel, as neighbours mostly see the same one.
struct TriangleContext {
  const Vertex *a = nullptr, *b = nullptr, *c = nullptr;
  ScreenTriangle screen;
  PositionDerivatives derivatives;
};

TriangleContext make_triangle(const ObjectContext& context, std::int32_t index) {
  const Mesh& mesh = *context.object->mesh;
  const glm::uvec3& corner = mesh.triangles[static_cast<std::size_t>(index)];
  TriangleContext triangle;
  triangle.a = &mesh.vertices[corner.x];
  triangle.b = &mesh.vertices[corner.y];
  triangle.c = &mesh.vertices[corner.z];
  const auto clip = [&](const Vertex& vertex) { return context.to_clip * glm::dvec4{vertex.position, 1.0}; };
  triangle.screen = make_screen_triangle({clip(*triangle.a), clip(*triangle.b), clip(*triangle.c)}, false);
  triangle.derivatives = position_derivatives(*triangle.a, *triangle.b, *triangle.c);
  return triangle;
}

/// The exact derivatives of (u, v) = (U, V) / W, where U, V and W are affine over the screen.
PixelFootprint exact_footprint(const TriangleContext& triangle, const glm::dvec3& p, const glm::dvec2& uv, int width, int height) {
  const auto& edges = triangle.screen.edges;
  const auto affine = [&](double a, double b, double c) { return edges[0] * a + edges[1] * b + edges[2] * c; };
  const glm::dvec3 w = affine(1, 1, 1);
  const glm::dvec3 u = affine(triangle.a->uv.x, triangle.b->uv.x, triangle.c->uv.x);
  const glm::dvec3 v = affine(triangle.a->uv.y, triangle.b->uv.y, triangle.c->uv.y);
  const double at = glm::dot(w, p);
  const double right = 2.0 / width / at, down = -2.0 / height / at;  // one pixel in normalised device coordinates, over W
  return {glm::dvec2{u.x - uv.x * w.x, v.x - uv.y * w.x} * right, glm::dvec2{u.y - uv.x * w.y, v.y - uv.y * w.y} * down};
}

/// What shading a pixel needs whichever way its normal comes about.
struct ShadingPoint {
  SurfacePoint surface;
  glm::dvec3 position{0}, to_eye{0};
  double texel[3] = {1, 1, 1};
};

ShadingPoint make_point(const ObjectContext& context, const TriangleContext& triangle, const glm::dvec3& p, const Scene& scene,
                        Filter filter) {
  const glm::dvec3 weight = triangle.screen.weights(p);
  const Vertex &a = *triangle.a, &b = *triangle.b, &c = *triangle.c;
  ShadingPoint point;
  SurfacePoint& surface = point.surface;
  surface.normal = a.normal * weight.x + b.normal * weight.y + c.normal * weight.z;
  surface.tangent = a.tangent * weight.x + b.tangent * weight.y + c.tangent * weight.z;
  surface.handedness = a.handedness * weight.x + b.handedness * weight.y + c.handedness * weight.z;
  surface.uv = a.uv * weight.x + b.uv * weight.y + c.uv * weight.z;
  if (filter == Filter::trilinear) surface.footprint = exact_footprint(triangle, p, surface.uv, scene.width, scene.height);
  point.position = a.position * weight.x + b.position * weight.y + c.position * weight.z;
  point.to_eye = glm::normalize(context.eye - point.position);
  if (const Texture* colour = context.object->colour.get())
    sample(*colour, filter, surface.uv.x, surface.uv.y, reference_level(*colour, filter, surface.footprint), point.texel);
  return point;
}

glm::dvec3 shade(const ObjectContext& context, const ShadingPoint& point, const glm::dvec3& normal) {
  const Material& material = context.object->material;
  double intensity = material.ambient;
  for (const Light& light : context.lights) {
    const glm::dvec3 to_light = light.directional ? light.vector : glm::normalize(light.vector - point.position);
    const glm::dvec3 sum = to_light + point.to_eye;
    const double length = glm::length(sum);
    const double diffuse = std::max(0.0, glm::dot(normal, to_light));
    // Light from straight behind the surface point has no half vector, and no highlight.
    const double half = length > 0 ? std::max(0.0, glm::dot(normal, sum) / length) : 0.0;
    intensity += light.intensity * (material.diffuse * diffuse + material.specular * std::pow(half, material.shininess));
  }
  return glm::clamp(glm::dvec3{point.texel[0], point.texel[1], point.texel[2]} * intensity, 0.0, 1.0);
}

void put(FrameBuffer& frame, std::size_t pixel, const glm::dvec3& colour) {
  for (int c = 0; c < 3; ++c) frame.colour[pixel * 3 + static_cast<std::size_t>(c)] = colour[c];
}

}  // namespace

bool has_blinn_reference(const Scene& scene) {
  bool heights = false;
  for (const SceneObject& object : scene.objects) {
    if (object.normals && !object.heights) return false;
    heights = heights || object.heights;
  }
  return heights;
}

/// Everything that does not change from row to row, and the pictures themselves.
struct ReferenceRenderer::State {
  const Scene& scene;
  const Filter filter;
  const bool cull_back_faces;
  const std::function<void()> watch;
  std::vector<ObjectContext> contexts;
  std::once_flag is_covered;
  Coverage coverage;
  FrameBuffer normal_map;
  std::optional<FrameBuffer> blinn;

  void cover_scene() {
    std::vector<glm::dmat4> matrices;
    for (const ObjectContext& context : contexts) matrices.push_back(context.to_clip);
    coverage = cover(scene, matrices, cull_back_faces, watch);
    const auto begin = [&](FrameBuffer& frame) {
      frame.width = scene.width;
      frame.height = scene.height;
      frame.colour.resize(coverage.object.size() * 3);
    };
    begin(normal_map);
    if (blinn) begin(*blinn);
  }
};

ReferenceRenderer::ReferenceRenderer(const Scene& scene, Filter filter, bool with_blinn, bool cull_back_faces, std::function<void()> watch)
    : state_(new State{scene, filter, cull_back_faces, std::move(watch), {}, {}, {}, {}, {}}) {
  if (with_blinn && !has_blinn_reference(scene)) {
    throw Error({"scene \"" + scene.name + "\" has no reference by Blinn's perturbation",
                 {},
                 "it needs the height map of every bumped object; a normal map alone does not say the heights",
                 "give the objects height maps, or compare with the normal-map reference"});
  }
  if (with_blinn) state_->blinn.emplace();
  const glm::dmat4 to_clip = world_to_clip(scene.camera, scene.width, scene.height, far_distance(scene));
  for (const SceneObject& object : scene.objects) state_->contexts.push_back(make_context(scene, object, to_clip));
}

ReferenceRenderer::~ReferenceRenderer() = default;

void ReferenceRenderer::draw_rows(int first_row, int end_row) {
  State& state = *state_;
  std::call_once(state.is_covered, [&state] { state.cover_scene(); });
  const Scene& scene = state.scene;
  const Coverage& coverage = state.coverage;
  std::int32_t current_object = -1, current_triangle = -1;
  TriangleContext triangle;
  for (int y = first_row; y < end_row; ++y) {
    for (int x = 0; x < scene.width; ++x) {
      const std::size_t pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(scene.width) + static_cast<std::size_t>(x);
      const std::int32_t index = coverage.object[pixel];
      if (index < 0) {
        put(state.normal_map, pixel, scene.background);
        if (state.blinn) put(*state.blinn, pixel, scene.background);
        continue;
      }
      const ObjectContext& context = state.contexts[static_cast<std::size_t>(index)];
      if (index != current_object || coverage.triangle[pixel] != current_triangle) {
        current_object = index;
        current_triangle = coverage.triangle[pixel];
        triangle = make_triangle(context, current_triangle);
      }
      const ShadingPoint point = make_point(context, triangle, pixel_centre(x, y, scene.width, scene.height), scene, state.filter);
      put(state.normal_map, pixel, shade(context, point, normal_from_map(*context.object, point.surface, state.filter)));
      if (!state.blinn) continue;
      put(*state.blinn, pixel,
          shade(context, point,
                normal_from_heights(*context.object, context.texel_size, triangle.derivatives, point.surface, state.filter)));
    }
  }
}

References ReferenceRenderer::release() {
  State& state = *state_;
  std::call_once(state.is_covered, [&state] { state.cover_scene(); });  // a picture without rows
  References references;
  if (state.blinn) {
    state.blinn->object = state.coverage.object;
    state.blinn->depth = state.coverage.depth;
    references.blinn = std::move(state.blinn);
  }
  references.normal_map = std::move(state.normal_map);
  references.normal_map.object = std::move(state.coverage.object);
  references.normal_map.depth = std::move(state.coverage.depth);
  state.coverage = {};
  return references;
}

FrameBuffer render_reference(const Scene& scene, Filter filter, ReferenceNormals which, bool cull_back_faces) {
  ReferenceRenderer renderer(scene, filter, which == ReferenceNormals::blinn, cull_back_faces);
  renderer.draw_rows(0, scene.height);
  References references = renderer.release();
  return which == ReferenceNormals::blinn ? std::move(*references.blinn) : std::move(references.normal_map);
}

}  // namespace bump
