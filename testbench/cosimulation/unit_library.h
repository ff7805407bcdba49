#pragma once
// Translated units as shared libraries, "<unit>.so" in a folder, made of verilated/unit.cpp and what Verilator wrote. They stay loaded
// until the program ends: modules of theirs may live as long.

#include <memory>
#include <string>
#include <vector>

#include "testbench/cosimulation/rtl_pins.h"

namespace bump {

/// Which of "environment" and "illumination" are in a folder. Throws Error(input) if none is.
std::vector<std::string> units_in(const std::string& folder);
/// Throws Error(input) with the loader's reason.
std::unique_ptr<RtlPins> load_unit(const std::string& folder, const std::string& unit);

}  // namespace bump
