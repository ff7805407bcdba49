#pragma once
// The pictures behind Table 2 as a folder: what each method drew, where the proposed one is off, and the table itself. It appears complete
// or not at all (results/pending_folder.h). No model of hardware.
//
//   table2.json                                   the table (table2_formats.h)
//   <scene>-conventional.png, <scene>-blinn.png   the references; the second where the scene has heights
//   <scene>-<space>-kim.png, -proposed.png        as the hardware draws them
//   <scene>-<space>-error.png                     proposed against conventional (reference/quality.h, error_image)

#include <string>

#include "channels/parameters.h"
#include "testbench/experiments/table2.h"

namespace bump {

/// Throws Error(input) if the folder cannot be written or is in use; call it before long work.
void check_table2_pictures(const std::string& folder, bool force);
/// An earlier folder of the same kind is replaced only with `force`.
void write_table2_pictures(const std::string& folder, const Table2& table, const Configuration& configuration, bool force);

}  // namespace bump
