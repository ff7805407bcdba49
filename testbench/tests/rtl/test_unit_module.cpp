// The wrapper of a unit against the recurrences of its stage, computed here from their definition.

#include <fmt/core.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <sstream>

#include "datapath/evaluate.h"
#include "rtl/unit_module.h"
#include "rtl/unit_vectors.h"
#include "small_unit.h"
#include "verilog_tools.h"

using namespace bump;
using namespace bump_test;
using Catch::Contains;

namespace {

constexpr int tokens = 60, cycles = 1200;

/// A unit, when its tokens come, and when its reader is ready.
struct Trial {
  RtlUnit unit;
  DatapathModule datapath;
  int capacity = 1, tail = 0;
  std::vector<int> arrival;
  std::vector<bool> ready;
};

Trial random_trial(int number, std::mt19937_64& random) {
  Trial trial;
  const int latency = integer(random, 0, 9), interval = integer(random, 1, 5);
  const std::string name = fmt::format("t{}", number);
  trial.datapath = small_datapath(name + "_sums_datapath", latency, interval);
  trial.unit = unit_module(name, "sums", trial.datapath);
  trial.capacity = integer(random, 1, trial.unit.latency + 3);
  trial.tail = integer(random, 0, 1) * integer(random, 0, 6);
  const int pause = integer(random, 0, 12), lazy = integer(random, 0, 7);
  int at = 0;
  for (int k = 0; k < tokens; ++k) trial.arrival.push_back(at += integer(random, 0, 1) * integer(random, 0, pause));
  // Ready for good in the end, so that all tokens come out.
  for (int t = 0; t < cycles; ++t) trial.ready.push_back(t > cycles / 2 || integer(random, 0, 7) >= lazy);
  return trial;
}

/// "s 12" for every start and "w 15" for every delivery, in order.
std::string by_recurrence(const Trial& trial) {
  const int latency = trial.unit.latency + trial.tail, interval = trial.unit.initiation_interval;
  std::vector<int> s, w;
  std::string text;
  for (int k = 0; k < tokens; ++k) {
    const auto at = static_cast<std::size_t>(k);
    int start = trial.arrival[at];
    if (k > 0) start = std::max(start, s[at - 1] + interval);
    if (k >= trial.capacity) start = std::max(start, w[at - static_cast<std::size_t>(trial.capacity)] + 1);
    int done = start + latency;
    if (k > 0) done = std::max(done, w[at - 1] + 1);
    while (!trial.ready[static_cast<std::size_t>(done)]) ++done;
    s.push_back(start);
    w.push_back(done);
  }
  for (const int start : s) text += fmt::format("s {}\n", start);
  for (int k = 0; k < tokens; ++k) {
    const int a = (k * 37 + 11) % 256, b = (k * 7) % 32, word = a < 128 ? a : a - 256;
    text += fmt::format("w {} {} {}\n", w[static_cast<std::size_t>(k)], (word + b) & 511, (word - b) & 511);
  }
  return text;
}

/// Replays arrivals and readiness on a unit; starts go to one file, deliveries to another.
std::string replay_module(const Trial& trial, int number) {
  return fmt::format(R"(
module replay_{0};
  reg clk, reset;
  reg [31:0] arrival[0:{1}];
  reg ready[0:{2}];
  integer cycle, taken, starts, ends;
  wire in_ready, out_valid;
  wire in_valid = !reset && taken < {3} && cycle >= arrival[taken];
  wire out_ready = !reset && ready[cycle];
  wire [7:0] a = in_valid ? taken * 37 + 11 : ~cycle;  // what is not valid must not matter
  wire [4:0] b = in_valid ? taken * 7 : cycle;
  wire [8:0] sum, difference;
  {4} #(.CAPACITY({5}), .TAIL({7})) unit (
      .clk(clk), .reset(reset), .in_valid(in_valid), .in_ready(in_ready), .in_a(a), .in_b(b),
      .out_valid(out_valid), .out_ready(out_ready), .out_sum(sum), .out_difference(difference));
  always #5 clk = ~clk;
  initial begin
    $readmemh("arrival_{0}.hex", arrival);
    $readmemb("ready_{0}.bin", ready);
    starts = $fopen("starts_{0}", "w");
    ends = $fopen("ends_{0}", "w");
    clk = 0; reset = 1; cycle = 0; taken = 0;
    repeat ({6}) @(posedge clk);  // units leave the reset in any phase of the others
    @(negedge clk) reset = 0;
  end
  always @(posedge clk) if (!reset) begin
    if (in_valid && in_ready) begin
      $fdisplay(starts, "s %0d", cycle);
      taken <= taken + 1;
    end
    if (out_valid && out_ready) $fdisplay(ends, "w %0d %0d %0d", cycle, sum, difference);
    cycle <= cycle + 1;
    if (cycle == {2}) $finish;
  end
endmodule
)",
                     number, tokens - 1, cycles - 1, tokens, trial.unit.module.name, trial.capacity, 2 + number % 3, trial.tail);
}

}  // namespace

TEST_CASE("tokens start and are delivered in the cycles of the recurrences") {
  if (!is_there("iverilog")) return;
  std::mt19937_64 random(1);
  const SmallFolder folder(1, 1);  // for its files
  std::vector<Trial> trials;
  std::string commands;
  for (int i = 0; i < 40; ++i) {
    trials.push_back(random_trial(i, random));
    const Trial& trial = trials.back();
    std::string arrivals, readiness;
    for (const int arrival : trial.arrival) arrivals += fmt::format("{:x}\n", arrival);
    for (const bool ready : trial.ready) readiness += ready ? "1\n" : "0\n";
    folder.write(fmt::format("arrival_{}.hex", i), arrivals);
    folder.write(fmt::format("ready_{}.bin", i), readiness);
    folder.write(fmt::format("all_{}.v", i), trial.datapath.text + trial.unit.module.text + replay_module(trial, i));
    commands += fmt::format(" && iverilog -g2001 -o t{0} -s replay_{0} all_{0}.v && vvp -N t{0} >>log", i);
  }
  REQUIRE(std::system(("cd '" + folder.path().string() + "'" + commands).c_str()) == 0);
  for (int i = 0; i < 40; ++i) {
    const Trial& trial = trials[static_cast<std::size_t>(i)];
    CAPTURE(i, trial.datapath.latency, trial.datapath.initiation_interval, trial.capacity, trial.tail);
    CHECK(folder.read(fmt::format("starts_{}", i)) + folder.read(fmt::format("ends_{}", i)) == by_recurrence(trial));
  }
}

TEST_CASE("lint has nothing to say of a unit, whatever its timing") {
  if (!is_there("verilator")) return;
  for (const auto& [latency, interval, capacity] :
       {std::tuple{0, 1, 0}, std::tuple{1, 1, 1}, std::tuple{7, 1, 0}, std::tuple{0, 2, 2}, std::tuple{3, 3, 0}, std::tuple{9, 5, 64}}) {
    const DatapathModule datapath = small_datapath("tiny_sums_datapath", latency, interval);
    const RtlUnit unit = unit_module("tiny", "sums", datapath, capacity);
    CAPTURE(latency, interval, capacity);
    CHECK(lint({unit.module, {datapath.name, datapath.text}}) == "");
  }
}

TEST_CASE("a unit of no cycles takes one, and sharing counts the longest wait for a turn") {
  CHECK(unit_module("s", "u", small_datapath("d", 0, 1)).latency == 1);
  CHECK(unit_module("s", "u", small_datapath("d", 5, 1)).latency == 5);
  CHECK(unit_module("s", "u", small_datapath("d", 5, 3)).latency == 7);
  CHECK(unit_module("s", "u", small_datapath("d", 5, 3)).capacity == 8);
  CHECK(unit_module("s", "u", small_datapath("d", 5, 3), 2).capacity == 2);
}

TEST_CASE("the test bench passes what is right and names what is wrong") {
  if (!is_there("iverilog") || !is_there("make")) return;
  for (const auto& [latency, interval] : {std::pair{4, 1}, std::pair{0, 1}, std::pair{3, 3}}) {
    const SmallFolder folder(latency, interval);
    const int l = std::max(1, latency + interval - 1);
    CAPTURE(latency, interval);
    for (const char* capacity : {"", "CAPACITY=1", "CAPACITY=3"}) {
      const SmallFolder::Outcome right = folder.make(std::string("test SEED=5 ") + capacity);
      INFO(right.said);
      CHECK(right.passed);
      if (*capacity == '\0')
        CHECK_THAT(right.said, Contains(fmt::format("sums: 200 vectors, 0 mismatches, latency {}, interval {}\n", l, interval)));
    }
    const auto fails = [&](const std::string& arguments, const std::string& says) {
      const SmallFolder::Outcome wrong = folder.make("test " + arguments);
      INFO(wrong.said);
      CHECK_FALSE(wrong.passed);
      CHECK_THAT(wrong.said, Contains(says));
      folder.restore();
    };
    const std::string unit = "rtl/tiny_sums.v";
    folder.change(unit, "assign in_ready = ", "assign in_ready = out_ready || ");
    fails("", "in_ready is 1 instead of 0");
    folder.change(unit, "if (push) queue[tail]", "if (push && tail != LAST) queue[tail]");
    fails("CAPACITY=3", "instead of");
    folder.change(unit, "else if (give && !take)", "else if (give && take)");
    fails("", "in_ready is ");
    folder.change(unit, "out_valid = finished ||", "out_valid =");
    fails("", "out_valid is 0 instead of 1");
    folder.change(unit, "if (reset) credits", "if (reset && credits === 1'bx) credits");
    fails("CAPACITY=2", "in_ready is ");
    folder.change(unit, "      head <= {INDEX_BITS{1'b0}};\n", "");
    folder.change(unit, "reg [INDEX_BITS-1:0] head, tail;", "reg [INDEX_BITS-1:0] head, tail;\n  initial head = 0;");
    fails("CAPACITY=3", "round 3");
    folder.change("rtl/tiny_sums_datapath.v", "{in_a[7], in_a} - ", "{in_a[7], in_a} + ");
    fails("", "vector ");
    fails("VECTORS=201", "has only 200 vectors");
    std::filesystem::remove(folder.path() / "test/sums.hex");
    fails("", "cannot read test/sums.hex");
  }
}

TEST_CASE("the harness around Verilator's model passes what is right and names what is wrong") {
  if (!is_there("verilator") || !is_there("make") || !is_there("g++")) return;
  const SmallFolder folder(2, 2);
  const SmallFolder::Outcome right = folder.make("verilate SEED=3 CXXFLAGS=-O0");
  INFO(right.said);
  REQUIRE(right.passed);
  CHECK_THAT(right.said, Contains("sums: 200 vectors, 0 mismatches, latency 3, interval 2\n"));
  const auto fails = [&](const std::string& arguments, const std::string& says) {
    const SmallFolder::Outcome wrong = folder.make("verilate CXXFLAGS=-O0 " + arguments);
    INFO(wrong.said);
    CHECK_FALSE(wrong.passed);
    CHECK_THAT(wrong.said, Contains(says));
  };
  fails("VECTORS=many", "VECTORS=many is no number");
  fails("VECTORS=201", "has only 200 vectors");
  const std::string vectors = folder.read("test/sums.hex");
  std::string wrong = vectors;
  wrong[7] = wrong[7] == '0' ? '1' : '0';  // the last digit of the first vector
  folder.write("test/sums.hex", wrong);
  fails("", "output difference is");
  fails("", "200 vectors, 22 mismatches");  // in either round, and after each of 20 resets
  folder.write("test/sums.hex", vectors.substr(0, vectors.size() - 3));
  fails("", "does not consist of lines of 8 digits");
  folder.restore();
  folder.change("rtl/tiny_sums.v", "      head <= {INDEX_BITS{1'b0}};\n", "");
  folder.change("rtl/tiny_sums.v", "reg [INDEX_BITS-1:0] head, tail;", "reg [INDEX_BITS-1:0] head, tail;\n  initial head = 0;");
  fails("CAPACITY=3", "round 3");
}

TEST_CASE("operators are counted by Yosys") {
  if (!is_there("yosys") || !is_there("make")) return;
  const SmallFolder folder(3, 2);
  const SmallFolder::Outcome right = folder.make("counts");
  INFO(right.said);
  CHECK(right.passed);
  CHECK_THAT(right.said, Contains("sums: 0 multipliers, 2 adders"));
  folder.change("rtl/tiny_sums_datapath.v", "{in_a[7], in_a} - {4'd0, in_b}", "{in_a[7], in_a}");
  const SmallFolder::Outcome wrong = folder.make("counts");
  CHECK_FALSE(wrong.passed);
  CHECK_THAT(wrong.said, Contains("tiny_sums_datapath/t:$add"));
}

TEST_CASE("vectors hold corners, then any words, and what the hardware makes of them") {
  const Netlist netlist = small_netlist();
  std::istringstream lines(unit_vectors(netlist, 600, 3));
  std::string line;
  int count = 0, corners = 0;
  std::vector<bool> seen_a(256), seen_b(32);
  for (; std::getline(lines, line); ++count) {
    REQUIRE(line.size() == 8);  // 8 + 5 + 9 + 9 bits
    const auto word = static_cast<std::int64_t>(std::stoull(line, nullptr, 16));
    const std::int64_t a = wrap(word >> 23, sfixed(8, 0)), b = (word >> 18) & 31;
    CHECK(wrap(word >> 9, sfixed(9, 0)) == a + b);
    CHECK(wrap(word, sfixed(9, 0)) == a - b);
    seen_a[static_cast<std::size_t>(a & 255)] = seen_b[static_cast<std::size_t>(b)] = true;
    if (count < 150 && (a == 0 || a == 1 || a == -1 || a == -128 || a == 127)) ++corners;
  }
  CHECK(count == 600);
  CHECK(corners > 30);
  CHECK(std::count(seen_a.begin(), seen_a.end(), true) > 180);
  CHECK(std::count(seen_b.begin(), seen_b.end(), true) == 32);
  CHECK(unit_vectors(netlist, 600, 3) == unit_vectors(netlist, 600, 3));
  CHECK(unit_vectors(netlist, 600, 3) != unit_vectors(netlist, 600, 4));
}
