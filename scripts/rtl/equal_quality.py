#!/usr/bin/env python3
"""Designs of equal picture quality in gates: what scripts/rtl_equal_quality.sh runs. For the designs that `bumpsim fit` found at each
target it synthesises the datapaths and their tables into 0.18 um cells and measures their energy, beside what the table of prices says of
the same hardware. Figures go to <fits>/equal_quality.json, for scripts/explore_report.py."""

import argparse
import concurrent.futures
import json
import os
import pathlib
import sys

import area
import power
import tools
from emission import Program, ProgramFailed


SCENES = ("wood_plane", "brick_cube", "world_sphere")
CEILING = 23  # dB, what Lee 2007 reaches on the worst scene with any words
# In the structure as published, where a search would choose another: Lee 2007, and what its "78 % fewer multiplications" may be held
# against.
BASELINES = [("lee2007", {})] + [("peercy1997", {"peercy1997.transform": transform, "peercy1997.normaliser": normaliser})
                                 for transform in ("pixel", "vertex") for normaliser in ("divider", "table")]
OWN = [("tl0", {}), ("lns", {}), ("n2l", {})]  # beside them at the ceiling, for which nothing else is fitted


def pairs(text):
    return dict(pair.split("=", 1) for pair in (text or "").split())


def fit_baselines(program, folder, targets):
    """Fits what every comparison needs and is not there yet."""
    folder.mkdir(parents=True, exist_ok=True)
    for target in targets:
        for scheme, settings in BASELINES + (OWN if target == CEILING else []):
            if scheme == "lee2007" and target > CEILING:
                continue
            words = [scheme] + [value for value in settings.values()]
            out = folder / f"fit-{target}-{'-'.join(words)}.json"
            if out.exists():
                continue
            print(f"fitting {' '.join(words)} to {target} dB", flush=True)
            sets = [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
            program.run("fit", *SCENES, "--scheme", scheme, "--psnr", str(target), "--structure", "keep", "--cost", "area",
                        "--prices", "osu018_model", "--prices", "horowitz45", *sets, "--json", "--out", str(out))


def designs(folders, targets, largest):
    """Designs of the fits, each with the targets it stands for; and what is left out because it is larger than `largest` NAND2 by the
    price table."""
    found, left_out = {}, set()
    for path in [path for folder in folders for path in sorted(folder.glob("fit-*.json"))]:
        fit = json.loads(path.read_text())
        target = round(fit["psnr_target_db"])
        for row in fit["rows"]:
            if target not in targets or row["status"] != "reached":
                continue
            structure = {**fit["settings"], **pairs(row.get("structure"))}
            settings = {**structure, **pairs(row["widths"])}
            if row["area_nand2"] > largest and path.parent != folders[0]:
                left_out.add(f"{row['scheme']} at {target} dB")
                continue
            design = found.setdefault((row["scheme"], tuple(sorted(settings.items()))), {
                "scheme": row["scheme"], "settings": settings, "structure": structure, "widths": row["widths"], "targets": [],
                "baseline": path.parent == folders[0],
                "psnr_worst_db": row["psnr_worst_db"], "multipliers": row["multipliers"], "adders": row["adders"],
                "dividers": row["dividers"], "table_kilobytes": row["table_kilobytes"], "reconstruction": row["reconstruction"],
                "fit_area_nand2": row["area_nand2"],
                "fit_energy_pj": row["energy_pj_per_fragment"]})
            if target not in design["targets"]:
                design["targets"].append(target)
    return list(found.values()), sorted(left_out)


class Gates:
    """Synthesis and simulation of one design after the other."""

    def __init__(self, program, with_energy):
        self.program, self.with_energy = program, with_energy
        self.synthesis = area.Synthesis(program.work)

    def measure(self, number, design):
        scheme, settings = design["scheme"], design["settings"]
        folder, manifest = self.program.emit(scheme, f"equal-{number}", settings, vectors=2 * (power.CYCLES + 100))
        prices = self.program.price(scheme, settings)
        made = {unit["unit"]: area.unit_area(self.synthesis, folder, unit) for unit in manifest["units"]}
        priced = [area.priced(prices[unit]) for unit in made]
        result = {**design, "synthesised": {part: sum(unit[part] for unit in made.values()) for part in area.PARTS},
                  "priced": {part: sum(unit[part] for unit in priced) for part in area.PARTS},
                  "units": {unit["unit"]: {"multipliers": unit["built"]["multipliers"], "dividers": unit["built"]["dividers"],
                                           "gates": sum(made[unit["unit"]][part] for part in area.PARTS)} for unit in manifest["units"]}}
        if self.with_energy:
            energies = {unit["unit"]: self.energy(number, scheme, folder, unit, made[unit["unit"]]) for unit in manifest["units"]}
            result["energy_pj"] = sum(energy["total"] for energy in energies.values())
            result["energy_clocked_pj"] = sum(energy["sequential"] for energy in energies.values())
            for unit, energy in energies.items():
                result["units"][unit]["energy_pj"] = energy["total"]
        print(f"{scheme:<18} {'/'.join(map(str, design['targets'])):<9} {sum(result['synthesised'].values()):8.0f} NAND2, price table "
              f"{sum(result['priced'].values()) / sum(result['synthesised'].values()) - 1:+.1%}"
              + (f", {result['energy_pj']:.0f} pJ" if self.with_energy else ""), flush=True)
        return result

    def energy(self, number, scheme, folder, unit, figures):
        name = unit["unit"]
        place = self.program.work / "power" / f"{number}-{scheme}-{name}"
        log = self.program.work / "logs" / "power" / f"{number}-{scheme}-{name}.log"
        return power.energy_of_unit(unit, folder, figures, self.synthesis, place, log)[0]


def main(argv):
    parser = argparse.ArgumentParser(prog="rtl_equal_quality.sh", description=__doc__)
    parser.add_argument("--fits", type=pathlib.Path, required=True, help="folder that scripts/explore.sh left its fits in "
                                                                          "($EXPLORE_WORK); those of the baselines are added")
    parser.add_argument("--program", default="build/bumpsim")
    parser.add_argument("--work", default="build/rtl")
    parser.add_argument("--targets", default="23,30,40,48", help="dB (default: 23,30,40,48)")
    parser.add_argument("--schemes", default="all")
    parser.add_argument("--largest", type=float, default=100e3, help="NAND2 by the price table above which a design is left out, "
                                                                     "but for the baselines (default: 100000)")
    parser.add_argument("--no-energy", action="store_true")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    arguments = parser.parse_args(argv)
    needed = tools.missing("yosys", "osu018", *(() if arguments.no_energy else ("iverilog", "sta")))
    if needed:
        print(f"rtl_equal_quality.sh: no {needed}", file=sys.stderr)
        return 2
    program = Program(pathlib.Path(arguments.program).resolve(), pathlib.Path(arguments.work).resolve())
    targets = [int(target) for target in arguments.targets.split(",")]
    if not any(arguments.fits.glob("fit-*.json")):
        print(f"rtl_equal_quality.sh: no fits in {arguments.fits}; EXPLORE_WORK={arguments.fits} scripts/explore.sh makes them",
              file=sys.stderr)
        return 2
    baselines = arguments.fits / "baselines"
    fit_baselines(program, baselines, targets)
    found, left_out = designs([baselines, arguments.fits], targets, arguments.largest)
    if arguments.schemes != "all":
        found = [design for design in found if design["scheme"] in arguments.schemes.split(",")]
    if not found:
        print("rtl_equal_quality.sh: no fit reached any of the targets", file=sys.stderr)
        return 2
    gates = Gates(program, not arguments.no_energy)
    results, failed = [], 0
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        order = sorted(range(len(found)), key=lambda i: -found[i]["fit_area_nand2"])
        futures = {i: pool.submit(gates.measure, i, found[i]) for i in order}
        try:
            for i, design in enumerate(found):
                try:
                    results.append(futures[i].result())
                except (tools.ToolFailed, ProgramFailed, OSError, KeyError, ValueError) as error:
                    failed += 1
                    print(f"FAILED {design['scheme']} {design['settings']}: {error}", flush=True)
        except BaseException:
            for future in futures.values():
                future.cancel()
            tools.stop_all()
            raise
    document = {"designs": results, "left_out": left_out, "largest": arguments.largest, "tools": tools.versions(), "cycles": power.CYCLES}
    (arguments.fits / "equal_quality.json").write_text(json.dumps(document, indent=1) + "\n")
    print(f"{len(results)} designs measured, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except KeyboardInterrupt:
        sys.exit(130)
