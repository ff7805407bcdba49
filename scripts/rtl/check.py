#!/usr/bin/env python3
"""Other people's tools against the program's Verilog: see scripts/check_rtl.sh, which starts this."""

import argparse
import concurrent.futures
import os
import pathlib
import re
import signal
import sys
import time

import area
import bit_exact
import clock
import counts
import fpga
import place
import tools
from emission import SETTINGS, Program, ProgramFailed
from results import FAILED, OK, SKIPPED, Check, Results

CHECKS = {  # name: the tools it needs
    "counts": ("yosys",),
    "benches": ("verilator", "iverilog", "make"),
    "bit_exact": ("verilator", "make", "g++"),
    "dsp": ("yosys",),
    "area": ("yosys", "osu018"),
    "clock": ("yosys", "osu018", "sta"),
    "place_route": ("yosys", "nextpnr-ice40"),
    "cycles": ("verilator", "make", "g++"),
}
QUICK = ("counts", "bit_exact")


class Plan:
    """The tasks of a run: what is checked, with which tool, in an order that starts long ones early."""

    def __init__(self, program, results, arguments):
        self.program, self.results, self.arguments = program, results, arguments
        self.synthesis = area.Synthesis(program.work)
        self.tasks = []

    def log(self, check, scheme, unit=""):
        return self.program.work / "logs" / check / f"{scheme}-{unit or 'all'}.log"

    def add(self, weight, check, scheme, unit, work):
        self.tasks.append((weight, lambda: self.attempt(check, scheme, unit, work)))

    def add_chain(self, weight, check, schemes, work):
        """As add() for each scheme, one after the other."""
        self.tasks.append((weight, lambda: [self.attempt(check, scheme, "all", lambda: work(scheme)) for scheme in schemes]))

    def does(self, sample, scheme):
        """Schemes that are asked for by name are no sample."""
        return self.arguments.full or self.arguments.schemes != "all" or scheme in SETTINGS["sample"][sample]

    def add_scheme(self, scheme, checks):
        folder, manifest = self.program.emit(scheme, "default", {})
        units = manifest["units"]
        if "counts" in checks:
            inventory = self.program.inventory(scheme)
            self.add(0, "counts", scheme, "all", lambda: counts.check_scheme(
                scheme, units, folder, lambda unit: self.log("counts", scheme, unit), inventory))
        if "benches" in checks:
            self.add(1, "benches", scheme, "all", lambda: bit_exact.check_benches(self.program, scheme, self.log("benches", scheme)))
        for unit in units:
            self.add_unit(scheme, unit, checks)
        if "dsp" in checks:
            self.add_dsp(scheme)
        if "place_route" in checks and self.does("place_route", scheme):
            self.add(3, "place_route", scheme, "all", lambda: self.place(scheme))
        if "area" in checks or "clock" in checks:
            for width in self.arguments.widths:
                self.add(width, "area", scheme, "all", lambda width=width: self.area(scheme, width, checks))

    def add_unit(self, scheme, unit, checks):
        name, vectors = unit["unit"], self.arguments.vectors
        if "bit_exact" in checks:
            self.add(2, "bit_exact", scheme, name,
                     lambda: bit_exact.check_unit(self.program, scheme, unit, vectors, self.log("bit_exact", scheme, name)))
        if not self.does("shared", scheme) or self.arguments.quick or unit["built"]["multipliers"] <= 2:
            return
        # A stage without limit of its own (the address of light maps) is named after its stage.
        limit = {{"light_map_address": "light_map_fetch"}.get(name, name) + ".multipliers": 2}
        if "bit_exact" in checks:
            self.add(1, "bit_exact", scheme, name, lambda: bit_exact.check_unit(
                self.program, scheme, unit, max(2, vectors // 10), self.log("bit_exact_shared", scheme, name), "shared", limit,
                " with 2 multipliers"))
        if "counts" in checks:
            self.add(0, "counts", scheme, name, lambda: self.shared_counts(scheme, name, limit))

    def shared_counts(self, scheme, name, limit):
        folder, manifest = self.program.emit(scheme, f"shared-counts-{name}", limit, unit=name)
        checks = counts.check_unit(scheme, manifest["units"][0], folder, self.log("counts_shared", scheme, name))
        for check in checks:
            check.detail += ", with 2 multipliers"
            check.data["settings"] = limit
        return checks

    def add_dsp(self, scheme):
        settings, _ = self.program.width_settings(scheme, 10)
        folder, manifest = self.program.emit(scheme, "w10-dsp", settings)
        prices = self.program.price(scheme, settings)
        for unit in manifest["units"]:
            name, items = unit["unit"], prices[unit["unit"]]["area"]["items"]
            self.add(1, "dsp", scheme, name, lambda unit=unit, name=name, items=items: fpga.check_dsp(
                scheme, unit, folder, self.log("dsp", scheme, name), items))

    def place(self, scheme):
        settings, notes = self.program.width_settings(scheme, 8)
        folder, manifest = self.program.emit(scheme, "w8-place", settings)
        return place.check_scheme(scheme, manifest["units"], folder, self.log("place_route", scheme), notes)

    def area(self, scheme, width, checks):
        settings, notes = self.program.width_settings(scheme, width)
        folder, manifest = self.program.emit(scheme, f"w{width}", settings)
        units = manifest["units"]
        made = {unit["unit"]: area.unit_area(self.synthesis, folder, unit) for unit in units}
        found = []
        if "area" in checks:
            prices = self.program.price(scheme, settings)
            found.append(area.compare(scheme, width, made, {unit: area.priced(prices[unit]) for unit in made}, notes))
            wrappers = [self.synthesis.wrapper(folder, unit["top"]) for unit in units]
            handshake = sum(w["registers"] + w["operators"] for w in wrappers)
            found.append(Check(OK, "area_handshake", scheme, "all", f"{width} bits: {handshake:.0f} NAND2 beside the datapaths, most of "
                                                                    f"it queues",
                               {"width": width, "area": handshake}))
        if "clock" in checks:
            for unit, figures in zip(units, made.values()):
                if tools.missing(*CHECKS["clock"]):
                    found.append(Check(SKIPPED, "clock", scheme, unit["unit"], f"no {tools.missing(*CHECKS['clock'])}"))
                    continue
                try:
                    found += clock.check_unit(scheme, unit, width, figures, notes, self.log(f"clock-{width}", scheme, unit["unit"]))
                except tools.ToolFailed as error:
                    found.append(Check(FAILED, "clock", scheme, unit["unit"], f"{width} bits: {error}"))
        return found

    def attempt(self, check, scheme, unit, task):
        """A task that fails is a line, not the end."""
        needed = tools.missing(*CHECKS.get(check, ()))
        if needed:
            self.results.add([Check(SKIPPED, check, scheme, unit, f"no {needed}")])
            return
        try:
            self.results.add(task())
        except (tools.ToolFailed, ProgramFailed, OSError, KeyError, ValueError, IndexError) as error:
            self.results.add([Check(FAILED, check, scheme, unit, f"{type(error).__name__}: {error}")])

    def run(self):
        """Two tasks at a time on two cores."""
        with concurrent.futures.ThreadPoolExecutor(self.arguments.jobs) as pool:
            futures = [pool.submit(task) for _, task in sorted(self.tasks, key=lambda task: -task[0])]
            try:
                for future in futures:
                    future.result()
            except BaseException:
                for future in futures:
                    future.cancel()
                tools.stop_all()
                raise


def cycles(plan, schemes):
    """The emitted units inside the SystemC pipeline, by a script of its own; one at a time, since each builds what it needs first. With
    default settings the vertices hold everything up, and no unit is ever full: the settings make the units wait, and be waited for."""
    script = pathlib.Path(__file__).resolve().parent.parent / "cosimulate.sh"
    chosen = SETTINGS["cycles"]

    build = pathlib.Path(plan.program.path).parent
    environment = {"BUILD": str(build)}
    if plan.arguments.no_install:
        environment["NO_INSTALL"] = "1"
        if not (build / "testbench/cosimulation/cosimulate").exists():
            plan.results.add([Check(SKIPPED, "cycles", scheme, "all", f"no cosimulate in {build}") for scheme in schemes])
            return
    settings = [word for key, value in chosen["settings"].items() for word in ("--set", f"{key}={value}")]

    def work(scheme):
        text = tools.run([str(script), scheme, chosen["scene"], "--size", str(chosen["size"]), *settings], plan.log("cycles", scheme),
                         environment=environment)
        said = re.search(r"cycles: (\d+) with models, (\d+) with Verilog", text)
        summary = re.search(r"(\d+) passed, (\d+) failed", text)
        good = said and summary and said[1] == said[2] and summary[2] == "0"
        detail = "the script compared nothing"
        if said and summary:
            detail = f"{said[0]}; {summary[0]}"
        return [Check(OK if good else FAILED, "cycles", scheme, "all", detail, {"detail": detail})]

    plan.add_chain(20, "cycles", [scheme for scheme in schemes if plan.does("cycles", scheme)], work)


def parse(argv):
    names = ",".join(CHECKS)
    parser = argparse.ArgumentParser(prog="check_rtl.sh", description="Checks the emitted Verilog of every scheme with other people's "
                                                                      "tools.")
    parser.add_argument("--program", default="build/bumpsim", help="bumpsim (default: build/bumpsim, which the script builds)")
    parser.add_argument("--work", default="build/rtl", help="folder for everything that is written (default: build/rtl)")
    parser.add_argument("--schemes", default="all", help="ids with commas between (default: all)")
    parser.add_argument("--checks", default=names, help=f"some of {names} (default: all)")
    parser.add_argument("--full", action="store_true", help="no samples: all widths, every scheme placed and routed and in the "
                                                            "pipeline; half an hour and more")
    parser.add_argument("--widths", help="word widths of the areas and clocks (default: 8,12; 8,10,12,16 with --full)")
    parser.add_argument("--vectors", type=int, help="of each unit (default: 1000000; 100000 with --quick)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="tasks side by side (default: one per core)")
    parser.add_argument("--quick", action="store_true", help="two schemes, counts and bit-exactness only")
    parser.add_argument("--no-install", action="store_true", help="neither installs packages nor builds; needs --program or build/bumpsim")
    arguments = parser.parse_args(argv)
    try:
        sampled = SETTINGS["full" if arguments.full else "sample"]["widths"]
        arguments.widths = [int(width) for width in arguments.widths.split(",")] if arguments.widths else sampled
    except ValueError:
        parser.error(f"--widths {arguments.widths}: whole numbers with commas between")
    arguments.checks = arguments.checks.split(",")
    unknown = [check for check in arguments.checks if check not in CHECKS]
    if unknown:
        parser.error(f"there is no check {unknown[0]}; choose from {names}")
    if arguments.quick:
        arguments.schemes = ",".join(SETTINGS["quick"]["schemes"]) if arguments.schemes == "all" else arguments.schemes
        arguments.checks = [check for check in arguments.checks if check in QUICK]
        if not arguments.checks:
            parser.error(f"--quick has the checks {' and '.join(QUICK)} only")
    if arguments.vectors is None:
        arguments.vectors = 100_000 if arguments.quick else 1_000_000
    if min(arguments.jobs, *arguments.widths) < 1 or arguments.vectors < 2:
        parser.error("numbers must be at least 1, vectors at least 2")
    return arguments


def interrupt(*_):
    raise KeyboardInterrupt


def main(argv):
    arguments = parse(argv)
    signal.signal(signal.SIGTERM, interrupt)  # what runs is ended in the same way
    begin = time.monotonic()
    program = Program(pathlib.Path(arguments.program).resolve(), pathlib.Path(arguments.work).resolve())
    results = Results()
    try:
        every = program.schemes()
        schemes = every if arguments.schemes == "all" else arguments.schemes.split(",")
        unknown = [scheme for scheme in schemes if scheme not in every]
        if unknown:
            print(f"check_rtl.sh: there is no scheme {unknown[0]}; bumpsim list schemes names them", file=sys.stderr)
            return 2
        plan = Plan(program, results, arguments)
        for scheme in schemes:
            try:
                plan.add_scheme(scheme, arguments.checks)
            except ProgramFailed as error:
                results.add([Check(FAILED, "emission", scheme, "all", str(error))])
        if "cycles" in arguments.checks:
            cycles(plan, schemes)
        plan.run()
    except (ProgramFailed, OSError) as error:
        print(f"check_rtl.sh: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("check_rtl.sh: interrupted", file=sys.stderr)
        return 130
    if not arguments.quick:
        results.write(program.work / "results.json", {
            "schemes": schemes, "checks_run": arguments.checks, "full": arguments.full, "widths": arguments.widths,
            "vectors": arguments.vectors, "tools": tools.versions(), "bands": SETTINGS["bands"],
            "exceptions": SETTINGS["exceptions"], "jobs": arguments.jobs, "cycles": SETTINGS["cycles"],
            "synthesised": len(plan.synthesis.made), "taken_from_earlier_runs": len(plan.synthesis.reused),
            "seconds": round(time.monotonic() - begin)})
    print(results.summary())
    return 1 if results.count(FAILED) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
