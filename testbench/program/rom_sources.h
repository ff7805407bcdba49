#pragma once
// Every table that the per-pixel netlists of the registered schemes read.

#include <vector>

#include "channels/parameters.h"
#include "luts/write_roms.h"

namespace bump {

/// Tables whose contents follow the material are those of the default material.
std::vector<RomSource> rom_sources(const Configuration& configuration);

}  // namespace bump
