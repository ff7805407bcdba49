#!/usr/bin/env python3
"""Writes reports/rtl.md from the figures of scripts/check_rtl.sh."""

import argparse
import json
import pathlib
import sys

PARTS = ("operators", "registers", "tables", "total")
TITLES = {"total": "all", "logic": "operators and registers together", "operators": "operators", "registers": "registers",
          "tables": "tables"}
TOOLS = {"yosys": "Yosys", "verilator": "Verilator", "iverilog": "Icarus Verilog", "sta": "OpenSTA", "nextpnr-ice40": "nextpnr"}
FAMILIES = (("ice40", "iCE40 UP MAC16"), ("ecp5", "ECP5 MULT18X18D"), ("xilinx", "Xilinx DSP48E1"))


def table(head, rows, right=1):
    """A Markdown table; columns from `right` on are aligned to the right."""
    lines = ["| " + " | ".join(head) + " |", "|" + "|".join("--" if i < right else "--:" for i in range(len(head))) + "|"]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]) + "\n"


def signed(value):
    """Per cent with a sign, without one if it rounds to 0."""
    return "0" if round(100 * value) == 0 else f"{100 * value:+.0f}"


def percent(value):
    return f"{signed(value)} %"


def span(values):
    if not values:
        return "none"
    return f"{percent(min(values))} to {percent(max(values))}"


class Report:
    def __init__(self, results):
        self.results = results
        self.checks = {}
        for check in results["checks"]:
            self.checks.setdefault(check["check"], []).append(check)
        self.text = []

    def add(self, text):
        self.text.append(text.rstrip("\n") + "\n")

    def of(self, name):
        return self.checks.get(name, [])

    def head(self):
        versions = self.results["tools"].items()
        tools = ", ".join(f"{TOOLS.get(name, name)} {version}" for name, version in versions)
        self.add("# The Verilog, checked by other people's tools\n\nWritten by `scripts/rtl_report.py` from what `scripts/check_rtl.sh` "
                 "measured. `bumpsim rtl` emits each scheme's per-pixel units; every count, latency and area below is what another program "
                 "says of that Verilog, beside what bumpsim says.\n")
        self.add(f"Tools: {tools}. {len(self.results['schemes'])} schemes.")
        absent = [title for check, title in CHECKS.items() if check not in self.results["checks_run"]]
        if absent:
            self.add(f"**Not all of it: the run had no {', '.join(absent)}.**")
        command = f"scripts/check_rtl.sh{' --full' if self.results['full'] else ''}"
        self.add(f"This copy: `{command}`, {self.results['seconds'] / 60:.0f} minutes with {self.results['jobs']} tasks side by side"
                 + (", syntheses of earlier runs not counted." if self.results["taken_from_earlier_runs"] else "."))
        reused, made = self.results["taken_from_earlier_runs"], self.results["synthesised"]
        if reused:
            self.add(f"{reused} of the {reused + made} syntheses for areas and clocks are those of earlier runs, of the same Verilog with the "
                     "same tools and cells.")
        if not self.results["full"]:
            ran = {"placed and routed": {c["scheme"] for c in self.of("place_route")},
                   "also checked with two shared multipliers": {c["scheme"] for c in self.of("bit_exact") if c["data"].get("settings")},
                   "run in the pipeline": {c["scheme"] for c in self.of("cycles")}}
            samples = [f"words of areas and clocks: {', '.join(map(str, self.results['widths']))} bits"]
            samples += [f"{what}: {', '.join(sorted(schemes))}" for what, schemes in ran.items() if schemes]
            self.add("Samples. " + "; ".join(samples) + ". Everything else is of every scheme. `scripts/check_rtl.sh --full` leaves nothing "
                     "out.")
        rows = []
        for name in sorted(self.checks):
            states = [check["status"] for check in self.checks[name]]
            rows.append((f"`{name}`", MEANING.get(name, ""), states.count("ok"), states.count("FAILED"), states.count("skipped")))
        self.add(table(("check", "what must hold", "passed", "failed", "skipped"), rows, 2))
        failed = [check for check in self.results["checks"] if check["status"] == "FAILED"]
        if failed:
            self.add("Failed:\n\n" + "\n".join(f"* `{c['check']}` {c['scheme']} {c['unit']}: {c['detail']}" for c in failed))

    def bit_exact(self):
        checks = [check for check in self.of("bit_exact") if check["data"]]
        if not checks:
            return
        total, wrong = sum(c["data"]["vectors"] for c in checks), sum(c["data"]["mismatches"] for c in checks)
        self.add(f"## Bit-exact, with stalls\n\nVerilator's models against the fixed-point evaluation: {total:,} vectors, {wrong} "
                 "mismatches. A quarter of the vectors are corner words (0, 1, -1, extremes, single bits), the others uniformly random "
                 "over the whole word. Every vector is sent twice: without a pause, where the first latency and the interval are read "
                 "off, and with random pauses on both sides; then some again between resets in the middle. In every cycle `in_ready`, "
                 "`out_valid` and the words must be what the recurrences of the stage say. The test benches do the same in Icarus Verilog "
                 "with some hundred vectors, and Verilator's lint has nothing to say of any module (`benches`).")
        rows = {}
        for check in checks:
            shared = bool(check["data"]["settings"])
            row = rows.setdefault((check["scheme"], check["unit"]), {})
            row["shared" if shared else "plain"] = check["data"]
        body = []
        for (scheme, unit), row in sorted(rows.items()):
            plain, shared = row.get("plain"), row.get("shared")
            body.append((scheme, unit, *(plain[key] if plain else "" for key in ("vectors", "latency", "interval")),
                         f"{shared['latency']}, {shared['interval']}" if shared else ""))
        self.add(table(("scheme", "unit", "vectors", "latency", "interval", "latency, interval with 2 multipliers"), body, 2))

    def counts(self):
        if not self.of("operators"):
            return
        registers = {(c["scheme"], c["unit"]): c["data"] for c in self.of("registers") if c["data"] and "settings" not in c["data"]}
        rows, notes = [], []
        for check in self.of("operators"):
            found = check["data"].get("found")
            if not found or "settings" in check["data"]:
                continue
            bits = registers.get((check["scheme"], check["unit"]), {})
            kinds = ("multipliers", "adders", "dividers", "square_roots", "tables")
            rows.append((check["scheme"], check["unit"], *(found[kind] for kind in kinds), bits.get("bits", "")))
            if check["data"]["redundant"]:
                notes.append(f"* {check['scheme']}, {check['unit']}: {', '.join(check['data']['redundant'])}")
            if check["data"]["folded"]:
                notes.append(f"* {check['scheme']}, {check['unit']}: {', '.join(check['data']['folded'])} has only constants as operands; "
                             "it is counted as the paper counts it, and no hardware is emitted for it")
        for check in self.of("registers"):
            if check["data"] and "settings" not in check["data"] and check["data"]["after_opt"] != check["data"]["bits"]:
                notes.append(f"* {check['scheme']}, {check['unit']}: {check['data']['after_opt']} of {check['data']['bits']} register bits "
                             "are left, the others hold constants or the same as another")
        self.add("## Counts\n\nCells that Yosys finds before it maps anything (`read_verilog; hierarchy; proc; memory -nomap`), dividers, "
                 "roots and ROMs being modules of their own. They are what the inventory says, unit by unit and in all "
                 "(`operators_all`), also with multipliers shared; no operator is anywhere else; a row that differs would be among the "
                 "failures above. Additions to a published design are in it, and the Verilog names them. Registers are those of the pipeline, between operators and inside those of several cycles.")
        self.add(table(("scheme", "unit", "multipliers", "adders", "dividers", "square roots", "tables", "register bits"), rows, 2))
        if notes:
            self.add("What `opt` takes away, being redundant for the constants or the structure of the unit:\n\n" + "\n".join(notes))

    def dsp(self):
        rows = {}
        for family, _ in FAMILIES:
            for check in self.of(f"dsp_{family}"):
                if check["data"]:
                    rows.setdefault((check["scheme"], check["unit"]), {})[family] = check
        body = []
        for (scheme, unit), found in sorted(rows.items()):
            data = {family: check["data"] for family, check in found.items()}
            if len(data) < len(FAMILIES) or (not any(d["multipliers"] for d in data.values())):
                continue
            any_family = next(iter(data.values()))
            body.append((scheme, unit, any_family["multipliers"], *(data[family]["found"] for family, _ in FAMILIES)))
        if not body:
            return
        different = sorted(f"* {check['scheme']}, {check['unit']}, {family}: {check['detail']}" for found in rows.values()
                           for family, check in found.items() if check["data"]["found"] != check["data"]["multipliers"])
        self.add("## DSP blocks\n\nWords of 10 bits. Blocks that Yosys's mappings for three FPGA families take, a second count of the "
                 "multipliers. A factor wider than the block (16, 18 or 25 x 18 bits) takes several, a product of too few bits none; the "
                 "expected number follows from the widths and is what is checked.")
        self.add(table(("scheme", "unit", "multipliers", *(title for _, title in FAMILIES)), body, 2))
        if different:
            self.add("Where blocks are not multipliers:\n\n" + "\n".join(different))

    def area(self):
        checks = [check for check in self.of("area") if check["data"]]
        if not checks:
            return
        widths = sorted({check["data"]["width"] for check in checks})
        by = {(check["scheme"], check["data"]["width"]): check["data"] for check in checks}
        schemes = sorted({scheme for scheme, _ in by})
        self.add("## Area\n\nOpen 0.18 um cells (OSU, typical, 1.8 V; NAND2X1 = 24 um2): Yosys flattens the datapath and maps it with ABC, "
                 "ROMs as black boxes; each ROM is synthesised into gates on its own. The table of prices `osu018_model` is held against "
                 "it; its operators and registers were not fitted to these designs, its tables to other images of the same functions. The queue and handshake around a datapath are apart. Words have the "
                 "stated width wherever a scheme has a parameter for one, tables of a quarter turn 2^(w-2) words and at most 2^10 "
                 "(scripts/rtl/settings.toml).")
        exceptions = self.results["exceptions"]
        usual = [s for s in schemes if s not in exceptions]
        lines = []
        for part, title in TITLES.items():
            errors = {w: [by[s, w]["errors"][part] for s in usual if (s, w) in by and part in by[s, w]["errors"]] for w in widths}
            spans = [f"{span(errors[w])} at {w} bits" for w in widths]
            low, high = self.results["bands"][part]
            lines.append(f"* {title}: {', '.join(spans)}; the check allows {percent(low)} to {percent(high)}.")
        logic = sorted(by[s, w]["errors"]["logic"] for s in usual for w in widths if (s, w) in by)
        for scheme, exception in exceptions.items():
            spans = [f"{percent(by[scheme, w]['errors']['operators'])} and {percent(by[scheme, w]['errors']['logic'])} at {w} bits"
                     for w in widths if (scheme, w) in by]
            if spans:
                lines.append(f"* {scheme} is apart, operators, and operators and registers together, {', '.join(spans)}: "
                             f"{exception['reason']}.")
        self.add("Error of the table of prices against synthesis"
                 + (f", without {', '.join(exceptions)} but for its own line" if exceptions else "") + ":\n\n" + "\n".join(lines))
        if logic:
            self.add(f"Of {len(logic)} designs the median of operators and registers together is {percent(logic[len(logic) // 2])}. The "
                     "table prices components that were synthesised alone; in a design the low bits of products that nobody reads are "
                     "pruned, and with array dividers the bits of their registers that never change.")
        rows = []
        for scheme in schemes:
            row = [scheme]
            for width in widths:
                data = by.get((scheme, width))
                if data is None:
                    row += ["", ""]
                    continue
                errors = " ".join(signed(data["errors"][part]) if part in data["errors"] else "-" for part in PARTS)
                row += [f"{data['synthesised']['total']:.0f}", errors]
            rows.append(row)
        self.add("NAND2 by synthesis, and the error of the price table in operators, registers, tables and all, in per cent (-: less than "
                 "100 NAND2):\n")
        self.add(table(("scheme", *(text for w in widths for text in (f"{w} bits", "error, %"))), rows))
        notes = sorted({f"* {s} at {w} bits: {note}" for (s, w), data in by.items() for note in data["notes"]})
        if notes:
            self.add("Out of a scheme's range:\n\n" + "\n".join(notes))
        queues = {(c["scheme"], c["data"]["width"]): c["data"]["area"] for c in self.of("area_handshake") if c["data"]}
        if queues:
            rows = [(s, *(f"{queues[s, w]:.0f}" if (s, w) in queues else "" for w in widths)) for s in schemes]
            self.add("Handshake and completion queue around the datapaths, NAND2 (latency + 1 entries of flip-flops; a memory would be "
                     "smaller):\n")
            self.add(table(("scheme", *(f"{w} bits" for w in widths)), rows))

    def clock(self):
        checks = [check for check in self.of("clock") if check["data"]]
        if not checks:
            return
        widths = sorted({check["data"]["width"] for check in checks})
        by = {(c["scheme"], c["unit"], c["data"]["width"]): c["data"]["period"] for c in checks}
        units = sorted({key[:2] for key in by})
        rows = [(*unit, *(f"{by[(*unit, w)]:.2f}" if by.get((*unit, w)) else "-" for w in widths)) for unit in units]
        self.add("## Clock\n\nShortest period in ns from register to register by OpenSTA, for the netlists above: no wires, no sizing for "
                 "fan-out, one operator a cycle and one bit of a quotient. Reads of ROMs are not in the path, as these are black boxes. -: "
                 "no path from register to register, or through ROMs only.")
        self.add(table(("scheme", "unit", *(f"{w} bits" for w in widths)), rows, 2))

    def place(self):
        checks = [check for check in self.of("place_route") if check["data"]]
        if not checks:
            return
        rows = []
        for check in checks:
            data = check["data"]
            clock = f"{data['mhz']:.1f}" if data["mhz"] else "does not fit"
            rows.append((check["scheme"], data["cells"], f"{data['percent']} %", data["shift_registers"], clock))
        self.add("## Place and route\n\nnextpnr on a Lattice iCE40 HX8K, words of 8 bits, no DSP blocks, all units with their queues and "
                 "with ROMs as logic, ports on shift registers because the chip has fewer pins; these are in the cells.")
        self.add(table(("scheme", "logic cells", "of the chip", "of which shift registers", "MHz"), rows))
        notes = [f"* {check['scheme']}: {note}" for check in checks for note in check["data"]["notes"]]
        if notes:
            self.add("Out of a scheme's range:\n\n" + "\n".join(notes))

    def cycles(self):
        settings = ", ".join(f"{key}={value}" for key, value in self.results["cycles"]["settings"].items())
        if self.of("cycles"):
            self.add("## Cycles\n\n`scripts/cosimulate.sh` puts the units, through Verilator's SystemC models, in place of the program's "
                     "own in the stepped engine, on a scene: handshake, words, picture, cycles and statistics are compared. The units are "
                     f"made to wait and to be waited for ({self.results['cycles']['scene']}, {self.results['cycles']['size']} x "
                     f"{self.results['cycles']['size']}, {settings}), so that the cycles in all depend on theirs.\n\n"
                     + "\n".join(f"* {c['scheme']}: {c['detail']}" for c in self.of("cycles")))


CHECKS = {"counts": "counts", "benches": "test benches", "bit_exact": "vectors", "dsp": "DSP blocks", "area": "areas", "clock": "clocks",
          "place_route": "place and route", "cycles": "cycles in the pipeline"}
MEANING = {
    "bit_exact": "Verilator's words are the evaluation's; latency and interval are the schedule's",
    "benches": "lint finds nothing; Icarus's words and handshake are right",
    "operators": "Yosys finds a unit's operators and tables where they are counted, and nowhere else",
    "operators_all": "those of all units are what the scheme is said to be built of",
    "registers": "Yosys finds the register bits between and inside operators, as priced",
    "handshake": "Yosys finds the wrapper's register and queue bits",
    "dsp_ice40": "blocks as the widths ask for", "dsp_ecp5": "blocks as the widths ask for", "dsp_xilinx": "blocks as the widths ask for",
    "area": "the table of prices stays in its bands", "area_handshake": "synthesised, no claim", "clock": "no tool complains; a period, "
                                                                                                          "where a register feeds another",
    "place_route": "placed and routed, or too large", "cycles": "the same picture and cycles with the Verilog in place of the models"}


def saving(results):
    """Lee 2007 against the conventional method at equal words, where the number of multiplications says 78 %."""
    at = {}
    for check in results["checks"]:
        if check["check"] == "area" and check["scheme"] in ("lee2007", "peercy1997") and check["data"]:
            at.setdefault(check["data"]["width"], {})[check["scheme"]] = check["data"]
    rows = []
    for width, data in sorted(at.items()):
        if len(data) < 2:
            continue
        lee, peercy = data["lee2007"], data["peercy1997"]
        if lee["notes"] or peercy["notes"]:
            continue  # the words are not of equal width
        parts = [lee["synthesised"][part] / peercy["synthesised"][part] - 1 for part in ("operators", "registers")]
        rows.append((f"{width} bits", f"{lee['units']['environment']:.0f}", f"{peercy['units']['environment']:.0f}",
                     percent(lee["units"]["environment"] / peercy["units"]["environment"] - 1),
                     *map(percent, parts), percent(lee["synthesised"]["total"] / peercy["synthesised"]["total"] - 1)))
    if not rows:
        return ""
    head = ("words", "lee2007, environment", "peercy1997, environment", "environment", "both units: operators", "registers",
            "both units: all, with tables")
    return ("## 78 % fewer multiplications, in gates\n\nThe environment unit of Lee 2007 multiplies 6 times where the conventional one does "
            "27 times: 78 % fewer. NAND2 of the areas above, at equal words, against Peercy 1997 with its transform and array dividers in "
            "every pixel; without widths that one of the two does not have. Tables have 2^10 words at most, whatever the width.\n\n"
            + table(head, rows) + "\nAt equal quality, with energy: [pareto.md](pareto.md#in-gates).\n")


def main(argv):
    root = pathlib.Path(__file__).resolve().parent.parent
    parser = argparse.ArgumentParser(prog="rtl_report.py", description="Writes the report of scripts/check_rtl.sh.")
    parser.add_argument("work", nargs="?", type=pathlib.Path, default=root / "build/rtl", help="the checks' folder (default: build/rtl)")
    parser.add_argument("report", nargs="?", type=pathlib.Path, default=root / "reports/rtl.md", help="default: reports/rtl.md")
    arguments = parser.parse_args(argv)
    path, target = arguments.work / "results.json", arguments.report
    if not path.exists():
        print(f"rtl_report.py: {path} is not there; scripts/check_rtl.sh writes it", file=sys.stderr)
        return 2
    report = Report(json.loads(path.read_text()))
    for part in (report.head, report.bit_exact, report.counts, report.dsp, report.area, report.clock, report.place, report.cycles):
        part()
    report.add(saving(report.results))
    target.write_text("\n".join(report.text))
    print(f"{target} is up to date")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
