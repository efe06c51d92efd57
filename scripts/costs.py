#!/usr/bin/python3
"""Writes tests/costs.txt anew:  scripts/costs.py BUILD

From what a run of all tests has measured on an idle computer (`make test QUARTER=all`), BUILD/tests.log. Tests that take
SHARED seconds or more are dealt out to the quarters, the longest first to the quarter that has the least; those that need
one another stay together. Units and commands count twice, for a third of theirs runs under the sanitizers, too, where they
take what BUILD/sanitize/tests.log says, or SANITIZED times as long, and are shared from SANITIZED times SHARED on. What
that log does not know keeps its line.
"""

import math
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
COSTS = ROOT / "tests/costs.txt"
SHARED = 2
SANITIZED = 10
THIRDS = 3
# The first that anyone tries, what holds the sources together, and what alone catches a kind of fault: always.
ALWAYS = re.compile(r"docs\.readme|architecture.*|validation\.test_verdicts|cli\.branch|browser\.page|unit\.store\.test_file|"
                    r"unit\.analyze\.test_locked|cli\.resume-after-interrupt-carry")
TOGETHER = re.compile(r"determinism\.compilers|portability\.musl")


def measured(log):
    """Seconds by names: of the processor, or most of those by the clock, which know of browsers what it does not."""
    costs = {}
    for line in log.read_text().splitlines():
        seconds, clock, _, name = line.split()
        costs[name] = max(float(seconds), 0.6 * float(clock) if name.startswith("browser.") else 0)
    return costs


def quarters_of(costs, sanitized):
    """The quarter of every test, 0: always, and, of units and commands in one, the third of it."""
    again = {name: sanitized.get(name, SANITIZED * seconds) for name, seconds in costs.items()
             if name.startswith(("unit.", "cli."))}
    groups = {}
    for name, seconds in costs.items():
        group = TOGETHER.match(name)
        groups.setdefault(group[0] if group else name, []).append((name, seconds, again.get(name, 0)))
    load, release, quarters = [0.0] * 5, [0.0] * 5, {}
    for tests in sorted(groups.values(), key=lambda tests: -sum(seconds + more / THIRDS for _, seconds, more in tests)):
        names, total = [name for name, _, _ in tests], sum(seconds for _, seconds, _ in tests)
        sanitized_total = sum(more for _, _, more in tests)
        weight = total + sanitized_total / THIRDS
        long = total >= SHARED or sanitized_total >= SANITIZED * SHARED
        shared = long and not any(ALWAYS.fullmatch(name) for name in names)
        quarter = min(range(1, 5), key=lambda q: load[q]) if shared else 0
        load[quarter] += weight
        release[quarter] += total
        quarters.update({name: quarter for name in names})
    thirds, parts = {}, {}
    for name in sorted(again, key=lambda name: -again[name]):
        if quarters[name]:
            sums = parts.setdefault(quarters[name], [0.0] * THIRDS)
            third = min(range(THIRDS), key=lambda t: sums[t])
            sums[third] += again[name]
            thirds[name] = third + 1
    for quarter, sums in sorted(parts.items()):
        print(f"seconds of the thirds of quarter {quarter} with the sanitizers:", *(round(x) for x in sums))
    for what, sums in (("", release), (", with the sanitizers", load)):
        print(f"seconds of tests that always run, and of the quarters{what}:", *(round(x) for x in sums))
    return quarters, thirds


def main():
    lines = COSTS.read_text().splitlines()
    costs = {line.split()[0]: float(line.split()[1]) for line in lines if not line.startswith("#")}
    costs.update(measured(Path(sys.argv[1]) / "tests.log"))
    listed = subprocess.run(["ctest", "--test-dir", sys.argv[1], "-N"], check=True, capture_output=True, text=True).stdout
    there = set(re.findall(r"Test +#\d+: (\S+)", listed))
    again = Path(sys.argv[1]) / "sanitize/tests.log"
    sanitized = measured(again) if again.exists() else {}
    quarters, thirds = quarters_of({name: seconds for name, seconds in costs.items() if name in there}, sanitized)
    head = [line for line in lines if line.startswith("#")]
    told = [f"{name:<52} {max(1, math.floor(costs[name] + 0.5)):>2} {quarters[name]} {thirds.get(name, '')}".rstrip()
            for name in sorted(quarters) if costs[name] >= 1 or quarters[name]]
    COSTS.write_text("\n".join(head + told) + "\n")


if __name__ == "__main__":
    main()
