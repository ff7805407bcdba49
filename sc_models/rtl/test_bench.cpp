#include "rtl/test_bench.h"

#include <fmt/core.h>

namespace bump {

namespace {

/// Slices of `word`, the first port in the highest bits.
std::string connections(const std::vector<DatapathModule::Port>& ports, const std::string& prefix, const std::string& word) {
  std::string text;
  int high = word_bits(ports) - 1;
  for (const auto& port : ports) {
    text += fmt::format(",\n      .{}{}({}[{}:{}])", prefix, port.verilog, word, high, high - port.format.width + 1);
    high -= port.format.width;
  }
  return text;
}

std::string declarations(const RtlUnit& unit, int vectors) {
  return fmt::format(R"(module {0}_tb;
  parameter VECTORS = {1};
  parameter CAPACITY = {2};
  parameter SEED = 1;
  localparam LATENCY = {3};
  localparam INTERVAL = {4};
  localparam IN_BITS = {5};
  localparam OUT_BITS = {6};

  reg clk, reset, in_valid, out_ready;
  wire in_ready, out_valid;
  reg [IN_BITS-1:0] in_words;
  wire [OUT_BITS-1:0] out_words;
  {0} #(.CAPACITY(CAPACITY)) unit (
      .clk(clk),
      .reset(reset),
      .in_valid(in_valid),
      .in_ready(in_ready){7},
      .out_valid(out_valid),
      .out_ready(out_ready){8}
  );

)",
                     unit.module.name, vectors, unit.capacity, unit.latency, unit.initiation_interval, word_bits(unit.inputs),
                     word_bits(unit.outputs), connections(unit.inputs, "in_", "in_words"), connections(unit.outputs, "out_", "out_words"));
}

const char* const state = R"(  reg [IN_BITS+OUT_BITS-1:0] vectors[0:VECTORS-1];
  reg [IN_BITS+OUT_BITS-1:0] vector;
  integer start[0:VECTORS-1];  // cycle in which a token started
  integer cycle, taken, delivered, free, quiet, round, mismatches, seed;
  integer lazy_source, lazy_reader;  // cycles in eight that they let pass
  integer first_start, second_start, first_delivery;
  reg expected_ready, expected_valid, wrong, stop;
  reg [IN_BITS-1:0] noise;  // words that the unit must not look at

  // A random number from 0 to 7.
  function integer eighths;
    input unused;
    eighths = ($random(seed) >> 8) & 7;
  endfunction

  // Both sides change well behind the clock edge.
  task edge_of_clock;
    begin
      @(posedge clk);
      #1;
    end
  endtask

  // Both sides of the unit, in the cycle that has just begun: a token that was offered stays until it is taken.
  task drive;
    begin
      if (in_valid && !expected_ready) begin
      end else if (taken < VECTORS && eighths(1'b0) >= lazy_source) begin
        vector = vectors[taken];
        in_valid = 1'b1;
        in_words = vector[IN_BITS+OUT_BITS-1:OUT_BITS];
      end else begin
        noise = (noise << 1) ^ ~(noise >> 3);
        in_valid = 1'b0;
        in_words = noise;
      end
      out_ready = eighths(1'b0) >= lazy_reader;
    end
  endtask

  // What the recurrences say of this cycle, against what the unit shows.
  task check;
    begin
      expected_ready = cycle >= free && taken - delivered < CAPACITY;
      expected_valid = 1'b0;
      if (delivered < taken) expected_valid = cycle >= start[delivered] + LATENCY;
      if (in_ready !== expected_ready || out_valid !== expected_valid) begin
        $display("@UNIT@: round %0d, cycle %0d: in_ready is %b instead of %b, out_valid is %b instead of %b", round, cycle, in_ready,
                 expected_ready, out_valid, expected_valid);
        mismatches = mismatches + 1;
        stop = 1'b1;
      end else if (expected_valid) begin
        vector = vectors[delivered];
        if (out_words !== vector[OUT_BITS-1:0] && !wrong) begin
          wrong = 1'b1;  // once a token, however long it is shown
          mismatches = mismatches + 1;
          if (mismatches <= 5)
            $display("@UNIT@: round %0d, cycle %0d: vector %0d gives %h instead of %h", round, cycle, delivered, out_words,
                     vector[OUT_BITS-1:0]);
        end
      end
    end
  endtask

  // What the clock edge at the end of this cycle does.
  task advance;
    begin
      if (expected_valid && out_ready) begin
        if (round == 1 && delivered == 0) first_delivery = cycle;
        delivered = delivered + 1;
        wrong = 1'b0;
      end
      if (in_valid && expected_ready) begin
        if (round == 1 && taken == 0) first_start = cycle;
        if (round == 1 && taken == 1) second_start = cycle;
        start[taken] = cycle;
        taken = taken + 1;
        free = cycle + INTERVAL;
      end
      if (delivered == VECTORS) quiet = quiet + 1;
      cycle = cycle + 1;
    end
  endtask

  task begin_anew;
    begin
      cycle = 0;
      taken = 0;
      delivered = 0;
      free = 0;
      quiet = 0;
      wrong = 1'b0;
      stop = 1'b0;
    end
  endtask

  task one_cycle;
    begin
      drive;
      @(negedge clk);
      check;
      advance;
      edge_of_clock;
    end
  endtask

  // All vectors, and then some cycles in which nothing may happen. The second round begins with tokens in flight, which the reset drops.
  task send_all;
    begin
      if (round == 2) begin
        in_valid = 1'b1;
        repeat (LATENCY + 2) edge_of_clock;
      end
      reset = 1'b1;
      in_valid = 1'b0;
      out_ready = 1'b0;
      edge_of_clock;
      edge_of_clock;
      reset = 1'b0;
      edge_of_clock;
      begin_anew;
      lazy_source = 0;
      lazy_reader = 0;
      while (quiet < LATENCY + 2 && !stop) begin
        if (round == 2 && cycle % 64 == 0) begin
          lazy_source = eighths(1'b0);
          lazy_reader = eighths(1'b0);
        end
        one_cycle;
      end
    end
  endtask

  // Resets of one cycle in the middle, whatever is in flight and in the queue: the next token is the first again.
  task resets;
    integer enough;
    begin
      repeat (20) begin
        reset = 1'b1;
        in_valid = eighths(1'b0) < 4;
        out_ready = eighths(1'b0) < 4;
        edge_of_clock;
        reset = 1'b0;
        in_valid = 1'b0;
        edge_of_clock;
        if (!stop) begin_anew;
        enough = 1 + (($random(seed) >> 8) & 65535) % (2 * (CAPACITY < 500 ? CAPACITY : 500) + 2);
        if (enough > VECTORS) enough = VECTORS;
        lazy_source = eighths(1'b0);
        lazy_reader = eighths(1'b0);
        while (delivered < enough && !stop) one_cycle;
      end
    end
  endtask

  always #5 clk = ~clk;

  // VECTORS of them, all digits: what a file lacks would be unknown words that agree with unknown results.
  task read_vectors;
    integer file;
    integer i;
    begin
      file = $fopen("test/@UNIT@.hex", "r");
      if (file == 0) begin
        $display("@UNIT@: cannot read test/@UNIT@.hex; run this in the folder that holds test/");
        $stop;
      end
      for (i = 0; i < VECTORS; i = i + 1) begin
        if ($fscanf(file, "%h", vector) != 1 || ^vector === 1'bx) begin
          $display("@UNIT@: test/@UNIT@.hex has only %0d vectors; bumpsim rtl --vectors writes more", i);
          $stop;
        end
        vectors[i] = vector;
      end
      $fclose(file);
    end
  endtask

  initial begin
    read_vectors;
    clk = 1'b0;
    seed = SEED;
    noise = {IN_BITS{1'b0}};
    expected_ready = 1'b1;
    mismatches = 0;
    first_start = 0;
    second_start = 0;
    first_delivery = 0;
    round = 1;
    send_all;
    round = 2;
    if (!stop) send_all;
    round = 3;
    if (!stop) resets;
    $display("@UNIT@: %0d vectors, %0d mismatches, latency %0d, interval %0d", VECTORS, mismatches, first_delivery - first_start,
             second_start - first_start);
    if (mismatches != 0) $stop;
    $finish;
  end
endmodule
)";

std::string with_name(std::string text, const std::string& unit) {
  const std::string mark = "@UNIT@";
  for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark)) text.replace(at, mark.size(), unit);
  return text;
}

}  // namespace

std::string test_bench(const RtlUnit& unit, int vectors) {
  const std::vector<std::string> comment = {
      "Test bench of " + unit.module.name + ": every vector twice, first without a pause on either side, then with random pauses; and",
      "resets in the middle.",
      "Every word is compared with the vectors, and in_ready and out_valid in every cycle with the recurrences of the unit.",
      "Runs in the folder above this one."};
  return verilog_module(unit.module.name + "_tb", comment, declarations(unit, vectors) + with_name(state, unit.unit)).text;
}

}  // namespace bump
