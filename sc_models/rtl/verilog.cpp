#include "rtl/verilog.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "datapath/invariant.h"

namespace bump {

namespace {

/// Reserved words of Verilog-2001 and SystemVerilog that a netlist could use as a name.
constexpr std::array<const char*, 60> keywords = {
    "always", "and",     "assign", "begin",  "bind",   "bit",      "buf",    "case",  "cell",  "clocking", "config", "const",
    "cross",  "default", "design", "do",     "edge",   "else",     "end",    "event", "final", "for",      "force",  "function",
    "if",     "initial", "inout",  "input",  "inside", "instance", "int",    "join",  "large", "local",    "logic",  "medium",
    "module", "nand",    "nor",    "not",    "or",     "output",   "packed", "ref",   "reg",   "release",  "rand",   "real",
    "signed", "small",   "solve",  "static", "table",  "tagged",   "this",   "time",  "type",  "unsigned", "wire",   "xor"};

}  // namespace

std::string verilog_identifier(const std::string& name) {
  BUMP_ASSERT(!name.empty());
  std::string result = name;
  for (char& letter : result) {
    const bool allowed = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9');
    if (!allowed) letter = '_';
  }
  if (result.front() >= '0' && result.front() <= '9') result.insert(0, "_");
  if (std::find(keywords.begin(), keywords.end(), result) != keywords.end()) result += "_";
  return result;
}

std::string verilog_range(int width) {
  BUMP_ASSERT(width >= 1);
  return fmt::format("[{}:0] ", width - 1);
}

std::string verilog_word(std::int64_t word, int width) {
  BUMP_ASSERT(width >= 1 && width <= 64);
  return fmt::format("{}'d{}", width, static_cast<std::uint64_t>(word) & (~std::uint64_t{0} >> (64 - width)));
}

VerilogModule verilog_module(const std::string& name, const std::vector<std::string>& comment, const std::string& text) {
  VerilogModule module;
  module.name = name;
  for (const std::string& line : comment) module.text += line.empty() ? "//\n" : "// " + line + "\n";
  module.text += "`default_nettype none\n\n" + text + "\n`default_nettype wire\n";
  return module;
}

}  // namespace bump
