#pragma once
// "a,b,c" on the command line of a benchmark.

#include <string>
#include <vector>

namespace bump::bench {

inline std::vector<std::string> list_option(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char letter : text) {
    if (letter == ',')
      parts.emplace_back();
    else
      parts.back() += letter;
  }
  return parts;
}

}  // namespace bump::bench
