#pragma once
// A small price table of round numbers and what tests of prices share.

#include <string>

#include "testbench/experiments/price_table.h"

namespace bump {

inline std::string head() {
  return "title = \"of round numbers\"\ntechnology = \"paper\"\nsource = \"made up\"\n";
}

inline std::string entry(const std::string& path, const std::string& form) {
  return "[" + path + "]\n" + form + "\nsource = \"made up\"\naccuracy = \"exact\"\n";
}

/// Areas of every component that datapaths have, in numbers that are easy to add up.
inline std::string round_areas() {
  return head() + "[area]\nunit = \"NAND2\"\naccuracy = \"exact\"\n" + entry("area.adder", "form = \"linear\"\nper_width = 10") +
         entry("area.constant_adder", "form = \"linear\"\nper_width = 3") +
         entry("area.multiplier", "form = \"product\"\ncoefficient = 10") +
         entry("area.squarer", "form = \"power\"\ncoefficient = 7\nexponent_width = 2") +
         entry("area.divider", "form = \"product\"\ncoefficient = 10\nper_rows = 1\nbase = 5") +
         entry("area.square_root", "form = \"product\"\ncoefficient = 6") + entry("area.clamp", "form = \"linear\"\nper_width = 4") +
         entry("area.select", "form = \"linear\"\nper_width = 2") + entry("area.negate", "form = \"linear\"\nper_width = 5") +
         entry("area.shifter", "form = \"product\"\ncoefficient = 2") + entry("area.index_encoder", "form = \"product\"\ncoefficient = 1") +
         entry("area.table", "form = \"product\"\ncoefficient = 0.5") + entry("area.second_port", "form = \"product\"\ncoefficient = 0.2") +
         entry("area.register", "form = \"constant\"\nvalue = 4");
}

inline PriceTable round_table() {
  return PriceTable(round_areas(), "round.toml", "round");
}

}  // namespace bump
