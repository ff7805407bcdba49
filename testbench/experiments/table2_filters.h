#pragma once
// One point of Table 2's dependence on the filter of the bump map: a scene by a polar scheme with `<scheme>.map_filter` set, measured
// against the conventional picture. Drawn in a child process without dates, as only the picture counts; the numbers come back as bytes
// (child_processes.h).

#include <string>

#include "channels/parameters.h"
#include "schemes/scheme.h"
#include "system/simulation.h"
#include "testbench/experiments/table2.h"

namespace bump {

/// In a child. Settings that do not go with the filter are a result, too; throws every Error that is not the user's.
std::string draw_filtered(const Scene& scene, const Scheme& scheme, const Configuration& configuration, const std::string& filter,
                          const FrameBuffer& conventional, SimulationOptions options);

/// The measures, or the reason why there are none.
void read_filtered(const std::string& bytes, Table2Filtered& picture);

}  // namespace bump
