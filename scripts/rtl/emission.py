"""What the checks ask the program for: the schemes, their Verilog, and their prices."""

import functools
import json
import pathlib
import re
import shutil
import subprocess
import tomllib

SETTINGS = tomllib.loads((pathlib.Path(__file__).parent / "settings.toml").read_text())


class ProgramFailed(Exception):
    """bumpsim refused or failed; the message is its own."""


class Program:
    """bumpsim, and the folder below which everything is written."""

    def __init__(self, path, work):
        self.path = str(path)
        self.work = pathlib.Path(work)

    def run(self, *arguments):
        result = subprocess.run([self.path, *arguments], capture_output=True, text=True, stdin=subprocess.DEVNULL, check=False)
        if result.returncode != 0:
            said = result.stdout + result.stderr
            try:
                said = json.dumps(json.loads(result.stdout)["error"])
            except (ValueError, KeyError, TypeError):
                pass
            raise ProgramFailed(f"bumpsim {arguments[0]} ended with {result.returncode}: {' '.join(said.split())[:200]}")
        return result.stdout

    def json(self, *arguments):
        text = self.run(*arguments, "--json")
        try:
            return json.loads(text)
        except ValueError as error:
            raise ProgramFailed(f"{self.path} {arguments[0]} --json printed no JSON: is that bumpsim?") from error

    @functools.cache
    def schemes(self):
        return [scheme["id"] for scheme in self.json("list", "schemes")["schemes"]]

    @functools.cache
    def inventory(self, scheme):
        """Operators of all netlists by `bumpsim describe`, additions included; light maps are memory, not hardware of the unit."""
        document = self.json("describe", scheme)
        units = {name: {kind: unit["built"][kind] + unit["additional"][kind] for kind in unit["built"]}
                 for name, unit in document["units"].items()}
        if "light_map_address" in units:
            units["light_map_address"]["maps"] -= len(document["light_maps"])
        return units

    @functools.cache
    def parameters(self, scheme):
        """Integer parameters: key without the scheme's name, to (default, least, most)."""
        found = {}
        for parameter in self.json("describe", scheme)["parameters"]:
            bounds = re.search(r"allowed (-?\d+) to (-?\d+)", parameter["allowed"])
            if bounds:
                found[parameter["key"].split(".", 1)[1]] = (int(parameter["default"]), int(bounds[1]), int(bounds[2]))
        return found

    def width_settings(self, scheme, width):
        """Settings for words of `width` bits by the rules of settings.toml, and notes on what a scheme does not allow."""
        settings, notes = {}, []
        for key, (_, least, most) in sorted(self.parameters(scheme).items()):
            rule = SETTINGS["widths"].get(key)
            if rule is None:
                continue
            wanted = min(width + rule.get("plus", 0), rule.get("most", 64))
            allowed = min(max(wanted, least), most)
            settings[f"{scheme}.{key}"] = allowed
            if allowed != wanted:
                notes.append(f"{key} {allowed} in place of {wanted}")
        return settings, notes

    def emit(self, scheme, tag, settings, vectors=2, unit=None, seed=1):
        """Writes the Verilog into work/emit/<tag>/<scheme>; the folder and its manifest."""
        folder = self.work / "emit" / tag / scheme
        if folder.exists():
            shutil.rmtree(folder)
        folder.parent.mkdir(parents=True, exist_ok=True)
        pairs = [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
        units = ["--unit", unit] if unit else []
        self.run("rtl", scheme, *units, *pairs, "--vectors", str(vectors), "--seed", str(seed), "--out", str(folder))
        return folder, json.loads((folder / "rtl.json").read_text())

    def price(self, scheme, settings, table="osu018_model"):
        """Units of the scheme by name, with their area and its items."""
        pairs = [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
        document = self.json("price", scheme, "--prices", table, "--items", *pairs)
        return {unit["unit"]: unit for unit in document["schemes"][0]["units"]}
