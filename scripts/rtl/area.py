"""Standard cells: area of the datapaths by synthesis, their ROMs as gates, and the table of prices held against both; and the clock."""

import hashlib
import json
import re
import threading

import tools
from emission import SETTINGS
from results import FAILED, OK, Check

# `synth` without its own run of ABC, whose result the one onto the cells would throw away: a third of the time, and 0.4 % less area.
SYNTHESIS = """hierarchy -check -top {top}
proc
flatten
opt_expr
opt_clean
opt -nodffe -nosdff
wreduce
peepopt
opt_clean
alumacc
opt
memory
opt_clean
opt -fast -full
techmap
opt -fast
dfflibmap -liberty {liberty}
abc -liberty {liberty}
opt_clean
tee -q -o {stat} stat -liberty {liberty}
"""
NETLIST = "splitnets -ports\nopt_clean -purge\nwrite_verilog -noattr -noexpr {netlist}\n"
DATAPATH = "read_verilog rtl/*.v\nblackbox rom_*\n" + SYNTHESIS + NETLIST
WRAPPER = "read_verilog rtl/*.v\nblackbox *_datapath\n" + SYNTHESIS
# A ROM is logic of its address: every word and every don't-care is known, so nothing else is left to do than what ABC does.
ROM = """read_verilog {verilog}
hierarchy -check -top {top}
proc
memory
opt -full
techmap
opt -fast
abc -liberty {liberty}
opt_clean
tee -q -o {stat} stat -liberty {liberty}
splitnets
write_verilog -noattr -noexpr {netlist}
"""


def statistics(path):
    """Cells of the last module of `stat -liberty`: (um2 of flip-flops, number of them, um2 of everything else, unknown types with
    their number)."""
    areas, flops, number, logic, boxes = tools.cell_areas(), 0.0, 0, 0.0, {}
    for name, count in re.findall(r"^\s+([\\$\w]+)\s+(\d+)$", path.read_text(), re.M):
        if name.startswith("DFF") or name.startswith("LATCH"):
            flops += areas[name] * int(count)
            number += int(count)
        elif name in areas:
            logic += areas[name] * int(count)
        elif not name.startswith("Number"):
            boxes[name.lstrip("\\")] = int(count)
    return flops, number, logic, boxes


def single_bit_assigns(text):
    """The netlist without assignments of or to `{..}`, which OpenSTA does not read."""

    def bits(side, count):
        """Single bits of a concatenation of nets, slices and constants, the highest first; of `count`, if it is one net alone."""
        words = [word.strip() for word in side.strip().removeprefix("{").removesuffix("}").split(",")]
        if count and len(words) == 1 and re.fullmatch(r"\w+", words[0]):
            return [f"{words[0]}[{bit}]" for bit in reversed(range(count))]
        found = []
        for word in words:
            constant = re.fullmatch(r"(\d+)'h([0-9a-f]+)", word)
            part = re.fullmatch(r"(\w+)\[(\d+):(\d+)\]", word)
            if constant:
                found += [f"1'h{bit}" for bit in f"{int(constant[2], 16):0{constant[1]}b}"]
            elif part:
                found += [f"{part[1]}[{bit}]" for bit in range(int(part[2]), int(part[3]) - 1, -1)]
            else:
                found.append(word)
        return found

    def split(match):
        count = max(len(bits(side, 0)) for side in match.groups())
        left, right = (bits(side, count) for side in match.groups())
        if len(left) != len(right):
            raise tools.ToolFailed(f"an assignment of {len(right)} to {len(left)} words in a netlist of bits")
        return "".join(f"  assign {a} = {b} ;\n" for a, b in zip(left, right))

    return re.sub(r"^\s*assign (\{[^}]*\}|[^={]*) = (\{[^}]*\}|[^;{]*);\n", lambda m: split(m) if "{" in m[0] else m[0], text, flags=re.M)


def without_comments(text):
    return re.sub(r"//[^\n]*", "", text)


class Synthesis:
    """Runs of synthesis, each once for equal texts but for comments, tools and cells, also over several runs of the checks."""

    def __init__(self, work):
        self.work = work / "synthesis"
        self.work.mkdir(parents=True, exist_ok=True)
        self._locks, self._lock = {}, threading.Lock()
        self.made, self.reused = set(), set()  # keys of this run, and of earlier ones that it took

    def _once(self, key, make):
        """`make(folder)` returns figures; those of an equal earlier run are taken from its folder."""
        folder = self.work / key
        with self._lock:
            lock = self._locks.setdefault(key, threading.Lock())
        with lock:
            done = folder / "figures.json"
            figures = json.loads(done.read_text()) if done.exists() else {}
            if figures.get("liberty") == tools.liberty_digest():
                self.reused |= {key} - self.made
            else:
                folder.mkdir(exist_ok=True)
                figures = {"liberty": tools.liberty_digest(), **make(folder)}
                done.write_text(json.dumps(figures))
                self.made.add(key)
            return {**figures, "folder": str(folder)}

    @staticmethod
    def _hash(*texts):
        digest = hashlib.sha256()
        for text in (tools.versions().get("yosys", ""), *texts):
            digest.update(without_comments(text).encode() + b"\0")
        return digest.hexdigest()[:20]

    def datapath(self, folder, top, modules):
        """Area of a datapath without its ROMs, NAND2; the mapped netlist stays in the folder."""
        texts = [(folder / "rtl" / f"{name}.v").read_text() for name in modules]

        def make(place):
            stat, netlist = place / "stat.txt", place / "netlist.v"
            tools.yosys(DATAPATH.format(top=top, liberty=tools.LIBERTY, stat=stat, netlist=netlist), place / "yosys.log", folder)
            flops, number, logic, boxes = statistics(stat)
            netlist.write_text(single_bit_assigns(netlist.read_text()))
            unknown = [name for name in boxes if not name.startswith("rom_")]
            if unknown:
                raise tools.ToolFailed(f"cells that are not in the Liberty file: {', '.join(unknown)}")
            return {"registers": flops / tools.nand2(), "register_bits": number, "operators": logic / tools.nand2(), "roms": boxes}

        return self._once("datapath-" + self._hash(DATAPATH, top, *texts), make)

    def wrapper(self, folder, top):
        text = (folder / "rtl" / f"{top}.v").read_text()

        def make(place):
            stat = place / "stat.txt"
            tools.yosys(WRAPPER.format(top=top, liberty=tools.LIBERTY, stat=stat), place / "yosys.log", folder)
            flops, number, logic, _ = statistics(stat)
            return {"registers": flops / tools.nand2(), "register_bits": number, "operators": logic / tools.nand2()}

        return self._once("wrapper-" + self._hash(WRAPPER, text), make)

    def rom(self, folder, name):
        """A ROM made of gates: its area in NAND2, its netlist in a folder; equal contents of whatever name are synthesised once."""
        verilog = (folder / "rtl" / f"{name}.v").read_text()
        image = re.search(r'\$readmemh\("([^"]+)"', verilog)[1]
        words = (folder / image).read_text()
        body = verilog[verilog.index("module"):].replace(name, "ROM").replace(image, "words.hex")

        def make(place):
            (place / "words.hex").write_text(words)
            (place / "rom.v").write_text(body)
            stat = place / "stat.txt"
            netlist = place / "netlist.v"
            script = ROM.format(verilog="rom.v", top="ROM", liberty=tools.LIBERTY, stat=stat, netlist=netlist)
            tools.yosys(script, place / "yosys.log", place)
            netlist.write_text(single_bit_assigns(netlist.read_text()))
            flops, _, logic, boxes = statistics(stat)
            if flops or boxes:
                raise tools.ToolFailed(f"{name} did not become gates: {boxes}")
            return {"gates": logic / tools.nand2()}

        return self._once("rom-" + self._hash(ROM, body, words), make)


def unit_area(synthesis, folder, unit):
    """Operators, registers and tables of a unit's datapath, NAND2."""
    datapath = synthesis.datapath(folder, unit["cells"]["module"], [name for name in unit["modules"] if name != unit["top"]])
    tables = {name: synthesis.rom(folder, name)["gates"] for name in datapath["roms"]}
    return {"operators": datapath["operators"], "registers": datapath["registers"], "register_bits": datapath["register_bits"],
            "tables": sum(datapath["roms"][name] * gates for name, gates in tables.items()),
            "roms": {name: [datapath["roms"][name], gates] for name, gates in tables.items()}, "folder": datapath["folder"]}


def priced(unit_price):
    """What the table of prices says of the same hardware: words that only pass the unit are in no datapath."""
    groups, bits = unit_price["area"]["groups"], unit_price["register_bits"]
    registers = groups.get("registers", 0.0)
    held = bits["between"] + bits["inside"]
    registers *= held / (held + bits["carried"]) if held + bits["carried"] else 0.0
    tables = groups.get("tables", 0.0)
    operators = sum(groups.values()) - groups.get("registers", 0.0) - tables
    return {"operators": operators, "registers": registers, "tables": tables, "register_bits": held}


SMALL = 100  # NAND2, below which an error in per cent says nothing


PARTS = ("operators", "registers", "tables")


def compare(scheme, width, synthesised, price, notes):
    """One line a scheme and width: error of the table of prices in operators, registers, tables and all. The figures are those of each
    unit, by name."""
    sums = {}
    for name, figures in (("synthesised", synthesised), ("priced", price)):
        sums[name] = {part: sum(unit[part] for unit in figures.values()) for part in PARTS}
        sums[name]["logic"] = sums[name]["operators"] + sums[name]["registers"]
        sums[name]["total"] = sums[name]["logic"] + sums[name]["tables"]
    exception = SETTINGS["exceptions"].get(scheme, {})
    errors, outside = {}, []
    for part, (low, high) in SETTINGS["bands"].items():
        made, said = sums["synthesised"][part], sums["priced"][part]
        if made < SMALL:
            continue
        errors[part] = said / made - 1
        high = exception.get(part, high)
        if not low <= errors[part] <= high:
            outside.append(f"{part} outside {low:+.0%} to {high:+.0%}")
    shown = ", ".join(f"{part} {error:+.1%}" for part, error in errors.items() if part != "logic")
    text = f"{width} bits: {sums['synthesised']['total']:.0f} NAND2, price table {shown}"
    text += "".join(f"; {reason}" for reason in outside) + "".join(f"; {note}" for note in notes)
    units = {unit: sum(figures[part] for part in PARTS) for unit, figures in synthesised.items()}
    return Check(FAILED if outside else OK, "area", scheme, "all", text,
                 {"width": width, **sums, "units": units, "errors": errors, "notes": notes})
