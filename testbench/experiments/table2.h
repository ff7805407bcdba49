#pragma once
// Table 2 of Lee 2007, drawn and measured: the pictures of three scenes by the proposed method, by Kim's and by the conventional one, with
// vectors in the object's axes and in the camera's. The paper does not say in which of them its angles are taken; only the second comes
// near its figures. No model of hardware: the pictures come from the simulated pipeline and from the reference renderer.
//
// The conventional method (Blinn's Eq 1, Cartesian, object space) is drawn twice, because how a bump map is made moves a picture more than
// hardware does:
//   conventional  exact Cartesian shading, in double precision, of the very map that the schemes encode
//   blinn         Blinn's perturbation from the heights, in double precision, where the scene has heights
//
// The paper (section 7) interpolates the bump map by the filter of its textures, but does not name it. phi means nothing on flat
// texels, so the polar schemes take the nearest texel by default, and `conventional` filters: the same map, not the same N' at a
// pixel. So the schemes are also drawn with the map filtered in each of the ways they know, against the same reference; with vectors the
// filter is the reference's, and what remains is the method.

#include <array>
#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "channels/parameters.h"
#include "testbench/experiments/table2_scenes.h"
#include "testbench/experiments/whole_frame.h"
#include "testbench/published/lee2007_table2.h"
#include "testbench/reference/quality.h"
#include "units/counters.h"
#include "units/object_space.h"
#include "units/scene.h"

namespace bump {

/// One of the pictures that are compared.
struct Table2Picture {
  std::string scene;                  ///< "plane", "cube", "sphere"
  std::string method;                 ///< "proposed", "kim", "conventional", "blinn"
  std::optional<ShadingSpace> space;  ///< absent for the references, which do not depend on it
  FrameBuffer frame;
  std::optional<AngularError> light;  ///< of the L' that the hardware delivers
};

struct Table2Comparison {
  std::string scene, test, reference;  ///< as above
  std::optional<ShadingSpace> space;   ///< absent between the two references
  WholeFrameMeasures whole;            ///< Table 2's measures
  Quality objects;                     ///< over object pixels, unrounded
  const published::Table2Row* published = nullptr;
};

/// Proposed against conventional with the light elsewhere.
struct Table2Angle {
  std::string scene;
  ShadingSpace space = ShadingSpace::object;
  Table2Light light;
  std::array<double, 3> nmse{};
};

/// A scheme with its bump map filtered in one of three ways, against conventional.
struct Table2Filtered {
  std::string scene, test;  ///< as above
  ShadingSpace space = ShadingSpace::object;
  std::string filter;                  ///< of table2_filters
  std::array<double, 3> nmse{};        ///< whole frame, 8 bits
  double psnr_db = 0;                  ///< object pixels, unrounded
  std::optional<std::string> refused;  ///< why the settings do not go with this filter; then the measures are NaN
};

struct Table2 {
  std::vector<Scene> scenes;  ///< as they were drawn, in the order of table2_scenes
  std::vector<Table2Picture> pictures;
  std::vector<Table2Comparison> comparisons;
  std::vector<Table2Angle> angles;          ///< only if asked for: table2_angles at azimuth 0
  std::vector<Table2Angle> azimuths;        ///< only if asked for: table2_azimuths at the scene's own angle
  std::vector<Table2Filtered> filtered;     ///< by scene, space, test ("proposed", "kim"), filter
  std::string texture_filter;               ///< of colours and of the references: texture_fetch.filter
  std::string proposed_filter, kim_filter;  ///< of the bump map in the table's own pictures: lee2007.map_filter, kim2001.map_filter

  const Table2Picture* picture(const std::string& scene, const std::string& method, std::optional<ShadingSpace> space) const;
  const Table2Comparison* comparison(const std::string& scene, const std::string& test, const std::string& reference,
                                     std::optional<ShadingSpace> space) const;
  /// Null if there is none.
  const Table2Filtered* filtered_picture(const std::string& scene, const std::string& test, ShadingSpace space,
                                         const std::string& filter) const;
  /// Of the bump map in the table's own pictures by "proposed" or "kim".
  const std::string& filter_of(const std::string& method) const;
};

struct Table2Options {
  bool angles = false;
  int jobs = 0;                                  ///< simulations side by side; 0: one per core
  std::function<void(double)> progress;          ///< share done, 0 to 1
  const std::atomic<bool>* cancelled = nullptr;  ///< may be null
};

inline constexpr std::array<ShadingSpace, 2> shading_spaces{ShadingSpace::object, ShadingSpace::eye};
/// Ways to filter the bump map: values of <scheme>.map_filter.
inline constexpr std::array<const char*, 3> table2_filters{"nearest", "linear", "vector"};
/// "object" or "eye", the values of vertex_processor.space.
std::string name_of(ShadingSpace space);
/// Ids of the schemes behind "proposed" and "kim".
std::string scheme_of(const std::string& method);

/// `shipped`: the scenes of table2_scenes, in order. The configuration holds for every picture, but for vertex_processor.space, which must
/// be at its default; `filtered` has every filter whatever <scheme>.map_filter is set to. Simulates in child processes (child_processes.h);
/// the result does not depend on their number. Throws Error.
Table2 measure_table2(const std::vector<Scene>& shipped, const Configuration& configuration, const Table2Options& options);

}  // namespace bump
