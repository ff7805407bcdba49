#!/usr/bin/env python3
"""For better_designs.sh: the specification of what is held against other scenes, and the report."""

import json
import pathlib
import sys

import table_study

TARGETS = (30, 40, 48)
SCENES = ("brick_torus", "bunny", "world_sphere")
PUBLISHED = ("lee2007", "peercy1997")


def fits(work):
    rows = []
    for path in sorted(work.glob("fit-*.json")):
        fit = json.loads(path.read_text())
        for row in fit["rows"]:
            if row["status"] in ("reached", "not_reached"):
                row["settings"] = {**fit["settings"], **{choice["key"]: choice["value"] for choice in row["choices"] if choice["value"] != choice["given"]}}
                row["prices"] = fit["prices"]
                if all(key_of(row) != key_of(other) or row["psnr_target_db"] != other["psnr_target_db"] for other in rows):
                    rows.append(row)  # a search may arrive where another was told to begin
    return rows


def name(row):
    settings = " ".join(f"{key.split('.')[-1]}={value}" for key, value in sorted(row["settings"].items()))
    return (row["scheme"] + ("" if row["scheme"] in PUBLISHED else "*") + " " + settings).strip()


def key_of(row):
    return (row["scheme"], row["widths"], json.dumps(row["settings"], sort_keys=True))


def write_specification(work):
    rows = list({key_of(row): row for row in fits(work)}.values())
    schemes = ", ".join(f'"{s}"' for s in sorted({row["scheme"] for row in rows}))
    text = f'scenes = [{", ".join(json.dumps(s) for s in SCENES)}]\nschemes = [{schemes}]\nquality = true\n'
    for row in rows:
        for scene in SCENES:
            text += f'[[list]]\nscene = "{scene}"\nscheme = "{row["scheme"]}"\n'
            text += "".join(f"{key} = {json.dumps(value)}\n" for key, value in row["settings"].items())
            text += "".join("{} = {}\n".format(*pair.split("=")) for pair in row["widths"].split())
    (work / "held.toml").write_text(text)


def read_held(work, rows):
    points = [json.loads(line) for line in (work / "held" / "points.jsonl").read_text().splitlines()]
    place = 0
    seen = {}
    for row in rows:
        key = key_of(row)
        if key not in seen:
            seen[key] = points[place : place + len(SCENES)]
            place += len(SCENES)
        row["held"] = {point["scene"]: point for point in seen[key]}
        assert set(row["held"]) == set(SCENES) and all(point["scheme"] == row["scheme"] for point in seen[key])


def psnr(row, scene):
    value = row["held"][scene].get("psnr_hardware_to_reference_db")
    return "-" if value is None else f"{value:.1f}"


def rate(row):
    value = row["held"]["world_sphere"].get("fragments_per_cycle")
    return "-" if value is None else f"{value:.2f}"


def smallest(rows, target, accept):
    candidates = [row for row in rows if row["psnr_target_db"] == target and row["status"] == "reached" and accept(row)]
    return min(candidates, key=lambda row: row["area_nand2"], default=None)


def headline(rows):
    print("## In short\n")
    print("Of the designs in the tables below:\n")
    for target in TARGETS:
        best = smallest(rows, target, lambda row: row["scheme"] not in PUBLISHED)
        same = smallest(rows, target, lambda row: row["scheme"] not in PUBLISHED and row["settings"].get(row["scheme"] + ".angles") == "pixel"
                        and row["scheme"].startswith("tl"))
        turning = smallest(rows, target, lambda row: row["scheme"] not in PUBLISHED and not row["scheme"].startswith("tl"))
        published = smallest(rows, target, lambda row: row["scheme"] in PUBLISHED)
        if best is None:
            continue
        text = (f"* At {target} dB the smallest is **{name(best)}**: {best['area_nand2']:.0f} NAND2, {best['table_bits']} bits of tables, {best['adders']} adders, "
                f"{best['multipliers']} multipliers, one fragment a clock by itself ({rate(best)} on world_sphere with default FIFOs and memory); held against scenes that were "
                f"not used, {psnr(best, 'brick_torus')} dB (brick_torus) and {psnr(best, 'bunny')} dB (bunny).")
        if turning:
            text += f" The smallest that takes the angles of Lee 2007, along the object's axes, is {name(turning)} with {turning['area_nand2']:.0f} NAND2."
        if published:
            text += (f" The smallest published design is {name(published)} with {published['area_nand2']:.0f} NAND2, {published['area_nand2'] / best['area_nand2']:.1f} times as many "
                     f"({psnr(published, 'brick_torus')} and {psnr(published, 'bunny')} dB).")
        if same and published:
            text += (f" Given the very interpolants of that, {name(same)} needs {same['area_nand2']:.0f} NAND2 with the unit that makes angles of them: a factor of "
                     f"{published['area_nand2'] / same['area_nand2']:.1f}.")
        print(text)
    print()


def equal_quality(rows):
    for target in TARGETS:
        print(f"## At {target} dB\n")
        print("| design | PSNR, worst of three | brick_torus | bunny | multipliers | adders | table bits | area | energy | fragments a cycle |")
        print("|--|--:|--:|--:|--:|--:|--:|--:|--:|--:|")
        of_target = [row for row in rows if row["psnr_target_db"] == target]
        for row in sorted(of_target, key=lambda row: (row["status"] != "reached", row["area_nand2"])):
            reached = "" if row["status"] == "reached" else " (not reached)"
            print(f"| {name(row)} | {row['psnr_worst_db']:.1f}{reached} | {psnr(row, 'brick_torus')} | {psnr(row, 'bunny')} | {row['multipliers']} | {row['adders']} | "
                  f"{row['table_bits']} | {row['area_nand2']:.0f} | {row['energy_pj_per_fragment']:.1f} | {rate(row)} |")
        print()
    print("Widths that were found:\n")
    for row in sorted(rows, key=lambda row: (row["psnr_target_db"], name(row))):
        print(f"* {row['psnr_target_db']:g} dB, {name(row)}: {row['widths']}")
    print()


def inputs(work):
    vertex, pixel, variant = (json.loads((work / f"inputs-{kind}.json").read_text()) for kind in ("vertex", "pixel", "variant"))
    rows = [(scheme["scheme"], scheme) for scheme in vertex["schemes"]]
    rows += [(scheme["scheme"] + " transform=vertex", scheme) for scheme in variant["schemes"]]

    def unit(scheme, which):
        return next((u for u in scheme.get("units", []) if u["unit"] == which), None)

    def amount(entry, key):
        return "-" if entry is None or not entry.get(key) else f"{entry[key]['total'] / (1000 if key == 'area' else 1):.1f}"

    def count(entry, component):
        if entry is None or not entry.get("area"):
            return "-"
        return f"{sum(item['count'] for item in entry['area']['items'] if item['component'] == component):.0f}"

    print("## What producing the inputs costs\n")
    print("No bump-mapping figure contains its interpolators. Here they are, perspective correction and texture coordinates included, as 16-bit fixed-point hardware with an own multiplier for every product, one "
          "fragment a clock, default settings (the program itself interpolates in floating point). *Vertex*: angles or vectors as the scheme interpolates them. *Pixel*: schemes on angles interpolate "
          "vectors instead, and a conversion unit makes the angles (default widths, priced with its registers). What paper or project left open is priced alike for all. Thousands of NAND2, pJ a fragment; vertex work pJ a vertex, 16-bit arithmetic.\n")
    print("| scheme | vertex: multipliers | adders | area | energy | pixel: multipliers | adders | area | conversion area | conversion energy | vertex work |")
    print("|--|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|")
    others = {scheme["scheme"]: scheme for scheme in pixel["schemes"]}
    for label, scheme in sorted(rows, key=lambda row: row[0]):
        at_vertex, other = unit(scheme, "interpolators"), others.get(label, {})
        conversion = unit(other, "conversion")
        at_pixel = unit(other, "interpolators") if conversion else None
        cells = [count(at_vertex, "multiplier"), count(at_vertex, "adder"), amount(at_vertex, "area"), amount(at_vertex, "energy_of_execution"),
                 count(at_pixel, "multiplier"), count(at_pixel, "adder"), amount(at_pixel, "area"), amount(conversion, "area"), amount(conversion, "energy_of_execution")]
        print(f"| {label} | " + " | ".join(cells + [amount(unit(scheme, "vertex"), "energy_of_execution")]) + " |")
    print("\nSo at these quality levels producing the inputs costs several times what the small designs cost themselves. In this table the fewest components win, whatever is done with them.\n")


def half_rate(rows):
    print("## One vector a cycle\n")
    print("L and H pass the same operators, so one set could serve both in turn: two cycles a fragment. An estimate from the fitted designs of `tl0`, not a design that is shipped: logarithm of cos b, light "
          "tables and their sum stay, everything else is there once, and two multiplexers of an angle's width and a register for the first light word come in.\n")
    print("| quality | one fragment a clock | fragments a clock on world_sphere | one every two clocks | saved | two of these |")
    print("|--|--:|--:|--:|--:|--:|")
    for target in TARGETS:
        row = next((row for row in rows if row["psnr_target_db"] == target and row["scheme"] == "tl0" and not row["settings"]), None)
        if row is None:
            continue
        widths = {pair.split("=")[0].split(".")[1]: int(pair.split("=")[1]) for pair in row["widths"].split()}
        light, logs = widths["light_word_bits"], widths["log_whole_bits"] - 1 + widths["log_bits"]
        area = row["area_nand2"]
        adder, register, select = 7.9, 4, 2.6
        shared = adder * (light + 1) + table_study.light_tables(widths) + table_study.log_cosine(widths) + register * (2 * light + logs)
        half = shared + (area - shared) / 2 + 2 * select * widths["angle_bits"] + register * light
        print(f"| {target} dB | {area:.0f} | {rate(row)} | {half:.0f} | {100 * (1 - half / area):.0f} % | {2 * half:.0f} |")
    print("\nWhere half a fragment a clock is enough, and only there, it is smaller; two such units, for one fragment a clock, would cost more than the one that is shipped.\n")


def report(work):
    rows = fits(work)
    read_held(work, rows)
    area = rows[0]["prices"]["area"]
    energy = rows[0]["prices"]["energy"]
    print("# Better designs\n")
    print("Written by `scripts/better_designs.sh`. `bumpsim fit` searches the widths of least area whose pictures of wood_plane, brick_cube and world_sphere all reach a PSNR against the reference; brick_torus "
          "and bunny were used for nothing but the columns with their names. * marks this project's own designs, in no paper.\n")
    print(f"Area in {area['unit']} by `{area['name']}` ({area['accuracy']}), energy in {energy['unit']} a fragment by `{energy['name']}` ({energy['accuracy']}): of the per-pixel datapaths with registers and tables, "
          "without interpolators, colour unit, texture and vertex work. [All schemes at equal quality](pareto.md).\n")
    print("**What is new.** The shipped designs on angles take the angles of N, L and H along the object's axes, as Lee 2007, and rotate in every pixel, at best by additions. "
          "[`tl0`](../sc_models/schemes/tl0/README.md) and [`tl2`](../sc_models/schemes/tl2/README.md) turn L and H into tangent space at the vertices, as Peercy 1997 does with vectors, and interpolate them as longitude and latitude about the axis "
          "on which the bump map has its pole. No rotation and no normaliser is left in a pixel, and N is not interpolated. Those inputs differ from Lee 2007's; they are made by the vertex transform that "
          "Peercy 1997 published, and with `angles=pixel` they *are* Peercy's: six vector components, from which a conversion unit without divider or root makes angles. "
          "Beside them `light_word_bits` (light tables) and `log_whole_bits` (`lns`, `lnsg`, `tl0`) let words be as short as the quality allows.\n")
    headline(rows)
    equal_quality(rows)
    inputs(work)
    half_rate(rows)
    table_study.report()


if __name__ == "__main__":
    {"specification": write_specification, "report": report}[sys.argv[1]](pathlib.Path(sys.argv[2]))
