"""Lines of shafts in figures against closed forms, and where parts of drawings stand:  shaft_lines.py lines|standing"""

import json
import math
import sys


def panels(name):
    with open(name + ".json") as file:
        return {panel["name"]: panel for panel in json.load(file)["panels"]}


def lines(panel):
    return [one for one in panel["series"] if one["shape"] == "line" and len(one.get("x", [])) > 20]


def worst(line, wanted):
    return max(abs(y - wanted(x / 1000)) for x, y in zip(line["x"], line["y"]) if x is not None)


def largest(panel):
    return max(lines(panel), key=lambda line: max(abs(y) for y in line["y"] if y is not None))


def sine(n):
    return lambda z: math.sin(n * math.pi * z) / math.sin(0.3 * n * math.pi)


def beam():
    """Of a beam on stiff bearings at its ends with a station at 0.3 L."""
    for n, panel in (1, "mode-1"), (2, "mode-3"):
        line = largest(panels("shapes")[panel])
        near = min(worst(line, sine(n)), worst(line, lambda z, n=n: -sine(n)(z)))
        print("mode", n, len(line["x"]) > 90, near < 3e-3)
    sag = lines(panels("sag")["sag"])[0]
    deepest = min(y for y in sag["y"] if y is not None)
    print("sag", worst(sag, lambda z: 3.2 * deepest * (z - 2 * z**3 + z**4)) < 1e-3 * -deepest)
    print("deflected", sorted({len(lines(panel)) for panel in panels("deflected").values()}))
    print("grey", len([one for one in panels("sag")["sag"]["series"] if one["shape"] in ("area", "boxes")]))


def standing():
    for top in "start", "end":
        panel = panels(top)["machine"]
        spots = {spot["station"]: spot["box"] for spot in panel["spots"]}
        heights = [sum(box[2:]) for box in spots.values()]
        ticks = dict(zip(panel["y"]["tick_texts"], panel["y"]["ticks"]))
        ways = heights == sorted(heights, reverse=True), heights == sorted(heights)
        print(top, *spots, panel["y"]["label"], panel["x"]["shown"], *ways, round(ticks["400"]))


beam() if sys.argv[1] == "lines" else standing()
