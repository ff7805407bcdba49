#pragma once
// The one exception type for problems that a user can cause or mend. `main` turns its kind into the exit code.
// A broken invariant of the program itself is not an Error but BUMP_ASSERT (invariant.h).

#include <stdexcept>
#include <string>
#include <utility>

namespace bump {

/// The process exit code that an error leads to.
enum class ErrorKind {
  input = 2,       ///< bad scene, mesh, texture, configuration, argument or output folder
  deadlock = 3,    ///< the simulated hardware stopped making progress
  self_check = 4,  ///< a result contradicts itself: conservation, token count, stated image bound
  internal = 5,    ///< a fault of the program
  cancelled = 130  ///< the user interrupted the run
};

/// Where in a user's file the problem is; line and column count from 1, 0 means unknown.
struct Location {
  Location() = default;
  // A constructor, not an aggregate: g++ 12 takes temporaries of nested aggregates in throw expressions for uninitialised.
  Location(std::string in_file, int in_line = 0, int in_column = 0) : file(std::move(in_file)), line(in_line), column(in_column) {}

  std::string file;
  int line = 0;
  int column = 0;
};

/// What is wrong, where, why, and what to try. Each part is a lower-case phrase; empty parts are left out.
struct ErrorText {
  std::string what;
  Location where{};
  std::string why{};
  std::string try_this{};
};

class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, ErrorText text);
  /// Shorthand for bad input.
  explicit Error(ErrorText text) : Error(ErrorKind::input, std::move(text)) {}

  ErrorKind kind() const { return kind_; }
  const ErrorText& text() const { return text_; }

 private:
  ErrorKind kind_;
  ErrorText text_;
};

/// "file:line:column", without the parts that are unknown.
std::string to_string(const Location& where);

}  // namespace bump
