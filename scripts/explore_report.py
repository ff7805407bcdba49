#!/usr/bin/env python3
"""Between the commands of explore.sh: specifications of the sweeps that follow from the fits, one table of all fits, and the report."""

import csv
import json
import pathlib
import sys

from explore_gates import Gates

TARGETS = (30, 40, 48)
OTHER_SCENES = ("brick_torus", "bunny")
LIMITS = (1, 2, 4)
PUBLISHED = ("blinn1978", "ernst1998", "kim2001", "kugler1998", "lee2007", "peercy1997")
TANGENT_SPACE = ("tl0", "tl2")  # whose vertices transform L and H
TANGENT_SPACE_IF = (("peercy1997.transform", "vertex"), ("ernst1998.variant", "gouraud"))
WITHOUT_BUMPS = ("phong1975",)


def fits(work):
    """Rows of all fits that have a design, each with what its structure differs in from the defaults."""
    rows = []
    for path in sorted(work.glob("fit-*.json")):
        fit = json.loads(path.read_text())
        for row in fit["rows"]:
            if row["status"] in ("reached", "not_reached"):
                row["settings"] = {choice["key"]: choice["value"] for choice in row["choices"] if choice["value"] != choice["given"]}
                row["prices"] = fit["prices"]
                rows.append(row)
    return rows


def key_of(row):
    return (row["scheme"], row["widths"], tuple(sorted((key, text_of(value)) for key, value in row["settings"].items())))


def distinct(rows):
    """Rows whose designs differ, in order."""
    seen = {}
    for row in rows:
        seen.setdefault(key_of(row), row)
    return list(seen.values())


def list_entry(scene, row, more=()):
    lines = ["[[list]]", f'scene = "{scene}"', f'scheme = "{row["scheme"]}"']
    lines += [f"{key} = {json.dumps(value)}" for key, value in row["settings"].items()]
    lines += [f"{key} = {value}" for key, value in (pair.split("=") for pair in row["widths"].split())]
    lines += [f"{key} = {value}" for key, value in more]
    return "\n".join(lines) + "\n"


def write_specifications(work):
    designs = distinct(fits(work))
    head = "scenes = [{}]\nschemes = [{}]\nquality = {}\n"
    schemes = ", ".join(f'"{s}"' for s in sorted({row["scheme"] for row in designs}))
    others = head.format(", ".join(f'"{s}"' for s in OTHER_SCENES), schemes, "true")
    limited = head.format('"world_sphere"', schemes, "false")
    for row in designs:
        for scene in OTHER_SCENES:
            others += list_entry(scene, row)
        for limit in LIMITS:
            limited += list_entry("world_sphere", row, [("environment.multipliers", limit), ("illumination.multipliers", limit)])
    (work / "others.toml").write_text(others)
    (work / "limited.toml").write_text(limited)


def write_table(work):
    rows = fits(work)
    columns = ["scheme", "psnr_target_db", "status", "psnr_worst_db", "multipliers", "adders", "multiplier_cells", "table_kilobytes", "area_nand2",
               "energy_pj_per_fragment", "widths"]
    with open(work / "fits.csv", "w", newline="") as file:
        table = csv.DictWriter(file, columns, extrasaction="ignore", lineterminator="\n")
        table.writeheader()
        for row in rows:
            table.writerow({**row, "scheme": name(row)})


def points(path):
    return [json.loads(line) for line in path.read_text().splitlines()]


def number(value, digits):
    return "-" if value is None else f"{value:.{digits}f}"


def report(work):
    rows = [row for row in fits(work) if row["scheme"] not in WITHOUT_BUMPS]
    others, limited = points(work / "others" / "points.jsonl"), points(work / "limited" / "points.jsonl")
    area, energy = rows[0]["prices"]["area"], rows[0]["prices"]["energy"]
    gates = Gates(work)

    # Points come in the order of the specification.
    place = {key_of(row): i for i, row in enumerate(distinct(fits(work)))}

    def held(row, scene):
        point = others[place[key_of(row)] * len(OTHER_SCENES) + OTHER_SCENES.index(scene)]
        assert point["scheme"] == row["scheme"] and point["scene"] == scene
        return point.get("psnr_hardware_to_reference_db")

    def rate(row, limit):
        point = limited[place[key_of(row)] * len(LIMITS) + LIMITS.index(limit)]
        assert point["scheme"] == row["scheme"] and point["environment.multipliers"] == limit
        return point.get("fragments_per_cycle")

    print("# All schemes at equal quality\n")
    print("Written by `scripts/explore.sh`. For each scheme `bumpsim fit` searches the structure, the widths and the table sizes with the least area whose "
          "pictures of wood_plane, brick_cube and world_sphere all reach a PSNR against the reference (512 x 512). Every design given here was measured on all three, and every "
          "PSNR is that of the worst. Brick_torus and bunny were not used to choose anything. Marks: (R) in part a reconstruction; * this project's own, in no paper.\n")
    print(f"Area in {area['unit']} by price table `{area['name']}` ({area['accuracy']}). Energy in {energy['unit']} a fragment by `{energy['name']}` "
          f"({energy['accuracy']}). Both are of the per-pixel datapaths with their pipeline registers and tables, one fragment a clock; interpolators, colour unit, "
          "texture and vertex work are not in them, and `bumpsim compare` lists these for every scheme.\n")
    print("How to read it: a row names the choices of structure in which it differs from the scheme's defaults. Left as they are: choices that decide more than what the "
          "same picture costs (the map's space and its normals in peercy1997, the readings of the paper's formulas in lee2007). \"Bound\" marks a design whose words, named "
          "under it, ended at the least that the scheme declares where a bit more would cost more: what it costs is an upper bound. \"Not reached\" gives the best "
          "quality of all structures that were tried, at any width. Searches are local: single flips of the answer's choices were looked at, not all combinations.\n")
    if gates.any():
        print("Columns by price are those of the two tables; the synthesised ones are what tools find in the Verilog of designs that reached the target, at most 40 k NAND2 (\"-\": not measured), and are explained under \"In gates\".\n")
    headline(rows, held, gates)
    for target in TARGETS:
        print(f"## At {target} dB\n")
        measured, rule = ("NAND2 synthesised | pJ, 0.18 um cells | ", "--:|--:|") if gates.any() else ("", "")
        print(f"| scheme | PSNR, worst of three | brick_torus | bunny | multipliers | adders | table KB | {area['unit']} by price | {energy['unit']} by price, 45 nm | {measured}fragments a cycle with 1, 2, 4 multipliers a unit |")
        print(f"|--|--:|--:|--:|--:|--:|--:|--:|--:|{rule}--|")
        of_target = [row for row in rows if row["psnr_target_db"] == target]
        reached = sorted((row for row in of_target if row["status"] == "reached"), key=lambda row: row["area_nand2"] or 1e99)
        missed = sorted((row for row in of_target if row["status"] != "reached"), key=lambda row: -row["psnr_worst_db"])
        for row in reached + missed:
            rates = ", ".join(number(rate(row, limit), 2) for limit in LIMITS)
            short = " (not reached)" if row["status"] != "reached" else " (bound)" if row["upper_bound"] else ""
            print(f"| {name(row)} | {row['psnr_worst_db']:.1f}{short} | {number(held(row, 'brick_torus'), 1)} | {number(held(row, 'bunny'), 1)} "
                  f"| {row['multipliers']} | {row['adders']} | {row['table_kilobytes']:.2f} | {number(row['area_nand2'], 0)} "
                  f"| {number(row['energy_pj_per_fragment'], 1)} | {''.join(number(figure, 0) + ' | ' for figure in gates.of(row)) if gates.any() else ''}{rates} |")
        print()
        for row in missed:
            print(f"* {name(row)}: not reached by {of_structures(row)}.")
        print()
    print("Fragments a cycle are those of world_sphere with the default FIFOs, vertex processor and memory, which allow 0.75 to 0.83 without a limit.\n")
    if gates.any():
        print(gates.section())
    print("## Fronts\n")
    for which, text in (("area", "area"), ("energy", "energy"), ("tables", "table KB"), ("multipliers", "multiplier cells, the sum over multipliers of the product of their operands' widths")):
        print(f"{text[0].upper() + text[1:]} against PSNR:\n\n![{text} against PSNR](pictures/pareto-{which}.svg)\n")
    print("## Structures and widths that were found\n")
    print("As settings of a run, without the scheme's name in front; words at their least allowed value, where that still costs, are named behind the dash.\n")
    for row in rows:
        prefix = row["scheme"] + "."
        text = " ".join([f"{key}={text_of(value)}" for key, value in row["settings"].items()] + [row["widths"]]).replace(prefix, "")
        least = row["least_allowed"].replace(prefix, "")
        if not row["search_complete"]:
            text += " (the search ended at its limit of designs)"
        print(f"* {row['psnr_target_db']:.0f} dB, {row['scheme']}: {text}" + (f" - {least}" if least else ""))


def of_structures(row):
    variants = row["variants"]
    measured = variants["fitted"] + variants["fall_short_at_the_widest"] + variants["same_picture"]
    possible = variants["possible"] - variants["contradictory_or_equal"]
    if possible == 1:
        return "the only structure that there is"
    rest = possible - measured
    text = f"any of {measured} structures measured"
    return text + (f"; {rest} more were left out by the limits of the search" if rest > 0 else ", which are all that there are")


def text_of(value):
    return json.dumps(value) if isinstance(value, bool) else str(value)


def name(row):
    mark = " (R)" if row["reconstruction"] else "" if row["scheme"] in PUBLISHED + WITHOUT_BUMPS else "*"
    settings = " ".join(f"{key.split('.')[1]}={text_of(value)}" for key, value in row["settings"].items())
    return row["scheme"] + mark + (f" {settings}" if settings else "")


def takes_object_angles(row):
    """False where the vertices transform L and H into tangent space."""
    return row["scheme"] not in TANGENT_SPACE and all(row["settings"].get(key) != value for key, value in TANGENT_SPACE_IF)


def headline(rows, held, gates):
    """What a designer should build, in numbers of this very table."""
    def synthesised(row, best=None):
        area, _ = gates.of(row)
        if not area:
            return ""
        than, _ = gates.of(best) if best else (None, None)
        return f", {area:.0f} by synthesis" + (f", {area / than:.1f} times" if than else "")

    print("## In short\n")
    lee = max((row for row in rows if row["scheme"] == "lee2007"), key=lambda row: row["psnr_worst_db"])
    print(f"* Lee 2007 with the paper's formulas reaches {lee['psnr_worst_db']:.1f} dB on the worst of the three scenes at most, whatever its structure and widths.")
    for target in TARGETS:
        reached = [row for row in rows if row["psnr_target_db"] == target and row["status"] == "reached" and row["area_nand2"] is not None]
        if not reached:
            print(f"* At {target} dB no scheme is left.")
            continue
        best = min(reached, key=lambda row: row["area_nand2"])
        thrifty = min(reached, key=lambda row: row["energy_pj_per_fragment"])
        text = (f"* At {target} dB the least area is {name(best)}: {best['area_nand2']:.0f} NAND2{' (an upper bound)' if best['upper_bound'] else ''}{synthesised(best)}, {best['multipliers']} multipliers, {best['table_kilobytes']:.2f} KB of tables; "
                f"on the scenes not used to choose it {number(held(best, 'brick_torus'), 1)} dB (brick_torus) and {number(held(best, 'bunny'), 1)} dB (bunny). "
                f"The least energy is {name(thrifty)} with {thrifty['energy_pj_per_fragment']:.1f} pJ.")
        published = [row for row in reached if row["scheme"] in PUBLISHED]
        if published:
            theirs = min(published, key=lambda row: row["area_nand2"])
            text += (f" The smallest published design is {name(theirs)} with {theirs['area_nand2']:.0f} NAND2 "
                     f"({theirs['area_nand2'] / best['area_nand2']:.1f} times{synthesised(theirs, best)}) and {theirs['energy_pj_per_fragment']:.1f} pJ.")
        else:
            text += " No published design reaches it."
        anywhere = [row for row in reached if (held(row, "bunny") or 0) >= target - 2]
        if anywhere:
            safe = min(anywhere, key=lambda row: row["area_nand2"])
            if safe is best:
                text += " That is within 2 dB of the target on the bunny, too, whose tangents run anywhere."
            else:
                text += (f" On a mesh whose tangents run anywhere it fails: within 2 dB of the target on the bunny, too, the smallest is {name(safe)} "
                         f"with {safe['area_nand2']:.0f} NAND2 and {safe['energy_pj_per_fragment']:.1f} pJ ({held(safe, 'bunny'):.1f} dB there).")
        along = [row for row in reached if takes_object_angles(row)]
        if along and min(along, key=lambda row: row["area_nand2"]) is not best:
            theirs = min(along, key=lambda row: row["area_nand2"])
            text += (f" Of the designs that take angles or vectors along the object's axes, as Lee 2007 does, the smallest is {name(theirs)} with {theirs['area_nand2']:.0f} NAND2"
                     f"{' (an upper bound)' if theirs['upper_bound'] else ''} and {theirs['energy_pj_per_fragment']:.1f} pJ, {number(held(theirs, 'brick_torus'), 1)} dB on brick_torus and "
                     f"{number(held(theirs, 'bunny'), 1)} dB on the bunny.")
        print(text)
    print("* Inputs differ: angles are formed at the vertices and interpolated, vectors are interpolated as they are, and transforms at the vertices are in no figure here; designs with `angles=pixel` form their angles "
          "per pixel and pay for it here.")
    print()


def main():
    step, work = sys.argv[1], pathlib.Path(sys.argv[2])
    {"specification": write_specifications, "table": write_table, "report": report}[step](work)


if __name__ == "__main__":
    main()
