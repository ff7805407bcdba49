#pragma once
// Version of the program and the compiler that built it.

#include <string>

namespace bump {

std::string version_text();   ///< "bumpsim 0.1.0"
std::string compiler_text();  ///< "g++ 12.2.0"

}  // namespace bump
