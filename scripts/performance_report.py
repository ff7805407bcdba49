#!/usr/bin/env python3
"""Puts the outputs of the benchmark programs in the folder given together as Markdown, and times whole runs and start-up beside them."""

import json
import pathlib
import statistics
import subprocess
import sys
import time

ROUNDS = 7


def seconds(command):
    begin = time.monotonic()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return time.monotonic() - begin


def interleaved(commands):
    """Median seconds of each command, taking turns."""
    taken = [[] for _ in commands]
    for _ in range(ROUNDS):
        for i, command in enumerate(commands):
            taken[i].append(seconds(command))
    return [statistics.median(each) for each in taken]


def whole_runs(work):
    rows = []
    for size in (512, 2048):
        folder = work / f"scenes-{size}"
        subprocess.run(["cp", "-r", "scenes", folder], check=True)
        path = folder / "world_sphere.toml"
        path.write_text(path.read_text().replace("width = 512", f"width = {size}").replace("height = 512", f"height = {size}"))
        whole, engine, units = [], [], []
        for _ in range(ROUNDS):
            whole.append(seconds(["build/bumpsim", "run", path, "--no-quality", "--out", work / "run", "--force"]))
            host = json.loads((work / "run" / "result.json").read_text())["host"]
            engine.append(host["wall_s"])
            units.append(host["wall_s"] - host["parts_s"]["preparation"])
        rows.append((size, statistics.median(whole) / statistics.median(engine), statistics.median(whole) / statistics.median(units)))
    return rows


def main():
    work = pathlib.Path(sys.argv[1])
    processor = next((line.split(":")[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")), "unknown")
    print("# Performance\n")
    print(f"Written by `scripts/performance.sh`; one core, {processor}. Only ratios of one run mean anything: machines differ, and this one is shared.\n")
    print("## Engines\n")
    print("The simulation alone (`--no-quality`; without reading the scene, preparing designs, tables and encoded maps, which is the same for all engines, and writing the result). A scene that stalls, with many cycles a fragment, flatters the first ratio.\n")
    print((work / "engines.md").read_text())
    print("With larger frames:\n")
    print((work / "engines-large.md").read_text())
    print("## Dates alone\n")
    print("The timing planes without any values, fed with the records of a recorded run (512 x 512): the clocked engine, the recurrence as a loop written by hand, "
          "which counts nothing, and the timeline of the dated engine with all its statistics.\n")
    print((work / "dates.md").read_text())
    print("## Where the time goes\n")
    print("The dated run by unit, in nanoseconds a fragment; preparation (encoding of bump maps, tables, empty frames) in milliseconds.\n")
    print((work / "stages.md").read_text())
    print("With growing frames:\n")
    print((work / "sizes.md").read_text())
    print("## Values\n")
    print("Netlists evaluated in blocks, against the Lee 2007 datapath written by hand as one vectorised loop in double precision.\n")
    print("```\n" + (work / "datapath.txt").read_text() + "```\n")
    print("## Re-timing\n")
    print("Million fragment-configurations a second on one core; with other caches, million fragments a second through the cache model (one cache, and eight at once); "
          "bytes of the trace for a fragment, without and with addresses.\n")
    print("| trace | bytes | with addresses | timeline | vectors, depths alike | vectors, all depths different | one cache | eight caches |")
    print("|--|--:|--:|--:|--:|--:|--:|--:|")
    for trace in json.loads((work / "retime.json").read_text()):
        rate = trace["million_fragment_configurations_per_s"]
        caches = trace["million_fragment_caches_per_s"]
        print(f"| {trace['scene']}, {trace['scheme']} | {trace['bytes_per_fragment']:.2f} | {trace['bytes_per_fragment_with_addresses']:.2f} "
              f"| {rate['timeline, depths alike']:.0f} | {rate['vectors, depths alike']:.0f} | {rate['vectors, all depths different']:.0f} "
              f"| {caches['texture cache']:.0f} | {caches['texture caches, eight at once']:.0f} |")
    sweep = ["build/bumpsim", "retime", work / "world_sphere.trace", "--format", "csv", "--jobs", "2",
             "--sweep", "memory.latency=" + ",".join(str(10 * i) for i in range(1, 101)),
             "--sweep", "fifos.depth=" + ",".join(str(i) for i in range(2, 102))]
    print(f"\n10,000 configurations of world_sphere (memory latency x FIFO depth) with two threads: {seconds(sweep):.1f} s.\n")
    print("## Whole runs\n")
    print("With the default number of threads: the two pictures are encoded side by side where there are two cores.\n")
    for size, ratio, to_units in whole_runs(work):
        print(f"* `run world_sphere --no-quality` at {size} x {size}, reading and writing included: {ratio:.1f} times the simulation with its preparation "
              f"(designs, tables, encoded maps, empty frames), {to_units:.1f} times the engine alone as above")
    nothing, listing = interleaved([["build/testbench/bench/bench_nothing"], ["build/bumpsim", "list"]])
    print(f"* `bumpsim list`: {1000 * (listing - nothing):.0f} ms more than a SystemC program that does nothing")
    print("\nWhat bounds these figures, and what was tried: [testbench/bench](../testbench/bench/README.md).")


if __name__ == "__main__":
    main()
