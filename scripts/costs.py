#!/usr/bin/python3
"""Writes tests/costs.txt anew:  scripts/costs.py BUILD

From what a run of all tests has measured on an idle computer (`make test QUARTER=all`), BUILD/tests.log. Tests that take
SHARED seconds or more are dealt out to the quarters, the longest first to the quarter that has the least; those that need
one another stay together. Of those that take SLOW seconds or more a third of the quarter runs, and of units and commands,
which run under the sanitizers, too, where they take what BUILD/sanitize/tests.log says, or SANITIZED times as long, and are
shared from SANITIZED times SHARED on. What that log does not know keeps its line.
"""

import math
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
COSTS = ROOT / "tests/costs.txt"
SHARED = 2
SLOW = 10
SANITIZED = 10
TOLD_SANITIZED = 1.5  # from so many with the sanitizers on a test takes turns there (cmake/testing.cmake)
THIRDS = 3
# The first that anyone tries, what holds the sources together, and what alone catches a kind of fault: always, but for
# the sanitizers.
ALWAYS = re.compile(r"docs\.readme|architecture.*|validation\.test_verdicts|cli\.branch|browser\.page|"
                    r"unit\.analyze\.test_locked|cli\.resume-after-interrupt-carry")
TOGETHER = re.compile(r"determinism\.compilers|portability\.musl")


def measured(log):
    """Seconds by names: of the processor, or most of those by the clock, which know of browsers what it does not."""
    costs = {}
    for line in log.read_text().splitlines():
        seconds, clock, _, name = line.split()
        costs[name] = max(float(seconds), 0.6 * float(clock) if name.startswith("browser.") else 0)
    return costs


def shared_out(groups, count, weight):
    """Which of `count` shares each group of names goes to, 1, 2, ..., the heaviest first to the lightest share."""
    shares, loads = {}, [0.0] * count
    for names in sorted(groups, key=weight, reverse=True):
        share = loads.index(min(loads))
        loads[share] += weight(names)
        shares.update(dict.fromkeys(names, share + 1))
    return shares


def quarters_of(costs, sanitized):
    """The quarter of every test, 0: always, and the third of it of units, commands and what is slow."""
    again = {name: sanitized.get(name, SANITIZED * seconds) for name, seconds in costs.items()
             if name.startswith(("unit.", "cli."))}
    groups = {}
    for name in costs:
        group = TOGETHER.match(name)
        groups.setdefault(group[0] if group else name, []).append(name)

    def cost(names):
        return sum(costs[name] for name in names)

    def sanitized_cost(names):
        return sum(again.get(name, 0) for name in names)

    def in_thirds(names):
        return cost(names) >= SLOW or sanitized_cost(names) > 0

    def weight(names):
        return (cost(names) + sanitized_cost(names)) / (THIRDS if in_thirds(names) else 1)

    turns = [names for names in groups.values() if not any(map(ALWAYS.fullmatch, names)) and
             (cost(names) >= SHARED or sanitized_cost(names) >= SANITIZED * SHARED)]
    quarters, thirds = shared_out(turns, 4, weight), {}
    for quarter in range(1, 5):
        own = [names for names in turns if quarters[names[0]] == quarter]
        thirds |= shared_out(filter(in_thirds, own), THIRDS, weight)
        for third in range(1, THIRDS + 1):
            run = [name for names in own for name in names if thirds.get(name, third) == third]
            print(f"quarter {quarter}, third {third}: {cost(run):.0f} s, {sanitized_cost(run):.0f} s with the sanitizers")
    print(f"always: {cost(name for name in costs if name not in quarters):.0f} s")
    return dict.fromkeys(costs, 0) | quarters, thirds


def seconds_of(name, costs):
    """Whole ones; of compilers those without what they have compiled before."""
    return max(3 if TOGETHER.match(name) else 1, math.floor(costs[name] + 0.5))


def main():
    lines = COSTS.read_text().splitlines()
    costs = {line.split()[0]: float(line.split()[1]) for line in lines if not line.startswith("#")}
    before = set(costs)
    costs.update(measured(Path(sys.argv[1]) / "tests.log"))
    listed = subprocess.run(["ctest", "--test-dir", sys.argv[1], "-N"], check=True, capture_output=True, text=True).stdout
    there = set(re.findall(r"Test +#\d+: (\S+)", listed))
    again = Path(sys.argv[1]) / "sanitize/tests.log"
    sanitized = measured(again) if again.exists() else {}
    quarters, thirds = quarters_of({name: seconds for name, seconds in costs.items() if name in there}, sanitized)
    head = [line for line in lines if line.startswith("#")]
    unknown = before - set(sanitized)

    def is_told(name):
        return costs[name] >= 1 or quarters[name] or name in unknown or sanitized.get(name, 0) >= TOLD_SANITIZED

    told = [f"{name:<52} {seconds_of(name, costs):>2} {quarters[name]} {thirds.get(name, '')}".rstrip()
            for name in sorted(quarters) if is_told(name)]
    COSTS.write_text("\n".join(head + told) + "\n")


if __name__ == "__main__":
    main()
