"""Energy of a datapath from its mapped netlist, tables as gates: Icarus Verilog simulates the cells with their delays on the unit's own
random vectors, compares the results, and counts how often every net changes; OpenSTA turns the changes into power. Clock tree, wires and
what comes before the unit are in no figure; words of neighbouring pixels change less than random ones, so energies are to be compared, not
quoted."""

import pathlib
import re

import tools

PERIOD = 20.0  # ns a cycle: longer than the slowest path with the cells' delays
CYCLES = 200   # over which changes are counted


def bit_names(port, width):
    """Ports of a netlist split into bits, the highest first, as Verilog writes them."""
    return [port] if width == 1 else [f"\\{port}[{bit}] " for bit in reversed(range(width))]


def plain(name):
    return name.strip().lstrip("\\")


def cells_of(netlist):
    """(type, instance, {pin: net}) of every instance in a netlist of write_verilog -noexpr; pins with several bits as written."""
    for match in re.finditer(r"^  (\w+) (\\\S+ |\w+) \(\n(.*?)\n  \);", netlist, re.M | re.S):
        yield match[1], plain(match[2]), {pin: net.strip() for pin, net in re.findall(r"\.(\w+)\(([^()]*)\)", match[3])}


def test_bench(unit, latency, has_clock, total):
    """Applies a vector a cycle, compares every result, and dumps the nets of the last CYCLES cycles."""
    inputs = [name for port in unit["inputs"] for name in bit_names(port["port"], port["width"])]
    outputs = [name for port in unit["outputs"] for name in bit_names(port["port"], port["width"])]
    given, made = len(inputs), len(outputs)
    connections = [".clk(clk)"] if has_clock else []
    connections += [f".{name}(operands[{given - 1 - i}])" for i, name in enumerate(inputs)]
    connections += [f".{name}(results[{made - 1 - i}])" for i, name in enumerate(outputs)]
    joined = ",\n    ".join(connections)
    return f"""`timescale 1ns/10ps
module bench;
  reg clk = 1'b0;
  reg [{given + made - 1}:0] vectors [0:{total - 1}];
  reg [{given - 1}:0] operands;
  wire [{made - 1}:0] results;
  integer cycle, wrong = 0;
  {unit["cells"]["module"]} dut (
    {joined}
  );
  initial begin
    $readmemh("vectors.hex", vectors);
    $dumpfile("changes.vcd");
    for (cycle = 0; cycle < {total}; cycle = cycle + 1) begin
      if (cycle == {total - CYCLES}) $dumpvars(0, dut);
      operands = vectors[cycle][{given + made - 1}:{made}];
      #{PERIOD / 2:.1f} ;
      if (cycle >= {latency} && results !== vectors[cycle - {latency}][{made - 1}:0]) wrong = wrong + 1;
      clk = 1'b1;
      #{PERIOD / 2:.1f} clk = 1'b0;
    end
    $display("%0d results, %0d mismatches", {total} - {latency}, wrong);
  end
endmodule
"""


def changes(path):
    """Changes of every bit in a VCD: {(scope, net): count}, scopes below `dut`."""
    symbols, scopes, counts, names = {}, [], {}, []
    with open(path) as file:
        for line in file:
            if line.startswith("$scope"):
                scopes.append(line.split()[2])
            elif line.startswith("$upscope"):
                scopes.pop()
            elif line.startswith("$var"):
                fields = line.split()
                width, symbol, name = int(fields[2]), fields[3], fields[4]
                if width == 1 and "dut" in scopes:
                    scope = tuple(scopes[scopes.index("dut") + 1:])
                    symbols.setdefault(symbol, 0)
                    names.append((scope, plain(name), symbol))
            elif line[0] in "01" and line[1:].strip() in symbols:
                symbols[line[1:].strip()] += 1
    for scope, name, symbol in names:
        counts[(scope, name)] = max(0, symbols[symbol] - 1)  # the first is its value, no change
    return counts


def energy_of_unit(unit, folder, figures, synthesis, place, log):
    """pJ a fragment by group, and how many results were compared. `folder` must hold at least 2 * CYCLES vectors."""
    place.mkdir(parents=True, exist_ok=True)
    top = unit["cells"]["module"]
    source = (folder / "rtl" / f"{top}.v").read_text()
    has_clock = re.search(r"input wire clk\b", source) is not None
    latency = unit["latency"] if has_clock else 0
    lines = (folder / "test" / f"{unit['unit']}.hex").read_text().split()
    total = CYCLES + latency + 8
    (place / "vectors.hex").write_text("\n".join(lines[-total:]) + "\n")
    (place / "bench.v").write_text(test_bench(unit, latency, has_clock, total))
    netlists = {top: (pathlib.Path(figures["folder"]) / "netlist.v").read_text()}
    for rom in figures["roms"]:
        text = (pathlib.Path(synthesis.rom(folder, rom)["folder"]) / "netlist.v").read_text()
        netlists[rom] = text.replace("module ROM(", f"module {rom}(")
    (place / "netlist.v").write_text("\n".join(netlists.values()))
    # OpenSTA 2.0.17 crashes on outputs of a ROM that are constant; they do not change, and take nothing.
    (place / "power.v").write_text(re.sub(r"^\s*assign word_\d+\[\d+\] = 1'h[01] ?;\n", "", "\n".join(netlists.values()), flags=re.M))
    cells = str(tools.LIBERTY.with_suffix(".v"))
    tools.run(["iverilog", "-g2005", "-gspecify", "-s", "bench", "-o", "bench.vvp", "bench.v", "netlist.v", cells],
              log.with_suffix(".iverilog.log"), place)
    said = tools.run(["vvp", "-N", "bench.vvp"], log.with_suffix(".vvp.log"), place)
    compared = re.search(r"(\d+) results, (\d+) mismatches", said)
    if not compared or int(compared[2]):
        raise tools.ToolFailed(f"the mapped netlist of {top} differs from the evaluation: {compared and compared[0]} (log: {log})")
    script = activity_script(top, netlists, changes(place / "changes.vcd"), place, has_clock)
    text = tools.sta(script, log, place)
    power = {}
    for name, value in re.findall(r"^(Sequential|Combinational|Macro|Pad|Total)\s+\S+\s+\S+\s+\S+\s+(\S+)", text, re.M):
        power[name.lower()] = float(value)
    if "total" not in power:
        raise tools.ToolFailed(f"sta reported no power (log: {log})")
    (place / "changes.vcd").unlink()
    return {name: watts * PERIOD * 1e3 for name, watts in power.items()}, int(compared[1])  # W x ns = nJ


def activity_script(top, netlists, counts, place, has_clock):
    """Every pin with the changes of its net in a cycle: OpenSTA takes switching power from the pins that drive, internal power from those
    that are driven. Its set_power_activity -pins does not work in version 2.0.17; what lies below does."""
    commands = [f"read_liberty {tools.LIBERTY}", f"read_verilog {place}/power.v", f"link_design {top}",
                f"create_clock -name clk -period {PERIOD}" + (" [get_ports clk]" if has_clock else ""),
                # Without a clock of its own OpenSTA takes the changes of logic behind inputs as those of a second.
                'foreach port [all_inputs] { if {[get_property $port full_name] != "clk"} { set_input_delay 0 -clock clk $port } }']

    def add(module, scope, path):
        for kind, instance, pins in cells_of(netlists[module]):
            if kind in netlists:
                add(kind, scope + (instance,), path + instance + "/")
                continue
            for pin, net in pins.items():
                if pin != "CLK":
                    rate = counts.get((scope, plain(net)), 0) / CYCLES
                    commands.append(f"sta::set_power_pin_activity [sta::find_pin {{{path}{instance}/{pin}}}] {rate:g} 0.5")

    add(top, (), "")
    return "\n".join(commands + ["report_power -digits 6"]) + "\n"
