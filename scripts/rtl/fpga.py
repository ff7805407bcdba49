"""FPGA flows: DSP blocks against multipliers."""

import netlists
import tools
from results import FAILED, OK, Check

# The steps of synth_ice40 -dsp up to its products, without the pass ice40_dsp behind them, which moves registers into the blocks, changes
# no number of blocks, and crashes in Yosys 0.23 on the larger units.
ICE40 = """synth_ice40 -dsp -top {top} -run begin:coarse
opt_expr
opt_clean
opt -nodffe -nosdff
wreduce
peepopt
opt_clean
share
opt_expr
opt_clean
wreduce t:$mul
techmap -map +/mul2dsp.v -map +/ice40/dsp_map.v -D DSP_A_MAXWIDTH=16 -D DSP_B_MAXWIDTH=16 \
  -D DSP_A_MINWIDTH=2 -D DSP_B_MINWIDTH=2 -D DSP_Y_MINWIDTH=11 -D DSP_NAME=$__MUL16X16"""
# How Yosys's mul2dsp splits a product, by family: the arguments with which its synthesis script calls it (yosys -h synth_...).
FAMILIES = {
    "ice40": {"commands": ICE40, "cell": "SB_MAC16", "a": 16, "b": 16, "least_y": 11, "signed_only": 0},
    "ecp5": {"commands": "synth_ecp5 -top {top} -run "
                         "begin:map_ram", "cell": "MULT18X18D", "a": 18, "b": 18, "least_y": 1, "signed_only": 0},
    "xilinx": {"commands": "synth_xilinx -flatten -top {top} -run "
                           "begin:coarse", "cell": "DSP48E1", "a": 25, "b": 18, "partial_a": 18, "least_y": 9,
               "signed_only": 1},
}


def blocks(a, b, y, family):
    """DSP blocks of a product of a by b bits, y of them used, as mul2dsp.v cuts it."""
    if a < b:
        a, b = b, a
    if b < 2 or y < family["least_y"]:
        return 0
    return _pieces(a, b, y, family)


def _pieces(a, b, y, family):
    if b < 2 or a < 2 or y < family["least_y"]:
        return 0
    headroom = family["signed_only"]
    for factor, most in ((a, family["a"]), (b, family["b"])):
        if factor <= most:
            continue
        part = family.get("partial_a", most) if factor == a and most == family["a"] else most
        cuts = -(-(factor - most) // (part - headroom))
        rest = factor - cuts * (part - headroom)
        if factor == a:
            return cuts * _pieces(part, b, min(y, b + part), family) + _pieces(rest, b, b + rest, family)
        return cuts * _pieces(a, part, min(y, a + part), family) + _pieces(a, rest, a + rest, family)
    return 1


WIDTHS = """read_verilog rtl/*.v
blackbox rom_* div_* sqrt_*
hierarchy -check -top {top}
proc -noopt
flatten
opt_clean
write_json {before}
opt -full
wreduce
opt
write_json {after}
"""

# No product is in ROMs, dividers and roots.
DSP = """read_verilog rtl/*.v
blackbox rom_* div_* sqrt_*
{commands}
tee -q -o {out} select -count {cells}
"""


def formats_of(items):
    """Factors of the products in a unit's price items: the formats of the netlist, whatever Yosys makes of them."""
    sizes = []
    for item in items:
        if item["component"] in ("multiplier", "constant_multiplier"):
            sizes += [(int(item["first"]), int(item["second"]))] * int(item["count"])
        elif item["component"] == "squarer":
            sizes += [(int(item["width"]), int(item["width"]))] * int(item["count"])
    return sizes


def products(scheme_folder, top, log):
    """How many products the datapath has, in whatever module but dividers, roots and ROMs; and (a, b, y, unsigned) of those that are left
    after constants are folded and words narrowed to the bits that are used."""
    before, after = log.with_suffix(".before.json"), log.with_suffix(".after.json")
    tools.yosys(WIDTHS.format(top=top, before=before, after=after), log.with_suffix(".widths.log"), scheme_folder)
    written, module = netlists.count(netlists.load(before)[top], "$mul"), netlists.load(after)[top]
    before.unlink()
    after.unlink()
    sizes = []
    for name in netlists.cells_of(module, "$mul"):
        cell = module["cells"][name]
        widths = tuple(netlists.parameter(cell, key) for key in ("A_WIDTH", "B_WIDTH", "Y_WIDTH"))
        sizes.append((*widths, 1 - netlists.parameter(cell, "A_SIGNED")))
    return written, sizes


def check_dsp(scheme, unit, folder, log, items):
    """Blocks of three families against what the widths of the factors ask for, and products against the inventory's multipliers."""
    name, top, multipliers = unit["unit"], unit["cells"]["module"], unit["cells"]["multipliers"]["count"]
    formats = formats_of(items)
    written, sizes = products(folder, top, log)
    checks = []
    for family_name, family in FAMILIES.items():
        out = log.with_suffix(f".{family_name}.txt")
        tools.yosys(DSP.format(commands=family["commands"].format(top=top), top=top, out=out, cells=f"{top}/t:{family['cell']}"),
                    log.with_suffix(f".{family_name}.log"), folder)
        found = int(out.read_text().split()[0])
        sign = family["signed_only"]
        expected = sum(blocks(a + unsigned * sign, b + unsigned * sign, y, family) for a, b, y, unsigned in sizes)
        by_formats = sum(blocks(a, b, a + b, family) for a, b in formats)
        text = f"{found} DSP blocks for {multipliers} multipliers"
        if found != multipliers:
            kinds = ", ".join(sorted({f"{a}x{b}" for a, b, _, _ in sizes})) or "none is left"
            text += f"; by their formats {by_formats}, by the products left after constants and unused bits ({kinds}) {expected}"
        if found != expected:
            text += f"; expected {expected}"
        if written != multipliers:
            text += f"; the Verilog has {written} products"
        data = {"found": found, "expected": expected, "by_formats": by_formats, "multipliers": multipliers, "products": len(sizes)}
        good = found == expected and written == multipliers
        checks.append(Check(OK if good else FAILED, f"dsp_{family_name}", scheme, name, text, data))
    return checks
