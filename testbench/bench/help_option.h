#pragma once
// "--help" on the command line of a benchmark.

#include <cstdio>
#include <string>

namespace bump::bench {

/// Prints what the benchmark measures and how it is called, if it is asked.
inline bool gave_help(int argc, char* argv[], const char* about, const char* usage) {
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument != "--help" && argument != "-h") continue;
    std::printf("%s\nUsage: %s\n", about, usage);
    return true;
  }
  return false;
}

}  // namespace bump::bench
