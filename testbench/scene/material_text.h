#pragma once
// Reads the lines of a Wavefront MTL material library before its parser does, which takes a damaged number for 0, drops what it does not
// know and mistakes options that it does not expect for the file's name: here a damaged colour is an error with its line, and whatever has
// no effect is named in a warning. Left out: the meaning of statements other than newmtl, Kd, map_Kd, map_Bump, bump and norm.

#include <string>
#include <vector>

#include "testbench/scene/file_name.h"

namespace bump {

/// The library reduced to what has an effect. Throws Error(input) with file and line for a Kd that is not three finite numbers. Warns, with
/// names, of statements and texture options without effect, of a -bm that is not a number from -1000 to 1000 (1 is used) and of colours
/// outside [0, 1].
std::string used_material_text(const std::string& text, const FileName& file, std::vector<std::string>& warnings);

}  // namespace bump
