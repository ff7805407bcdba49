#pragma once
// Words of a datapath as Verilog text: how an identifier is widened, and how the rounding rule of format.h is written as wiring. Everything
// is done with unsigned vectors of stated widths and explicit sign bits, so that no rule of the language widens or signs anything by
// itself.

#include <string>

#include "datapath/format.h"

namespace bump {

/// A vector of the module, [width-1:0], as the word of a number.
struct WordText {
  std::string name;  ///< an identifier, of which bits can be selected
  int width = 0;
  bool is_signed = false;
  int fraction = 0;  ///< weight of the last bit is 2^-fraction; may be negative
};

/// The word of a format.
WordText word_text(const std::string& name, const Format& format);

/// `zeros` more places at the low end, then sign or zero bits in front up to `width` bits in all. width >= word.width + zeros.
std::string widened(const WordText& word, int width, int zeros = 0);

/// The rounding rule: the floor of the number at the result's fraction, wrapped to its width.
std::string rounded(const WordText& exact, const Format& to);

}  // namespace bump
