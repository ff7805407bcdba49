"""Yosys finds the operators, tables and registers that the program counts, before it maps them to a technology."""

import netlists
import tools
from results import FAILED, OK, Check

# Before `opt` nothing is merged or folded; operators of constants alone are no cells, and the manifest names them. What `opt` removes is
# redundant in the description, which is reported, not wrong.
SCRIPT = """read_verilog rtl/*.v
hierarchy -check -top {top}
proc -noopt
opt_clean
memory -nomap
write_json {before}
opt
opt_clean
write_json {after}
"""

# What no part of a unit but its datapath has, and what the leaves may have at most: everything else would escape the counts.
NOWHERE_ELSE = ("$mul", "$div", "$mod", "$pow", "$sqrt")
ADDERS = ("$add", "$sub")
NO_ADDERS = ("table_", "rom_")

SHORT = {"multipliers": "mul", "adders": "add", "dividers": "div", "square_roots": "sqrt", "tables": "table"}
KIND = {"$mul": "multiplier", "$add": "adder", "$sub": "adder", "addsub": "adder", "div": "divider", "sqrt": "square root",
        "table": "table"}


def kind_of(cell_type):
    return KIND.get(cell_type) or KIND[cell_type.split("_")[0]]


def removed(before, after, patterns, folder):
    """Operators that `opt` merged with an equal one or turned into something simpler, as "kind name"."""
    gone = [name for name in netlists.cells_of(before, *patterns) if name not in after["cells"]]
    changed = [name for name in netlists.cells_of(before, *patterns)
               if name in after["cells"] and after["cells"][name]["type"] != before["cells"][name]["type"]]
    return sorted(f"{kind_of(before['cells'][name]['type'])} "
                  f"{netlists.name_in_source(before['cells'][name], folder)}" for name in gone + changed)


def check_scheme(scheme, units, folder, log, inventory):
    """The lines of each unit, and one for all units against what the program says the scheme is built of."""
    checks = [check for unit in units for check in check_unit(scheme, unit, folder, log(unit["unit"]))]
    found = [check.data["found"] for check in checks if check.check == "operators"]
    sums = {kind: sum(of_unit[kind] for of_unit in found) for kind in SHORT}
    built = [inventory[unit["unit"]] for unit in units]
    expected = {kind: sum(of_unit[kind] for of_unit in built) for kind in SHORT}
    expected["tables"] += sum(of_unit["maps"] for of_unit in built)
    folded = [name for unit in units for name in unit.get("folded", [])]
    text = ", ".join(f"{sums[kind]} {SHORT[kind]}" for kind in SHORT)
    different = sum(abs(sums[kind] - expected[kind]) for kind in SHORT) - len(folded)
    if different:
        text += f" instead of {', '.join(f'{expected[kind]} {SHORT[kind]}' for kind in SHORT)}"
    if folded:
        text += f", and {len(folded)} of constants alone"
    return checks + [Check(FAILED if different else OK, "operators_all", scheme, "all", text, {"found": sums, "folded": folded})]


def check_unit(scheme, unit, folder, log):
    """Three lines: operators and tables, registers of the datapath, and the wrapper's registers."""
    log.parent.mkdir(parents=True, exist_ok=True)
    before_path, after_path = log.with_suffix(".before.json"), log.with_suffix(".after.json")
    tools.yosys(SCRIPT.format(top=unit["top"], before=before_path, after=after_path), log, folder)
    before, after = netlists.load(before_path), netlists.load(after_path)
    before_path.unlink()
    after_path.unlink()
    name = unit["cells"]["module"]
    datapath, optimised, wrapper = before[name], after[name], before[unit["top"]]
    bits = [netlists.register_bits_below(modules, name) for modules in (before, after)]
    return [operators(scheme, unit, datapath, optimised, folder, hidden(before, name)), datapath_registers(scheme, unit, *bits),
            wrapper_registers(scheme, unit, wrapper)]


def hidden(modules, datapath):
    """Operators where none are counted: in the unit around the datapath, in tables and ROMs, a second adder in an adder-subtractor."""
    found = []
    for name, module in modules.items():
        if name == datapath:
            continue
        found += [f"{kind} in {name}" for kind in NOWHERE_ELSE if netlists.count(module, kind)]
        adders = netlists.count(module, *ADDERS)
        if (name.startswith(NO_ADDERS) and adders) or (name.startswith("addsub_") and adders != 1):
            found.append(f"{adders} adders in {name}")
    return found


def operators(scheme, unit, datapath, optimised, folder, differences):
    found, patterns = {}, []
    for kind, expected in unit["cells"].items():
        if kind == "module":
            continue
        found[kind] = netlists.count(datapath, *expected["types"])
        patterns += expected["types"]
        if found[kind] != expected["count"]:
            differences.append(f"{found[kind]} {kind} instead of {expected['count']}")
    redundant = removed(datapath, optimised, patterns, folder)
    text = ", ".join(f"{found[kind]} {SHORT[kind]}" for kind in found)
    if unit.get("folded"):
        text += f"; of constants alone, so no hardware: {', '.join(unit['folded'])}"
    if redundant:
        text += f"; redundant after opt: {', '.join(redundant)}"
    if differences:
        text = "; ".join(differences)
    data = {"found": found, "redundant": redundant, "folded": unit.get("folded", [])}
    return Check(FAILED if differences else OK, "operators", scheme, unit["unit"], text, data)


def datapath_registers(scheme, unit, found, kept):
    expected = unit["register_bits"]["between_operators"] + unit["register_bits"]["inside_operators"]
    text = f"{found} bits between and inside operators" + (f", {kept} after opt" if kept != found else "")
    if found != expected:
        text = f"{found} bits between and inside operators instead of {expected}"
    return Check(OK if found == expected else FAILED, "registers", scheme, unit["unit"], text, {"bits": found, "after_opt": kept})


def wrapper_registers(scheme, unit, wrapper):
    bits = unit["register_bits"]
    expected = (bits["control"] + bits["entry"] + bits["result"], bits["completion_queue"])
    found = (netlists.register_bits(wrapper), netlists.memory_bits(wrapper))
    text = f"{found[0]} bits of control and words, {found[1]} in the completion queue"
    if found != expected:
        text += f" instead of {expected[0]} and {expected[1]}"
    return Check(OK if found == expected else FAILED, "handshake", scheme, unit["unit"], text, {"bits": found[0], "queue": found[1]})
