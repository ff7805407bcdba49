"""Modules as Yosys writes them (write_json): cells by type, and what a cell is called in the Verilog it came from."""

import fnmatch
import json
import pathlib
import re


def load(path):
    return json.loads(pathlib.Path(path).read_text())["modules"]


def parameter(cell, name):
    value = cell["parameters"][name]
    return value if isinstance(value, int) else int(value.strip() or "0", 2)


def cells_of(module, *patterns):
    """Names of the cells whose type fits one of the patterns, as Yosys's `select t:` takes them."""
    return [name for name, cell in module["cells"].items() if any(fnmatch.fnmatchcase(cell["type"], p) for p in patterns)]


def count(module, *patterns):
    return len(cells_of(module, *patterns))


def register_bits(module):
    """Bits of the flip-flops in the module itself, not in what it instantiates."""
    flops = cells_of(module, "$dff", "$dffe", "$sdff", "$sdffe", "$sdffce", "$adff*")
    return sum(parameter(module["cells"][name], "WIDTH") for name in flops)


def register_bits_below(modules, name):
    """Bits of the flip-flops in a module and, instance by instance, in what it is made of."""
    cells = modules[name]["cells"].values()
    return register_bits(modules[name]) + sum(register_bits_below(modules, cell["type"]) for cell in cells if cell["type"] in modules)


def memory_bits(module):
    return sum(parameter(module["cells"][name], "SIZE") * parameter(module["cells"][name], "WIDTH") for name in cells_of(module, "$mem*"))


def name_in_source(cell, folder):
    """What the netlist calls the word that the cell computes: the wire that its line declares, or the cell's own name."""
    source = cell.get("attributes", {}).get("src", "")
    place = re.match(r"(.+?):(\d+)\.", source)
    if place:
        lines = (pathlib.Path(folder) / place.group(1)).read_text().splitlines()
        line = lines[int(place.group(2)) - 1] if int(place.group(2)) <= len(lines) else ""
        declared = re.search(r"(?:wire|reg)\s+(?:signed\s+)?(?:\[[^]]*\]\s*)?(\w+)\s*=", line) or re.search(r"(\w+)\s*<=", line)
        if declared:
            return re.sub(r"(_next)?(_exact)?$", "", declared.group(1))
    return source or "?"
