"""Verilator's model of a unit against the fixed-point evaluation, with the harness that the program writes."""

import re
import shutil

import tools
from results import FAILED, OK, Check

LINE = re.compile(r": (\d+) vectors, (\d+) mismatches, latency (\d+), interval (\d+)")


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
