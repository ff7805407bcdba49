#pragma once
// Writes the ROMs of recorded datapaths to a folder: one image a table (rom_image.h) and manifest.json, which says for each image where it
// comes from, its formula, address rule, word layout, size, error bound and SHA-256. The same bytes every time.

#include <map>
#include <string>
#include <vector>

#include "datapath/table.h"

namespace bump {

/// A table and who reads it. The same table may come several times, from several units. Tables of vertex programs (real index or columns)
/// are not ROMs and are left out.
struct RomSource {
  std::string scheme, unit;
  TablePtr table;
};

/// File name to contents: "<scheme>_<table>.hex" and "manifest.json". Two tables of one scheme with one name must hold the same words:
/// Error(internal).
std::map<std::string, std::string> rom_files(const std::vector<RomSource>& sources);

/// Writes rom_files() to the folder, made if need be: all of them or, after an error, none (rom_folder.h). Files of other names are left
/// alone. Throws Error(input) with the path and the system's reason when the folder cannot be written.
void write_roms(const std::vector<RomSource>& sources, const std::string& folder);

/// Names of the files in `folder` that are missing or differ from rom_files(); empty when all are up to date.
std::vector<std::string> outdated_roms(const std::vector<RomSource>& sources, const std::string& folder);

}  // namespace bump
