#include "small_unit.h"

#include <fmt/core.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "rtl/harness.h"
#include "rtl/makefile.h"
#include "rtl/test_bench.h"
#include "rtl/unit_vectors.h"

namespace bump_test {

namespace fs = std::filesystem;
using namespace bump;

Netlist small_netlist() {
  Netlist n("sums");
  const Wire a = n.input("a", sfixed(8, 0)), b = n.input("b", ufixed(5, 0));
  n.output("sum", n.add("sum", a, b, sfixed(9, 0)));
  n.output("difference", n.sub("difference", a, b, sfixed(9, 0)));
  return n;
}

DatapathModule small_datapath(const std::string& name, int latency, int interval) {
  DatapathModule datapath;
  datapath.name = name;
  datapath.inputs = {{"a", "a", sfixed(8, 0)}, {"b", "b", ufixed(5, 0)}};
  datapath.outputs = {{"sum", "sum", sfixed(9, 0)}, {"difference", "difference", sfixed(9, 0)}};
  datapath.latency = latency;
  datapath.initiation_interval = interval;
  datapath.has_clock = latency > 0 || interval > 1;
  std::string ports, body = "  wire [17:0] word_0 = {{in_a[7], in_a} + {4'd0, in_b}, {in_a[7], in_a} - {4'd0, in_b}};\n";
  if (datapath.has_clock) ports += "  input wire clk,\n";
  if (interval > 1) ports += fmt::format("  input wire [{}:0] phase,\n", interval > 4 ? 2 : interval > 2 ? 1 : 0);
  std::string last = "word_0";
  if (interval > 1 && latency == 0) {  // read in phase 0, held in the others
    body += "  reg [17:0] held;\n  always @(posedge clk) if (phase == 0) held <= word_0;\n";
    last = "(phase == 0 ? word_0 : held)";
  }
  for (int cycle = 1; cycle <= latency; ++cycle) {
    const std::string when = interval > 1 && cycle == 1 ? "if (phase == 0) " : "";
    body += fmt::format("  reg [17:0] word_{0};\n  always @(posedge clk) {1}word_{0} <= word_{2};\n", cycle, when, cycle - 1);
    last = fmt::format("word_{}", cycle);
  }
  body += fmt::format("  assign {{out_sum, out_difference}} = {};\n", last);
  datapath.text = verilog_module(name, {"Two sums."},
                                 fmt::format("module {} (\n{}  input wire [7:0] in_a,\n  input wire [4:0] in_b,\n"
                                             "  output wire [8:0] out_sum,\n  output wire [8:0] out_difference\n);\n{}endmodule\n",
                                             name, ports, body))
                      .text;
  return datapath;
}

SmallFolder::SmallFolder(int latency, int interval)
    : datapath_(small_datapath("tiny_sums_datapath", latency, interval)), unit_(unit_module("tiny", "sums", datapath_)) {
  std::string pattern = (fs::temp_directory_path() / "bumpsim-unit-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = pattern;
  restore();
}

SmallFolder::~SmallFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void SmallFolder::restore() const {
  const Netlist netlist = small_netlist();
  write("rtl/tiny_sums.v", unit_.module.text);
  write("rtl/tiny_sums_datapath.v", datapath_.text);
  write("test/sums.hex", unit_vectors(netlist, 200, 1));
  write("test/sums_tb.v", test_bench(unit_, 200));
  write("test/sums_ports.h", harness_ports(unit_));
  write("test/harness.cpp", harness_text());
  write("test/sums.ys", yosys_script(unit_, expected_cells(netlist, schedule(netlist, {}), datapath_)));
  write("Makefile", makefile_text("tiny", {unit_}));
}

void SmallFolder::write(const std::string& name, const std::string& text) const {
  fs::create_directories((path_ / name).parent_path());
  std::ofstream file(path_ / name, std::ios::binary);
  file << text;
  if (!file.flush()) throw std::runtime_error("cannot write " + name);
}

std::string SmallFolder::read(const std::string& name) const {
  std::ifstream file(path_ / name, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void SmallFolder::change(const std::string& name, const std::string& from, const std::string& to) const {
  std::string text = read(name);
  const std::size_t at = text.find(from);
  INFO(name << " should hold: " << from);
  REQUIRE(at != std::string::npos);
  write(name, text.replace(at, from.size(), to));
}

SmallFolder::Outcome SmallFolder::make(const std::string& arguments) const {
  const int status =
      std::system(("make -s -C '" + path_.string() + "' " + arguments + " >'" + path_.string() + "/said' 2>&1 </dev/null").c_str());
  return {status == 0, read("said")};
}

}  // namespace bump_test
