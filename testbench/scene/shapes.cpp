#include "testbench/scene/shapes.h"

#include <cmath>

#include "datapath/invariant.h"

namespace bump {

namespace {

constexpr double pi = 3.14159265358979323846;

struct Direction {
  double cosine, sine;
};

/// Cosine and sine of index/count of a turn, exact at quarter turns and equal for index 0 and count.
Direction direction(int index, int count) {
  const int i = index % count;
  if (4 * i % count == 0) {
    static constexpr Direction quarters[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    return quarters[4 * i / count];
  }
  const double angle = 2 * pi * i / count;
  return {std::cos(angle), std::sin(angle)};
}

/// Appends the two triangles of a cell; corners seen from outside: lower left, lower right, upper left, upper right.
void add_cell(Mesh& mesh, unsigned lower_left, unsigned lower_right, unsigned upper_left, unsigned upper_right) {
  mesh.triangles.emplace_back(lower_left, lower_right, upper_right);
  mesh.triangles.emplace_back(lower_left, upper_right, upper_left);
}

/// A flat grid: `centre` + (2u-1) * half_u + (2v-1) * half_v.
void add_grid(Mesh& mesh, const glm::dvec3& centre, const glm::dvec3& half_u, const glm::dvec3& half_v, int columns, int rows) {
  BUMP_ASSERT(columns >= 1 && rows >= 1);
  const unsigned first = static_cast<unsigned>(mesh.vertices.size());
  const glm::dvec3 tangent = glm::normalize(half_u), normal = glm::normalize(glm::cross(half_u, half_v));
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      const glm::dvec2 uv(static_cast<double>(column) / columns, static_cast<double>(row) / rows);
      mesh.vertices.push_back({centre + (2 * uv.x - 1) * half_u + (2 * uv.y - 1) * half_v, normal, tangent, 1.0, uv});
    }
  }
  const unsigned stride = static_cast<unsigned>(columns) + 1;
  for (unsigned row = 0; row < static_cast<unsigned>(rows); ++row) {
    for (unsigned column = 0; column < static_cast<unsigned>(columns); ++column) {
      const unsigned corner = first + row * stride + column;
      add_cell(mesh, corner, corner + 1, corner + stride, corner + stride + 1);
    }
  }
}

}  // namespace

Mesh make_plane(double width, double height, int columns, int rows) {
  Mesh mesh;
  add_grid(mesh, glm::dvec3(0), glm::dvec3(width / 2, 0, 0), glm::dvec3(0, height / 2, 0), columns, rows);
  return mesh;
}

Mesh make_cube(double size, int segments) {
  const glm::dvec3 x(size / 2, 0, 0), y(0, size / 2, 0), z(0, 0, size / 2);
  Mesh mesh;
  add_grid(mesh, x, y, z, segments, segments);
  add_grid(mesh, -x, -y, z, segments, segments);
  add_grid(mesh, y, -x, z, segments, segments);
  add_grid(mesh, -y, x, z, segments, segments);
  add_grid(mesh, z, x, y, segments, segments);
  add_grid(mesh, -z, -x, y, segments, segments);
  return mesh;
}

Mesh make_sphere(double radius, int segments, int rings) {
  BUMP_ASSERT(segments >= 3 && rings >= 2);
  Mesh mesh;
  const auto add_vertex = [&](const Direction& latitude, const Direction& longitude, double u, double v) {
    const glm::dvec3 normal(latitude.cosine * longitude.cosine, latitude.cosine * longitude.sine, latitude.sine);
    mesh.vertices.push_back({radius * normal, normal, glm::dvec3(-longitude.sine, longitude.cosine, 0), 1.0, glm::dvec2(u, v)});
  };
  const unsigned columns = static_cast<unsigned>(segments);
  for (const bool north : {false, true}) {  // one vertex a column, first the south pole
    for (int column = 0; column < segments; ++column) {
      add_vertex({0, north ? 1.0 : -1.0}, direction(2 * column + 1, 2 * segments), (column + 0.5) / segments, north ? 1 : 0);
    }
  }
  for (int ring = 1; ring < rings; ++ring) {
    // Latitude from -90 to 90 degrees: the angle ring / (2 rings) of a turn, less a quarter turn.
    const Direction colatitude = direction(ring, 2 * rings);
    for (int column = 0; column <= segments; ++column) {
      add_vertex({colatitude.sine, -colatitude.cosine}, direction(column, segments), static_cast<double>(column) / segments,
                 static_cast<double>(ring) / rings);
    }
  }
  const auto index = [&](unsigned ring, unsigned column) { return 2 * columns + (ring - 1) * (columns + 1) + column; };
  const unsigned last = static_cast<unsigned>(rings) - 1;
  for (unsigned column = 0; column < columns; ++column) {
    mesh.triangles.emplace_back(column, index(1, column + 1), index(1, column));
  }
  for (unsigned ring = 1; ring < last; ++ring) {
    for (unsigned column = 0; column < columns; ++column) {
      add_cell(mesh, index(ring, column), index(ring, column + 1), index(ring + 1, column), index(ring + 1, column + 1));
    }
  }
  for (unsigned column = 0; column < columns; ++column) {
    mesh.triangles.emplace_back(index(last, column), index(last, column + 1), columns + column);
  }
  return mesh;
}

Mesh make_torus(double radius, double tube, int segments, int rings) {
  BUMP_ASSERT(segments >= 3 && rings >= 3);
  Mesh mesh;
  for (int ring = 0; ring <= rings; ++ring) {
    const Direction t = direction(ring, rings);
    for (int column = 0; column <= segments; ++column) {
      const Direction s = direction(column, segments);
      const double reach = radius + tube * t.cosine;
      mesh.vertices.push_back({glm::dvec3(reach * s.cosine, reach * s.sine, tube * t.sine),
                               glm::dvec3(s.cosine * t.cosine, s.sine * t.cosine, t.sine), glm::dvec3(-s.sine, s.cosine, 0), 1.0,
                               glm::dvec2(static_cast<double>(column) / segments, static_cast<double>(ring) / rings)});
    }
  }
  const unsigned stride = static_cast<unsigned>(segments) + 1;
  for (unsigned ring = 0; ring < static_cast<unsigned>(rings); ++ring) {
    for (unsigned column = 0; column < static_cast<unsigned>(segments); ++column) {
      const unsigned corner = ring * stride + column;
      add_cell(mesh, corner, corner + 1, corner + stride, corner + stride + 1);
    }
  }
  return mesh;
}

void scale_texture(Mesh& mesh, double u, double v) {
  for (Vertex& vertex : mesh.vertices) {
    vertex.uv *= glm::dvec2(u, v);
    if (u < 0) vertex.tangent = -vertex.tangent;
    if ((u < 0) != (v < 0)) vertex.handedness = -vertex.handedness;
  }
}

}  // namespace bump
