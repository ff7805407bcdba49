#pragma once
// The figures of a run that a comparison sets side by side, taken from its result document (result_json.h), so that they are those of a
// single run. One list for all formats: tables choose from it, CSV and JSON have it whole. No model of hardware.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace bump {

/// Operators as the metrics' names have them: "multipliers" ... "maps".
const std::vector<std::string>& operator_names();
/// Units whose netlists make the schemes differ: "environment", "illumination", "conversion", "light_map_address", "frame".
const std::vector<std::string>& compared_units();

/// An object of name and number (or word), the names, with their units, the same for every document. Not applicable is null, an infinite
/// ratio (identical images) infinite. `<unit>_<operators>` counts what the paper lists, `<unit>_additional_<operators>` what the design
/// needs beside it; operations and table reads per fragment are those of all compared units together, but of `frame`, whose work is done
/// once a frame.
nlohmann::ordered_json metrics_of(const nlohmann::ordered_json& result);

}  // namespace bump
