#pragma once
// What an emitted folder says of itself: rtl.json for programs, README.md for people, and the lines that the command prints.

#include <nlohmann/json.hpp>
#include <string>

#include "testbench/program/rtl_emission.h"

namespace bump {

/// rtl.json: schema, version, scheme, what the configuration changes, the scene whose material it has (or null), and each unit's modules,
/// ports, cycles, inventory, the cells that a synthesis tool must find, and register bits. Lists all files but itself.
nlohmann::ordered_json rtl_manifest(const Emission& emission, const Configuration& configuration, const EmissionOptions& options);

/// README.md of the folder.
std::string rtl_readme(const Emission& emission, const Configuration& configuration, const EmissionOptions& options);

/// A line a unit.
std::string rtl_summary(const Emission& emission);

}  // namespace bump
