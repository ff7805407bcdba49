#include "rtl/leaf_text.h"

#include <fmt/core.h>

#include "datapath/invariant.h"

namespace bump {

namespace {

constexpr const char* lint_off = "  /* verilator lint_off UNUSED */\n";
constexpr const char* lint_on = "\n  /* verilator lint_on UNUSED */";

}  // namespace

std::string format_name(const Format& format) {
  const char* sign = format.is_signed ? "s" : "u";
  return format.fraction < 0 ? fmt::format("{}{}_m{}", sign, format.width, -format.fraction)
                             : fmt::format("{}{}_{}", sign, format.width, format.fraction);
}

std::string concatenation(const std::vector<std::string>& parts) {
  std::string text;
  int count = 0;
  for (const std::string& part : parts) {
    if (part.empty()) continue;
    if (++count > 1) text += ", ";
    text += part;
  }
  return count > 1 ? "{" + text + "}" : text;
}

std::string copies(const std::string& bit, int count) {
  if (count <= 0) return "";
  return count == 1 ? bit : fmt::format("{{{}{{{}}}}}", count, bit);
}

std::string bits_of(const std::string& word, int high, int low) {
  if (high < low) return "";
  return high == low ? fmt::format("{}[{}]", word, high) : fmt::format("{}[{}:{}]", word, high, low);
}

std::string zero_extended(const std::string& word, int from, int to) {
  return concatenation({copies("1'b0", to - from), word});
}

void LeafText::clock(Read read) {
  const std::string port = "  input  wire clk";
  ports_.push_back(read == Read::whole ? port : lint_off + port + lint_on);
}

void LeafText::input(const std::string& name, int width, Read read) {
  const std::string port = "  input  wire " + verilog_range(width) + name;
  ports_.push_back(read == Read::whole ? port : lint_off + port + lint_on);
}

void LeafText::output(const std::string& name, int width) {
  ports_.push_back("  output wire " + verilog_range(width) + name);
}

void LeafText::word(const std::string& name, int width, const std::string& expression, Read read) {
  const std::string text = "  wire " + verilog_range(width) + name + " = " + expression + ";";
  body_ += (read == Read::whole ? text : lint_off + text + lint_on) + "\n";
}

void LeafText::registers(const std::vector<Register>& bank) {
  if (bank.empty()) return;
  for (const Register& r : bank) {
    line("reg " + (r.width == 0 ? "" : verilog_range(r.width)) + r.name + ";");
    register_bits_ += r.width == 0 ? 1 : r.width;
  }
  line("always @(posedge clk) begin");
  for (const Register& r : bank) line("  " + r.name + " <= " + r.next + ";");
  line("end");
}

VerilogModule LeafText::module() const {
  BUMP_ASSERT(!ports_.empty());
  std::string text = "module " + name_ + " (\n";
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    // The comma belongs behind the port, in front of a pragma that closes on the next line.
    const std::string comma = i + 1 < ports_.size() ? "," : "";
    const std::size_t end = ports_[i].find(lint_on);
    text += end == std::string::npos ? ports_[i] + comma : ports_[i].substr(0, end) + comma + lint_on;
    text += "\n";
  }
  VerilogModule module = verilog_module(name_, comments_, text + ");\n" + body_ + "endmodule\n");
  module.register_bits = register_bits_;
  return module;
}

}  // namespace bump
