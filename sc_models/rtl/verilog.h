#pragma once
// What every emitted Verilog file has in common: names that the language allows, and the frame around a module. The text is Verilog-2001,
// for synthesis, one module to a file.

#include <cstdint>
#include <string>
#include <vector>

#include "datapath/format.h"

namespace bump {

/// A module of its own file, "rtl/<name>.v".
struct VerilogModule {
  std::string name;
  std::string text;                ///< the whole file
  std::int64_t register_bits = 0;  ///< of one instance
};

/// `name` with everything but letters, digits and '_' replaced by '_', e.g. "L.theta_x" to "L_theta_x". Keywords of the language and names
/// that begin with a digit get a '_' behind or in front.
std::string verilog_identifier(const std::string& name);

/// "[11:0] " for 12 bits; one bit is "[0:0] ", so that every word is a vector.
std::string verilog_range(int width);

/// "12'd5", two's complement for negative words, e.g. "4'd15" for -1.
std::string verilog_word(std::int64_t word, int width);

/// The file of a module: `comment` (lines without the slashes) in front, then `text`, with implicit nets switched off meanwhile.
VerilogModule verilog_module(const std::string& name, const std::vector<std::string>& comment, const std::string& text);

}  // namespace bump
