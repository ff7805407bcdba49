#include "rtl/word_text.h"

#include <fmt/core.h>

#include <algorithm>

#include "datapath/invariant.h"

namespace bump {

namespace {

/// `count` copies of the sign, or zeros; empty for none.
std::string front(const WordText& word, int count) {
  if (count == 0) return "";
  if (!word.is_signed) return fmt::format("{}'d0", count);
  const std::string sign = fmt::format("{}[{}]", word.name, word.width - 1);
  return count == 1 ? sign : fmt::format("{{{}{{{}}}}}", count, sign);
}

std::string bits(const WordText& word, int high, int low) {
  if (low == 0 && high == word.width - 1) return word.name;
  return high == low ? fmt::format("{}[{}]", word.name, low) : fmt::format("{}[{}:{}]", word.name, high, low);
}

std::string joined(const std::string& a, const std::string& b, const std::string& c) {
  std::string parts;
  int count = 0;
  for (const std::string& part : {a, b, c}) {
    if (part.empty()) continue;
    parts += (parts.empty() ? "" : ", ") + part;
    ++count;
  }
  return count == 1 ? parts : "{" + parts + "}";
}

std::string zeros_behind(int count) {
  return count == 0 ? "" : fmt::format("{}'d0", count);
}

}  // namespace

WordText word_text(const std::string& name, const Format& format) {
  return {name, format.width, format.is_signed, format.fraction};
}

std::string widened(const WordText& word, int width, int zeros) {
  BUMP_ASSERT(zeros >= 0 && width >= word.width + zeros);
  return joined(front(word, width - word.width - zeros), word.name, zeros_behind(zeros));
}

std::string rounded(const WordText& exact, const Format& to) {
  const int dropped = exact.fraction - to.fraction;
  const int low = std::max(0, dropped), zeros = std::min(std::max(0, -dropped), to.width);
  const int taken = to.width - zeros;  // places of the result that the exact number reaches
  if (taken == 0) return zeros_behind(zeros);
  if (low >= exact.width) return joined(front(exact, taken), "", zeros_behind(zeros));
  const int high = std::min(low + taken - 1, exact.width - 1);
  return joined(front(exact, taken - (high - low + 1)), bits(exact, high, low), zeros_behind(zeros));
}

}  // namespace bump
