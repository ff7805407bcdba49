#pragma once
// A scene as the simulated hardware receives it: indexed triangle meshes with tangent frames, textures, lights, a camera. Plain data,
// already validated by whoever read it. Shading is in the object's or the camera's axes, so objects are placed by rotation, translation and
// uniform scale only.

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "memory/texture.h"

namespace bump {

struct Vertex {
  glm::dvec3 position{0};
  glm::dvec3 normal{0, 0, 1};   ///< unit
  glm::dvec3 tangent{1, 0, 0};  ///< unit, orthogonal to the normal, along growing u
  double handedness = 1;        ///< binormal = handedness * cross(normal, tangent), along growing v
  glm::dvec2 uv{0};
};

struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<glm::uvec3> triangles;  ///< counter-clockwise seen from outside
};

/// Coefficients of Lee 2007 Eq 2: I = ambient + intensity * (diffuse * N'.L + specular * (N'.H)^shininess).
struct Material {
  double ambient = 0.15, diffuse = 0.7, specular = 0.25, shininess = 20;
  bool operator==(const Material& o) const {
    return ambient == o.ambient && diffuse == o.diffuse && specular == o.specular && shininess == o.shininess;
  }
};

struct SceneObject {
  std::string name;
  std::shared_ptr<const Mesh> mesh;
  glm::dmat4 to_world{1};                  ///< rotation, translation, uniform scale
  std::shared_ptr<const Texture> colour;   ///< 3 channels in [0, 1], display values (no linearisation)
  std::shared_ptr<const Texture> normals;  ///< 3 channels, unit tangent-space normals, z towards the outside, x along u, y along v
  std::shared_ptr<const Texture> heights;  ///< 1 channel, in texels of its own level 0; null when the map came as normals
  Material material;
};

struct Light {
  bool directional = true;
  glm::dvec3 vector{0, 0, 1};  ///< directional: unit, towards the light; point: position. World space
  double intensity = 1;
};

struct Camera {
  glm::dvec3 eye{0, 0, 3}, target{0}, up{0, 1, 0};
  double field_of_view = 45;  ///< vertical, degrees
  double near = 0.01;         ///< distance of the near plane
};

struct Scene {
  std::string name;
  int width = 512, height = 512;
  glm::dvec3 background{0};
  Camera camera;
  std::vector<Light> lights;
  std::vector<SceneObject> objects;
  struct InputFile {
    std::string path, sha256;
  };
  std::vector<InputFile> inputs;      ///< every file that was read, in order; paths from the scene's folder
  std::vector<std::string> warnings;  ///< what the reader noticed and mended
};

}  // namespace bump
