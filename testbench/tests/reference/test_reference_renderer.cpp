#include <algorithm>
#include <catch2/catch.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "datapath/error.h"
#include "shapes.h"
#include "testbench/reference/coverage.h"
#include "testbench/reference/quality.h"
#include "testbench/reference/reference_renderer.h"
#include "testbench/reference/row_bands.h"
#include "units/projection.h"

using namespace bump;

namespace {

/// The ray through a pixel centre of a camera on the z axis that looks at the origin.
glm::dvec3 ray(const Scene& scene, int x, int y) {
  const double scale = std::tan(scene.camera.field_of_view * shapes::pi / 360);
  const double aspect = static_cast<double>(scene.width) / scene.height;
  return glm::normalize(glm::dvec3{(2 * (x + 0.5) / scene.width - 1) * scale * aspect, (1 - 2 * (y + 0.5) / scene.height) * scale, -1});
}

double blinn_phong(const Scene& scene, const glm::dvec3& position, const glm::dvec3& normal) {
  const Material& material = scene.objects[0].material;
  double intensity = material.ambient;
  for (const Light& light : scene.lights) {
    const glm::dvec3 to_light = light.directional ? light.vector : glm::normalize(light.vector - position);
    const glm::dvec3 half = glm::normalize(to_light + glm::normalize(scene.camera.eye - position));
    intensity += light.intensity * (material.diffuse * std::max(0.0, glm::dot(normal, to_light)) +
                                    material.specular * std::pow(std::max(0.0, glm::dot(normal, half)), material.shininess));
  }
  return std::clamp(intensity, 0.0, 1.0);
}

std::int64_t covered(const FrameBuffer& frame) {
  return std::count_if(frame.object.begin(), frame.object.end(), [](std::int32_t object) { return object >= 0; });
}

}  // namespace

TEST_CASE("a plane with a flat map is Blinn-Phong in closed form at every pixel") {
  const int cells = GENERATE(1, 3, 8);
  const bool directional = GENERATE(true, false);
  Scene scene = shapes::scene(shapes::plane(cells, 2));
  scene.width = 80;
  if (!directional) {
    scene.lights[0].directional = false;
    scene.lights[0].vector = {0.5, -0.3, 1.5};
  }
  const FrameBuffer frame = render_reference(scene, Filter::bilinear, ReferenceNormals::normal_map);
  double worst = 0;
  int wrong = 0;
  for (int y = 0; y < scene.height; ++y) {
    for (int x = 0; x < scene.width; ++x) {
      const glm::dvec3 direction = ray(scene, x, y);
      const glm::dvec3 hit = scene.camera.eye + direction * (-scene.camera.eye.z / direction.z);
      const bool inside = std::abs(hit.x) < 1 && std::abs(hit.y) < 1;
      const auto pixel = static_cast<std::size_t>(y * scene.width + x);
      if (inside != (frame.object[pixel] == 0)) ++wrong;
      if (inside) worst = std::max(worst, std::abs(frame.colour[pixel * 3 + 1] - blinn_phong(scene, hit, {0, 0, 1})));
    }
  }
  CHECK(wrong == 0);
  CHECK(covered(frame) > 1400);
  CHECK(worst < 1e-12);
}

TEST_CASE("a finely cut sphere converges to the analytic sphere") {
  double worst[2] = {0, 0};
  for (int k = 0; k < 2; ++k) {
    const Scene scene = shapes::scene(shapes::sphere(k == 0 ? 24 : 96));
    const FrameBuffer frame = render_reference(scene, Filter::bilinear, ReferenceNormals::normal_map);
    for (int y = 0; y < scene.height; ++y) {
      for (int x = 0; x < scene.width; ++x) {
        const glm::dvec3 direction = ray(scene, x, y);
        const double b = glm::dot(direction, scene.camera.eye), c = glm::dot(scene.camera.eye, scene.camera.eye) - 1;
        if (b * b - c < 0.05) continue;  // away from the silhouette, where facets show
        const glm::dvec3 hit = scene.camera.eye + direction * (-b - std::sqrt(b * b - c));
        const auto pixel = static_cast<std::size_t>(y * scene.width + x);
        REQUIRE(frame.object[pixel] == 0);
        worst[k] = std::max(worst[k], std::abs(frame.colour[pixel * 3] - blinn_phong(scene, hit, hit)));
      }
    }
  }
  CHECK(worst[0] < 0.04);
  CHECK(worst[1] < worst[0] / 8);  // second order in the size of a facet: 16 times for 4 times the rings
}

TEST_CASE("triangles that share edges leave no gaps and cover no pixel twice") {
  // The plane fills the frame: with 32 cells corners, with 64 edges fall onto pixel centres, as does the diagonal.
  const int cells = GENERATE(1, 5, 32, 64);
  const Scene scene = shapes::scene(shapes::plane(cells, 2 * 4 * std::tan(22.5 * shapes::pi / 180) * (1 + 1e-9)));
  const glm::dmat4 to_clip = world_to_clip(scene.camera, 64, 64, far_distance(scene));
  std::vector<int> owners(64 * 64, 0);
  const Mesh& mesh = *scene.objects[0].mesh;
  const auto clip = [&](unsigned vertex) { return to_clip * glm::dvec4{mesh.vertices[vertex].position, 1.0}; };
  for (const glm::uvec3& corner : mesh.triangles) {
    const ScreenTriangle triangle = make_screen_triangle({clip(corner.x), clip(corner.y), clip(corner.z)}, true);
    REQUIRE(triangle.drawable);
    for (int pixel = 0; pixel < 64 * 64; ++pixel) {
      if (triangle.contains(pixel_centre(pixel % 64, pixel / 64, 64, 64))) ++owners[static_cast<std::size_t>(pixel)];
    }
  }
  CHECK(std::count(owners.begin(), owners.end(), 1) == 64 * 64);
  const FrameBuffer frame = render_reference(scene, Filter::nearest, ReferenceNormals::normal_map);
  CHECK(covered(frame) == 64 * 64);
}

TEST_CASE("the picture does not change when object, light and camera move together") {
  Scene scene = shapes::scene(shapes::sphere(16));
  const auto heights = shapes::hills(64, 1.5);
  scene.objects[0].heights = heights;
  scene.objects[0].normals = shapes::normals_of(*heights);
  const ReferenceNormals which = GENERATE(ReferenceNormals::normal_map, ReferenceNormals::blinn);
  const FrameBuffer still = render_reference(scene, Filter::bilinear, which);
  const glm::dmat4 turn = glm::rotate(glm::dmat4{1}, 0.7, glm::normalize(glm::dvec3{1, 2, 3}));
  scene.objects[0].to_world = glm::translate(glm::dmat4{1}, {1, -2, 0.5}) * turn * glm::scale(glm::dmat4{1}, glm::dvec3{2.5});
  const auto move = [&](const glm::dvec3& v, double w) { return glm::dvec3{scene.objects[0].to_world * glm::dvec4{v, w}}; };
  scene.camera.eye = move(scene.camera.eye, 1);
  scene.camera.target = move(scene.camera.target, 1);
  scene.camera.up = move(scene.camera.up, 0);
  scene.camera.near *= 2.5;
  scene.lights[0].vector = glm::dvec3{turn * glm::dvec4{scene.lights[0].vector, 0}};
  const Quality quality = compare_frames(render_reference(scene, Filter::bilinear, which), still);
  CHECK(quality.excluded <= 2);
  CHECK(quality.psnr_db > 200);
}

TEST_CASE("a plane seen from behind is culled, and drawn when culling is off") {
  Scene scene = shapes::scene(shapes::plane(2, 2));
  scene.camera.eye = {0, 0, -4};
  CHECK(covered(render_reference(scene, Filter::nearest, ReferenceNormals::normal_map)) == 0);
  CHECK(covered(render_reference(scene, Filter::nearest, ReferenceNormals::normal_map, false)) > 1000);
}

TEST_CASE("a plane that reaches behind the camera is cut at the near plane") {
  Scene scene = shapes::scene(shapes::plane(1, 100));
  scene.camera.eye = {0, -1, 1};
  scene.camera.target = {0, 10, 0.9};
  scene.camera.up = {0, 0, 1};
  scene.camera.field_of_view = 90;
  const FrameBuffer frame = render_reference(scene, Filter::nearest, ReferenceNormals::normal_map);
  const auto object_at = [&](int x, int y) { return frame.object[static_cast<std::size_t>(y * scene.width + x)]; };
  CHECK(object_at(32, 63) == 0);  // below the horizon: ground, although two corners of it are behind the eye
  CHECK(object_at(32, 40) == 0);
  CHECK(object_at(32, 10) == -1);  // above: sky
  CHECK(std::all_of(frame.depth.begin(), frame.depth.end(), [](double depth) { return depth >= 0 && depth <= 1; }));
}

TEST_CASE("the nearer of two objects is seen whatever their order") {
  Scene scene = shapes::scene(shapes::plane(1, 2));
  scene.objects.push_back(scene.objects[0]);
  scene.objects[1].to_world = glm::translate(glm::dmat4{1}, {0, 0, 0.5});
  const FrameBuffer frame = render_reference(scene, Filter::nearest, ReferenceNormals::normal_map);
  CHECK(frame.object[32 * 64 + 32] == 1);
  std::swap(scene.objects[0], scene.objects[1]);
  CHECK(render_reference(scene, Filter::nearest, ReferenceNormals::normal_map).object[32 * 64 + 32] == 0);
}

TEST_CASE("on an evenly mapped plane Blinn's normals are the square-patch normals but for the order of filtering") {
  // Normals are filtered after they are made, slopes before: at texel centres they agree, between them almost.
  const bool mirrored = GENERATE(false, true);
  Scene scene = shapes::scene(shapes::plane(2, 2, mirrored), 128);
  const auto heights = shapes::hills(128, 1.5);
  scene.objects[0].heights = heights;
  scene.objects[0].normals = shapes::normals_of(*heights);
  const FrameBuffer map = render_reference(scene, Filter::bilinear, ReferenceNormals::normal_map);
  const FrameBuffer blinn = render_reference(scene, Filter::bilinear, ReferenceNormals::blinn);
  const Quality quality = compare_frames(map, blinn);
  CHECK(quality.excluded == 0);
  CHECK(quality.psnr_db > 95);  // about 105 dB

  scene.objects[0].normals = shapes::flat_normals();
  const FrameBuffer flat = render_reference(scene, Filter::bilinear, ReferenceNormals::normal_map);
  CHECK(compare_frames(flat, blinn).psnr_db < 35);  // the bumps are there to be seen
}

TEST_CASE("without height maps there is no reference by Blinn") {
  const Scene scene = shapes::scene(shapes::plane(1, 2));
  CHECK_FALSE(has_blinn_reference(scene));
  CHECK_THROWS_AS(render_reference(scene, Filter::bilinear, ReferenceNormals::blinn), Error);
}

TEST_CASE("a trilinear reference of a distant plane shows the mean of its texture") {
  Scene scene = shapes::scene(shapes::plane(1, 2), 8);
  auto checks = shapes::texture(256, 256, 3, [](int x, int y, double* texel) { texel[0] = texel[1] = texel[2] = (x + y) % 2; });
  build_mip_levels(*checks);
  scene.objects[0].colour = checks;
  scene.objects[0].material = {1, 0, 0, 1};  // the texel itself
  const FrameBuffer frame = render_reference(scene, Filter::trilinear, ReferenceNormals::normal_map);
  int seen = 0;
  for (std::size_t pixel = 0; pixel < frame.object.size(); ++pixel) {
    if (frame.object[pixel] < 0) continue;
    ++seen;
    CHECK(frame.colour[pixel * 3] == Approx(0.5).margin(1e-12));
  }
  CHECK(seen > 10);
}

TEST_CASE("the reference is exact to the last bit from run to run") {
  Scene scene = shapes::scene(shapes::sphere(12));
  const FrameBuffer first = render_reference(scene, Filter::bilinear, ReferenceNormals::normal_map);
  CHECK(first.colour == render_reference(scene, Filter::bilinear, ReferenceNormals::normal_map).colour);
}

TEST_CASE("rows drawn by several threads, both references at once, are those drawn one after another") {
  Scene scene = shapes::scene(shapes::sphere(12), 96);
  scene.background = {0.1, 0.2, 0.3};
  const auto heights = shapes::hills(64, 1.5);
  scene.objects[0].heights = heights;
  scene.objects[0].normals = shapes::normals_of(*heights);
  const Filter filter = GENERATE(Filter::nearest, Filter::bilinear, Filter::trilinear);
  ReferenceRenderer renderer(scene, filter, true, true);
  for_row_bands(scene.height, 5, 3, [&](int first_row, int end_row) { renderer.draw_rows(first_row, end_row); });
  const References both = renderer.release();
  REQUIRE(both.blinn);
  for (const ReferenceNormals which : {ReferenceNormals::normal_map, ReferenceNormals::blinn}) {
    const FrameBuffer alone = render_reference(scene, filter, which);
    const FrameBuffer& together = which == ReferenceNormals::blinn ? *both.blinn : both.normal_map;
    CHECK(together.colour == alone.colour);
    CHECK(together.object == alone.object);
    CHECK(together.depth == alone.depth);
  }
  CHECK(both.normal_map.colour != both.blinn->colour);
}

TEST_CASE("coverage is what a look at every pixel and every triangle gives") {
  Scene scene = shapes::scene(GENERATE(shapes::sphere(9), shapes::plane(3, 2)), 70);
  scene.height = 53;
  scene.camera.eye = {GENERATE(0.0, 0.7), 0.4, 2.1};
  const bool cull = GENERATE(true, false);
  const glm::dmat4 to_clip = world_to_clip(scene.camera, scene.width, scene.height, far_distance(scene)) * scene.objects[0].to_world;
  const Coverage coverage = cover(scene, {to_clip}, cull);
  const Mesh& mesh = *scene.objects[0].mesh;
  Coverage expected = coverage;
  std::fill(expected.triangle.begin(), expected.triangle.end(), -1);
  std::fill(expected.depth.begin(), expected.depth.end(), 1.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<glm::dvec4, 3> clip{};
    for (int corner = 0; corner < 3; ++corner)
      clip[static_cast<std::size_t>(corner)] = to_clip * glm::dvec4{mesh.vertices[mesh.triangles[t][corner]].position, 1.0};
    const ScreenTriangle triangle = make_screen_triangle(clip, cull);
    for (int pixel = 0; triangle.drawable && pixel < scene.width * scene.height; ++pixel) {
      const glm::dvec3 p = pixel_centre(pixel % scene.width, pixel / scene.width, scene.width, scene.height);
      if (!triangle.contains(p)) continue;
      const glm::dvec3 weight = triangle.weights(p);
      const glm::dvec4 at = clip[0] * weight.x + clip[1] * weight.y + clip[2] * weight.z;
      const double depth = (at.z / at.w + 1) * 0.5;
      if (at.z < -at.w || at.z > at.w || !(depth < expected.depth[static_cast<std::size_t>(pixel)])) continue;
      expected.depth[static_cast<std::size_t>(pixel)] = depth;
      expected.triangle[static_cast<std::size_t>(pixel)] = static_cast<std::int32_t>(t);
    }
  }
  CHECK(coverage.triangle == expected.triangle);
  CHECK(coverage.depth == expected.depth);
}
