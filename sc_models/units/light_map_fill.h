#pragma once
// What fills the light maps once a frame: the design's `frame` netlist, evaluated for the normal that each entry stands for and for every
// light, summed with the lights' intensities and rounded to the words of the maps. Lights and eye count as infinitely far from the object's
// centre (that of the box around its mesh). The host does it, or a frame before: it takes no cycle of the pixel pipeline, and its work and
// the bytes that it writes are reported apart. The same sum, unrounded, is the continuous function that the double evaluation takes in
// place of the maps. Source: Kugler 1998 as Lee 2007 describes it.

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "datapath/evaluate.h"
#include "schemes/scheme.h"
#include "units/fragment_block.h"
#include "units/object_space.h"

namespace bump {

/// A light as the maps see it, in the axes of the vertex program. Both vectors are unit vectors, or zero where there is no direction (a
/// point light in the centre of the object, a light right behind it).
struct DistantLight {
  glm::dvec3 light{0}, half{0};
  double intensity = 1;
};

/// The lights of a scene as seen from the centre of the box around `mesh`.
std::vector<DistantLight> distant_lights(const ObjectSpace& space, const Mesh& mesh);

/// What follows the design's netlist for each light: the maps' values times the light's intensity ("intensity"; only if `scaled`), and for
/// every light but the first (`added`) the sum with what the lights before it gave ("<map>.sum"). One output per map, by its name. Floating
/// point.
Netlist light_sum_netlist(const LightMaps& maps, bool scaled, bool added);
/// Whether a scene's lights need the multiplication.
bool scales_lights(const std::vector<Light>& lights);

/// The maps of one object. Words are signed integers as `quantise` gives them.
struct LightMapWords {
  std::vector<std::vector<std::int32_t>> words;  ///< by map, by entry
  std::vector<std::vector<bool>> clipped;        ///< by map, by entry: the sum did not fit into the word
};

class LightMapFill {
 public:
  /// The maps must outlive this.
  explicit LightMapFill(const LightMaps& maps);

  void set_lights(const std::vector<DistantLight>& lights);
  /// The sum over the lights, map by map, for `lanes` unit normals, 0 <= lanes <= block_lanes.
  void evaluate(const std::vector<glm::dvec3>& normals, int lanes, std::vector<Lanes>& sums);
  /// Every entry of every map.
  void fill(LightMapWords& maps);

 private:
  /// One light's vectors over all lanes: L.x L.y L.z H.x H.y H.z.
  struct Light {
    std::array<Lanes, 6> vectors{};
    Lanes intensity{};
  };

  const LightMaps& maps_;
  std::unique_ptr<Evaluator> evaluator_;
  Netlist first_, further_;  ///< light_sum_netlist of the first light and of those after it
  std::unique_ptr<Evaluator> first_evaluator_, further_evaluator_;
  std::vector<int> inputs_;   ///< for each input of the netlist its vector component, N before L before H
  std::vector<int> outputs_;  ///< for each map its output of the netlist
  std::array<Lanes, 3> normal_{};
  std::vector<Light> lights_;
  std::vector<Lanes> results_;  ///< by output
};

}  // namespace bump
