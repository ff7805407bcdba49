#include "rtl/adder_subtractor_module.h"

#include <fmt/core.h>

#include <algorithm>

#include "datapath/invariant.h"
#include "rtl/leaf_text.h"

namespace bump {

namespace {

/// The low `width` bits of a word with `zeros` bits behind it, its sign in front of it as far as needed.
std::string aligned(const std::string& name, const Format& format, int zeros, int width) {
  const int held = std::min(format.width, width - zeros);
  if (held <= 0) return copies("1'b0", width);
  const std::string sign = format.is_signed ? bits_of(name, format.width - 1, format.width - 1) : "1'b0";
  return concatenation({copies(sign, width - zeros - held), bits_of(name, held - 1, 0), copies("1'b0", zeros)});
}

/// Bits of the aligned word as a signed number.
int signed_bits(const Format& format, int zeros) {
  return format.width + zeros + (format.is_signed ? 0 : 1);
}

}  // namespace

VerilogModule adder_subtractor_module(const Format& a, const Format& b, const Format& sum) {
  const int fraction = std::max(a.fraction, b.fraction);
  const int zeros_a = fraction - a.fraction, zeros_b = fraction - b.fraction;
  const int exact = std::max(signed_bits(a, zeros_a), signed_bits(b, zeros_b)) + 1;
  BUMP_ASSERT(exact <= 63);
  const int right = fraction - sum.fraction;  // bits of the exact sum that are cut off; below 0, zeros behind it
  // No bit above the result's highest matters.
  const int width = std::min(exact, sum.width + right);

  LeafText text(fmt::format("addsub_{}_{}_to_{}", format_name(a), format_name(b), format_name(sum)));
  text.comment("Adder-subtractor: q = subtract ? a - b : a + b, exact, then cut to the format.");
  text.comment(fmt::format("a {}, b {}, q {}. One adder of {} bits with a carry in.", to_string(a), to_string(b), to_string(sum),
                           std::max(width, 0)));
  const auto read = [&](const Format& operand, int zeros) {
    return width - zeros < operand.width ? LeafText::Read::partly : LeafText::Read::whole;
  };
  text.input("subtract", 1, width <= 0 ? LeafText::Read::partly : LeafText::Read::whole);
  text.input("a", a.width, read(a, zeros_a));
  text.input("b", b.width, read(b, zeros_b));
  text.output("q", sum.width);
  if (width <= 0) {
    text.assign("q", verilog_word(0, sum.width));
    return text.module();
  }

  // The carry in is the carry out of a place in front of the lowest: one adder, and no synthesis tool makes two of it.
  text.word("x", width, aligned("a", a, zeros_a, width));
  text.word("y", width, fmt::format("{} ^ {}", aligned("b", b, zeros_b, width), copies("subtract[0]", width)));
  text.remark("The lowest place makes the carry in.");
  text.word("total", width + 1, "{x, 1'b1} + {y, subtract[0]}", LeafText::Read::partly);
  const int low = std::max(0, right), held = std::min(sum.width, width - low);  // of the sum, below it zeros, above it the sign
  const int zeros = std::max(0, -right);
  if (held <= 0) {
    text.assign("q", copies(bits_of("total", width, width), sum.width));
    return text.module();
  }
  const int body = std::min(held, sum.width - zeros);
  text.assign("q", concatenation({copies(bits_of("total", width, width), sum.width - zeros - body), bits_of("total", low + body, low + 1),
                                  copies("1'b0", zeros)}));
  return text.module();
}

}  // namespace bump
