#include "rtl/harness.h"

#include <fmt/core.h>

namespace bump {

namespace {

const char* const text = R"harness(// Checks a unit, as translated by Verilator, against vectors and against the recurrences of its stage:
//   s(k) = max(s(k-1) + II, arrival(k), w(k-CAPACITY) + 1)   a token starts
//   d(k) = max(s(k) + L, w(k-1) + 1)                         it is finished
//   w(k) = first cycle from d(k) on with out_ready           it is delivered
// Every vector is sent twice: in round 1 without a pause on either side, in round 2 with random pauses on both. Round 3 sends the first
// ones again, between resets of one cycle that come whatever is in flight and in the queue. In every cycle in_ready and
// out_valid must be what the recurrences say, and the words that are shown those of the vector; none of them may change within a cycle when
// in_valid, out_ready or the operands do.
// Compiled with -DUNIT_PORTS=<unit>_ports.h. Run as: check FILE [VECTORS [SEED]]; VECTORS 0 means all of the file.

#include <verilated.h>

#include <algorithm>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#define TEXT_OF(x) #x
#define EXPANDED(x) TEXT_OF(x)
#include EXPANDED(UNIT_PORTS)

#ifndef UNIT_CAPACITY
#define UNIT_CAPACITY UnitPorts::capacity
#endif

double sc_time_stamp() { return 0; }

namespace {

[[noreturn]] void fail(const std::string& what) {
  std::fprintf(stderr, "%s: %s\n", UnitPorts::name, what.c_str());
  std::exit(1);
}

/// Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  unsigned eighths() { return static_cast<unsigned>(next() >> 61); }

 private:
  std::uint64_t state_;
};

constexpr int words = UnitPorts::inputs + UnitPorts::outputs;

/// One vector a line in hexadecimal, the first port in the highest bits.
class Vectors {
 public:
  explicit Vectors(const char* path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) fail(std::string("cannot read ") + path);
    text_.assign(std::istreambuf_iterator<char>(file), {});
    int bits = 0;
    for (int i = 0; i < words; ++i) bits += UnitPorts::port[i].width;
    digits_ = static_cast<std::size_t>(bits + 3) / 4;
    if (text_.empty() || text_.size() % (digits_ + 1) != 0)
      fail(std::string(path) + " does not consist of lines of " + std::to_string(digits_) + " digits");
    for (std::size_t i = 0; i < text_.size(); ++i) {
      const char c = text_[i];
      const bool end = i % (digits_ + 1) == digits_, digit = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
      if (end ? c != '\n' : !digit) fail(std::string(path) + ", line " + std::to_string(i / (digits_ + 1) + 1) + " is no vector");
    }
  }
  std::size_t count() const { return text_.size() / (digits_ + 1); }
  /// Words [first, last) of the ports.
  void read(std::size_t vector, int first, int last, std::uint64_t* to) const {
    const char* line = text_.data() + vector * (digits_ + 1);
    std::size_t low = digits_ * 4;  // bits from the left of the line
    for (int i = words - 1; i >= 0; --i) {
      low -= static_cast<std::size_t>(UnitPorts::port[i].width);
      if (i >= first && i < last) to[i - first] = slice(line, low, static_cast<std::size_t>(UnitPorts::port[i].width));
    }
  }

 private:
  static std::uint64_t slice(const char* line, std::size_t begin, std::size_t width) {
    std::uint64_t value = 0;
    const std::size_t end = begin + width;
    for (std::size_t digit = begin / 4; digit * 4 < end; ++digit) {
      const auto nibble = static_cast<std::uint64_t>(line[digit] <= '9' ? line[digit] - '0' : line[digit] - 'a' + 10);
      const std::size_t right = digit * 4 + 4;
      if (right <= end)
        value = (value << 4) | nibble;
      else
        value = (value << (4 - (right - end))) | (nibble >> (right - end));
    }
    return width == 64 ? value : value & ((std::uint64_t{1} << width) - 1);
  }
  std::string text_;
  std::size_t digits_ = 0;
};

class Check {
 public:
  Check(const Vectors& vectors, std::size_t count, std::uint64_t seed) : vectors_(vectors), count_(count), random_(seed) {
    context_.randReset(2);
    context_.randSeed(static_cast<int>(seed & 0x7fffffff) + 1);
    unit_ = std::make_unique<Vunit>(&context_);
  }
  ~Check() { unit_->final(); }

  /// False if it cannot go on: the handshake went wrong.
  bool round(int number) {
    round_ = number;
    reset();
    begin();
    unsigned lazy_source = 0, lazy_reader = 0;
    for (int quiet = 0; quiet < UnitPorts::latency + 2; quiet += delivered_ == count_ ? 1 : 0) {
      if (number == 2 && cycle_ % 64 == 0) {
        lazy_source = random_.eighths();
        lazy_reader = random_.eighths();
      }
      if (!drive(random_.eighths() >= lazy_source, random_.eighths() >= lazy_reader)) return false;
      advance();
    }
    return true;
  }
  /// Resets of one cycle in the middle, whatever is in flight and in the queue: the next token is the first again. False as round().
  bool resets() {
    round_ = 3;
    for (int i = 0; i < 20; ++i) {
      unit_->reset = 1;
      unit_->in_valid = random_.eighths() < 4;
      unit_->out_ready = random_.eighths() < 4;
      edge();
      unit_->reset = 0;
      unit_->in_valid = 0;
      edge();
      begin();
      const std::size_t most = 2 * std::min<std::size_t>(UNIT_CAPACITY, 500) + 2;
      const std::size_t enough = std::min<std::size_t>(count_, 1 + random_.next() % most);
      const unsigned lazy_source = random_.eighths(), lazy_reader = random_.eighths();
      while (delivered_ < enough) {
        if (!drive(random_.eighths() >= lazy_source, random_.eighths() >= lazy_reader)) return false;
        advance();
      }
    }
    return true;
  }
  std::uint64_t mismatches() const { return mismatches_; }
  std::int64_t latency() const { return first_delivery_ - first_start_; }
  std::int64_t interval() const { return second_start_ - first_start_; }

 private:
  void edge() {
    unit_->clk = 1;
    unit_->eval();
    shown_ = shown();
    unit_->clk = 0;
    unit_->eval();
  }
  void begin() {
    start_.assign(UNIT_CAPACITY, 0);
    taken_ = delivered_ = 0;
    cycle_ = free_ = 0;
    offered_ = wrong_ = false;
  }
  /// The second round begins with tokens in flight, which the reset drops.
  void reset() {
    unit_->clk = 0;
    unit_->reset = round_ == 1;
    unit_->in_valid = 1;
    unit_->out_ready = 0;
    for (int i = 0; i < UnitPorts::latency + 2; ++i) edge();
    unit_->reset = 1;
    unit_->in_valid = 0;
    for (int i = 0; i < 2; ++i) edge();
    unit_->reset = 0;
    edge();
  }
  void scramble() {
    std::uint64_t operands[UnitPorts::inputs];
    for (int i = 0; i < UnitPorts::inputs; ++i) operands[i] = random_.next() & (~std::uint64_t{0} >> (64 - UnitPorts::port[i].width));
    UnitPorts::drive(*unit_, operands);
  }

  struct Shown {
    bool ready = false, valid = false;
    std::uint64_t results[UnitPorts::outputs] = {};
  };
  Shown shown() const {
    Shown now;
    now.ready = unit_->in_ready;
    now.valid = unit_->out_valid;
    UnitPorts::read(*unit_, now.results);
    return now;
  }

  /// One cycle up to its end: both sides of the unit, and what it makes of them.
  bool drive(bool offer, bool accept) {
    if (!offered_) {
      offered_ = offer && taken_ < count_;
      unit_->in_valid = offered_;
      if (offered_) {
        std::uint64_t operands[UnitPorts::inputs];
        vectors_.read(taken_, 0, UnitPorts::inputs, operands);
        UnitPorts::drive(*unit_, operands);
      } else {
        scramble();
      }
    }
    unit_->out_ready = accepted_ = accept;
    unit_->eval();
    const Shown now = shown();
    ready_ = cycle_ >= free_ && taken_ - delivered_ < UNIT_CAPACITY;
    valid_ = delivered_ < taken_ && cycle_ >= start_[delivered_ % UNIT_CAPACITY] + UnitPorts::latency;
    if (now.ready != ready_ || now.valid != valid_)
      return handshake("in_ready is " + std::to_string(now.ready) + " instead of " + std::to_string(ready_) + ", out_valid is " +
                       std::to_string(now.valid) + " instead of " + std::to_string(valid_));
    if (now.ready != shown_.ready) return handshake("in_ready follows in_valid, out_ready or the operands within the cycle");
    if (now.valid != shown_.valid) return handshake("out_valid follows in_valid, out_ready or the operands within the cycle");
    if (!valid_) return true;
    std::uint64_t results[UnitPorts::outputs];
    vectors_.read(delivered_, UnitPorts::inputs, words, results);
    for (int i = 0; i < UnitPorts::outputs; ++i) {
      if (now.results[i] != shown_.results[i]) return handshake("the words follow in_valid, out_ready or the operands within the cycle");
      if (now.results[i] == results[i] || wrong_) continue;
      wrong_ = true;  // once a token, however long it is shown
      if (++mismatches_ <= 5)
        std::printf("%s: round %d, cycle %" PRId64 ": vector %zu, output %s is 0x%" PRIx64 " instead of 0x%" PRIx64 "\n", UnitPorts::name,
                    round_, cycle_, delivered_, UnitPorts::port[UnitPorts::inputs + i].name, now.results[i], results[i]);
    }
    return true;
  }
  bool handshake(const std::string& what) {
    ++mismatches_;
    std::printf("%s: round %d, cycle %" PRId64 ": %s\n", UnitPorts::name, round_, cycle_, what.c_str());
    return false;
  }

  /// The clock edge at the end of the cycle.
  void advance() {
    if (valid_ && accepted_) {
      if (round_ == 1 && delivered_ == 0) first_delivery_ = cycle_;
      ++delivered_;
      wrong_ = false;
    }
    if (offered_ && ready_) {
      if (round_ == 1 && taken_ == 0) first_start_ = cycle_;
      if (round_ == 1 && taken_ == 1) second_start_ = cycle_;
      start_[taken_ % UNIT_CAPACITY] = cycle_;
      ++taken_;
      free_ = cycle_ + UnitPorts::interval;
      offered_ = false;
    }
    edge();
    ++cycle_;
  }

  const Vectors& vectors_;
  std::size_t count_;
  Random random_;
  VerilatedContext context_;
  std::unique_ptr<Vunit> unit_;
  int round_ = 1;
  std::vector<std::int64_t> start_;  // of the tokens in flight
  std::size_t taken_ = 0, delivered_ = 0;
  std::int64_t cycle_ = 0, free_ = 0;
  bool offered_ = false, accepted_ = false, ready_ = false, valid_ = false, wrong_ = false;
  Shown shown_;  // right after the clock edge
  std::uint64_t mismatches_ = 0;
  std::int64_t first_start_ = 0, second_start_ = 0, first_delivery_ = 0;
};

/// A whole number, "" for 0.
std::uint64_t number(const std::string& text) {
  if (text.size() > 18 || text.find_first_not_of("0123456789") != std::string::npos) fail("'" + text + "' is no number");
  return text.empty() ? 0 : std::strtoull(text.c_str(), nullptr, 10);
}

}  // namespace

int main(int argc, char* argv[]) {
  if (argc < 2) fail("run it as: check FILE [VECTORS [SEED]]");
  const Vectors vectors(argv[1]);
  std::size_t count = argc > 2 ? number(argv[2]) : 0;
  if (count > vectors.count())
    fail(std::string(argv[1]) + " has only " + std::to_string(vectors.count()) + " vectors; bumpsim rtl --vectors writes more");
  if (argc <= 2 || *argv[2] == '\0') count = vectors.count();
  if (count < 2) fail("an interval is measured between two vectors at least");
  Check check(vectors, count, argc > 3 ? number(argv[3]) : 1);
  if (check.round(1) && check.round(2)) check.resets();
  std::printf("%s: %zu vectors, %" PRIu64 " mismatches, latency %" PRId64 ", interval %" PRId64 "\n", UnitPorts::name, count,
              check.mismatches(), check.latency(), check.interval());
  return check.mismatches() == 0 ? 0 : 1;
}
)harness";

}  // namespace

std::string harness_text() {
  return text;
}

std::string harness_ports(const RtlUnit& unit) {
  std::string ports, drive, read;
  for (std::size_t i = 0; i < unit.inputs.size(); ++i) {
    const auto& port = unit.inputs[i];
    ports += fmt::format("      {{\"{}\", {}}},\n", port.name, port.format.width);
    drive += fmt::format("    unit.in_{} = operands[{}];\n", port.verilog, i);
  }
  for (std::size_t i = 0; i < unit.outputs.size(); ++i) {
    const auto& port = unit.outputs[i];
    ports += fmt::format("      {{\"{}\", {}}},\n", port.name, port.format.width);
    read += fmt::format("    results[{}] = unit.out_{};\n", i, port.verilog);
  }
  return fmt::format(R"(// What harness.cpp must know of {0}: its ports, inputs first, with their widths in bits, and its timing in cycles.
#pragma once
#include <cstdint>

#include "Vunit.h"

struct UnitPorts {{
  static constexpr const char* name = "{1}";
  static constexpr int latency = {2}, interval = {3}, capacity = {4};
  static constexpr int inputs = {5}, outputs = {6};
  struct Port {{
    const char* name;
    int width;
  }};
  static constexpr Port port[] = {{
{7}  }};
  static void drive(Vunit& unit, const std::uint64_t* operands) {{
{8}  }}
  static void read(const Vunit& unit, std::uint64_t* results) {{
{9}  }}
}};
)",
                     unit.module.name, unit.unit, unit.latency, unit.initiation_interval, unit.capacity, unit.inputs.size(),
                     unit.outputs.size(), ports, drive, read);
}

}  // namespace bump
