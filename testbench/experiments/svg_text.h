#pragma once
// Text for SVG files. No model of hardware.

#include <string>

namespace bump {

/// As XML has it: marks escaped, control characters and bytes that are no UTF-8 replaced.
std::string xml_text(const std::string& text);

}  // namespace bump
