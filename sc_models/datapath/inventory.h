#pragma once
// Counts what a netlist is built of. `Inventory` is one column entry of Lee 2007, Table 1, and what that table leaves out.

#include <cstdint>

#include "datapath/netlist.h"

namespace bump {

struct Inventory {
  // As Table 1 of Lee 2007 lists them.
  int multipliers = 0;
  int adders = 0;  ///< subtractors are adders, and so is one that does both
  int dividers = 0;
  int square_roots = 0;
  int tables = 0;  ///< tables read by one index each, several columns are one table
  int maps = 0;    ///< large tables with more than one index
  // Listed apart: barrel shifters, which that table has no column for, wiring and sign logic.
  int shifters = 0;      ///< by a number of places that is a value; a shift by a constant is wiring
  int second_ports = 0;  ///< of tables: another index in the same cycle, no words of its own
  int shifts = 0;        ///< and joins
  int sign_logic = 0;    ///< negate, absolute, half_turn, is_negative, is_beyond_quarter, exclusive_or
  int clamps = 0;
  int selects = 0;
  int index_encoders = 0;  ///< leading-one detectors in front of tables with a floating index
  // Storage.
  std::int64_t table_bits = 0;           ///< one ROM for every read, as one fragment a clock needs
  std::int64_t distinct_table_bits = 0;  ///< every content stored once

  Inventory& operator+=(const Inventory& other);
};

enum class Portion { published, addition, all };

/// Counts the nodes of the portion. Distinct bits are counted within this netlist.
Inventory count(const Netlist& netlist, Portion portion = Portion::all);

}  // namespace bump
