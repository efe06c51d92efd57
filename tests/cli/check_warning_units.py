"""Warnings in US units: every number of the same warnings in SI, converted by the factors of NIST SP 811."""
import json
import re
import sys

inch, pound = 0.0254, 0.45359237
force = pound * 9.80665
# SI unit or that of the case: unit shown, its size, and the offset of temperatures.
shown = {
    "m": ("mil", inch / 1000, 0),
    "m/s": ("in/s", inch, 0),
    "Pa": ("psi", force / inch**2, 0),
    "N/m": ("lbf/in", force / inch, 0),
    "N s/m": ("lbf s/in", force / inch, 0),
    "kg": ("lbm", pound, 0),
    "degC": ("degF", 5 / 9, 459.67 - 273.15 * 9 / 5),
    "Hz": ("cpm", 1 / 60, 0),
}
number = r"(?<![\w.])-?\d[\d.]*(?:e[+-]?\d+)?"
units = sorted([*shown, *(own[0] for own in shown.values())], key=len, reverse=True)
quantity = re.compile(rf"({number}) ({'|'.join(map(re.escape, units))})(?![\w/])")


def texts(name):
    """What `check` says, what the result says, and the warnings of its JSON."""
    warned = re.compile(r"^(?:\S+ )?warning: (.*)$|^((?:bearing|seal) at .*)$", re.M)
    with open(name + ".check") as file, open(name + ".show") as out, open(name + ".json") as document:
        said = [["".join(one) for one in warned.findall(own.read())] for own in (file, out)]
        own = json.load(document)
    said.append(own["warnings"] + own.get("fits", []))
    return said


used = set()
for of in sys.argv[1:]:
    metric, customary = texts(of), texts(of + "-us")
    assert metric[1] == metric[2] and customary[1] == customary[2], "summary and JSON differ"
    assert set(w for w in metric[0] if not w.startswith(("bearing", "seal"))) <= set(metric[1]), "check says others"
    for si, us in zip(metric[1], customary[1], strict=True):
        assert quantity.sub("#", si) == quantity.sub("#", us), (si, us)
        for (value, unit), (printed, own) in zip(quantity.findall(si), quantity.findall(us), strict=True):
            name, size, zero = shown[unit]
            right = float(value) / size - zero
            assert own == name and abs(float(printed) - right) <= 5.1e-4 * abs(right), (
                si,
                us,
            )
            used.add(f"{unit} as {name}")
print("converted:", ", ".join(sorted(used)))
