#pragma once
// Configuration files and --set: TOML whose tables are module paths, so that [texture_fetch.cache] ways = 4 sets the parameter
// "texture_fetch.cache.ways". Strict: a key that nobody declared, a value of another type or outside its range is an error with file, line
// and column, the nearest key and the allowed range. Later files and settings win.

#include <string>

#include "channels/parameters.h"

namespace bump {

/// Applies every key of the file to `configuration`. Throws Error(input).
void read_configuration(const std::string& path, Configuration& configuration);

/// Applies TOML text; `file` is the name used in locations.
void read_configuration_text(const std::string& text, const std::string& file, Configuration& configuration);

/// Applies one "key=value" of the command line. Throws Error(input).
void apply_setting(const std::string& key_equals_value, Configuration& configuration);

/// All resolved values as TOML that read_configuration() accepts and that gives the same values; each line ends with a comment: where the
/// value came from ("default", "file:line", "--set"), its range and its meaning.
std::string to_toml(const Configuration& configuration);

}  // namespace bump
