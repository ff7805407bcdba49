#include "scene_bench.h"

#include <OpenImageIO/imageio.h>
#include <stdlib.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace bump::test {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "bumpsim_test_XXXXXX").string();
  REQUIRE(mkdtemp(name.data()) != nullptr);
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code error;
  fs::remove_all(path_, error);
}

std::string TemporaryFolder::write(const std::string& name, const std::string& content) const {
  const fs::path file(path(name));
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << content;
  return file.string();
}

std::string TemporaryFolder::write_image(const std::string& name, int width, int height, int channels, const std::vector<float>& values,
                                         int bits) const {
  const std::string file = path(name);
  const OIIO::TypeDesc type = bits == 8 ? OIIO::TypeDesc::UINT8 : bits == 16 ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::FLOAT;
  OIIO::ImageSpec spec(width, height, channels, type);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  const auto output = OIIO::ImageOutput::create(file);
  REQUIRE(output);
  REQUIRE(output->open(file, spec));
  REQUIRE(output->write_image(OIIO::TypeDesc::FLOAT, values.data()));
  REQUIRE(output->close());
  return file;
}

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  REQUIRE(file.good());
  return std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
}

ErrorText error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::input);
    CHECK_FALSE(error.text().where.file.empty());
    return error.text();
  }
  FAIL("no error was thrown");
  return {};
}

bool warns_of(const std::vector<std::string>& warnings, const std::string& text) {
  for (const auto& warning : warnings) {
    if (warning.find(text) != std::string::npos) return true;
  }
  return false;
}

void check_mesh(const Mesh& mesh) {
  REQUIRE_FALSE(mesh.triangles.empty());
  double worst = 0;
  for (const Vertex& vertex : mesh.vertices) {
    worst = std::max({worst, std::abs(glm::length(vertex.normal) - 1), std::abs(glm::length(vertex.tangent) - 1),
                      std::abs(glm::dot(vertex.normal, vertex.tangent))});
    REQUIRE(std::abs(vertex.handedness) == 1);
    REQUIRE(std::isfinite(vertex.uv.x + vertex.uv.y));
  }
  CHECK(worst < 1e-9);  // NaN fails too
  for (const auto& triangle : mesh.triangles) {
    glm::dvec3 corner[3], normal(0);
    for (int i = 0; i < 3; ++i) {
      REQUIRE(triangle[i] < mesh.vertices.size());
      corner[i] = mesh.vertices[triangle[i]].position;
      normal += mesh.vertices[triangle[i]].normal;
    }
    const glm::dvec3 face = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
    REQUIRE(glm::length(face) > 0);
    REQUIRE(glm::dot(face, normal) >= 0);
  }
}

}  // namespace bump::test
