"""OpenSTA on the mapped datapaths: the shortest period from register to register; and power at a stated activity."""

import re

import tools
from results import FAILED, OK, Check

PERIOD = 100.0  # ns, longer than any path
TIMING = """read_liberty {liberty}
read_verilog {netlist}
link_design {top}
create_clock -name clk -period {period} [get_ports clk]
puts "registers [llength [all_registers -cells]]"
report_checks -path_delay max -from [all_registers -clock_pins] -to [all_registers -data_pins] -digits 4 -format full
"""


def shortest_period(folder, top, log):
    """ns; None if no path leads from a register to a register: there is one stage only, or ROMs are in between."""
    text = tools.sta(TIMING.format(liberty=tools.LIBERTY, netlist=f"{folder}/netlist.v", top=top, period=PERIOD), log, folder)
    if not re.search(r"^registers \d+$", text, re.M):
        raise tools.ToolFailed(f"sta found no design (log: {log})")
    slack = re.search(r"(-?[\d.]+)\s+slack", text)
    if slack is None:
        if "No paths found" not in text:
            raise tools.ToolFailed(f"sta reported no path (log: {log})")
        return None
    return PERIOD - float(slack[1])


def check_unit(scheme, unit, width, area, notes, log):
    """The area's mapped netlist, ROMs as black boxes: table reads are not in the path, wires have no load."""
    top, name = unit["cells"]["module"], unit["unit"]
    if area["register_bits"] == 0:
        return [Check(OK, "clock", scheme, name, f"{width} bits: no register, no clock", {"width": width, "period": None})]
    period = shortest_period(area["folder"], top, log)
    if period is None:
        text = f"{width} bits: no path from register to register"
        text += " but through ROMs, which are black boxes" if area["roms"] else ", there is one stage"
    else:
        text = f"{width} bits: {period:.2f} ns, {1000 / period:.0f} MHz"
    text += "".join(f"; {note}" for note in notes)
    good = period is None or 0 < period < PERIOD
    return [Check(OK if good else FAILED, "clock", scheme, name, text, {"width": width, "period": period})]
