#pragma once
// A look-up table of a netlist as Verilog, two modules and a ROM image: the reader makes an address of each port's index words
// (table_address.h), reads the ROM and gives odd columns their sign; the ROM holds the words, a combinational read for each address. A
// mirrored column reads the first column's words at the complemented address, by a read of its own. Timing: with internal stages the
// address is registered in front of the ROM (what FPGA memories ask for), with two or more the word behind it, too, and further registers
// delay the address; the columns are not registered; one index a clock and port, nothing stalls. Leaves out: filling the ROM
// (tabulate()). Source: the words of look_up() in table.h.

#include <string>

#include "datapath/table.h"
#include "rtl/verilog.h"

namespace bump {

struct TableModules {
  VerilogModule reader, rom;
  std::string rom_file;  ///< "rom/<scheme>_<TABLE>.hex", as the ROM reads it
  std::string rom_text;  ///< luts/rom_image.h
};

/// Reader ports: clk (unless stages is 0), and for each port p of 0..ports-1 the index words i0_p, i1_p, i2_p as far as the table has them,
/// and c<k>_p for column k. ports is 1 or 2; stages >= 0. The modules are called table_<scheme>_<TABLE> and rom_<scheme>_<TABLE>, with
/// "_p2" behind for two ports, and the reader with "_n<stages>" behind unless stages is 0.
TableModules table_modules(const std::string& scheme, const Table& table, const TableContents& contents, int ports, int stages);

}  // namespace bump
