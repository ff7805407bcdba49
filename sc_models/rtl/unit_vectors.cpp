#include "rtl/unit_vectors.h"

#include <algorithm>
#include <vector>

#include "datapath/evaluate.h"
#include "datapath/invariant.h"

namespace bump {

namespace {

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

 private:
  std::uint64_t state_;
};

std::uint64_t mask(int width) {
  return (std::uint64_t{1} << width) - 1;
}

/// Zero, one, all ones, the extremes of signed words, single bits.
std::vector<std::uint64_t> corners_of(int width) {
  const std::uint64_t all = mask(width), top = std::uint64_t{1} << (width - 1);
  std::vector<std::uint64_t> corners = {0, 1 & all, all, top, top - 1, all - 1, (top + 1) & all};
  for (int bit = 1; bit + 1 < width; ++bit) corners.push_back(std::uint64_t{1} << bit);
  return corners;
}

class VectorText {
 public:
  explicit VectorText(const Netlist& netlist) : netlist_(netlist) {
    for (const Netlist::Port& port : netlist.inputs()) bits_ += width(port);
    for (const Netlist::Port& port : netlist.outputs()) bits_ += width(port);
  }
  int width(const Netlist::Port& port) const { return netlist_.nodes()[static_cast<std::size_t>(port.node)].format.width; }

  void begin() { used_ = (4 - bits_ % 4) % 4, digit_ = 0; }
  void append(std::uint64_t word, int width) {
    for (int bit = width - 1; bit >= 0; --bit) {
      digit_ = 2 * digit_ + static_cast<unsigned>((word >> bit) & 1);
      if (++used_ % 4 != 0) continue;
      text_ += "0123456789abcdef"[digit_];
      digit_ = 0;
    }
  }
  void end() { text_ += '\n'; }
  void reserve(int vectors) { text_.reserve(static_cast<std::size_t>(vectors) * static_cast<std::size_t>((bits_ + 3) / 4 + 1)); }
  std::string take() { return std::move(text_); }

 private:
  const Netlist& netlist_;
  int bits_ = 0, used_ = 0;
  unsigned digit_ = 0;
  std::string text_;
};

/// The input words of vectors in order.
class Stimuli {
 public:
  Stimuli(const Netlist& netlist, int count, std::uint64_t seed) : corner_vectors_(std::max(1, count / 4)), random_(seed) {
    for (const Netlist::Port& port : netlist.inputs()) {
      const Format& format = netlist.nodes()[static_cast<std::size_t>(port.node)].format;
      BUMP_ASSERT(format.width >= 1 && format.width <= 53);  // as doubles, too, they are exact
      formats_.push_back(format);
      corners_.push_back(corners_of(format.width));
      alike_ = std::max(alike_, static_cast<int>(corners_.back().size()));
    }
  }
  std::uint64_t word(int vector, std::size_t port) {
    const std::uint64_t draw = random_.next();
    const std::vector<std::uint64_t>& corners = corners_[port];
    if (vector >= corner_vectors_) return draw & mask(formats_[port].width);
    const std::uint64_t corner = vector < alike_ ? static_cast<std::uint64_t>(vector) : draw;
    return corners[corner % corners.size()];
  }
  const Format& format(std::size_t port) const { return formats_[port]; }

 private:
  int corner_vectors_, alike_ = 0;
  Random random_;
  std::vector<Format> formats_;
  std::vector<std::vector<std::uint64_t>> corners_;
};

}  // namespace

std::string unit_vectors(const Netlist& netlist, int count, std::uint64_t seed) {
  BUMP_ASSERT(count >= 1);
  const std::size_t inputs = netlist.inputs().size(), outputs = netlist.outputs().size();
  const auto evaluator = make_evaluator(netlist, Arithmetic::fixed);
  Stimuli stimuli(netlist, count, seed);
  VectorText text(netlist);
  text.reserve(count);
  std::vector<std::vector<std::uint64_t>> words(inputs, std::vector<std::uint64_t>(block_lanes));
  std::vector<std::vector<double>> values(inputs, std::vector<double>(block_lanes)), results(outputs, std::vector<double>(block_lanes));
  std::vector<const double*> in;
  std::vector<double*> out;
  for (const auto& value : values) in.push_back(value.data());
  for (auto& result : results) out.push_back(result.data());
  for (int first = 0; first < count; first += block_lanes) {
    const int lanes = std::min(block_lanes, count - first);
    for (int lane = 0; lane < lanes; ++lane)
      for (std::size_t i = 0; i < inputs; ++i) {
        const auto at = static_cast<std::size_t>(lane);
        words[i][at] = stimuli.word(first + lane, i);
        values[i][at] = to_double(wrap(static_cast<std::int64_t>(words[i][at]), stimuli.format(i)), stimuli.format(i));
      }
    evaluator->evaluate(in.data(), lanes, out.data());
    for (int lane = 0; lane < lanes; ++lane) {
      text.begin();
      for (std::size_t i = 0; i < inputs; ++i) text.append(words[i][static_cast<std::size_t>(lane)], text.width(netlist.inputs()[i]));
      for (const Netlist::Port& port : netlist.outputs())
        text.append(static_cast<std::uint64_t>(evaluator->raw(port.node, lane)), text.width(port));
      text.end();
    }
  }
  return text.take();
}

}  // namespace bump
