#pragma once
// The configuration of a command: declared defaults, then configuration files in order, then --set, each winning over what came before.

#include <string>
#include <vector>

#include "channels/parameters.h"

namespace bump {

Configuration configure(const std::vector<std::string>& files, const std::vector<std::string>& settings);

}  // namespace bump
