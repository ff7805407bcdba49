#pragma once
// Assertions that stay on in release builds: a broken invariant is a fault of the program (exit code 5), never of the user.

#include <string>

#include "datapath/error.h"

namespace bump {

[[noreturn]] inline void broken_invariant(const char* condition, const char* file, int line) {
  throw Error(ErrorKind::internal, {std::string("internal error: ") + condition + " does not hold", {file, line, 0}, "", "report this with the command that led to it"});
}

}  // namespace bump

#define BUMP_ASSERT(condition) \
  do {                         \
    if (!(condition)) ::bump::broken_invariant(#condition, __FILE__, __LINE__); \
  } while (false)
