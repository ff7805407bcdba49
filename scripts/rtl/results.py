"""What a check found: one line of output, and figures for the report."""

import dataclasses
import json
import pathlib
import threading

OK, FAILED, SKIPPED = "ok", "FAILED", "skipped"


@dataclasses.dataclass
class Check:
    """One line "<status> <check> <scheme> <unit> <detail>"; `data` are the figures behind the detail."""

    status: str
    check: str
    scheme: str
    unit: str
    detail: str
    data: dict = dataclasses.field(default_factory=dict)

    def line(self):
        return f"{self.status:<7} {self.check:<14} {self.scheme:<18} {self.unit:<18} {self.detail}".rstrip()


class Results:
    """Collects checks from several threads, prints each as it comes, and keeps them in a file."""

    def __init__(self):
        self._lock = threading.Lock()
        self._checks = []

    def add(self, checks):
        with self._lock:
            for check in checks:
                self._checks.append(check)
                print(check.line(), flush=True)

    def count(self, status):
        return sum(check.status == status for check in self._checks)

    def summary(self):
        text = f"{self.count(OK)} passed, {self.count(FAILED)} failed"
        return text + (f", {self.count(SKIPPED)} skipped" if self.count(SKIPPED) else "")

    def write(self, path, header):
        """In an order that does not depend on which check was finished first."""
        checks = sorted(self._checks, key=lambda c: (c.check, c.scheme, c.unit, c.detail))
        document = {**header, "checks": [dataclasses.asdict(check) for check in checks]}
        pathlib.Path(path).write_text(json.dumps(document, indent=1) + "\n")
