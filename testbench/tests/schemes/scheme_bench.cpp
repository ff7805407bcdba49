#include "testbench/tests/schemes/scheme_bench.h"

#include <algorithm>
#include <cmath>

namespace bump::bench {

namespace {

constexpr double two_pi = 6.283185307179586476925;

void set_vector(Planes& planes, const std::string& name, std::size_t lane, const glm::dvec3& v) {
  planes[name + ".x"][lane] = v.x;
  planes[name + ".y"][lane] = v.y;
  planes[name + ".z"][lane] = v.z;
}

double decibels(double squared_error, double count) {
  return -10 * std::log10(std::max(squared_error / count, 1e-30));
}

/// Zero where there is no direction.
glm::dvec3 unit_or_zero(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : glm::dvec3(0);
}

/// Address, look-up of the nearest entry (or the continuous function) and the planes "light.<name>", every point with a light of its own.
void read_light_maps(const LightMaps& maps, Arithmetic arithmetic, const std::vector<Point>& points, Planes& planes, int lanes) {
  planes["light_map.base"].fill(0);
  run(maps.address, arithmetic, planes, lanes);
  Planes frame;
  std::vector<double> coordinates(maps.coordinates.size());
  for (std::size_t i = 0; i < static_cast<std::size_t>(lanes); ++i) {
    for (std::size_t c = 0; c < coordinates.size(); ++c) coordinates[c] = planes.at(maps.coordinates[c])[i];
    if (arithmetic == Arithmetic::fixed) maps.centre(static_cast<std::int64_t>(planes.at("light_map.entry")[i]), coordinates.data());
    const glm::dvec3 light = unit_or_zero(points[i].light);
    set_vector(frame, "N", i, maps.direction(coordinates.data()));
    set_vector(frame, "L", i, light);
    set_vector(frame, "H", i, unit_or_zero(light + unit_or_zero(points[i].view)));
  }
  run(maps.fill, Arithmetic::real, frame, lanes);
  for (const LightMaps::Map& map : maps.maps)
    for (std::size_t i = 0; i < static_cast<std::size_t>(lanes); ++i) {
      const double sum = frame.at(map.name)[i];
      planes["light." + map.name][i] = arithmetic == Arithmetic::fixed ? to_double(quantise(sum, map.word), map.word) : sum;
    }
}

}  // namespace

Configuration configured(const Scheme& scheme, Settings settings) {
  Parameters parameters;
  scheme.declare(parameters);
  Configuration configuration(parameters);
  for (const auto& [key, value] : settings) configuration.set_text(scheme.page().id + "." + key, value, Location("test"));
  return configuration;
}

Design designed(const std::string& id, Settings settings, const Material& material) {
  const Scheme& scheme = find_scheme(id);
  return scheme.design(configured(scheme, settings), material);
}

std::unique_ptr<Evaluator> run(const Netlist& netlist, Arithmetic arithmetic, Planes& planes, int lanes) {
  std::unique_ptr<Evaluator> evaluator = make_evaluator(netlist, arithmetic);
  std::vector<const double*> inputs;
  std::vector<double*> outputs;
  for (const Netlist::Port& port : netlist.inputs()) inputs.push_back(planes.at(port.name).data());
  std::vector<Plane> results(netlist.outputs().size());
  for (Plane& result : results) outputs.push_back(result.data());
  evaluator->evaluate(inputs.data(), lanes, outputs.data());
  for (std::size_t i = 0; i < results.size(); ++i) planes[netlist.outputs()[i].name] = results[i];
  return evaluator;
}

std::uint64_t Random::word() {
  std::uint64_t z = (state_ += 0x9e3779b97f4a7c15);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

double Random::uniform(double low, double high) {
  return low + (high - low) * static_cast<double>(word() >> 11) * 0x1p-53;
}

glm::dvec3 Random::direction() {
  const double z = uniform(-1, 1), phi = uniform(0, two_pi), r = std::sqrt(1 - z * z);
  return {r * std::cos(phi), r * std::sin(phi), z};
}

Point Random::point(double tilt) {
  Point p;
  p.normal = direction();
  p.tangent = glm::normalize(glm::cross(direction(), p.normal));
  p.binormal = glm::cross(p.normal, p.tangent);
  p.light = direction();
  if (glm::dot(p.light, p.normal) < 0) p.light = -p.light;
  p.view = direction();
  if (glm::dot(p.view, p.normal) < 0) p.view = -p.view;
  const double theta = uniform(0, tilt), phi = uniform(0, two_pi);
  p.bump = {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
  return p;
}

double exact_intensity(const Point& p, const Material& material) {
  const glm::dvec3 bumped = p.bump.x * p.tangent + p.bump.y * p.binormal + p.bump.z * p.normal;
  const glm::dvec3 half = glm::normalize(glm::normalize(p.light) + glm::normalize(p.view));
  return material.diffuse * std::max(0.0, glm::dot(bumped, glm::normalize(p.light))) +
         material.specular * std::pow(std::max(0.0, glm::dot(bumped, half)), material.shininess);
}

Planes shade(const Design& design, Arithmetic arithmetic, const std::vector<Point>& points) {
  Planes vertex;
  const auto lanes = std::min(points.size(), static_cast<std::size_t>(block_lanes));
  for (std::size_t i = 0; i < lanes; ++i) {
    set_vector(vertex, "N", i, points[i].normal);
    set_vector(vertex, "T", i, points[i].tangent);
    set_vector(vertex, "B", i, points[i].binormal);
    set_vector(vertex, "L", i, points[i].light);
    set_vector(vertex, "V", i, points[i].view);
  }
  run(design.vertex, Arithmetic::real, vertex, static_cast<int>(lanes));
  Planes planes;
  for (const Interpolant& interpolant : design.interpolants) planes[interpolant.name] = vertex.at(interpolant.name);
  std::vector<double> channels(design.map.channels.size());
  for (std::size_t i = 0; i < lanes; ++i) {
    design.map.encode(points[i].bump, channels.data());
    for (std::size_t c = 0; c < channels.size(); ++c) {
      const BumpEncoding::Channel& channel = design.map.channels[c];
      planes["map." + channel.name][i] =
          arithmetic == Arithmetic::fixed ? to_double(quantise(channels[c], channel.format), channel.format) : channels[c];
    }
  }
  if (design.conversion) run(*design.conversion, arithmetic, planes, static_cast<int>(lanes));
  run(design.environment, arithmetic, planes, static_cast<int>(lanes));
  if (design.light_maps) read_light_maps(*design.light_maps, arithmetic, points, planes, static_cast<int>(lanes));
  run(design.illumination, arithmetic, planes, static_cast<int>(lanes));
  return planes;
}

Accuracy accuracy(const Design& design, const Material& material, int blocks, const std::function<Point(Random&)>& draw) {
  Random random(20070323);
  const auto reader = make_evaluator(design.environment, Arithmetic::fixed);  // ROM contents live as long as one
  double fixed_real = 0, real_exact = 0, fixed_exact = 0;
  for (int block = 0; block < blocks; ++block) {
    std::vector<Point> points;
    for (int i = 0; i < block_lanes; ++i) points.push_back(draw(random));
    const Planes real = shade(design, Arithmetic::real, points), fixed = shade(design, Arithmetic::fixed, points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double r = real.at("intensity")[i], f = fixed.at("intensity")[i], e = exact_intensity(points[i], material);
      fixed_real += (f - r) * (f - r);
      real_exact += (r - e) * (r - e);
      fixed_exact += (f - e) * (f - e);
    }
  }
  const double count = static_cast<double>(blocks) * block_lanes;
  return {decibels(fixed_real, count), decibels(real_exact, count), decibels(fixed_exact, count)};
}

std::array<double, 3> components(const glm::dvec3& v) {
  return {v.x, v.y, v.z};
}

glm::dvec3 from_polar(double phi, double theta) {
  return {std::sin(two_pi * theta) * std::cos(two_pi * phi), std::sin(two_pi * theta) * std::sin(two_pi * phi), std::cos(two_pi * theta)};
}

double degrees_between(const glm::dvec3& a, const glm::dvec3& b) {
  // The chord is accurate for small angles, where the arc cosine is not.
  return 2 * std::asin(std::min(1.0, glm::length(a - b) / 2)) * 360 / two_pi;
}

}  // namespace bump::bench
