#include "units/light_map_fill.h"

#include <algorithm>
#include <string>

#include "datapath/invariant.h"

namespace bump {

namespace {

/// What is shorter than rounding errors has no direction.
glm::dvec3 unit_or_zero(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 1e-12 ? v / length : glm::dvec3(0);
}

glm::dvec3 centre_of(const Mesh& mesh) {
  if (mesh.vertices.empty()) return glm::dvec3(0);
  glm::dvec3 low = mesh.vertices.front().position, high = low;
  for (const Vertex& vertex : mesh.vertices) {
    low = glm::min(low, vertex.position);
    high = glm::max(high, vertex.position);
  }
  return 0.5 * (low + high);
}

/// Place of an input among N, L, H; each x, y, z.
int component(const std::string& name) {
  static const std::string letters = "NLH", axes = "xyz";
  const bool known =
      name.size() == 3 && name[1] == '.' && letters.find(name[0]) != std::string::npos && axes.find(name[2]) != std::string::npos;
  if (!known)
    throw Error(ErrorKind::internal,
                {"the frame netlist reads '" + name + "'", {}, "inputs are N L H, .x .y .z", "mend the scheme's light maps"});
  return static_cast<int>(3 * letters.find(name[0]) + axes.find(name[2]));
}

}  // namespace

std::vector<DistantLight> distant_lights(const ObjectSpace& space, const Mesh& mesh) {
  const glm::dvec3 centre = centre_of(mesh), eye = unit_or_zero(space.eye_vector(centre));
  std::vector<DistantLight> lights;
  for (std::size_t l = 0; l < space.lights.size(); ++l) {
    DistantLight light;
    light.light = unit_or_zero(space.light_vector(static_cast<int>(l), centre));
    light.half = unit_or_zero(light.light + eye);
    light.intensity = space.lights[l].intensity;
    lights.push_back(light);
  }
  return lights;
}

Netlist light_sum_netlist(const LightMaps& maps, bool scaled, bool added) {
  Netlist n("light_sum");
  const Format format = real();
  Wire intensity;
  if (scaled) intensity = n.input("intensity", format);
  for (const LightMaps::Map& map : maps.maps) {
    Wire value = n.input(map.name, format);
    if (scaled) value = n.mul(map.name + ".scaled", value, intensity, format);
    if (added) value = n.add(map.name + ".total", value, n.input(map.name + ".sum", format), format);
    n.output(map.name, value);
  }
  return n;
}

bool scales_lights(const std::vector<Light>& lights) {
  return std::any_of(lights.begin(), lights.end(), [](const Light& light) { return light.intensity != 1; });
}

LightMapFill::LightMapFill(const LightMaps& maps)
    : maps_(maps),
      evaluator_(make_evaluator(maps.fill, Arithmetic::real)),
      first_(light_sum_netlist(maps, true, false)),
      further_(light_sum_netlist(maps, true, true)),
      first_evaluator_(make_evaluator(first_, Arithmetic::real)),
      further_evaluator_(make_evaluator(further_, Arithmetic::real)) {
  for (const Netlist::Port& port : maps.fill.inputs()) inputs_.push_back(component(port.name));
  const std::vector<Netlist::Port>& outputs = maps.fill.outputs();
  for (const LightMaps::Map& map : maps.maps) {
    const auto found = std::find_if(outputs.begin(), outputs.end(), [&](const Netlist::Port& port) { return port.name == map.name; });
    if (found == outputs.end())
      throw Error(
          ErrorKind::internal,
          {"the frame netlist has no output '" + map.name + "'", {}, "it has one for each light map", "mend the scheme's light maps"});
    outputs_.push_back(static_cast<int>(found - outputs.begin()));
  }
  results_.resize(outputs.size());
}

void LightMapFill::set_lights(const std::vector<DistantLight>& lights) {
  lights_.resize(lights.size());
  for (std::size_t l = 0; l < lights.size(); ++l) {
    lights_[l].intensity.fill(lights[l].intensity);
    for (int axis = 0; axis < 3; ++axis) {
      lights_[l].vectors[static_cast<std::size_t>(axis)].fill(lights[l].light[axis]);
      lights_[l].vectors[static_cast<std::size_t>(3 + axis)].fill(lights[l].half[axis]);
    }
  }
}

void LightMapFill::evaluate(const std::vector<glm::dvec3>& normals, int lanes, std::vector<Lanes>& sums) {
  const auto count = static_cast<std::size_t>(lanes);
  BUMP_ASSERT(lanes >= 0 && lanes <= block_lanes && normals.size() >= count && sums.size() == outputs_.size());
  for (std::size_t lane = 0; lane < count; ++lane)
    for (int axis = 0; axis < 3; ++axis) normal_[static_cast<std::size_t>(axis)][lane] = normals[lane][axis];
  for (Lanes& sum : sums) std::fill_n(sum.begin(), count, 0.0);
  std::vector<const double*> inputs(inputs_.size()), parts;
  std::vector<double*> outputs, totals;
  for (Lanes& result : results_) outputs.push_back(result.data());
  for (Lanes& sum : sums) totals.push_back(sum.data());
  for (std::size_t l = 0; l < lights_.size(); ++l) {
    const Light& light = lights_[l];
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const auto at = static_cast<std::size_t>(inputs_[i]);
      inputs[i] = at < 3 ? normal_[at].data() : light.vectors[at - 3].data();
    }
    evaluator_->evaluate(inputs.data(), lanes, outputs.data());
    // In the order of light_sum_netlist's ports.
    parts.assign(1, light.intensity.data());
    for (std::size_t map = 0; map < sums.size(); ++map) {
      parts.push_back(results_[static_cast<std::size_t>(outputs_[map])].data());
      if (l > 0) parts.push_back(sums[map].data());
    }
    Evaluator& sum = l == 0 ? *first_evaluator_ : *further_evaluator_;
    sum.evaluate(parts.data(), lanes, totals.data());
  }
}

void LightMapFill::fill(LightMapWords& maps) {
  const std::int64_t entries = std::int64_t{1} << maps_.address_bits;
  maps.words.resize(maps_.maps.size());
  maps.clipped.resize(maps_.maps.size());
  for (std::vector<std::int32_t>& words : maps.words) words.resize(static_cast<std::size_t>(entries));
  for (std::vector<bool>& clipped : maps.clipped) clipped.assign(static_cast<std::size_t>(entries), false);
  std::vector<double> coordinates(maps_.coordinates.size());
  std::vector<glm::dvec3> normals(block_lanes);
  std::vector<Lanes> sums(maps_.maps.size());
  for (std::int64_t first = 0; first < entries; first += block_lanes) {
    const auto lanes = static_cast<std::size_t>(std::min<std::int64_t>(block_lanes, entries - first));
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      maps_.centre(first + static_cast<std::int64_t>(lane), coordinates.data());
      normals[lane] = maps_.direction(coordinates.data());
    }
    evaluate(normals, static_cast<int>(lanes), sums);
    for (std::size_t map = 0; map < sums.size(); ++map) {
      const Format& word = maps_.maps[map].word;
      const double half = 0.5 * word.step(), low = word.lowest() - half, high = word.highest() + half;
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const double sum = sums[map][lane];
        const std::size_t entry = static_cast<std::size_t>(first) + lane;
        maps.words[map][entry] = static_cast<std::int32_t>(quantise(sum, word));
        if (sum < low || sum >= high) maps.clipped[map][entry] = true;
      }
    }
  }
}

}  // namespace bump
