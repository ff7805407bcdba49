"""Place and route of a whole scheme on a Lattice iCE40 HX8K: logic cells and clock, or by how much it does not fit."""

import re

import tools
from results import FAILED, OK, Check

CELLS = 7680
SYNTHESIS = """read_verilog rtl/*.v {chip}
synth_ice40 -top chip -json {json}
"""


def chip_text(units):
    """A chip of all units side by side. The HX8K has fewer pins than the units ports: words come and go through shift registers."""
    instances, inputs, outputs = [], 0, 0
    for unit in units:
        ports = [".clk(clk)", ".reset(reset)"]
        for name, width in [("in_valid", 1)] + [(p["port"], p["width"]) for p in unit["inputs"]] + [("out_ready", 1)]:
            ports.append(f".{name}(given[{inputs + width - 1}:{inputs}])")
            inputs += width
        for name, width in [("in_ready", 1), ("out_valid", 1)] + [(p["port"], p["width"]) for p in unit["outputs"]]:
            ports.append(f".{name}(made[{outputs + width - 1}:{outputs}])")
            outputs += width
        instances.append(f"  {unit['top']} unit_{unit['unit']} (\n    " + ",\n    ".join(ports) + "\n  );\n")
    text = f"""module chip (input wire clk, input wire reset, input wire load, input wire serial_in, output wire serial_out);
  reg [{inputs - 1}:0] given;
  wire [{outputs - 1}:0] made;
  reg [{outputs - 1}:0] taken;
  always @(posedge clk) begin
    given <= {{given[{inputs - 2}:0], serial_in}};
    taken <= load ? made : {{taken[{outputs - 2}:0], given[{inputs - 1}]}};
  end
  assign serial_out = taken[{outputs - 1}];
{''.join(instances)}endmodule
"""
    return text, inputs + outputs


def check_scheme(scheme, units, folder, log, notes):
    """One line: logic cells and MHz, or per cent of the chip if the scheme does not fit."""
    log.parent.mkdir(parents=True, exist_ok=True)
    chip, json_path = log.with_suffix(".chip.v"), log.with_suffix(".json")
    text, shift_registers = chip_text(units)
    chip.write_text(text)
    tools.yosys(SYNTHESIS.format(chip=chip, json=json_path), log.with_suffix(".yosys.log"), folder)
    failure = None
    try:
        tools.run(["nextpnr-ice40", "--hx8k", "--package", "ct256", "--json", str(json_path), "--freq", "100", "--timing-allow-fail",
                   "--seed", "1", "--pcf-allow-unconstrained"], log, folder)
    except tools.ToolFailed as error:
        failure = str(error)
    json_path.unlink()
    said = log.read_text()
    used = re.search(r"ICESTORM_LC:\s*(\d+)/\s*(\d+)\s+(\d+)%", said)
    rams = re.search(r"ICESTORM_RAM:\s*(\d+)/", said)
    mhz = re.findall(r"Max frequency for clock .*?: ([\d.]+) MHz", said)
    if not used:
        return [Check(FAILED, "place_route", scheme, "all", failure or f"nextpnr counted no cells (log: {log})")]
    cells, percent = int(used[1]), int(used[3])
    data = {"cells": cells, "percent": percent, "shift_registers": shift_registers, "rams": int(rams[1]) if rams else 0, "mhz": None,
            "notes": notes}
    detail = f"8 bits: {cells} of {CELLS} logic cells ({percent} %), {shift_registers} of them shift registers around the ports"
    tail = "".join(f"; {note}" for note in notes)
    if failure and cells > CELLS and re.search(r"no BELs remaining|no more BELs|Unable to place", said):
        return [Check(OK, "place_route", scheme, "all", detail + ": does not fit" + tail, data)]
    if failure or not mhz:
        return [Check(FAILED, "place_route", scheme, "all", failure or f"nextpnr gave no clock (log: {log})", data)]
    data["mhz"] = float(mhz[-1])
    return [Check(OK, "place_route", scheme, "all", f"{detail}, {data['mhz']:.1f} MHz{tail}", data)]
