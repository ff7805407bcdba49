#pragma once
// The datapath of a unit as Verilog: the operators of the netlist, each where the schedule has it, and the pipeline registers of the
// register plan between them. It never stalls, takes new inputs every initiation interval, and knows nothing of valid bits: the unit around
// it (unit_module.h) knows which results mean something. Every divider, square root, adder-subtractor and table is a module of its own;
// with shared multipliers their operands are steered by `phase`, the cycle modulo the initiation interval. Ports are words: in_<input>,
// read in the cycle of phase 0 in which a token begins, and out_<output>, valid `latency` cycles later, for that cycle. Names are those
// of the netlist; x_c7 is the word x in a register behind the clock edge in front of the token's cycle 7, x_next the word that a register
// takes at the next edge.

#include <map>
#include <string>
#include <vector>

#include "datapath/netlist.h"
#include "datapath/schedule.h"
#include "rtl/verilog.h"

namespace bump {

struct DatapathModule {
  struct Port {
    std::string name;     ///< the netlist's
    std::string verilog;  ///< identifier, without "in_" or "out_"
    Format format{};
  };
  std::string name, text;
  std::vector<VerilogModule> leaves;        ///< what it instantiates, each once
  std::map<std::string, std::string> roms;  ///< path to text
  std::vector<Port> inputs, outputs;
  int latency = 0;  ///< cycles from the reading of the inputs to the outputs; 0: combinational, and no clock
  int initiation_interval = 1;
  bool has_clock = false;           ///< any register: then there is a port clk
  std::vector<std::string> folded;  ///< operators of constants only, by node name: counted, but no hardware
  std::int64_t register_bits = 0;   ///< between operators, as the register plan has them; not those inside operators
  std::int64_t inside_bits = 0;     ///< of operators of several cycles, in the leaves, too
};

/// Module "<scheme>_<unit>_datapath".
DatapathModule datapath_module(const std::string& scheme, const std::string& unit, const Netlist& netlist, const Schedule& schedule);

}  // namespace bump
