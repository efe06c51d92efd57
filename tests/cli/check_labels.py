"""No two movable texts of figures meet, nor leave their panels:  check_labels.py FIGURE.json..."""

import json
import math
import sys

SIDES = {  # left end in widths, gap in letters' heights, lower edge in letters' heights, turn
    "above": (-0.5, 0.0, 0.2, 0),
    "below": (-0.5, 0.0, -1.2, 0),
    "left": (-1.0, -0.5, 0.2, 0),
    "right": (0.0, 0.5, -1.2, 0),
    "slanted": (0.0, 0.5, -0.45, 60),
    "beside": (0.0, 0.5, -0.45, 0),
}


def share(axis, value):
    if axis["log"]:
        return math.log(value / axis["low"]) / math.log(axis["high"] / axis["low"])
    return (value - axis["low"]) / (axis["high"] - axis["low"])


def boxes(figure, panel):
    """Corners, cm in the panel, of all texts of a panel, whose letters are as wide as those of Helvetica."""
    left, right, bottom, top = panel["box"]
    width, height = (right - left) * figure["width_cm"], (top - bottom) * figure["height_cm"]
    em = 0.9 * figure["font_pt"] * 2.54 / 72
    for series in panel["series"]:
        begin, gap, low, turn = SIDES[series.get("side", "above")]
        for x, y, text in zip(series.get("x", []), series.get("y", []), series.get("texts", [])):
            wide = 0.556 * em / 0.9 * len(text)
            at = complex(width * share(panel["x"], x), height * share(panel["y"], y))
            u, v = begin * wide + gap * em, low * em
            turned = complex(math.cos(math.radians(turn)), math.sin(math.radians(turn)))
            corners = [complex(u + i * wide, v + k * 0.9 * em) for i, k in ((0, 0), (1, 0), (1, 1), (0, 1))]
            yield text, [at + turned * corner for corner in corners], (width, height)


def meet(one, other):
    """Two convex shapes meet unless an edge of one has all of the other outside."""
    for a, b in ((one, other), (other, one)):
        for i in range(4):
            edge = a[(i + 1) % 4] - a[i]
            if all((edge.conjugate() * (corner - a[i])).imag <= 1e-9 for corner in b):
                return False
    return True


texts = 0
for path in sys.argv[1:]:
    with open(path) as file:
        figure = json.load(file)
    for panel in figure["panels"]:
        found = list(boxes(figure, panel))
        texts += len(found)
        for i, (text, box, (width, height)) in enumerate(found):
            if not all(0 <= corner.real <= width and 0 <= corner.imag <= height for corner in box):
                print(f"{path}: {text} leaves the panel {panel['name']}")
            for other, its, _ in found[:i]:
                if meet(box, its):
                    print(f"{path}: {text} meets {other} in the panel {panel['name']}")
print(f"{texts} texts")
