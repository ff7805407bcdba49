#pragma once
// What travels between the units of the functional plane: a block of up to 256 fragments as a structure of arrays, together with the timing
// records that the units leave for the timing plane. Fragments of one block belong to one object.
//
// Values are planes: one array of 256 doubles per named quantity (an interpolant, a map channel, a datapath output). With fixed-point
// arithmetic two sets of planes travel side by side: what the hardware holds, and the same datapath in double precision, so that
// quantisation error can be told from model error.

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "datapath/evaluate.h"
#include "units/token_records.h"

namespace bump {

using Lanes = std::array<double, block_lanes>;

/// The triangle that a fragment belongs to, after clipping and projection, with what the interpolators need.
struct SetupTriangle {
  std::array<double, 3> x{}, y{};     ///< pixel coordinates (snapped), y downwards
  std::array<double, 3> depth{};      ///< z / w, 0 near to 1 far
  std::array<double, 3> inverse_w{};  ///< 1 / clip w
  std::vector<double> attributes;     ///< 3 corners x (2 texture coordinates + all interpolants), corner by corner
  std::uint32_t source = 0;           ///< index of the mesh triangle it was cut from
};

struct FragmentBlock {
  int lanes = 0;
  int object = 0;                                  ///< index into Scene::objects
  std::array<std::int32_t, block_lanes> x{}, y{};  ///< pixel, (0, 0) is the top left
  Lanes depth{};
  std::array<std::int32_t, block_lanes> triangle{};  ///< index into `triangles`
  std::vector<std::shared_ptr<const SetupTriangle>> triangles;
  Lanes weight1{}, weight2{};  ///< perspective-correct barycentric weights of corners 1 and 2
  Lanes u{}, v{};
  Lanes dudx{}, dvdx{}, dudy{}, dvdy{};  ///< change of u and v from pixel to pixel, memory/level_of_detail.h

  std::array<std::uint8_t, block_lanes>
      diverged{};  ///< 1 where Design::jumps, Design::least or a clipped light map take the pixel out of the stated bound

  std::vector<Lanes> hardware;  ///< planes by index (PlaneMap), as the simulated hardware holds them
  /// The same in double precision; empty when the arithmetic is double anyway. Planes that both share (PipelineContext::shared_planes) are
  /// kept in `hardware` only: read through PipelineContext::exact_plane().
  std::vector<Lanes> exact;

  // Timing records of the tokens of this block, in token order.
  TokenRecords vertex_records, setup_records;  ///< triangles that entered the pipeline up to this block
  TokenRecords raster_records;                 ///< fragments, and triangles without any
  TokenRecords texture_records;                ///< one per fragment
  TokenRecords light_map_records;              ///< one per fragment where the design has light maps
  bool last = false;                           ///< nothing follows
};

/// Names of the planes of a pipeline. Lights share names: planes of light l are "name" for l = 0 and "name#l" for the others.
class PlaneMap {
 public:
  /// The index of `name`, added if new.
  int add(const std::string& name);
  /// The index of `name`; a broken invariant if unknown.
  int index(const std::string& name) const;
  bool contains(const std::string& name) const;
  std::size_t size() const { return names_.size(); }
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::vector<std::string> names_;
};

std::string plane_of_light(const std::string& name, int light);

}  // namespace bump
