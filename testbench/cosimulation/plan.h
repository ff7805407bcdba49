#pragma once
// What must be known to translate the emitted units of a scheme for a scene: their top modules, the parameters that make them stages of
// this pipeline, their ports, and the tables of the scene's material. No hardware.

#include <map>
#include <string>
#include <vector>

#include "channels/parameters.h"
#include "schemes/scheme.h"
#include "units/scene.h"

namespace bump {

struct PlannedUnit {
  std::string unit;           ///< "environment" or "illumination"
  std::string top;            ///< its module
  std::int64_t capacity = 0;  ///< parameter CAPACITY
  std::int64_t tail = 0;      ///< parameter TAIL, cycles of what follows in the same stage
  std::string ports;          ///< the header that verilated/unit.cpp includes
  /// Verilog and ROM images with the constants and tables of the scene's material: path in the emitted folder to text.
  std::map<std::string, std::string> files;
};

/// Units without operands or results are wiring, and left out. Throws Error(input) like check_cosimulation().
std::vector<PlannedUnit> plan_units(const Scene& scene, const Scheme& scheme, const Configuration& configuration);

/// Throws Error(input) if a file of the emitted folder is not there or another than planned: emitted for another configuration or material.
void check_emitted(const std::vector<PlannedUnit>& units, const std::string& folder);

}  // namespace bump
