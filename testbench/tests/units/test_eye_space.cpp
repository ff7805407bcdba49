// Shading along the camera's axes: values against the object's axes turned by hand, operators against the netlist that computes the same.

#include <catch2/catch.hpp>
#include <map>

#include "datapath/inventory.h"
#include "samples.h"
#include "units/angular_error.h"
#include "units/projection.h"

namespace bump {
namespace {

glm::dmat4 tilted() {
  return glm::rotate(glm::scale(glm::translate(glm::dmat4(1), {0.3, -0.2, 0.1}), glm::dvec3(0.7)), 1.1,
                     glm::normalize(glm::dvec3(1, 2, 3)));
}

Scene tilted_scene() {
  Scene scene = samples::scene({samples::object(samples::sphere(6), tilted())});
  scene.camera.eye = {1.5, -2, 2.5};
  scene.camera.up = {0.2, 1, 0.3};
  return scene;
}

ObjectSpace space_of(const Scene& scene, ShadingSpace shading) {
  return make_object_space(scene, scene.objects[0], world_to_clip(scene.camera, scene.width, scene.height, far_distance(scene)), shading);
}

std::shared_ptr<const PipelineContext> eye_context(const Scene& scene) {
  ContextOptions options;
  options.shading = ShadingSpace::eye;
  return samples::context(scene, options);
}

TEST_CASE("eye space has the eye at its origin, x to the right, y up and z towards the viewer") {
  const Scene scene = tilted_scene();
  const ObjectSpace space = space_of(scene, ShadingSpace::eye);
  const glm::dmat4 to_object = glm::inverse(scene.objects[0].to_world);
  const auto seen = [&](const glm::dvec3& world) { return space.position(glm::dvec3(to_object * glm::dvec4(world, 1))); };
  const glm::dvec3 forwards = glm::normalize(scene.camera.target - scene.camera.eye);
  const glm::dvec3 right = glm::normalize(glm::cross(forwards, scene.camera.up));
  CHECK(glm::length(space.eye) == 0);
  CHECK(glm::length(seen(scene.camera.eye)) < 1e-12);
  CHECK(glm::length(seen(scene.camera.eye + forwards) - glm::dvec3(0, 0, -1)) < 1e-12);
  CHECK(glm::length(seen(scene.camera.eye + right) - glm::dvec3(1, 0, 0)) < 1e-12);
  CHECK(glm::length(seen(scene.camera.eye + glm::cross(right, forwards)) - glm::dvec3(0, 1, 0)) < 1e-12);
}

TEST_CASE("object space leaves every bit of a vector as it is, and eye space keeps lengths and angles") {
  const Scene scene = tilted_scene();
  const ObjectSpace own = space_of(scene, ShadingSpace::object), eye = space_of(scene, ShadingSpace::eye);
  CHECK(std::signbit(own.direction({-0.0, 1, 0}).x));
  CHECK(std::signbit(own.position({-0.0, 1, 0}).x));
  std::mt19937 random(7);
  const auto coordinate = [&] { return static_cast<double>(random() % 2001) / 1000.0 - 1; };
  for (int i = 0; i < 500; ++i) {
    const glm::dvec3 a(coordinate(), coordinate(), coordinate()), b(coordinate(), coordinate(), coordinate());
    REQUIRE(own.direction(a) == a);
    REQUIRE(glm::dot(eye.direction(a), eye.direction(b)) == Approx(glm::dot(a, b)).margin(1e-12));
    // Lights and eye are seen in the same directions; lengths to them are the world's, 0.7 times the object's.
    REQUIRE(glm::length(eye.eye_vector(a) - 0.7 * eye.direction(own.eye_vector(a))) < 1e-12);
    REQUIRE(glm::length(eye.light_vector(0, a) - eye.direction(own.light_vector(0, a))) < 1e-12);
    REQUIRE(glm::length(eye.light_vector(1, a) - 0.7 * eye.direction(own.light_vector(1, a))) < 1e-12);
  }
}

TEST_CASE("the vertex program reads all its vectors along the camera's axes") {
  const Scene scene = tilted_scene();
  const auto context = eye_context(scene);
  const ObjectSpace space = space_of(scene, ShadingSpace::eye);
  VertexProcessor unit(context, {});
  const Mesh& mesh = *scene.objects[0].mesh;
  const auto value = [&](const double* corner, const std::string& plane) {
    for (std::size_t a = 0; a < context->attributes.size(); ++a)
      if (context->planes.names()[static_cast<std::size_t>(context->attributes[a].plane)] == plane) return corner[2 + a];
    return std::nan("");
  };
  TriangleBlock block;
  while (unit.next(block)) {
    for (int i = 0; i < 3 * block.triangles; ++i) {
      const Vertex& v = mesh.vertices[mesh.triangles[block.source[static_cast<std::size_t>(i / 3)]][i % 3]];
      const double* corner = &block.attributes[static_cast<std::size_t>(i) * static_cast<std::size_t>(block.stride)];
      const glm::dvec3 normal = space.direction(v.normal), tangent = space.direction(v.tangent);
      REQUIRE(value(corner, "n.x") == normal.x);
      REQUIRE(value(corner, "n.z") == normal.z);
      REQUIRE(value(corner, "l.x") == Approx(glm::dot(tangent, space.light_vector(0, v.position))).margin(1e-12));
      REQUIRE(value(corner, "l.x#1") == Approx(glm::dot(tangent, space.light_vector(1, v.position))).margin(1e-12));
    }
  }
}

TEST_CASE("eye space costs a rotation for each vector of the frame and the position where V or a point light needs it") {
  const auto cost = [](const TransformNeeds& needs) {
    const Inventory counted = count(vertex_transform(needs));
    return std::pair<std::int64_t, std::int64_t>(counted.multipliers, counted.adders);
  };
  using Cost = std::pair<std::int64_t, std::int64_t>;
  TransformNeeds needs;
  needs.frame = "NT";
  needs.towards_eye = true;
  needs.point_lights = 2;
  CHECK(cost(needs) == Cost(16, 12 + 3 * 3));  // in object space the frame is free
  needs.space = ShadingSpace::eye;
  CHECK(cost(needs) == Cost(16 + 2 * 9 + 9, 12 + 2 * 6 + 9 + 2 * 3));  // V is the negated position
  needs.frame = "NTB";
  needs.point_lights = 0;
  CHECK(cost(needs) == Cost(16 + 3 * 9 + 9, 12 + 3 * 6 + 9));
  needs.towards_eye = false;  // directional lights come in camera axes
  CHECK(cost(needs) == Cost(16 + 3 * 9, 12 + 3 * 6));
  needs.frame = "";
  CHECK(cost(needs) == Cost(16, 12));
}

TEST_CASE("vertices that are shaded in eye space take the cycles of these operations") {
  const Scene scene = samples::crowded_scene();
  const VertexWork own = vertex_work(*samples::context(scene)), eye = vertex_work(*eye_context(scene));
  CHECK(eye.transform - own.transform == 3 * 15 + 18);  // the sample design reads N, T, B, and L of a point light
  CHECK(eye.once == own.once);
  CHECK(eye.per_light == own.per_light);
}

TEST_CASE("the recorded transform computes what the vertex processor hands to the program") {
  const Scene scene = tilted_scene();
  const ObjectSpace space = space_of(scene, ShadingSpace::eye);
  TransformNeeds needs;
  needs.frame = "NTB";
  needs.towards_eye = true;
  needs.point_lights = 1;
  needs.space = ShadingSpace::eye;
  const Netlist netlist = vertex_transform(needs);
  const Vertex v = scene.objects[0].mesh->vertices[10];
  const glm::dvec3 binormal = v.handedness * glm::cross(v.normal, v.tangent);
  const auto input = [&](const std::string& name) {
    const auto axis = [](char letter) { return letter == 'w' ? 3 : letter - 'x'; };
    const int last = axis(name.back());
    if (name.rfind("M.clip.", 0) == 0) return space.to_clip[last][axis(name[7])];
    if (name.rfind("M.eye.", 0) == 0) return space.to_shading[last][axis(name[6])];
    if (name.rfind("R.", 0) == 0) return space.rotation[last][axis(name[2])];
    if (name.rfind("from.L", 0) == 0) return space.lights[1].vector[last];
    if (name[0] == 'P') return last == 3 ? 1.0 : v.position[last];
    return (name[0] == 'N' ? v.normal : name[0] == 'T' ? v.tangent : binormal)[last];
  };
  std::vector<Lanes> inputs(netlist.inputs().size()), outputs(netlist.outputs().size());
  std::vector<const double*> in;
  std::vector<double*> out;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    inputs[i][0] = input(netlist.inputs()[i].name);
    in.push_back(inputs[i].data());
  }
  for (Lanes& lanes : outputs) out.push_back(lanes.data());
  make_evaluator(netlist, Arithmetic::real)->evaluate(in.data(), 1, out.data());
  std::map<std::string, double> result;
  for (std::size_t i = 0; i < outputs.size(); ++i) result[netlist.outputs()[i].name] = outputs[i][0];
  const auto vector = [&](const std::string& name) {
    return glm::dvec3(result.at(name + ".x"), result.at(name + ".y"), result.at(name + ".z"));
  };
  CHECK(glm::length(vector("clip") - glm::dvec3(space.to_clip * glm::dvec4(v.position, 1))) < 1e-12);
  CHECK(glm::length(vector("N_eye") - space.direction(v.normal)) < 1e-12);
  CHECK(glm::length(vector("T_eye") - space.direction(v.tangent)) < 1e-12);
  CHECK(glm::length(vector("B_eye") - space.direction(binormal)) < 1e-12);
  CHECK(glm::length(vector("V") - space.eye_vector(v.position)) < 1e-12);
  CHECK(glm::length(vector("L") - space.light_vector(1, v.position)) < 1e-12);
}

}  // namespace
}  // namespace bump
