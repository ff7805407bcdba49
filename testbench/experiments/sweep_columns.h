#pragma once
// What a sweep tells of each point: the figures of a comparison (compare_metrics.h) and totals over the per-pixel datapaths, as columns of
// one table. No model of hardware.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "datapath/error.h"

namespace bump {

/// The names, with their units, the same for every point.
const std::vector<std::string>& sweep_columns();

/// The figures in that order, from a run's document (result_json.h); not applicable is null, an infinite ratio (identical images) "inf".
nlohmann::ordered_json sweep_values(const nlohmann::ordered_json& result);

/// What a row says of a failure: what, why and what to try, without the place, which need not be the user's.
std::string reason_of(const Error& error);

}  // namespace bump
