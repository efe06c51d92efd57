"""Checks the document of `whirl verify --json` of cases/jeffcott-rub.yaml."""
import json
import sys


def refuse(word):
    raise ValueError(f"{word} is not JSON")


with open(sys.argv[1], encoding="utf-8") as file:
    document = json.load(file, parse_constant=refuse)
assert document["table"] == "detail" and document["parameter"] == "omega" and document["revolutions"] == 20
found = []
orders = []
for point in document["points"]:
    runs = point["runs"]
    assert len(runs) == 6 and [run["method"] for run in runs] == ["rk4"] * 3 + ["dop853"] * 3
    assert [run["steps_per_revolution"] for run in runs[:3]] == [1024, 2048, 4096]
    assert all(abs(run["rtol"] * 10 ** (9 + i) - 1) < 1e-9 for i, run in enumerate(runs[3:]))
    assert runs[5]["difference"] == 0 and all(run["difference"] < 1e-5 for run in runs)
    verdicts = {(run["regime"], run["period"]) for run in runs}
    assert point["agreed"] == (len(verdicts) == 1)
    exponents = [run["exponent"] for run in runs]
    assert abs(point["exponent_spread"] - (max(exponents) - min(exponents))) < 1e-15
    regime, period = verdicts.pop()
    assert (runs[0]["section"] is None) == (regime != "periodic")
    found.append(f"{point['value']:g} " + (f"P-{period}" if regime == "periodic" else regime))
    orders.append(point["order"]["rk4"])
assert min(orders) < 3.5, orders
print(", ".join(found) + ": agreed; the order of rk4 is below 4")
