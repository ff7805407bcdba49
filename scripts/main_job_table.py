#!/usr/bin/env python3
"""Prints Markdown tables from the comparisons SCENE/compare.json in the folder given as the argument."""

import json
import pathlib
import sys

SCENES = ["wood_plane", "brick_cube", "world_sphere", "brick_torus", "bunny"]


def decibel(comparison):
    if comparison is None:
        return "-"
    value = comparison["psnr_db"]
    return "identical" if value is None else f"{value:.1f}"


def main():
    folder = pathlib.Path(sys.argv[1])
    results = {}
    for path in sorted(folder.glob("*/compare.json")):
        comparison = json.loads(path.read_text())
        for scheme in comparison["schemes"]:
            results[comparison["scene"]["name"], scheme["id"]] = scheme["result"]
    schemes = sorted({scheme for _, scheme in results})

    print("# The main job: every scheme on every shipped scene\n")
    print("Written by `scripts/report.sh`. 512 x 512 pixels, one light, default configurations, fixed point.\n")
    print("## Quality\n")
    print("PSNR in dB over object pixels: the hardware's picture against the reference (same map), of which the scheme's own formula in double\n"
          "precision, and the hardware's picture against that formula (quantisation).\n")
    print("| scene | scheme | hardware / reference | double / reference | hardware / double | hardware / Blinn | largest error of 255 |")
    print("|--|--|--|--|--|--|--|")
    for scene in SCENES:
        for scheme in schemes:
            quality = results[scene, scheme]["quality"]
            print(f"| {scene} | {scheme} | {decibel(quality['against_reference'])} | {decibel(quality['double_against_reference'])} "
                  f"| {decibel(quality['against_double'])} | {decibel(quality.get('against_blinn'))} "
                  f"| {quality['against_reference']['max_error']:.0f} |")
    print("\n## Time\n")
    print("| scene | scheme | fragments | cycles | fragments per cycle | bound reached | what binds | cache hits |")
    print("|--|--|--|--|--|--|--|--|")
    for scene in SCENES:
        for scheme in schemes:
            r = results[scene, scheme]
            print(f"| {scene} | {scheme} | {r['fragments']:,} | {r['cycles']:,} | {r['fragments_per_cycle']:.3f} "
                  f"| {100 * r['bound']['cycles'] / r['cycles']:.0f} % | {r['bound']['by']} | {100 * r['texture']['hit_rate']:.2f} % |")
    print("\n## Angle of L' from the exact vector (degrees)\n")
    print("| scene | scheme | mean | rms | largest |")
    print("|--|--|--|--|--|")
    for scene in SCENES:
        for scheme in schemes:
            for error in results[scene, scheme]["angular_error"]["hardware"]:
                if error["vector"] == "L'" and error["count"] > 0:
                    print(f"| {scene} | {scheme} | {error['mean_degrees']:.3f} | {error['rms_degrees']:.3f} | {error['max_degrees']:.3f} |")


if __name__ == "__main__":
    main()
