#include <cmath>
#include <sstream>

#include "scene_bench.h"
#include "testbench/scene/obj_file.h"
#include "testbench/scene/polygon.h"
#include "testbench/scene/shapes.h"

using namespace bump;
using namespace bump::test;

namespace {

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

Mesh build(const std::string& text, std::vector<std::string>& warnings) {
  return build_obj(text, "m.obj", false, warnings).parts.front().mesh;
}

ErrorText error_in(const std::string& text) {
  return error_of([&] {
    std::vector<std::string> warnings;
    build(text, warnings);
  });
}

double area(const std::vector<glm::dvec3>& outline, const std::vector<std::array<int, 3>>& triangles) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const glm::dvec3 p = outline[static_cast<std::size_t>(a)], q = outline[static_cast<std::size_t>(b)],
                     r = outline[static_cast<std::size_t>(c)];
    sum += 0.5 * glm::cross(q - p, r - p).z;
  }
  return sum;
}

}  // namespace

TEST_CASE("a square with everything given is read as it stands") {
  std::vector<std::string> warnings;
  const Mesh mesh = build(square + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 2\nf 1/1/1 2/2/1 3/3/1 4/4/1\n", warnings);
  check_mesh(mesh);
  CHECK(warnings.empty());
  CHECK(mesh.vertices.size() == 4);
  CHECK(mesh.triangles.size() == 2);
  for (const auto& vertex : mesh.vertices) {
    CHECK(vertex.normal == glm::dvec3(0, 0, 1));
    CHECK(glm::distance(vertex.tangent, glm::dvec3(1, 0, 0)) < 1e-12);
    CHECK(vertex.handedness == 1);
  }
}

TEST_CASE("comments, carriage returns, continued lines, negative indices and unknown keys are understood") {
  std::vector<std::string> warnings;
  const Mesh mesh =
      build("\xef\xbb\xbf# comment\r\no thing\r\nv 0 0 0 # corner\r\nv +1 0 0\r\n v\t1 1.0e0 \\\r\n 0\r\ns off\r\nfoo bar\r\nf -3 -2 -1",
            warnings);
  CHECK(mesh.vertices.size() == 3);
  CHECK(mesh.vertices[2].position == glm::dvec3(1, 1, 0));
}

TEST_CASE("a face that refers to what is not there is an error in its line") {
  CHECK(to_string(error_in(square + "f 1 2 3\nf 1 2 5\n").where) == "m.obj:6");
  CHECK(error_in(square + "f 1 2 5\n").what == "a face refers to vertex 5");
  CHECK(error_in(square + "f 1 2 0\n").why == "indices count from 1");
  CHECK(error_in(square + "f 1 2 -5\n").why == "only 4 stand before it");
  CHECK(error_in(square + "f 1/1 2/1 3/1\n").what == "a face refers to texture coordinate 1");
  CHECK(error_in(square + "f 1//1 2//1 3//1\n").what == "a face refers to normal 1");
  CHECK(error_in(square + "f 1 2 99999999999\n").where.line == 5);
  CHECK(error_in(square + "f 1 2 99999999999999999999999\n").where.line == 5);
}

TEST_CASE("damaged lines are errors with their number") {
  CHECK(error_in("v 0 0\n").what == "'v' has 2 numbers");
  CHECK(error_in("v 0 0 0\nv 0 x 0\n").where.line == 2);
  CHECK(error_in("v 0 0 1.5.2\n").what == "'1.5.2' is not a number");
  CHECK(error_in(square + "f 1 2\n").what == "a face has 2 corners");
  CHECK(error_in(square + "f 1 2 b\n").what == "'b' is not a face corner");
  CHECK(error_in(square + "f 1 2 3/1/1/1\n").what == "'3/1/1/1' is not a face corner");
  CHECK(error_in(square + "f 1 2 /1\n").what == "'/1' is not a face corner");
  CHECK(error_in(square + "vt 1\nf 1 2 3\n").where.line == 5);
  CHECK(error_in(square + "vn 1 0\nf 1 2 3\n").where.line == 5);
}

TEST_CASE("coordinates that are not finite are errors with their line") {
  const auto number = GENERATE(as<std::string>(), "nan", "inf", "-inf");
  const ErrorText error = error_in("v 0 0 0\nv 1 " + number + " 0\n");
  CHECK(error.what == "'" + number + "' is not a finite coordinate");
  CHECK(to_string(error.where) == "m.obj:2");
}

TEST_CASE("coordinates out of range are errors with the range, and too small ones are zero") {
  const auto number = GENERATE(as<std::string>(), "1e999", "-1e31", "1e308", "-1E+308", "1e31");
  const ErrorText error = error_in("v 0 0 0\nv 1 " + number + " 0\n");
  CHECK(error.what == "'" + number + "' is out of range");
  CHECK(error.why == "coordinates are allowed from -1e30 to 1e30");
  CHECK(to_string(error.where) == "m.obj:2");
  for (const std::string tiny : {"1e-999", "-1E-999"}) {
    std::vector<std::string> warnings;
    CHECK(build("v 0 " + tiny + " 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n", warnings).vertices[0].position == glm::dvec3(0));
  }
}

TEST_CASE("a mesh without vertices, without faces, or binary, is refused") {
  CHECK(error_in("# nothing\n").what == "mesh 'm.obj' has no vertices");
  CHECK(error_in(square).what == "mesh 'm.obj' has no faces");
  CHECK(error_in(square + std::string("f 1 2 3\0", 8)).what == "mesh 'm.obj' is not a text file");
}

TEST_CASE("a truncated mesh is an error at the line where it ends") {
  std::ostringstream text;
  text << square << "vn 0 0 1\nf 1//1 2//1 3//1\nf 1//1 3//1 4//1\n";
  const std::string whole = text.str();
  int refused = 0;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    std::vector<std::string> warnings;
    try {
      check_mesh(build(whole.substr(0, size), warnings));
    } catch (const Error& error) {
      CHECK(error.text().where.file == "m.obj");
      ++refused;
    }
  }
  CHECK(refused > 40);
}

TEST_CASE("triangles without area are dropped with a warning, and a mesh of nothing else is refused") {
  std::vector<std::string> warnings;
  const Mesh mesh = build(square + "v 2 0 0\nf 1 2 3\nf 1 2 5\nf 3 3 4\nf 1 3 4\n", warnings);
  CHECK(mesh.triangles.size() == 2);
  CHECK(warns_of(warnings, "2 triangles without area were dropped, the first in line 7"));
  CHECK(error_in(square + "f 1 1 1\n").what == "mesh 'm.obj' has no triangle with any area");
}

TEST_CASE("missing normals are smoothed, also across doubled vertices") {
  std::vector<std::string> warnings;
  // A roof: two squares that meet at right angles, the ridge given twice.
  const Mesh mesh = build("v 0 0 0\nv 1 0 1\nv 1 1 1\nv 0 1 0\nv 1 0 1\nv 2 0 0\nv 2 1 0\nv 1 1 1\nf 1 2 3 4\nf 5 6 7 8\n", warnings);
  check_mesh(mesh);
  for (const auto& vertex : mesh.vertices) {
    if (vertex.position.x == 1) CHECK(glm::distance(vertex.normal, glm::dvec3(0, 0, 1)) < 1e-12);
    if (vertex.position.x == 0) CHECK(glm::distance(vertex.normal, glm::normalize(glm::dvec3(-1, 0, 1))) < 1e-12);
  }
}

TEST_CASE("triangles turn to face where their normals point") {
  std::vector<std::string> warnings;
  const Mesh mesh = build(square + "vn 0 0 1\nf 1//1 3//1 2//1\nf 1//1 3//1 4//1\n", warnings);
  check_mesh(mesh);
  CHECK(warns_of(warnings, "1 triangles were turned round"));
}

TEST_CASE("normals without length are replaced with a warning") {
  std::vector<std::string> warnings;
  const Mesh mesh = build(square + "vn 0 0 0\nf 1//1 2//1 3//1\n", warnings);
  check_mesh(mesh);
  CHECK(warns_of(warnings, "1 normals have no length"));
}

TEST_CASE("a face seen from both sides keeps a normal for each side") {
  std::vector<std::string> warnings;
  check_mesh(build(square + "f 1 2 3\nf 3 2 1\n", warnings));
}

TEST_CASE("missing texture coordinates come from box projection, right-handed and never degenerate") {
  std::vector<std::string> warnings;
  std::ostringstream text;
  const Mesh sphere = make_sphere(3, 24, 12);
  for (const auto& v : sphere.vertices) text << "v " << v.position.x << " " << v.position.y << " " << v.position.z << "\n";
  for (const auto& t : sphere.triangles) text << "f " << t.x + 1 << " " << t.y + 1 << " " << t.z + 1 << "\n";
  const Mesh mesh = build(text.str(), warnings);
  check_mesh(mesh);
  CHECK(warns_of(warnings, "no texture coordinates; box projection"));
  for (const auto& vertex : mesh.vertices) CHECK(vertex.handedness == 1);
  for (const auto& t : mesh.triangles) {
    const glm::dvec2 a = mesh.vertices[t.x].uv, b = mesh.vertices[t.y].uv - a, c = mesh.vertices[t.z].uv - a;
    const glm::dvec3 p = mesh.vertices[t.x].position;
    const double world = glm::length(glm::cross(mesh.vertices[t.y].position - p, mesh.vertices[t.z].position - p));
    CHECK((b.x * c.y - b.y * c.x) * 36 / world > 0.4);  // the texture repeats once over 6 units
  }
}

TEST_CASE("polygons are cut into triangles that cover them exactly") {
  const std::vector<glm::dvec3> arrow = {glm::dvec3(0, 0, 0), glm::dvec3(2, -1, 0), glm::dvec3(0.5, 0, 0), glm::dvec3(2, 1, 0)};
  for (std::size_t first = 0; first < arrow.size(); ++first) {  // concave, whichever corner comes first
    std::vector<glm::dvec3> outline;
    for (std::size_t i = 0; i < arrow.size(); ++i) outline.push_back(arrow[(first + i) % arrow.size()]);
    const auto triangles = triangulate(outline);
    REQUIRE(triangles.size() == 2);
    double sum = 0;
    for (const auto& triangle : triangles) {
      CHECK(area(outline, {triangle}) > 0);
      sum += area(outline, {triangle});
    }
    CHECK(sum == Approx(0.5));
  }
  for (int n = 3; n < 40; ++n) {  // stars
    std::vector<glm::dvec3> star;
    for (int i = 0; i < 2 * n; ++i) {
      const double angle = 3.14159265358979 * i / n, radius = i % 2 == 0 ? 1.0 : 0.4;
      star.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    }
    const auto triangles = triangulate(star);
    REQUIRE(triangles.size() == star.size() - 2);
    for (const auto& triangle : triangles) CHECK(area(star, {triangle}) > 0);
    CHECK(area(star, triangles) == Approx(n * 0.4 * std::sin(3.14159265358979 / n)));
  }
}

TEST_CASE("faces of several materials become several parts") {
  std::vector<std::string> warnings;
  const ObjModel model = build_obj("mtllib a b.mtl\n" + square + "f 1 2 3\nusemtl red paint\nf 1 3 4\n", "m.obj", true, warnings);
  REQUIRE(model.parts.size() == 2);
  CHECK(model.parts[0].material.empty());
  CHECK(model.parts[1].material == "red paint");
  REQUIRE(model.libraries.size() == 1);
  CHECK(model.libraries[0].name == "a b.mtl");
}
