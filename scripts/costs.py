#!/usr/bin/python3
"""Writes tests/costs.txt anew:  scripts/costs.py BUILD

From what a run of all tests has measured on an idle computer (`make test QUARTER=all`), BUILD/tests.log. Tests that take
SHARED seconds or more are dealt out to the quarters, the longest first to the quarter that has the least; those that need
one another stay together. Of those that take SLOW seconds or more a third runs, and of all units and commands under the
sanitizers, where they take what BUILD/sanitize/tests.log says, or SANITIZED times as long, and are shared from SANITIZED
times SHARED on. What that log does not know keeps its line.
"""

import math
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
COSTS = ROOT / "tests/costs.txt"
SHARED = 2
SLOW = 10 # as cmake/testing.cmake has it
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


def shared_out(groups, count, loads):
    """Which of `count` shares each group of (name, weight) goes to, 1, 2, ..., the heaviest first to the lightest share."""
    shares = {}
    for tests in sorted(groups, key=lambda tests: -sum(weight for _, weight in tests)):
        share = min(range(1, count + 1), key=lambda s: loads[s])
        loads[share] += sum(weight for _, weight in tests)
        shares.update({name: share for name, _ in tests})
    return shares


def quarters_of(costs, sanitized):
    """The quarter of every test, 0: always, and the third of it of units, commands and what is slow."""
    again = {name: sanitized.get(name, SANITIZED * seconds) for name, seconds in costs.items()
             if name.startswith(("unit.", "cli."))}
    groups = {}
    for name in costs:
        group = TOGETHER.match(name)
        groups.setdefault(group[0] if group else name, []).append(name)

    def long(names):
        return (sum(costs[name] for name in names) >= SHARED or
                sum(again.get(name, 0) for name in names) >= SANITIZED * SHARED) and not any(map(ALWAYS.fullmatch, names))

    def weights(names):
        return [(name, (costs[name] / THIRDS if costs[name] >= SLOW else costs[name]) + again.get(name, 0) / THIRDS)
                for name in names]

    loads = [0.0] * 5
    taking_turns = [names for names in groups.values() if long(names)]
    quarters = dict.fromkeys(costs, 0) | shared_out(map(weights, taking_turns), 4, loads)
    thirds = {}
    for quarter in range(1, 5):
        parts = [[name for name in names if name in again or costs[name] >= SLOW]
                 for names in taking_turns if quarters[names[0]] == quarter]
        sums = [0.0] * (THIRDS + 1)
        thirds |= shared_out(map(weights, parts), THIRDS, sums)
        for third in range(1, THIRDS + 1):
            run = [name for name, its in quarters.items() if its == quarter and
                   thirds.get(name, third if costs[name] < SLOW else 0) == third]
            run += [name for name in thirds if quarters[name] == quarter and thirds[name] != third and costs[name] < SLOW]
            print(f"quarter {quarter}, third {third}: {sum(costs[name] for name in run):.0f} s,",
                  f"{sum(again.get(name, 0) for name in run if thirds.get(name) == third):.0f} s with the sanitizers")
    print(f"always: {sum(seconds for name, seconds in costs.items() if not quarters[name]):.0f} s")
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
