#include "testbench/program/version.h"

namespace bump {

std::string version_text() { return std::string("bumpsim ") + BUMP_VERSION; }

std::string compiler_text() {
#if defined(__clang__)
  return "clang++ " + std::to_string(__clang_major__) + "." + std::to_string(__clang_minor__) + "." + std::to_string(__clang_patchlevel__);
#else
  return "g++ " + std::to_string(__GNUC__) + "." + std::to_string(__GNUC_MINOR__) + "." + std::to_string(__GNUC_PATCHLEVEL__);
#endif
}

}  // namespace bump
