#pragma once
// What a price table can give a price to: the operators of a netlist as hardware, with the sizes that a price may depend on, and what a
// fragment costs outside the datapaths. A special case (a squarer, an adder with a constant) that a table does not list is priced as the
// general one, which costs no less; anything else that is missing is an error of whoever asks. No hardware of its own, no time.

#include <string>
#include <vector>

namespace bump {

enum class Component {
  adder,                      ///< subtractors too; width: columns in which two operands meet, up to the result's top bit
  constant_adder,             ///< one operand is a constant of the structure; else as adder
  adder_subtractor,           ///< a flag chooses the sign
  constant_adder_subtractor,  ///< what is added or subtracted is a constant of the structure; else as adder_subtractor
  multiplier,                 ///< first, second: widths of the factors
  squarer,                    ///< both factors are one value; width; else as multiplier
  constant_multiplier,        ///< one factor is a constant of the structure; else as multiplier
  divider,                    ///< restoring array; rows: quotient bits, width: of the divisor
  square_root,                ///< restoring array; rows: root bits; width: of a row, as many
  clamp,                      ///< width: of what is clamped
  select,                     ///< two to one; width: of the result
  negate,                     ///< negation, absolute value, and the sign work of a folded table; width
  shifter,                    ///< barrel shifter; width: of what is shifted, places: bits of the distance
  index_encoder,              ///< leading-one detector of a floating index; binades: exponents, word: mantissa bits
  table,                      ///< entries; word: stored bits of all columns; columns; changes: stored bits that differ from the word before
  line_table,                 ///< table whose words lie on a straight line; else as table
  map,                        ///< table of several indices; else as table
  second_port,                ///< further index of a table in the same cycle, without words of its own; sizes of the words that it reads
  register_bits,              ///< "register": one flip-flop; energy: of one clocking
  float_adder,                ///< comparisons too
  float_multiplier,
  float_divider,
  float_square_root,
  float_select,
  cache_read,   ///< energy: one look-up; bytes: capacity of the cache
  memory_byte,  ///< energy: one byte moved between cache and memory
  count
};

/// The name in a price table's file.
const char* name_of(Component component);
/// Sizes that a price may depend on, in the order of PriceSizes: at most four.
const std::vector<std::string>& sizes_of(Component component);
/// Whether it is so many equal bits side by side: its first size is its width.
bool has_width(Component component);
/// What it is priced as where a table has no entry for it; itself if there is nothing more general.
Component general(Component component);

/// Columns of a cost breakdown.
enum class CostGroup { multipliers, adders, dividers, tables, registers, logic, memory, count };
const char* name_of(CostGroup group);
CostGroup group_of(Component component);

}  // namespace bump
