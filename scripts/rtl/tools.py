"""Other people's programs: which are there, and running them with their output kept and judged."""

import functools
import hashlib
import os
import pathlib
import re
import shutil
import signal
import subprocess
import threading

LIBERTY = pathlib.Path("/usr/share/qflow/tech/osu018/osu018_stdcells.lib")


_running = set()
_running_lock = threading.Lock()
_stopped = threading.Event()


class ToolFailed(Exception):
    """A program ended with an error, or said one although it did not."""


class Stopped(BaseException):
    """Nothing more is run, and what ran says nothing about what it checked."""


def has(tool):
    return LIBERTY.exists() if tool == "osu018" else shutil.which(tool) is not None


def missing(*tools):
    """The first of `tools` that is not there, or None."""
    return next((tool for tool in tools if not has(tool)), None)


def stop_all():
    """Ends what run() started, with everything that it started itself; from now on run() raises Stopped."""
    _stopped.set()
    with _running_lock:
        for pid in _running:
            os.killpg(pid, signal.SIGKILL)


def run(command, log, cwd=None, timeout=1800, environment=None):
    """Runs a program; everything it says goes to the file `log` and is returned. Raises ToolFailed on any exit code but 0."""
    if _stopped.is_set():
        raise Stopped
    log = pathlib.Path(log)
    log.parent.mkdir(parents=True, exist_ok=True)
    with open(log, "w") as file:
        process = subprocess.Popen(command, cwd=cwd, stdout=file, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                                   start_new_session=True, env={**os.environ, **(environment or {})})
        with _running_lock:
            _running.add(process.pid)
        try:
            code = process.wait(timeout)
        except subprocess.TimeoutExpired as error:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
            raise ToolFailed(f"{command[0]} took more than {timeout} s, see {log}") from error
        finally:
            with _running_lock:
                _running.discard(process.pid)
    if _stopped.is_set():
        raise Stopped
    text = log.read_text(errors="replace")
    if code != 0:
        lines = [line for line in text.splitlines() if line.strip()]
        telling = [line for line in lines if re.search(r"error|mismatch|instead of|fatal|failed", line, re.I)]
        telling = [line for line in telling if not line.startswith("make") and " 0 mismatches" not in line]
        said = telling[0] if telling else lines[-1] if lines else "nothing"
        raise ToolFailed(f"{pathlib.Path(command[0]).name} failed ({code}): {said.strip()[:160]} (log: {log})")
    return text


def yosys(script, log, cwd):
    """Runs Yosys commands in the folder of an emission, so that ROM images are found."""
    path = pathlib.Path(log).with_suffix(".ys")
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(script)
    return run(["yosys", "-Q", "-T", "-s", str(path)], log, cwd)


def sta(script, log, cwd):
    """OpenSTA ends with 0 after errors, and leaves out what it does not know: what it says decides. Only ROMs may be black boxes."""
    path = pathlib.Path(log).with_suffix(".tcl")
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(script)
    text = run(["sta", "-no_splash", "-no_init", "-exit", str(path)], log, cwd)
    error = re.search(r"^(Error|.*syntax error).*$|^.*module (?!rom_)\S+ not found.*$", text, re.M)
    if error:
        raise ToolFailed(f"sta: {error.group(0)[:160]} (log: {log})")
    return text


@functools.lru_cache
def cell_areas():
    """um2 of every cell of the Liberty file."""
    areas, cell = {}, None
    for line in LIBERTY.read_text().splitlines():
        head = re.match(r"\s*cell\s*\(\s*\"?(\w+)\"?\s*\)", line)
        if head:
            cell = head.group(1)
        area = re.match(r"\s*area\s*:\s*([\d.]+)", line)
        if area and cell and cell not in areas:
            areas[cell] = float(area.group(1))
    return areas


@functools.lru_cache
def liberty_digest():
    return hashlib.sha256(LIBERTY.read_bytes()).hexdigest()[:20]


def nand2():
    """um2 of the unit of areas."""
    return cell_areas()["NAND2X1"]


@functools.lru_cache
def versions():
    """What the checks were made with: names and version numbers of the programs that are there."""
    commands = {"yosys": ["yosys", "-V"], "verilator": ["verilator", "--version"], "iverilog": ["iverilog", "-V"],
                "sta": ["sta", "-version"], "nextpnr-ice40": ["nextpnr-ice40", "--version"]}
    found = {}
    for tool, command in commands.items():
        if has(tool):
            out = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL, check=False)
            number = re.search(r"\d+(\.\d+)+", out.stdout + out.stderr)
            found[tool] = number[0] if number else "?"
    return found
