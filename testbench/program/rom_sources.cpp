#include "testbench/program/rom_sources.h"

#include "testbench/program/scheme_units.h"

namespace bump {

std::vector<RomSource> rom_sources(const Configuration& configuration) {
  std::vector<RomSource> sources;
  for (const Scheme* scheme : all_schemes()) {
    const Design design = scheme->design(configuration, Material{});
    for (const NamedNetlist& unit : units_of(design)) {
      if (!unit.is_datapath) continue;  // its functions are the arithmetic units' own, not ROMs
      for (const TablePtr& table : unit.netlist->tables()) sources.push_back({scheme->page().id, unit.name, table});
    }
  }
  return sources;
}

}  // namespace bump
