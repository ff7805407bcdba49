#pragma once
// Assertions that stay on in release builds: a broken invariant is a fault of the program (exit code 5), never of the user.

#include <string>
#include <utility>

#include "datapath/error.h"

namespace bump {

[[noreturn]] inline void broken_invariant(const char* condition, const char* file, int line) {
  // Field by field: g++ 12 warns of uninitialised members when the whole aggregate is a temporary of the throw expression.
  ErrorText text;
  text.what = std::string("internal error: ") + condition + " does not hold";
  text.where.file = file;
  text.where.line = line;
  text.try_this = "report this with the command that led to it";
  throw Error(ErrorKind::internal, std::move(text));
}

}  // namespace bump

#define BUMP_ASSERT(condition) \
  do {                         \
    if (!(condition)) ::bump::broken_invariant(#condition, __FILE__, __LINE__); \
  } while (false)
