"""Findings of bearings and balancing in US units: SI is the same, what is shown follows by the factors of NIST SP 811."""
import json

inch, pound, gravity = 0.0254, 0.45359237, 9.80665
force = pound * gravity
ounce_inch = pound / 16 * inch
sizes = {
    "lbf": force,
    "mil": inch / 1000,
    "psi": force / inch**2,
    "gpm": 231 * inch**3 / 60,
    "hp": 550 * 12 * inch * force,
    "lbm": pound,
    "lbf/in": force / inch,
    "lbf s/in": force / inch,
    "oz in": ounce_inch,
    "oz": pound / 16,
    "in": inch,
    "mil p-p": inch / 2000,
    "mil p-p/(oz in)": inch / 2000 / ounce_inch,
    "degF": 5 / 9,
    "rpm": 3.141592653589793 / 30,
}


def sheets(name):
    with open(name + ".json") as file:
        return {sheet["name"]: sheet for sheet in json.load(file)["sheets"]}


used = set()
for name in ("b", "w"):
    metric = sheets(name)
    for key, sheet in sheets(name + "-us").items():
        assert sheet["rows"] == metric[key]["rows"], key
        for c, column in enumerate(sheet["columns"]):
            unit = column["unit"]
            if unit in ("", "deg"):
                continue
            used.add(unit)
            for row, shown in zip(sheet["rows"], sheet["shown"]):
                if row[c] is None:
                    continue
                value = row[c] / sizes[unit] - (459.67 if unit == "degF" else 0)
                assert abs(float(shown[c]) - value) <= 6e-4 * abs(value), (key, unit, row[c], shown[c])
print("shown in", *sorted(used))
