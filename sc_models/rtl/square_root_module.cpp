#include "rtl/square_root_module.h"

#include <fmt/core.h>

#include <algorithm>

#include "datapath/arithmetic.h"
#include "datapath/array_registers.h"
#include "datapath/invariant.h"
#include "rtl/leaf_text.h"

namespace bump {

namespace {

class RootArray {
 public:
  RootArray(const Format& a, const Format& root, int stages)
      : a_(a),
        q_(root),
        stages_(stages),
        shape_(root_shape(a, root)),
        cut_(std::max(0, -shape_.shift)),
        edges_(root_edges(a, root, stages)),
        text_(name()) {
    BUMP_ASSERT(stages >= 0 && shape_.magnitude >= 1 && !a.is_signed);
  }

  VerilogModule module() {
    heading();
    const int share = rows_per_segment(shape_.rows, stages_);
    int row = 0;
    for (int segment = 0; segment <= stages_; ++segment) {
      if (segment > 0) registers(segment, edges_[static_cast<std::size_t>(segment) - 1]);
      for (const int end = std::min(shape_.rows, row + share); row < end; ++row) add_row(row);
    }
    result();
    return text_.module();
  }

 private:
  std::string name() const {
    const std::string formats = fmt::format("sqrt_{}_to_{}", format_name(a_), format_name(q_));
    return stages_ == shape_.magnitude - 1 ? formats : fmt::format("{}_n{}", formats, stages_);
  }

  void heading() {
    text_.comment(fmt::format("Square root: q = floor(sqrt(a * 2^{})).", shape_.shift));
    text_.comment(fmt::format("a {}, q {}. Restoring array of {} rows, {} internal register stages.", to_string(a_), to_string(q_),
                              shape_.rows, stages_));
    if (cut_ > 0) text_.comment(fmt::format("The {} lowest bits of a lie below the root's last place.", std::min(cut_, a_.width)));
    if (stages_ > 0) text_.clock(shape_.rows == 0 ? LeafText::Read::partly : LeafText::Read::whole);
    text_.input("a", a_.width, cut_ > 0 ? LeafText::Read::partly : LeafText::Read::whole);
    text_.output("q", q_.width);
  }

  /// Bit of a that is the lower of the two a row brings in; below 0 it is a zero that the shift brings in.
  int low_bit_at(int row) const { return 2 * (shape_.rows - 1 - row) - shape_.shift; }

  std::string radicand_bit(int bit) const {
    return bit < 0 || bit >= a_.width ? "1'b0" : bits_of(rest_, bit - rest_origin_, bit - rest_origin_);
  }

  /// A row tries whether the remainder, with two more bits behind it, holds 4 root + 1.
  void add_row(int row) {
    const std::string number = std::to_string(row), t = "t" + number, s = "s" + number, found = "q" + number;
    const int remainder_bits = row == 0 ? 0 : row + 1, kept = row + 2;
    const int trial_bits = remainder_bits + 2;
    text_.remark(fmt::format("row {}: root bit {}", row, shape_.rows - 1 - row));
    text_.word(t, trial_bits, concatenation({remainder_, radicand_bit(low_bit_at(row) + 1), radicand_bit(low_bit_at(row))}));
    const std::string trial = zero_extended(t, trial_bits, kept + 1), subtrahend = concatenation({"1'b0", root_, "2'b01"});
    if (row == shape_.rows - 1) {
      text_.bit(found, trial + " >= " + subtrahend);
    } else {
      text_.word(s, kept + 1, trial + " - " + subtrahend);
      text_.bit(found, fmt::format("~{}[{}]", s, kept));
      remainder_ = "r" + std::to_string(row + 1);
      text_.word(remainder_, kept, fmt::format("{} ? {} : {}", found, bits_of(s, kept - 1, 0), bits_of(t, kept - 1, 0)));
    }
    const bool last = row == shape_.rows - 1;
    if (last && shape_.rows > shape_.magnitude) text_.remark("Root bits above the format's are dropped.");
    const int below = last ? std::min(row, shape_.magnitude - 1) : row;  // bits kept in front of the new one
    root_bits_ = below + 1;
    const std::string root = "root" + std::to_string(row + 1);
    text_.word(root, root_bits_, concatenation({bits_of(root_, below - 1, 0), found}));
    root_ = root;
  }

  void registers(int segment, const RootEdge& kept) {
    std::vector<LeafText::Register> bank;
    const auto keep = [&](std::string& word, const std::string& called, int width, const std::string& next) {
      word = fmt::format("{}_{}", called, segment);
      bank.push_back({word, width, next});
    };
    if (kept.remainder > 0) keep(remainder_, "remainder", kept.remainder, std::string(remainder_));
    if (kept.rest > 0) {
      keep(rest_, "rest", kept.rest, bits_of(rest_, cut_ + kept.rest - 1 - rest_origin_, cut_ - rest_origin_));
      rest_origin_ = cut_;
    }
    if (kept.found > 0) keep(root_, "found", kept.found, std::string(root_));
    text_.remark(fmt::format("end of segment {}", segment - 1));
    text_.registers(bank);
  }

  void result() { text_.assign("q", shape_.rows == 0 ? verilog_word(0, q_.width) : zero_extended(root_, root_bits_, q_.width)); }

  Format a_, q_;
  int stages_;
  RootShape shape_;
  int cut_;  // low bits of a that a shift to the right drops
  std::vector<RootEdge> edges_;
  LeafText text_;

  // The words as they are called in the present segment; the radicand's lowest bit is bit `rest_origin_` of a.
  std::string rest_ = "a", remainder_, root_;
  int rest_origin_ = 0, root_bits_ = 0;
};

}  // namespace

VerilogModule square_root_module(const Format& a, const Format& root, int stages) {
  return RootArray(a, root, stages).module();
}

}  // namespace bump
