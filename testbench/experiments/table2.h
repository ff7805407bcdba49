#pragma once
// Table 2 of Lee 2007, drawn and measured: the pictures of three scenes by the proposed method, by Kim's and by the conventional one, with
// vectors in the object's axes and in the camera's. The paper does not say in which of them its angles are taken; only the second comes
// near its figures. No model of hardware: the pictures come from the simulated pipeline and from the reference renderer.
//
// The conventional method (Blinn's Eq 1, Cartesian, object space) is drawn twice, because how a bump map is made moves a picture more than
// hardware does:
//   conventional  exact Cartesian shading, in double precision, of the very map that the schemes encode: the comparison isolates the
//   method; blinn         Blinn's perturbation from the heights, in double precision, where the scene has heights.

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

struct Table2 {
  std::vector<Scene> scenes;  ///< as they were drawn, in the order of table2_scenes
  std::vector<Table2Picture> pictures;
  std::vector<Table2Comparison> comparisons;
  std::vector<Table2Angle> angles;    ///< only if asked for: table2_angles at azimuth 0
  std::vector<Table2Angle> azimuths;  ///< only if asked for: table2_azimuths at the scene's own angle

  const Table2Picture* picture(const std::string& scene, const std::string& method, std::optional<ShadingSpace> space) const;
  const Table2Comparison* comparison(const std::string& scene, const std::string& test, const std::string& reference,
                                     std::optional<ShadingSpace> space) const;
};

struct Table2Options {
  bool angles = false;
  int jobs = 0;                                  ///< simulations side by side; 0: one per core
  std::function<void(double)> progress;          ///< share done, 0 to 1
  const std::atomic<bool>* cancelled = nullptr;  ///< may be null
};

inline constexpr std::array<ShadingSpace, 2> shading_spaces{ShadingSpace::object, ShadingSpace::eye};
/// "object" or "eye", the values of vertex_processor.space.
std::string name_of(ShadingSpace space);
/// Ids of the schemes behind "proposed" and "kim".
std::string scheme_of(const std::string& method);

/// `shipped`: the scenes of table2_scenes, in order. The configuration holds for every picture, but for vertex_processor.space, which must
/// be at its default. Simulates in child processes (child_processes.h); the result does not depend on their number. Throws Error.
Table2 measure_table2(const std::vector<Scene>& shipped, const Configuration& configuration, const Table2Options& options);

}  // namespace bump
