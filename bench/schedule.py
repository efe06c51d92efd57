#!/usr/bin/env python3
"""How evenly ranks of whirl-mpi are kept busy: simulates how they are dealt a study's points, whose costs are measured.

    whirl run cases/paper-map.yaml -o map.h5 && whirl export map.h5 --csv FOLDER
    bench/schedule.py FOLDER/map.csv [--points N] [--rate R] [--part P] [--latency S] [--service S]

The costs are the revolutions that every point of the map took ("regime/revolutions" and what Newton's method added,
"floquet/revolutions") over the rate, in revolutions a second of a core. A study of N points is the same map drawn
finer: each of its points costs what the nearest one measured did, so that dear points lie together as they do in a map.

A rank of one thread asks the first rank for its next points: a P-th of its part of those that are left (as far as it
knows, from its last answer), one in the end; whirl-mpi takes an eighth. The first rank answers one question after the
other. Efficiency is the work of all points over what the ranks could have done until the last one ends.
"""
import argparse
import csv
import heapq
import itertools


def read_costs(path):
    """Revolutions of all points: a row for each value of the second parameter, along the first one."""
    with open(path, newline="", encoding="utf-8") as file:
        table = csv.DictReader(file)
        taken = [name for name in table.fieldnames if name.startswith(("regime/revolutions", "floquet/revolutions"))]
        second = table.fieldnames[2]
        rows = {}
        for line in table:
            cost = sum(float(line[name]) for name in taken if line[name] not in ("", "nan"))
            rows.setdefault(line[second], []).append(cost)
    return list(rows.values())


def finer(rows, points):
    """Costs of a nearly square map of `points` points, row by row: those of the nearest measured ones."""
    width = round(points ** 0.5)
    height = points // width
    for y in range(height):
        row = rows[y * len(rows) // height]
        yield from (row[x * len(row) // width] for x in range(width))


def simulate(sums, ranks, options):
    """Seconds until the last rank ends, and the number of questions; sums[i]: seconds of all points before point i."""
    count = len(sums) - 1
    ready = [(0.0, rank) for rank in range(ranks)]
    known = [0] * ranks  # points dealt, as a rank knows
    dealt, free, end, questions = 0, 0.0, 0.0, 0
    while ready:
        asked, rank = heapq.heappop(ready)
        arrived = asked + options.latency / 2
        free = max(free, arrived) + options.service
        answered = free + options.latency / 2
        wanted = max((count - known[rank]) // (options.part * ranks), 1)
        first, dealt = dealt, dealt + wanted
        questions += 1
        last = min(dealt, count)
        known[rank] = last
        if first < count:
            heapq.heappush(ready, (answered + sums[last] - sums[first], rank))
        end = max(end, answered)
    return end, questions


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("table")
    parser.add_argument("--points", type=int, default=10**6)
    parser.add_argument("--rate", type=float, default=23500.0, help="revolutions a second of a core")
    parser.add_argument("--part", type=int, default=8, help="of a rank's part of what is left, which it is dealt")
    parser.add_argument("--latency", type=float, default=2e-3, help="seconds of a question, waiting included")
    parser.add_argument("--service", type=float, default=5e-6, help="seconds of the first rank for one answer")
    options = parser.parse_args()
    costs = [cost / options.rate for cost in finer(read_costs(options.table), options.points)]
    sums = [0.0, *itertools.accumulate(costs)]
    mean, longest = sums[-1] / len(costs), max(costs)
    print(f"{len(costs)} points, {mean * 1e3:.3g} ms each, the longest {longest / mean:.2f} times that")
    print("| ranks | seconds | requests | efficiency |\n|---:|---:|---:|---:|")
    for ranks in (1, 10, 100, 1000, 3000, 10000):
        end, questions = simulate(sums, ranks, options)
        print(f"| {ranks:,} | {end:,.3g} | {questions:,} | {sums[-1] / (ranks * end):.3f} |")


main()
