#pragma once
// From netlists and execution counts to what a run reports: the cost of each unit and the use of each table.

#include <string>
#include <vector>

#include "system/pipeline_timing.h"
#include "system/simulation.h"
#include "units/light_map_fetch.h"

namespace bump {

/// A per-pixel netlist with its schedule (null for programs on ALUs and interpolators).
UnitCost unit_cost(const std::string& name, const Netlist& netlist, const Schedule* schedule, std::int64_t executions);

/// Filling the light maps: the frame netlist with the sum over the lights, executed once for every entry, its part for each light as
/// `per_light`.
UnitCost frame_cost(const LightMaps& maps, const std::vector<Light>& lights, std::int64_t executions);

/// Adds the bits of the further copies that tables with contents by material need.
void keep_tables_per_material(UnitCost& cost, const Netlist& netlist, int materials);

/// One row for each distinct table of the netlist, published and additional reads apart. `materials`: sets of contents kept for tables that
/// follow the material.
std::vector<TableUse> table_uses(const std::string& unit, const Netlist& netlist, std::int64_t executions, int materials);

/// What was written into the maps and read from them.
std::vector<LightMapUse> light_map_uses(const LightMaps& maps, const LightMapFetch& fetch);

}  // namespace bump
