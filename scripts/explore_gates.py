"""What scripts/rtl_equal_quality.sh measured, for the report of explore.sh: designs of equal quality as gates."""

import json

PARTS = ("operators", "registers", "tables")
CONVENTIONAL = (("transform", "pixel"), ("normaliser", "divider"))
SUBJECTS = ("lee2007", "tl0", "lns", "n2l")  # held against the conventional method


class Gates:
    """Synthesised area and energy of the designs in <work>/equal_quality.json; of none if there is no such file."""

    def __init__(self, work):
        path = work / "equal_quality.json"
        self.document = json.loads(path.read_text()) if path.exists() else {"designs": [], "left_out": []}
        for design in self.document["designs"]:
            design["gates"] = sum(design["synthesised"].values())
        self._by_key = {key_of(d["scheme"], d["settings"]): d for d in self.document["designs"]}

    def any(self):
        return bool(self.document["designs"])

    def of(self, row):
        """(NAND2, pJ a fragment) of a row of a fit, None where they were not measured."""
        widths = dict(pair.split("=") for pair in row["widths"].split())
        structure = dict(pair.split("=", 1) for pair in row["structure"].split())
        design = self._by_key.get(key_of(row["scheme"], {**structure, **widths}))
        return (design["gates"], design.get("energy_pj")) if design else (None, None)

    def section(self):
        document = self.document
        lines = [
            "## In gates\n",
            "The same designs as the Verilog of `bumpsim rtl`, without queues: Yosys and ABC map operators, registers and tables onto open 0.18 um cells (OSU, typical, 1.8 V; NAND2X1 = 24 um2). "
            f"Energy: Icarus Verilog runs the mapped netlists with the cells' delays over {document['cycles']} random vectors, compares the results, and OpenSTA takes the changes of every net. Clock tree, wires, "
            "queues, and with them the words that only pass a unit (the columns by price have their registers), interpolators, vertex work and texture are in no figure; random words change more often than those of neighbouring pixels, so energies are to be compared with one another only. "
            "Written from what `scripts/rtl_equal_quality.sh` measured "
            f"({', '.join(f'{tool} {version}' for tool, version in document['tools'].items() if tool in ('yosys', 'iverilog', 'sta'))}).\n",
            "### Does \"78 % fewer multiplications\" hold in gates?\n",
            "Lee 2007's environment unit multiplies 6 times, the conventional one 27 times. Designs in the structures of the papers, with the widths that `bumpsim fit` found, "
            "against four forms of the conventional method: transform per pixel or at the vertices, normalised by dividers or by a table. \"Environment\" is that unit alone, \"all\" "
            "has the illumination unit, too.\n",
            "How to read it: the least of the targets is just below what Lee 2007's formulas allow, so that its words must be nearly exact while those of the others may be coarse; at equal words see "
            "[rtl.md](rtl.md). And interpolators are several times larger than these units and differ between the methods: [better_designs.md](better_designs.md) has them, scheme by scheme.\n",
        ]
        for target in sorted({target for design in document["designs"] for target in design["targets"]}):
            chosen = [d for d in document["designs"] if target in d["targets"]]
            lines += [answer(target, chosen), f"At {target} dB:\n", absolute(chosen), relative(chosen), widths(chosen)]
        errors = sorted(sum(d["priced"].values()) / d["gates"] - 1 for d in document["designs"])
        lines.append(f"The table of prices is {percent(errors[0])} to {percent(errors[-1])} off for these {len(errors)} designs, in the middle {percent(errors[len(errors) // 2])}; "
                     "mostly narrow products whose low bits nobody reads.\n")
        if document["left_out"]:
            lines.append(f"Not synthesised, being above {document['largest'] / 1000:.0f} k NAND2 by the table of prices (the forms of the conventional method were, whatever their size): {', '.join(document['left_out'])}.\n")
        return "\n".join(lines)


def key_of(scheme, settings):
    return (scheme, tuple(sorted((key, str(value).lower()) for key, value in settings.items())))


def table(head, rows, right):
    lines = ["| " + " | ".join(head) + " |", "|" + "|".join("--" if i < right else "--:" for i in range(len(head))) + "|"]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]) + "\n"


def percent(value):
    return "0 %" if round(100 * value) == 0 else f"{100 * value:+.0f} %"


def form_of(design):
    """"pixel divider" for a form of the conventional method, else the choices in which it differs from the scheme's defaults."""
    if design["scheme"] == "peercy1997":
        return " ".join(design["structure"].get(f"peercy1997.{key}", default) for key, default in CONVENTIONAL)
    return " ".join(f"{key.split('.')[1]}={value}" for key, value in sorted(design["structure"].items()))


def baselines_of(chosen):
    return sorted((d for d in chosen if d["scheme"] == "peercy1997" and d["baseline"]), key=lambda d: -d["gates"])


def subjects_of(chosen):
    """Lee 2007 as published, and the smallest own designs that were measured."""
    best = {}
    for d in sorted(chosen, key=lambda d: (d["baseline"], d["gates"])):
        best.setdefault(d["scheme"], d)
    return [best[scheme] for scheme in SUBJECTS if scheme in best and (scheme != "lee2007" or best[scheme]["baseline"])]


def answer(target, chosen):
    """What becomes of the saving, in a sentence for each form of the conventional method that Lee 2007 can be held against."""
    lee = [d for d in subjects_of(chosen) if d["scheme"] == "lee2007"]
    lines = []
    for b in baselines_of(chosen) if lee else []:
        figures = [(unit, figure, figure_of(lee[0], unit, figure), figure_of(b, unit, figure))
                   for unit, figure in (("environment", "multipliers"), ("environment", "gates"), (None, "gates"), (None, "energy_pj"))]
        parts = [percent(mine / theirs - 1) if theirs and mine is not None else "-" for _, _, mine, theirs in figures]
        lines.append(f"* Lee 2007 at {target} dB against `{form_of(b)}`: {parts[0]} multipliers and {parts[1]} gates in the environment unit, "
                     f"{parts[2]} gates and {parts[3]} energy in both units.")
    return "\n".join(lines) + ("\n" if lines else "")


def absolute(chosen):
    rows = []
    for d in subjects_of(chosen) + baselines_of(chosen):
        name = f"{d['scheme']} {form_of(d)}".strip() + (" (R)" if d["reconstruction"] else "")
        energy = f"{d['energy_pj']:.0f}" if "energy_pj" in d else "-"
        clocked = f"{100 * d['energy_clocked_pj'] / d['energy_pj']:.0f} %" if "energy_pj" in d else "-"
        rows.append((name, f"{d['psnr_worst_db']:.1f}", d["multipliers"], *(f"{d['synthesised'][part]:.0f}" for part in PARTS), f"{d['gates']:.0f}", energy, clocked))
    head = ("design", "PSNR, worst of three", "multipliers", *PARTS, "NAND2", "pJ a fragment", "of the energy, in flip-flops")
    return table(head, rows, 1)


def relative(chosen):
    rows = []
    for d in subjects_of(chosen):
        for b in baselines_of(chosen):
            cells = []
            for unit in ("environment", None):
                for figure in ("multipliers", "gates", "energy_pj"):
                    mine, theirs = figure_of(d, unit, figure), figure_of(b, unit, figure)
                    cells.append(percent(mine / theirs - 1) if theirs and mine is not None else "-")
            rows.append((d["scheme"], form_of(b), *cells))
    parts = ("environment", "all")
    return table(("design", "against peercy1997", *(f"{part}: {figure}" for part in parts for figure in ("multipliers", "gates", "energy"))), rows, 2)


def widths(chosen):
    """What makes the designs again, as settings of a run without the scheme's name in front."""
    lines = []
    for d in subjects_of(chosen) + baselines_of(chosen):
        settings = {**d["structure"], **dict(pair.split("=") for pair in d["widths"].split())}
        text = " ".join(f"{key}={value}" for key, value in settings.items()).replace(d["scheme"] + ".", "")
        lines.append(f"* {d['scheme']}: {text}")
    return "\n".join(lines) + "\n"


def figure_of(design, unit, figure):
    """Of one unit, or of all with None; None where it was not measured."""
    values = [u.get(figure) for name, u in design["units"].items() if unit in (None, name)]
    return None if None in values else sum(values)
