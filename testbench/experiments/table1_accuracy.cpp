#include "testbench/experiments/table1_accuracy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

#include "datapath/evaluate.h"
#include "units/angular_error.h"

namespace bump {

namespace {

constexpr int blocks = 64;

using Plane = std::array<double, block_lanes>;
using Planes = std::map<std::string, Plane>;

/// SplitMix64 (Steele, Lea, Flood 2014): the same numbers everywhere.
class Random {
 public:
  double uniform(double low, double high) {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return low + (high - low) * std::ldexp(static_cast<double>((z ^ (z >> 31)) >> 11), -53);
  }
  /// Uniform over the sphere, by rejection in the ball.
  glm::dvec3 direction() {
    for (;;) {
      const double x = uniform(-1, 1), y = uniform(-1, 1), z = uniform(-1, 1);
      const double square = x * x + y * y + z * z;
      if (square > 1e-3 && square <= 1) return glm::dvec3(x, y, z) / std::sqrt(square);
    }
  }
  glm::dvec3 above(const glm::dvec3& normal) {
    const glm::dvec3 v = direction();
    return glm::dot(v, normal) < 0 ? -v : v;
  }

 private:
  std::uint64_t state_ = 2007;
};

void set(Planes& planes, const std::string& name, std::size_t lane, const glm::dvec3& v) {
  for (int axis = 0; axis < 3; ++axis) planes[name + "." + "xyz"[axis]][lane] = v[axis];
}

void run(const Netlist& netlist, Planes& planes) {
  std::vector<const double*> inputs;
  std::vector<double*> outputs;
  for (const Netlist::Port& port : netlist.inputs()) inputs.push_back(planes[port.name].data());
  for (const Netlist::Port& port : netlist.outputs()) outputs.push_back(planes[port.name].data());
  make_evaluator(netlist, Arithmetic::real)->evaluate(inputs.data(), block_lanes, outputs.data());
}

glm::dvec3 delivered(const DeliveredDirection& direction, const Planes& planes, std::size_t lane) {
  const auto value = [&](std::size_t i) { return planes.at(direction.planes[i])[lane]; };
  return direction.planes.size() == 2 ? polar_direction(value(0), value(1)) : glm::dvec3(value(0), value(1), value(2));
}

}  // namespace

std::optional<DirectionError> light_direction_error(const Design& design) {
  const auto light = std::find_if(design.directions.begin(), design.directions.end(),
                                  [](const DeliveredDirection& d) { return d.of == DeliveredDirection::Of::light; });
  if (light == design.directions.end()) return std::nullopt;
  std::vector<double> texel(design.map.channels.size());
  if (design.map.encode) design.map.encode({0, 0, 1}, texel.data());

  Random random;
  DirectionError error;
  for (int block = 0; block < blocks; ++block) {
    Planes planes;
    std::vector<glm::dvec3> truth;
    for (std::size_t c = 0; c < texel.size(); ++c) planes["map." + design.map.channels[c].name].fill(texel[c]);
    for (std::size_t lane = 0; lane < block_lanes; ++lane) {
      const glm::dvec3 n = random.direction(), t = glm::normalize(glm::cross(n, random.direction())), b = glm::cross(n, t);
      const glm::dvec3 l = random.above(n);
      set(planes, "N", lane, n);
      set(planes, "T", lane, t);
      set(planes, "B", lane, b);
      set(planes, "L", lane, l);
      set(planes, "V", lane, random.above(n));
      truth.push_back(glm::transpose(delivery_frame(light->frame, n, t, b)) * l);
    }
    // The vertex program reads vectors and its outputs may have the same names: inputs are read before outputs are written.
    Planes interpolated = planes;
    std::vector<const double*> inputs;
    std::vector<double*> outputs;
    for (const Netlist::Port& port : design.vertex.inputs()) inputs.push_back(planes[port.name].data());
    for (const Netlist::Port& port : design.vertex.outputs()) outputs.push_back(interpolated[port.name].data());
    make_evaluator(design.vertex, Arithmetic::real)->evaluate(inputs.data(), block_lanes, outputs.data());
    if (design.conversion) run(*design.conversion, interpolated);
    run(design.environment, interpolated);
    for (std::size_t lane = 0; lane < truth.size(); ++lane) {
      const double degrees = angle_between(truth[lane], delivered(*light, interpolated, lane));
      error.mean_degrees += degrees;
      error.rms_degrees += degrees * degrees;
      error.max_degrees = std::max(error.max_degrees, degrees);
    }
  }
  constexpr double points = double{blocks} * block_lanes;
  error.mean_degrees /= points;
  error.rms_degrees = std::sqrt(error.rms_degrees / points);
  return error;
}

}  // namespace bump
