#include "testbench/scene/obj_file.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "testbench/scene/input_files.h"
#include "testbench/scene/mesh_frames.h"
#include "testbench/scene/polygon.h"

namespace bump {

namespace {

struct Triangle {
  ObjCorner corner[3];
  int material = -1;
  int side = -1;  ///< of box projection, -1 where the file has texture coordinates
};

class ObjBuilder {
 public:
  ObjBuilder(ObjText text, FileName file, std::vector<std::string>& warnings)
      : obj_(std::move(text)), file_(std::move(file)), warnings_(warnings) {}

  ObjModel build(bool split) {
    collect_triangles();
    complete_normals();
    project_texture();
    ObjModel model;
    model.libraries = obj_.libraries;
    TangentReport total;
    for (int material = split ? -1 : 0; material < (split ? static_cast<int>(obj_.materials.size()) : 1); ++material) {
      Mesh mesh = gather(material, split);
      if (mesh.triangles.empty()) continue;
      const TangentReport report = build_tangents(mesh);
      total.without_texture_area += report.without_texture_area;
      model.parts.push_back({split && material >= 0 ? obj_.materials[static_cast<std::size_t>(material)] : "", std::move(mesh)});
    }
    if (total.without_texture_area > 0) {
      warn(std::to_string(total.without_texture_area) +
           " triangles have no area in the texture; they take the tangents of their neighbours");
    }
    return model;
  }

 private:
  void warn(const std::string& text) { warnings_.push_back("'" + file_.shown + "': " + text); }
  const glm::dvec3& position(const ObjCorner& corner) const { return obj_.positions[static_cast<std::size_t>(corner.position)]; }

  bool has_area(const Triangle& triangle) const {
    const glm::dvec3 a = position(triangle.corner[1]) - position(triangle.corner[0]),
                     b = position(triangle.corner[2]) - position(triangle.corner[0]);
    const glm::dvec3 c = position(triangle.corner[2]) - position(triangle.corner[1]);
    const double longest = std::max({glm::dot(a, a), glm::dot(b, b), glm::dot(c, c)});
    return glm::length(glm::cross(a, b)) > 1e-10 * longest;
  }

  void collect_triangles() {
    int dropped = 0, first_line = 0;
    for (const auto& face : obj_.faces) {
      std::vector<glm::dvec3> outline;
      for (const auto& corner : face.corners) outline.push_back(position(corner));
      for (const auto& [a, b, c] : triangulate(outline)) {
        const auto at = [&](int i) { return face.corners[static_cast<std::size_t>(i)]; };
        const Triangle triangle{{at(a), at(b), at(c)}, face.material, -1};
        if (has_area(triangle)) {
          triangles_.push_back(triangle);
        } else if (dropped++ == 0) {
          first_line = face.line;
        }
      }
    }
    if (triangles_.empty())
      throw Error({"mesh '" + file_.path + "' has no triangle with any area",
                   {file_.path, first_line, 0},
                   "all were dropped",
                   "re-export the mesh"});
    if (dropped > 0)
      warn(std::to_string(dropped) + " triangles without area were dropped, the first in line " + std::to_string(first_line));
  }

  /// Unit normals; corners without a usable one get a smooth one. Triangles are turned so that they face where their normals point.
  void complete_normals() {
    int without_length = 0;
    for (auto& normal : obj_.normals) {
      const double largest = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
      without_length += largest > 0 ? 0 : 1;
      normal = largest > 0 ? glm::normalize(normal / largest) : glm::dvec3(0);
    }
    if (without_length > 0) warn(std::to_string(without_length) + " normals have no length; smooth normals take their place");

    int turned = 0;
    for (auto& triangle : triangles_) {
      glm::dvec3 sum(0);
      for (const auto& corner : triangle.corner) sum += given_normal(corner);
      if (glm::dot(face_normal(triangle), sum) < 0) {
        std::swap(triangle.corner[1], triangle.corner[2]);
        ++turned;
      }
    }
    if (turned > 0) warn(std::to_string(turned) + " triangles were turned round: their normals point the other way");

    std::vector<glm::uvec3> indices;
    for (const auto& triangle : triangles_) {
      indices.emplace_back(triangle.corner[0].position, triangle.corner[1].position, triangle.corner[2].position);
    }
    const bool incomplete = std::any_of(triangles_.begin(), triangles_.end(), [&](const Triangle& triangle) {
      return std::any_of(triangle.corner, triangle.corner + 3,
                         [&](const ObjCorner& corner) { return given_normal(corner) == glm::dvec3(0); });
    });
    if (!incomplete) return;
    const int first_smooth = static_cast<int>(obj_.normals.size());
    const auto smooth = smooth_normals(obj_.positions, indices);
    obj_.normals.insert(obj_.normals.end(), smooth.begin(), smooth.end());
    for (auto& triangle : triangles_) {
      for (auto& corner : triangle.corner) {
        if (given_normal(corner) != glm::dvec3(0)) continue;
        corner.normal = first_smooth + corner.position;
        if (obj_.normals[static_cast<std::size_t>(corner.normal)] != glm::dvec3(0)) continue;
        corner.normal = static_cast<int>(obj_.normals.size());  // faces that cancel one another: each keeps its own
        obj_.normals.push_back(face_normal(triangle));
      }
    }
  }

  glm::dvec3 given_normal(const ObjCorner& corner) const {
    return corner.normal < 0 ? glm::dvec3(0) : obj_.normals[static_cast<std::size_t>(corner.normal)];
  }

  glm::dvec3 face_normal(const Triangle& triangle) const {
    const glm::dvec3 a = position(triangle.corner[1]) - position(triangle.corner[0]),
                     b = position(triangle.corner[2]) - position(triangle.corner[0]);
    const double size = std::max({glm::length(a), glm::length(b)});
    return glm::normalize(glm::cross(a / size, b / size));
  }

  void project_texture() {
    low_ = high_ = position(triangles_.front().corner[0]);
    std::size_t projected = 0;
    for (auto& triangle : triangles_) {
      bool complete = true;
      glm::dvec3 mean(0);
      for (const auto& corner : triangle.corner) {
        low_ = glm::min(low_, position(corner));
        high_ = glm::max(high_, position(corner));
        complete = complete && corner.texture >= 0;
        mean += given_normal(corner);
      }
      if (complete) continue;
      triangle.side = box_side(glm::length(mean) > 1e-6 ? mean : face_normal(triangle));
      ++projected;
    }
    if (projected > 0 && projected < triangles_.size()) {
      warn(std::to_string(projected) + " triangles have no texture coordinates; box projection gives them some");
    } else if (projected > 0) {
      warn("no texture coordinates; box projection gives them");
    }
  }

  Mesh gather(int material, bool split) const {
    const glm::dvec3 extent = high_ - low_;
    const double size = std::max({extent.x, extent.y, extent.z});
    Mesh mesh;
    std::map<std::tuple<int, int, int, int>, unsigned> index_of;
    for (const auto& triangle : triangles_) {
      if (split && triangle.material != material) continue;
      glm::uvec3 indices(0);
      for (int i = 0; i < 3; ++i) {
        const ObjCorner& corner = triangle.corner[i];
        const int texture = triangle.side >= 0 ? -1 : corner.texture;
        const auto added = index_of.emplace(std::make_tuple(corner.position, corner.normal, texture, triangle.side),
                                            static_cast<unsigned>(mesh.vertices.size()));
        indices[i] = added.first->second;
        if (!added.second) continue;
        Vertex vertex;
        vertex.position = position(corner);
        vertex.normal = given_normal(corner);
        vertex.uv =
            texture >= 0 ? obj_.textures[static_cast<std::size_t>(texture)] : box_coordinates(vertex.position, triangle.side, low_, size);
        mesh.vertices.push_back(vertex);
      }
      mesh.triangles.push_back(indices);
    }
    return mesh;
  }

  ObjText obj_;
  FileName file_;
  std::vector<std::string>& warnings_;
  std::vector<Triangle> triangles_;
  glm::dvec3 low_{0}, high_{0};
};

}  // namespace

ObjModel build_obj(const std::string& text, const FileName& file, bool split, std::vector<std::string>& warnings) {
  return ObjBuilder(parse_obj(text, file.path), file, warnings).build(split);
}

Mesh load_obj(const std::string& path, std::vector<std::string>& warnings) {
  return std::move(build_obj(read_bytes(path, "mesh"), path, false, warnings).parts.front().mesh);
}

}  // namespace bump
