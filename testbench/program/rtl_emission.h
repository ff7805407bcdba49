#pragma once
// A scheme's units as Verilog with everything that checks them: what `bumpsim rtl` writes, before it is written.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "channels/parameters.h"
#include "datapath/inventory.h"
#include "datapath/schedule.h"
#include "rtl/expected_cells.h"
#include "rtl/unit_module.h"
#include "schemes/scheme.h"
#include "units/scene.h"

namespace bump {

struct EmittedUnit {
  RtlUnit wrapper;
  DatapathModule datapath;
  Schedule schedule;
  Inventory built;  ///< of the netlist; multipliers are products, whether they share one or not
  ExpectedCells cells;
};

struct Emission {
  std::string scheme;
  std::vector<EmittedUnit> units;
  std::map<std::string, std::string> files;  ///< path to text: Verilog, ROM images, vectors, test benches, harness, scripts and Makefile
};

struct EmissionOptions {
  std::vector<std::string> units;  ///< by name; none: all datapath units of the scheme
  std::string scene;               ///< whose material it is, as the user named it; empty: the default material
  Material material;               ///< what tables and constants that follow the material hold
  int vectors = 1000;              ///< of each unit, >= 2
  std::uint64_t seed = 1;
};

/// Throws Error(input) for units that the scheme does not have
/// or that are programs, and if the configuration asks for double precision.
Emission emit(const Scheme& scheme, const Configuration& configuration, const EmissionOptions& options);

}  // namespace bump
