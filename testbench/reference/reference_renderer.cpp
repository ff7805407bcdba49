#include "testbench/reference/reference_renderer.h"

#include <algorithm>
#include <cmath>

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

glm::dvec3 shade(const ObjectContext& context, const TriangleContext& triangle, const glm::dvec3& p, int width, int height, Filter filter,
                 ReferenceNormals which) {
  const glm::dvec3 weight = triangle.screen.weights(p);
  const Vertex &a = *triangle.a, &b = *triangle.b, &c = *triangle.c;
  const SceneObject& object = *context.object;

  SurfacePoint point;
  point.normal = a.normal * weight.x + b.normal * weight.y + c.normal * weight.z;
  point.tangent = a.tangent * weight.x + b.tangent * weight.y + c.tangent * weight.z;
  point.handedness = a.handedness * weight.x + b.handedness * weight.y + c.handedness * weight.z;
  point.uv = a.uv * weight.x + b.uv * weight.y + c.uv * weight.z;
  if (filter == Filter::trilinear) point.footprint = exact_footprint(triangle, p, point.uv, width, height);

  const glm::dvec3 normal = which == ReferenceNormals::normal_map
                                ? normal_from_map(object, point, filter)
                                : normal_from_heights(object, context.texel_size, triangle.derivatives, point, filter);
  const glm::dvec3 position = a.position * weight.x + b.position * weight.y + c.position * weight.z;
  const glm::dvec3 to_eye = glm::normalize(context.eye - position);

  double intensity = object.material.ambient;
  for (const Light& light : context.lights) {
    const glm::dvec3 to_light = light.directional ? light.vector : glm::normalize(light.vector - position);
    const glm::dvec3 sum = to_light + to_eye;
    const double length = glm::length(sum);
    const double diffuse = std::max(0.0, glm::dot(normal, to_light));
    // Light from straight behind the surface point has no half vector, and no highlight.
    const double half = length > 0 ? std::max(0.0, glm::dot(normal, sum) / length) : 0.0;
    intensity +=
        light.intensity * (object.material.diffuse * diffuse + object.material.specular * std::pow(half, object.material.shininess));
  }
  double texel[3] = {1, 1, 1};
  if (object.colour)
    sample(*object.colour, filter, point.uv.x, point.uv.y, reference_level(*object.colour, filter, point.footprint), texel);
  return glm::clamp(glm::dvec3{texel[0], texel[1], texel[2]} * intensity, 0.0, 1.0);
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

FrameBuffer render_reference(const Scene& scene, Filter filter, ReferenceNormals which, bool cull_back_faces) {
  if (which == ReferenceNormals::blinn && !has_blinn_reference(scene)) {
    throw Error({"scene \"" + scene.name + "\" has no reference by Blinn's perturbation",
                 {},
                 "it needs the height map of every bumped object; a normal map alone does not say the heights",
                 "give the objects height maps, or compare with the normal-map reference"});
  }
  const glm::dmat4 to_clip = world_to_clip(scene.camera, scene.width, scene.height, far_distance(scene));
  std::vector<ObjectContext> contexts;
  std::vector<glm::dmat4> matrices;
  for (const SceneObject& object : scene.objects) {
    contexts.push_back(make_context(scene, object, to_clip));
    matrices.push_back(contexts.back().to_clip);
  }
  Coverage coverage = cover(scene, matrices, cull_back_faces);

  FrameBuffer frame;
  frame.width = scene.width;
  frame.height = scene.height;
  frame.colour.resize(coverage.object.size() * 3);
  std::int32_t current_object = -1, current_triangle = -1;
  TriangleContext triangle;
  for (int y = 0; y < scene.height; ++y) {
    for (int x = 0; x < scene.width; ++x) {
      const std::size_t pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(scene.width) + static_cast<std::size_t>(x);
      glm::dvec3 colour = scene.background;
      if (coverage.object[pixel] >= 0) {
        const ObjectContext& context = contexts[static_cast<std::size_t>(coverage.object[pixel])];
        if (coverage.object[pixel] != current_object || coverage.triangle[pixel] != current_triangle) {
          current_object = coverage.object[pixel];
          current_triangle = coverage.triangle[pixel];
          triangle = make_triangle(context, current_triangle);
        }
        colour = shade(context, triangle, pixel_centre(x, y, scene.width, scene.height), scene.width, scene.height, filter, which);
      }
      frame.colour[pixel * 3] = colour.x;
      frame.colour[pixel * 3 + 1] = colour.y;
      frame.colour[pixel * 3 + 2] = colour.z;
    }
  }
  frame.object = std::move(coverage.object);
  frame.depth = std::move(coverage.depth);
  return frame;
}

}  // namespace bump
