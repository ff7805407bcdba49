#include "rtl/divider_module.h"

#include <fmt/core.h>

#include <algorithm>

#include "datapath/arithmetic.h"
#include "datapath/array_registers.h"
#include "datapath/invariant.h"
#include "rtl/leaf_text.h"

namespace bump {

namespace {

class DividerArray {
 public:
  DividerArray(const Format& a, const Format& b, const Format& quotient, int stages)
      : a_(a),
        b_(b),
        q_(quotient),
        stages_(stages),
        shift_(divider_shape(a, b, quotient).shift),
        rows_(magnitude_bits(quotient)),
        cut_(std::max(0, -shift_)),
        edges_(divider_edges(a, b, quotient, stages)),
        text_(name()) {
    BUMP_ASSERT(stages >= 0 && rows_ >= 1 && !b.is_signed && (quotient.is_signed || !a.is_signed));
  }

  VerilogModule module() {
    heading();
    operands();
    const int share = rows_per_segment(rows_, stages_);
    int row = 0;
    for (int segment = 0; segment <= stages_; ++segment) {
      if (segment > 0) registers(segment, edges_[static_cast<std::size_t>(segment) - 1]);
      for (const int end = std::min(rows_, row + share); row < end; ++row) add_row(row);
    }
    result();
    return text_.module();
  }

 private:
  std::string name() const {
    const std::string formats = fmt::format("div_{}_by_{}_to_{}", format_name(a_), format_name(b_), format_name(q_));
    return stages_ == rows_ - 1 ? formats : fmt::format("{}_n{}", formats, stages_);
  }

  void heading() {
    text_.comment(fmt::format("Divider: q = floor(|a| * 2^{} / b) with the sign of a; a quotient too large, and b = 0: all ones.", shift_));
    text_.comment(fmt::format("a {}, b {}, q {}. Restoring array of {} rows, {} internal register stages.", to_string(a_), to_string(b_),
                              to_string(q_), rows_, stages_));
    if (stages_ > 0) text_.clock();
    text_.input("a", a_.width);
    text_.input("b", b_.width);
    text_.output("q", q_.width);
  }

  /// Bit of |a| that enters at a row; below 0 it is one of the zeros that the shift brings in, above the word there is none.
  int bit_at(int row) const { return rows_ - 1 - row - shift_; }

  void operands() {
    if (a_.is_signed) text_.bit("negative", bits_of("a", a_.width - 1, a_.width - 1));
    if (cut_ > 0) text_.remark(fmt::format("The {} lowest bits lie below the quotient's last place.", std::min(cut_, a_.width)));
    text_.word("magnitude", a_.width, a_.is_signed ? "negative ? -a : a" : "a", cut_ > 0 ? LeafText::Read::partly : LeafText::Read::whole);
    const int highest = std::min(a_.width - 1, bit_at(0));
    if (highest >= cut_) text_.word("rest", highest - cut_ + 1, bits_of("magnitude", highest, cut_));

    const int first_bits = std::max(0, a_.width + shift_ - rows_);
    if (first_bits == 0) {
      text_.bit("too_large", fmt::format("b == {}", verilog_word(0, b_.width)));
      return;
    }
    text_.remark("What is above the quotient's bits is the first remainder.");
    const int zeros = std::clamp(shift_ - rows_, 0, first_bits);
    text_.word("first", first_bits,
               concatenation({bits_of("magnitude", a_.width - 1, std::max(cut_, rows_ - shift_)), copies("1'b0", zeros)}));
    const int widest = std::max(first_bits, b_.width);
    text_.bit("too_large", zero_extended("first", first_bits, widest) + " >= " + zero_extended("b", b_.width, widest));
    remainder_bits_ = std::min(first_bits, b_.width);
    if (remainder_bits_ > 0) text_.word("r0", remainder_bits_, bits_of("first", remainder_bits_ - 1, 0));
    remainder_ = "r0";
  }

  /// A row subtracts the divisor from the remainder with the next dividend bit behind it, unless that would be negative.
  void add_row(int row) {
    const int bit = bit_at(row);
    if (bit >= a_.width) return;  // nothing of the dividend has entered yet: the quotient bit is 0
    const std::string next = bit < 0 ? "1'b0" : bits_of(rest_, bit - cut_, bit - cut_);
    const std::string number = std::to_string(row), t = "t" + number, s = "s" + number, found = "q" + number;
    const int trial_bits = remainder_bits_ + 1, kept = std::min(trial_bits, b_.width);
    text_.remark(fmt::format("row {}: quotient bit {}", row, rows_ - 1 - row));
    text_.word(t, trial_bits, concatenation({remainder_bits_ > 0 ? remainder_ : "", next}));
    if (row == rows_ - 1) {
      const int widest = std::max(trial_bits, b_.width);
      text_.bit(found, zero_extended(t, trial_bits, widest) + " >= " + zero_extended(divisor_, b_.width, widest));
    } else {
      text_.word(s, kept + 1, zero_extended(t, trial_bits, kept + 1) + " - " + concatenation({"1'b0", bits_of(divisor_, kept - 1, 0)}));
      const std::string above = bits_of(divisor_, b_.width - 1, kept);
      text_.bit(found, fmt::format("~{}[{}]", s, kept) + (above.empty() ? "" : fmt::format(" & ~|{}", above)));
      remainder_ = "r" + std::to_string(row + 1);
      text_.word(remainder_, kept, fmt::format("{} ? {} : {}", found, bits_of(s, kept - 1, 0), bits_of(t, kept - 1, 0)));
    }
    remainder_bits_ = kept;
    found_.push_back(found);
    ++found_bits_;
  }

  void registers(int segment, const DividerEdge& kept) {
    BUMP_ASSERT(kept.found == found_bits_ && (kept.divisor == 0 || kept.remainder == remainder_bits_));
    std::vector<LeafText::Register> bank;
    const auto keep = [&](std::string& word, const std::string& called, int width, const std::string& next) {
      word = fmt::format("{}_{}", called, segment);
      bank.push_back({word, width, next});
    };
    if (kept.sign > 0) keep(negative_, "negative", 0, std::string(negative_));
    keep(too_large_, "too_large", 0, std::string(too_large_));
    if (kept.divisor > 0) keep(divisor_, "b", kept.divisor, std::string(divisor_));
    if (kept.remainder > 0) keep(remainder_, "remainder", kept.remainder, std::string(remainder_));
    if (kept.rest > 0) keep(rest_, "rest", kept.rest, bits_of(rest_, kept.rest - 1, 0));
    if (kept.found > 0) {
      std::string word;
      keep(word, "found", kept.found, concatenation(found_));
      found_ = {word};
    }
    text_.remark(fmt::format("end of segment {}", segment - 1));
    text_.registers(bank);
  }

  void result() {
    text_.remark(a_.is_signed ? "Saturation, then the sign." : "Saturation.");
    const std::string quotient = concatenation({copies("1'b0", rows_ - found_bits_), concatenation(found_)});
    text_.word("absolute", rows_, quotient + " | " + copies(too_large_, rows_));
    const std::string positive = zero_extended("absolute", rows_, q_.width);
    text_.assign("q", a_.is_signed ? fmt::format("{} ? -{} : {}", negative_, positive, positive) : positive);
  }

  Format a_, b_, q_;
  int stages_, shift_, rows_;
  int cut_;  // low bits of |a| that a shift to the right drops
  std::vector<DividerEdge> edges_;
  LeafText text_;

  // The words as they are called in the present segment.
  std::string negative_ = "negative", too_large_ = "too_large", divisor_ = "b", rest_ = "rest", remainder_;
  std::vector<std::string> found_;  // quotient bits, the highest first
  int found_bits_ = 0, remainder_bits_ = 0;
};

}  // namespace

VerilogModule divider_module(const Format& a, const Format& b, const Format& quotient, int stages) {
  return DividerArray(a, b, quotient, stages).module();
}

}  // namespace bump
