#pragma once
// A scheme's design with everything around it that has a netlist, and counts of its parts: what Table 1 is derived from. The scene is one
// triangle under one light, because counts, schedules and interpolants do not depend on more than the number of lights. No hardware of its
// own, no time.

#include <optional>
#include <string>
#include <string_view>

#include "channels/parameters.h"
#include "datapath/inventory.h"
#include "schemes/scheme.h"
#include "system/pipeline_timing.h"
#include "testbench/published/lee2007_table1.h"

namespace bump {

struct BuiltScheme {
  Design design;
  Netlist colour, interpolators, transform;
  int interpolator_components = 0;  ///< besides u, v
  DatapathSchedules schedules;
};

/// For one directional light of intensity 1 and the default material. Throws Error(input) if settings contradict one another.
BuiltScheme build_scheme(const Scheme& scheme, const Configuration& configuration);
/// For the lights of a scene and the material of its first object; materials change constants and table contents only.
BuiltScheme build_scheme(const Scheme& scheme, const Configuration& configuration, const Scene& scene);

/// The configuration with "key=value" settings on top, blanks between them. Throws Error(input) for a key that nobody declared.
Configuration with_settings(const Configuration& configuration, std::string_view settings);
/// Whether each of the settings has its value already.
bool has_settings(const Configuration& configuration, std::string_view settings);

/// One of Table 1's rows. With light maps the illumination step is what generates their address, the maps, and what makes an intensity of
/// them; colour blending only if asked for.
Inventory step_count(const BuiltScheme& built, std::string_view step, Portion portion, bool colour_blending);

/// The published portion of a part of a unit.
Inventory part_count(const Design& design, const published::Part& part);

/// Bytes of what the part's netlists (environment and illumination if it names no unit) keep; nullopt if there is no such thing.
std::optional<double> part_bytes(const BuiltScheme& built, const published::Part& part, published::Storage storage);

/// Bytes of all light maps of one object; 0 without.
double light_map_bytes(const Design& design);

}  // namespace bump
