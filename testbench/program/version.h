#pragma once
// Version of the program and the compiler that built it.

#include <string>

namespace bump {

std::string version_text();   ///< "bumpsim 0.1.0"
/// 16 hexadecimal digits over the sources from which results come: models, scene reading, reference, measuring, re-timing, rows. A change of
/// any of them changes it; compiler and folder do not. Made when the program is built (source_digest.cmake).
std::string models_digest();
std::string compiler_text();  ///< "g++ 12.2.0"

}  // namespace bump
