#pragma once
// Reads of one ROM by several indices in the same cycle: with one port a ROM for every read, which is how tables are counted everywhere
// else; with two, as block memories have, every second read goes to the second port of the ROM before it, which halves the words and
// changes no result. Timing: that of a table read.

#include <string>
#include <vector>

#include "datapath/netlist.h"

namespace bump {

class RomPorts {
 public:
  /// `ports`: 1 or 2.
  RomPorts(TablePtr table, int ports) : table_(std::move(table)), ports_(ports) {}

  /// One wire per column; 1 table, or a second port.
  std::vector<Wire> read(Netlist& n, const std::string& name, Wire index, const std::string& equation = "") {
    const bool second = ports_ == 2 && reads_++ % 2 != 0;
    return second ? n.second_port(name, table_, index, equation) : n.table(name, table_, index, equation);
  }
  const Table& table() const { return *table_; }

 private:
  TablePtr table_;
  int ports_;
  int reads_ = 0;
};

}  // namespace bump
