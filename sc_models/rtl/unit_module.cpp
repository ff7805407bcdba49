#include "rtl/unit_module.h"

#include <fmt/core.h>

#include <algorithm>

#include "datapath/invariant.h"

namespace bump {

namespace {

using Ports = std::vector<DatapathModule::Port>;

/// Bits that hold the numbers 0 to n, at least one.
int bits_of(int n) {
  int bits = 1;
  for (int rest = n >> 1; rest > 0; rest >>= 1) ++bits;
  return bits;
}

/// Then the unit registers its words: a stage has a latency of one cycle at least.
bool is_combinational(const DatapathModule& datapath) {
  return datapath.latency + datapath.initiation_interval - 1 == 0;
}

/// "{in_a, in_b}", the first port in the highest bits.
std::string concatenation(const Ports& ports, const std::string& prefix) {
  std::string text;
  for (const auto& port : ports) text += (text.empty() ? "{" : ", ") + prefix + port.verilog;
  return text + "}";
}

struct Declaration {
  std::string text, comment;
};

void declare(std::vector<Declaration>& to, const Ports& ports, const std::string& direction, const std::string& prefix) {
  for (const auto& port : ports)
    to.push_back({direction + verilog_range(port.format.width) + prefix + port.verilog, port.name + ", " + to_string(port.format)});
}

std::string header(const RtlUnit& unit) {
  std::vector<Declaration> ports = {{"input wire clk", ""},
                                    {"input wire reset", "synchronous; clears the control, not the words"},
                                    {"input wire in_valid", ""},
                                    {"output wire in_ready", ""}};
  declare(ports, unit.inputs, "input wire ", "in_");
  ports.push_back({"output wire out_valid", ""});
  ports.push_back({"input wire out_ready", ""});
  declare(ports, unit.outputs, "output wire ", "out_");
  const int busy = (unit.latency + unit.initiation_interval) / unit.initiation_interval;
  std::string text = fmt::format(
      "module {} #(\n  parameter CAPACITY = {},  // tokens in flight, from 1; {} keep the unit busy\n"
      "  parameter TAIL = 0  // cycles that a token stays after L: of a fixed unit behind this one\n) (\n",
      unit.module.name, unit.capacity, busy);
  for (const Declaration& port : ports)
    text += fmt::format("  {}{}{}{}\n", port.text, &port == &ports.back() ? "" : ",", port.comment.empty() ? "" : "  // ", port.comment);
  return text + ");\n\n";
}

const char* const constants = R"(  // Bits that hold the numbers 0 to n.
  function integer bits_of;
    input integer n;
    integer rest;
    begin
      bits_of = 1;
      for (rest = n >> 1; rest > 0; rest = rest >> 1) bits_of = bits_of + 1;
    end
  endfunction

  localparam COUNT_BITS = bits_of(CAPACITY);
  localparam INDEX_BITS = bits_of(CAPACITY - 1);
  localparam [31:0] BEHIND = CAPACITY - 1;
  localparam [COUNT_BITS-1:0] ALL = CAPACITY[COUNT_BITS-1:0];
  localparam [INDEX_BITS-1:0] LAST = BEHIND[INDEX_BITS-1:0];

  wire take = in_valid && in_ready;    // a token starts
  wire give = out_valid && out_ready;  // a token is delivered

  // Credits: room for tokens in flight. One that comes back counts from the next cycle on.
  reg [COUNT_BITS-1:0] credits;
  always @(posedge clk) begin
    if (reset) credits <= ALL;
    else if (take && !give) credits <= credits - 1'b1;
    else if (give && !take) credits <= credits + 1'b1;
  end

)";

/// Interval, phase and entry register of shared multipliers; and the operands that the datapath reads.
std::string entry(const RtlUnit& unit, int in_bits) {
  const std::string operands = concatenation(unit.inputs, "in_");
  const int interval = unit.initiation_interval;
  if (interval == 1)
    return fmt::format("  assign in_ready = credits != {{COUNT_BITS{{1'b0}}}};\n\n  wire [{}:0] operands = {};\n\n", in_bits - 1, operands);
  return fmt::format(R"(  // A token starts every {0} cycles at most.
  reg [{1}:0] pause;
  always @(posedge clk) begin
    if (reset) pause <= {2};
    else if (take) pause <= {3};
    else if (pause != {2}) pause <= pause - 1'b1;
  end
  assign in_ready = pause == {2} && credits != {{COUNT_BITS{{1'b0}}}};

  // The multipliers' round: operands are read in phase 0. A token that starts in another phase waits here for the next round.
  reg [{1}:0] phase;
  reg pending;
  reg [{4}:0] entry;
  always @(posedge clk) begin
    if (reset || phase == {3}) phase <= {2};
    else phase <= phase + 1'b1;
    if (reset || phase == {2}) pending <= 1'b0;
    else if (take) pending <= 1'b1;
    if (take) entry <= {5};
  end
  wire [{4}:0] operands = pending ? entry : {5};

)",
                     interval, bits_of(interval - 1) - 1, verilog_word(0, bits_of(interval - 1)),
                     verilog_word(interval - 1, bits_of(interval - 1)), in_bits - 1, operands);
}

std::string starts(const RtlUnit& unit) {
  return fmt::format(R"(  // Starts of this and of the last SPAN cycles: the oldest says that a token is finished.
  localparam SPAN = {} + TAIL;
  reg [SPAN-1:0] started;
  wire [SPAN:0] starts = {{started, take}};
  always @(posedge clk) begin
    if (reset) started <= {{SPAN{{1'b0}}}};
    else started <= starts[SPAN-1:0];
  end
  wire finished = starts[SPAN];

)",
                     unit.latency);
}

std::string datapath_instance(const RtlUnit& unit, const DatapathModule& datapath, int out_bits) {
  std::string wires, connections;
  int high = word_bits(unit.inputs) - 1;
  for (const auto& port : unit.inputs) {
    connections += fmt::format(",\n      .in_{}(operands[{}:{}])", port.verilog, high, high - port.format.width + 1);
    high -= port.format.width;
  }
  for (const auto& port : unit.outputs) {
    wires += fmt::format("  wire {}word_{};\n", verilog_range(port.format.width), port.verilog);
    connections += fmt::format(",\n      .out_{0}(word_{0})", port.verilog);
  }
  if (datapath.initiation_interval > 1) connections.insert(0, ",\n      .phase(phase)");
  if (datapath.has_clock) connections.insert(0, ",\n      .clk(clk)");
  const std::string words = concatenation(unit.outputs, "word_");
  std::string text = wires + fmt::format("  {} datapath (\n{}\n  );\n", datapath.name, connections.substr(2));
  const int interval = datapath.initiation_interval;
  if (interval > 1)
    return text + fmt::format(R"(  // The datapath shows a result for one cycle of the round; it is kept until it is asked for.
  wire fresh = phase == {0};
  reg [{1}:0] kept;
  always @(posedge clk) if (fresh) kept <= {2};
  wire [{1}:0] result = fresh ? {2} : kept;

)",
                              verilog_word(datapath.latency % interval, bits_of(interval - 1)), out_bits - 1, words);
  if (!is_combinational(datapath)) return text + fmt::format("  wire [{}:0] result = {};\n\n", out_bits - 1, words);
  return text + fmt::format(R"(  // The datapath takes no cycle, the unit one.
  reg [{}:0] result;
  always @(posedge clk) result <= {};

)",
                            out_bits - 1, words);
}

/// Nothing by default.
std::string tail(int out_bits) {
  return fmt::format(R"(  // Results wait for the unit behind.
  wire [{0}:0] released;
  generate
    if (TAIL == 0) begin : without_tail
      assign released = result;
    end else begin : with_tail
      reg [{1}*TAIL-1:0] line;
      wire [{1}*(TAIL+1)-1:0] results = {{line, result}};
      always @(posedge clk) line <= results[{1}*TAIL-1:0];
      assign released = results[{1}*TAIL +: {1}];
    end
  endgenerate

)",
                     out_bits - 1, out_bits);
}

std::string completion_queue(const RtlUnit& unit, int out_bits) {
  return fmt::format(R"(  // Completion queue, passed by when it is empty and the reader is ready.
  reg [{0}:0] queue[0:CAPACITY-1];
  reg [INDEX_BITS-1:0] head, tail;
  reg [COUNT_BITS-1:0] waiting;
  wire empty = waiting == {{COUNT_BITS{{1'b0}}}};
  wire push = finished && !(empty && out_ready);
  wire pop = !empty && out_ready;
  always @(posedge clk) begin
    if (reset) begin
      head <= {{INDEX_BITS{{1'b0}}}};
      tail <= {{INDEX_BITS{{1'b0}}}};
      waiting <= {{COUNT_BITS{{1'b0}}}};
    end else begin
      if (push) tail <= tail == LAST ? {{INDEX_BITS{{1'b0}}}} : tail + 1'b1;
      if (pop) head <= head == LAST ? {{INDEX_BITS{{1'b0}}}} : head + 1'b1;
      if (push && !pop) waiting <= waiting + 1'b1;
      else if (pop && !push) waiting <= waiting - 1'b1;
    end
    if (push) queue[tail] <= released;
  end
  assign out_valid = finished || !empty;
  assign {1} = empty ? released : queue[head];

endmodule
)",
                     out_bits - 1, concatenation(unit.outputs, "out_"));
}

std::vector<std::string> comment(const std::string& scheme, const RtlUnit& unit) {
  std::vector<std::string> lines = {
      fmt::format("The {} unit of {}: it takes a token every {} at most and is done with it {} later.", unit.unit, scheme,
                  unit.initiation_interval == 1 ? "cycle" : fmt::format("{} cycles", unit.initiation_interval),
                  unit.latency == 1 ? "1 cycle" : fmt::format("{} cycles", unit.latency)),
      "A token is taken at the edge that ends a cycle with in_valid and in_ready, and delivered at that of one with out_valid and",
      "out_ready, in order. The pipeline never stalls: a token starts only when a credit guarantees room for its result in the completion",
      "queue. in_ready, out_valid and the output words depend on registers only.",
      "",
      "  s(k) = max(s(k-1) + II, arrival(k), w(k-CAPACITY) + 1)   start",
      fmt::format("  d(k) = max(s(k) + L + TAIL, w(k-1) + 1)                  finished; here L = {}, II = {}", unit.latency,
                  unit.initiation_interval),
      "  w(k) = first cycle from d(k) on with out_ready           delivered"};
  return lines;
}

void check_names(const Ports& ports) {
  for (const auto& port : ports) BUMP_ASSERT(port.verilog != "valid" && port.verilog != "ready");
}

}  // namespace

int word_bits(const Ports& ports) {
  int bits = 0;
  for (const auto& port : ports) bits += port.format.width;
  return bits;
}

RtlUnit unit_module(const std::string& scheme, const std::string& unit_name, const DatapathModule& datapath, int capacity) {
  BUMP_ASSERT(!datapath.inputs.empty() && !datapath.outputs.empty());
  BUMP_ASSERT(datapath.latency >= 0 && datapath.initiation_interval >= 1 && capacity >= 0);
  check_names(datapath.inputs);
  check_names(datapath.outputs);
  RtlUnit unit;
  unit.unit = unit_name;
  unit.module.name = verilog_identifier(scheme) + "_" + verilog_identifier(unit_name);
  unit.inputs = datapath.inputs;
  unit.outputs = datapath.outputs;
  unit.initiation_interval = datapath.initiation_interval;
  unit.latency = std::max(1, datapath.latency + datapath.initiation_interval - 1);
  unit.capacity = capacity > 0 ? capacity : unit.latency + 1;
  const int in_bits = word_bits(unit.inputs), out_bits = word_bits(unit.outputs);
  unit.module = verilog_module(unit.module.name, comment(scheme, unit),
                               header(unit) + constants + entry(unit, in_bits) + starts(unit) +
                                   datapath_instance(unit, datapath, out_bits) + tail(out_bits) + completion_queue(unit, out_bits));
  return unit;
}

WrapperRegisters wrapper_registers(const RtlUnit& unit, const DatapathModule& datapath) {
  WrapperRegisters bits;
  const int interval = unit.initiation_interval, out_bits = word_bits(unit.outputs);
  bits.control = 2 * bits_of(unit.capacity) + 2 * bits_of(unit.capacity - 1) + unit.latency;
  if (interval > 1) {
    bits.control += 2 * bits_of(interval - 1) + 1;
    bits.entry = word_bits(unit.inputs);
  }
  bits.result = is_combinational(datapath) || interval > 1 ? out_bits : 0;
  bits.queue = unit.capacity * out_bits;
  return bits;
}

}  // namespace bump
