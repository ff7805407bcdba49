#pragma once
// A hand-made run for the tests of the result folder: every list has something in it, every number is known.

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "testbench/results/run_report.h"

namespace bump::made_up {

class SampleScheme : public Scheme {
 public:
  const SchemePage& page() const override { return page_; }
  void declare(Parameters&) const override {}
  Design design(const Configuration&, const Material&) const override { return {}; }

 private:
  SchemePage page_{"lee2007", "Polar bump mapping", "Lee et al. 2007", "as published", "A sample."};
};

inline FrameBuffer frame(int width, int height, double shift) {
  FrameBuffer result;
  result.width = width;
  result.height = height;
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  for (std::size_t i = 0; i < pixels; ++i) {
    const double along = static_cast<double>(i) / static_cast<double>(pixels);
    for (const double base : {0.1, 0.3, 0.5}) result.colour.push_back(base + 0.4 * along + shift);
    result.object.push_back(0);
    result.depth.push_back(0.5);
  }
  return result;
}

struct Sample {
  Scene scene;
  SampleScheme scheme;
  SimulationResult result;
  RunReport report;

  Sample(const Sample&) = delete;
  explicit Sample(int size = 16) {
    scene.name = "wooden plane";
    scene.width = scene.height = size;
    scene.lights.resize(1);
    scene.objects.resize(1);
    scene.inputs = {{"plane.toml", std::string(64, 'a')}, {"wood.png", std::string(64, 'b')}};
    scene.warnings = {"wood.png: normals had lengths from 0.98 to 1.03 and were normalised"};

    result.timing.cycles = 1000;
    result.timing.stages = {{"rasterizer", 250, 400, 100, 300, 200, 950}, {"frame_sink", 250, 250, 750, 0, 0, 999}};
    result.timing.fifos = {{"rasterizer_to_frame_sink", 8, 250, 7, 0, 120}};
    result.timing.memories = {{"memory", 30, 120}};
    result.fragments = 250;
    result.bound = {800, "rasterizer: initiation interval"};
    UnitCost environment, illumination;
    environment.name = "environment";
    environment.published.multipliers = 6;
    environment.published.adders = 16;
    environment.published.tables = 12;
    environment.published.table_bits = 65536;
    environment.addition.adders = 2;
    environment.pipeline = {9, 1, 6};
    environment.executions = 250;
    illumination.name = "illumination";
    illumination.published.multipliers = 2;
    illumination.published.adders = 13;
    illumination.published.tables = 8;
    illumination.pipeline = {4, 1, 2};
    illumination.executions = 500;
    result.units = {environment, illumination};
    result.tables = {{"environment", "SC", "sin x, cos x; x in turns", 256, 8192, 4, 1000, false}};
    result.texture = {2000, 900, 870, 30, 1920};
    result.geometry = {8, 4, 4, 1, 1, 0, 1, 2, 260, 10, 250, 250};
    result.hardware = frame(size, size, 0.02);
    result.exact = frame(size, size, 0.0201);
    result.angular_errors = {{"L'", 250, 3.5, 4.25, 20}};
    result.angular_errors_exact = {{"L'", 250, 3.4, 4.1, 19.5}};
    result.interpolator_components = 6;
    result.quantisation_floor_db = 50;

    report.scene = &scene;
    report.scheme = &scheme;
    report.result = &result;
    report.resolved_toml = "filter = \"bilinear\"  # default\n";
    report.host = {0.5, 500, 20, "g++", "bumpsim"};
    const FrameBuffer reference = frame(size, size, 0);
    measure_quality(report, &reference, nullptr);
    report.error_picture = error_image(result.hardware, reference);
  }
};

/// A folder of its own for one test, gone afterwards.
class Workspace {
 public:
  Workspace() {
    std::string pattern = (std::filesystem::temp_directory_path() / "bumpsim-test-XXXXXX").string();
    path_ = mkdtemp(pattern.data());
  }
  ~Workspace() { std::filesystem::remove_all(path_); }
  Workspace(const Workspace&) = delete;

  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  /// Names of everything in it.
  std::vector<std::string> names() const {
    std::vector<std::string> list;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) list.push_back(entry.path().filename().string());
    return list;
  }

 private:
  std::filesystem::path path_;
};

inline std::string read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace bump::made_up
