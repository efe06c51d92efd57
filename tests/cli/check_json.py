"""Checks the document of `whirl run --json`: what must be there, of which kind, and that the numbers are possible."""
import json
import math
import sys


def refuse(word):
    raise ValueError(f"{word} is not JSON")


def number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)


def check_point(point):
    assert number(point["parameters"]["omega"]) and number(point["parameters"]["kappa"])
    assert point["regime"] in ("periodic", "quasi-periodic", "chaotic", "diverged", "undetermined"), point["regime"]
    if point["regime"] == "periodic":
        assert 1 <= point["period"] <= 64
    assert number(point["lyapunov"]["largest"]) and point["lyapunov"]["error"] >= 0
    assert isinstance(point["rub"]["contact"], bool) and 0 <= point["rub"]["fraction"] <= 1
    assert point["rub"]["contact"] == (point["rub"]["fraction"] > 0)
    radius = point["stations"]["disc"]["max_radius"]
    assert 0 < radius < 10
    section = point["poincare"]["disc"]
    assert len(section) == 10, "as many as revolutions were recorded"
    for x, y in section:
        assert math.hypot(x, y) <= radius * (1 + 1e-12)
    for line in point["spectrum"]["disc"]:
        assert line["order"] > 0 and line["amplitude"] >= 0 and line["direction"] in ("forward", "backward")


path, count = sys.argv[1], int(sys.argv[2])
with open(path, encoding="utf-8") as file:
    points = json.load(file, parse_constant=refuse)["points"]
assert len(points) == count
for point in points:
    check_point(point)
omegas = [point["parameters"]["omega"] for point in points]
assert all(math.isclose(omega, 1 + 3 * i / (count - 1)) for i, omega in enumerate(omegas))
print(f"good: {count} points")
