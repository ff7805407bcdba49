#pragma once
// Puts the shards of a sweep together: a folder as the whole sweep would have left it. No model of hardware.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace bump {

/// The folders, each once: `repeated` gets those that were named again.
std::vector<std::string> distinct_folders(const std::vector<std::string>& folders, std::vector<std::string>& repeated);

/// `folders`: finished shards of one sweep, which cover it; points that several of them have must agree. Returns the manifest. Throws
/// Error(input): a folder that is no finished sweep, of another specification, or of another program; points that are missing, or that
/// differ; an output folder in use (`force` replaces an earlier sweep).
nlohmann::ordered_json merge_sweeps(const std::vector<std::string>& folders, const std::string& out, bool force);

}  // namespace bump
