#pragma once
// A small design with light maps for the tests of the units and of the system: the map holds the upper half sphere by x and y of the
// normal, 2^bits columns and rows; diffuse kd max(0, N.L) and specular ks (N.H)^4. The normal is the interpolated one; there is no bump
// map.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "samples.h"
#include "schemes/scheme.h"
#include "units/light_map_fill.h"

namespace bump::samples {

constexpr double light_map_kd = 0.7, light_map_ks = 0.25;

/// What the maps hold for one normal, all lights together.
inline std::pair<double, double> light_map_formula(const glm::dvec3& normal, const std::vector<DistantLight>& lights) {
  double diffuse = 0, specular = 0;
  for (const DistantLight& light : lights) {
    const double cosine = std::max(0.0, glm::dot(normal, light.half));
    diffuse += light.intensity * light_map_kd * std::max(0.0, glm::dot(normal, light.light));
    specular += light.intensity * light_map_ks * cosine * cosine * cosine * cosine;
  }
  return {diffuse, specular};
}

/// `s`, `t` in [0, 2): x + 1 and y + 1.
inline glm::dvec3 light_map_normal(double s, double t) {
  const double x = s - 1, y = t - 1;
  return {x, y, std::sqrt(std::max(0.0, 1 - x * x - y * y))};
}

inline Netlist light_map_fill_netlist() {
  Netlist n("frame");
  const Format r = real();
  const char* axes[3] = {".x", ".y", ".z"};
  std::vector<Wire> normal;
  for (const char* axis : axes) normal.push_back(n.input(std::string("N") + axis, r));
  const auto cosine = [&](const std::string& name) {
    Wire sum;
    for (std::size_t i = 0; i < 3; ++i) {
      const Wire product = n.mul("N" + name + axes[i], normal[i], n.input(name + axes[i], r), r);
      sum = i == 0 ? product : n.add("N" + name + axes[i] + ".sum", sum, product, r);
    }
    return n.clamp("N" + name, sum, 0, 1e9, r);
  };
  const Wire light = cosine("L"), half = cosine("H");
  n.output("diffuse", n.mul("diffuse", n.constant("kd", light_map_kd, r), light, r));
  const Wire square = n.mul("H2", half, half, r);
  n.output("specular", n.mul("specular", n.constant("ks", light_map_ks, r), n.mul("H4", square, square, r), r));
  return n;
}

/// `bits` of rows and of columns; `word` of both maps.
inline LightMaps light_maps(int bits, Format word) {
  LightMaps maps;
  maps.maps = {{"diffuse", word}, {"specular", word}};
  maps.address_bits = 2 * bits;
  maps.coordinates = {"m.s", "m.t"};
  Netlist& n = maps.address;
  const Format normal = sfixed(14, 12), place = ufixed(13, 12), count = ufixed(bits, 0);
  std::vector<Wire> cells;
  for (const auto& [axis, coordinate] : {std::pair{"e.x", "m.s"}, std::pair{"e.y", "m.t"}}) {
    const std::string name = coordinate;
    const Wire scaled = n.mul(name + ".scaled", n.input(axis, normal), n.constant(name + ".scale", 1, sfixed(4, 2)), normal);
    const Wire inside = n.clamp(name + ".inside", scaled, -1, 1 - 0x1p-12, sfixed(13, 12));
    const Wire shifted = n.add(name, inside, n.constant(name + ".one", 1, place), place);
    n.output(name, shifted);
    cells.push_back(n.shift(name + ".cell", shifted, bits - 1, count));
  }
  const Format entry = ufixed(2 * bits, 0), whole = ufixed(2 * bits + 3, 0);
  const Wire cell = n.add("cell", n.shift("row", cells[1], bits, entry), cells[0], entry);
  n.output("light_map.entry", n.add("light_map.entry", n.input("light_map.base", whole), cell, whole));
  maps.direction = [](const double* c) { return light_map_normal(c[0], c[1]); };
  maps.centre = [bits](std::int64_t at, double* c) {
    const double size = std::ldexp(1.0, 1 - bits);
    c[0] = (static_cast<double>(at % (std::int64_t{1} << bits)) + 0.5) * size;
    c[1] = (static_cast<double>(at >> bits) + 0.5) * size;
  };
  maps.fill = light_map_fill_netlist();
  return maps;
}

inline Design light_map_design(int bits = 10, Format word = ufixed(18, 16)) {
  Design d;
  const Format r = real(), normal = sfixed(14, 12), light = sfixed(20, 16);
  for (const char* axis : {"x", "y", "z"}) {
    const std::string name = std::string("n.") + axis;
    d.vertex.output(name, d.vertex.input(std::string("N.") + axis, r));
    d.interpolants.push_back({name, InterpolantKind::linear});
  }
  for (const char* axis : {"x", "y"}) {
    const std::string name = std::string("e.") + axis;
    const Wire zero = d.environment.constant(name + ".zero", 0, normal);
    d.environment.output(name, d.environment.add(name, d.environment.input(std::string("n.") + axis, normal), zero, normal));
  }
  d.light_maps = light_maps(bits, word);
  const Wire diffuse = d.illumination.input("light.diffuse", word), specular = d.illumination.input("light.specular", word);
  d.illumination.output("intensity", d.illumination.add("intensity", diffuse, specular, light));
  d.map.encode = [](const glm::dvec3&, double*) {};
  return d;
}

inline std::shared_ptr<const PipelineContext> light_map_context(const Scene& scene, const ContextOptions& options = {}, int bits = 10,
                                                                Format word = ufixed(18, 16)) {
  std::vector<Design> designs;
  designs.push_back(light_map_design(bits, word));
  return make_context(scene, std::move(designs), std::vector<int>(scene.objects.size(), 0), options);
}
std::shared_ptr<const PipelineContext> light_map_context(const Scene&&, const ContextOptions& = {}, int = 0, Format = {}) = delete;

/// Two objects and three lights, one of them a point light, of different intensities.
inline Scene light_map_scene(int width = 96, int height = 64) {
  Scene result = scene(
      {object(sphere(10)), object(sphere(8), glm::scale(glm::translate(glm::dmat4(1), {0.9, 0.3, -0.6}), glm::dvec3(0.7)))}, width, height);
  result.lights[1].intensity = 0.5;
  result.lights.push_back({true, glm::normalize(glm::dvec3(-0.8, 0.1, 0.4)), 0.25});
  return result;
}

}  // namespace bump::samples
