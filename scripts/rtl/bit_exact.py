"""The Verilog against the fixed-point evaluation: Verilator's model of a unit with the harness that the program writes, and the test
benches in Icarus Verilog."""

import re
import shutil

import tools
from results import FAILED, OK, Check

BENCH_LINE = re.compile(r"^(\w+): (\d+) vectors, (\d+) mismatches, latency (\d+), interval (\d+)", re.M)
LINE = re.compile(r": (\d+) vectors, (\d+) mismatches, latency (\d+), interval (\d+)")


BENCH_VECTORS = 200


def check_benches(program, scheme, log):
    """Lint of every module by Verilator, and the test benches in Icarus Verilog: a line for the scheme."""
    folder, manifest = program.emit(scheme, "benches", {}, vectors=BENCH_VECTORS)
    text = tools.run(["make", "lint", "test", "SEED=7"], log, folder)
    said = {unit: [int(word) for word in words] for unit, *words in BENCH_LINE.findall(text)}
    good = all(said.get(unit["unit"]) == [BENCH_VECTORS, 0, unit["latency"], unit["initiation_interval"]] for unit in manifest["units"])
    good = good and all(f"{unit['unit']}: lint found nothing" in text for unit in manifest["units"])
    text = f"lint found nothing; {', '.join(said)}: {BENCH_VECTORS} vectors each, 0 mismatches" if good else f"see {log}"
    return [Check(OK if good else FAILED, "benches", scheme, "all", text, {"vectors": BENCH_VECTORS})]


def check_unit(program, scheme, unit, vectors, log, tag="vectors", settings=None, what=""):
    """A million vectors are some 100 MB of text: the folder goes away when they have been compared."""
    name = unit["unit"]
    folder, manifest = program.emit(scheme, f"{tag}-{name}", settings or {}, vectors=vectors, unit=name)
    unit = manifest["units"][0]
    try:
        text = tools.run(["make", f"verilate-{name}", "SEED=7"], log, folder)
    finally:
        shutil.rmtree(folder)
    said = LINE.search(text)
    if not said:
        return [Check(FAILED, "bit_exact", scheme, name, f"the harness said nothing (log: {log})")]
    count, mismatches, latency, interval = (int(word) for word in said.groups())
    good = (count, mismatches, latency, interval) == (vectors, 0, unit["latency"], unit["initiation_interval"])
    text = f"{count} vectors{what}, {mismatches} mismatches, latency {latency}, interval {interval}"
    if not good:
        text += f"; expected {vectors} vectors, latency {unit['latency']}, interval {unit['initiation_interval']}"
    return [Check(OK if good else FAILED, "bit_exact", scheme, name, text,
                  {"vectors": count, "mismatches": mismatches, "latency": latency, "interval": interval, "settings": settings or {}})]
