#pragma once
// The specification of a sweep, a TOML file: scenes, schemes, base settings, and sections that say which points there are. Read strictly:
// every key and value is checked before anything runs. README.md of this folder describes the format. No model of hardware.

#include <string>
#include <vector>

#include "channels/parameters.h"
#include "schemes/scheme.h"

namespace bump {

struct SweptScene {
  std::string name;  ///< as the specification gives it
  std::string path;  ///< of the scene file or mesh
};

/// A point of the specification. Sizes are those of the frame in pixels, 0 where it is the scene's own.
struct SpecPoint {
  std::size_t scene = 0, scheme = 0;  ///< index into the specification's lists
  int width = 0, height = 0;
  std::vector<ParameterValue> values;  ///< of the swept parameters; of those of other schemes the base's
};

struct SweepSpec {
  std::string file;
  std::vector<SweptScene> scenes;
  std::vector<const Scheme*> schemes;
  Configuration base;             ///< what points do not set
  bool quality = true;            ///< pictures are measured
  std::vector<std::string> keys;  ///< swept parameters, in the order in which the specification names them
  std::vector<SpecPoint> points;  ///< in order; some may be the same
};

/// False for a parameter that another scheme alone declares: keys of a scheme's parameters start with its id.
bool concerns(const std::string& key, const Scheme& scheme);

/// `scene_folders`: of scenes by name; other scenes are paths, relative ones from the specification's folder. Throws Error(input) with
/// file, line and column.
SweepSpec read_sweep_spec(const std::string& path, const Parameters& parameters, const std::vector<std::string>& scene_folders);

}  // namespace bump
