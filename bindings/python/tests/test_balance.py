"""Weights that `whirl balance` finds on simulated rotors take their vibration away."""

import json
import subprocess

import numpy as np
import pytest
from conftest import COMMAND

import whirl

CASE = """
whirl: 1
parameters: {{omega: 300 rad/s}}
rotor:
  speed: = omega
  length_scale: 1 um
  stations:
    left: {{position: 0 m}}
    first: {{position: 0.3 m, mass: 20 kg}}
    second: {{position: 0.8 m, mass: 30 kg}}
    right: {{position: 1.2 m}}
  elements:
    - segment: {{length: 1.2 m, outer: 80 mm}}
    - bearing: {{at: left, kxx: 30 MN/m, kyy: 20 MN/m, cxx: 3 kN s/m}}
    - bearing: {{at: right, kxx: 40 MN/m, kyy: 25 MN/m, cxx: 3 kN s/m}}
{weights}
study:
  unbalance: {{parameter: omega, values: {speeds}}}
"""
OWN = [("first", 1.3e-3, 70.0), ("second", 0.9e-3, 250.0)]
PLANES = ("first", "second")


def response(weights, speeds):
    lines = [f"    - unbalance: {{at: {at}, moment: {m:.17g}, angle: {a:.17g} deg}}" for at, m, a in weights]
    text = CASE.format(weights="\n".join(lines), speeds=speeds)
    table = whirl.run(whirl.Case(text=text), progress=False)["unbalance"]
    return table["unbalance/amplitude"][:, [0, 3], 0] * 1e-6, table["unbalance/lag"][:, [0, 3], 0]


def rows(run, weights, speeds):
    sizes, lags = response(weights, speeds)
    return [
        {"run": run, "speed": speed, "probe": probe, "amplitude": sizes[i, k], "phase": f"{lags[i, k]:.17g} deg"}
        for i, speed in enumerate(speeds)
        for k, probe in enumerate(("left", "right"))
    ]


def balance(path, file):
    path.write_text(json.dumps(file))  # JSON is YAML
    done = subprocess.run([COMMAND, "balance", path, "--json"], capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


@pytest.mark.parametrize("speeds", ([300], [250, 300, 420]))
def test_weights_take_the_vibration_away(tmp_path, speeds):
    trials = [("first", 0.5e-3, 20.0), ("second", 0.4e-3, 130.0)]
    file = {
        "balance": 1,
        "angles": "with",
        "phases": "lag",
        "planes": [{"name": plane} for plane in PLANES],
        "trials": [
            {"run": 2 + i, "plane": at, "moment": m, "angle": f"{a} deg"} for i, (at, m, a) in enumerate(trials)
        ],
        "vibration": rows(1, OWN, speeds) + rows(2, OWN + trials[:1], speeds) + rows(3, OWN + trials[1:], speeds),
    }
    found = balance(tmp_path / "b.yaml", file)["correction"]
    for at, moment, angle in OWN:
        own = found[at]["moment"] * np.exp(1j * found[at]["angle"])
        assert own == pytest.approx(-moment * np.exp(1j * np.radians(angle)), rel=1e-8)
    weights = [(at, found[at]["moment"], np.degrees(found[at]["angle"])) for at in PLANES]
    before, after = (response(own, speeds)[0].max() for own in (OWN, OWN + weights))
    assert after < 1e-7 * before


def test_least_squares_of_one_plane(tmp_path):
    """What numpy finds: three readings, weights of their own, one plane."""
    speeds = [250, 300, 420]
    file = {
        "balance": 1,
        "angles": "with",
        "phases": "lag",
        "planes": [{"name": "first"}],
        "trials": [{"run": 2, "plane": "first", "moment": 0.5e-3, "angle": "20 deg"}],
        "vibration": [
            {**row, "weight": 1 + 2 * i}
            for run in (1, 2)
            for i, row in enumerate(rows(run, OWN + [("first", 0.5e-3, 20.0)] * (run - 1), speeds))
        ],
    }
    found = balance(tmp_path / "b.yaml", file)
    vectors = [row["amplitude"] * np.exp(-1j * np.radians(float(row["phase"].split()[0]))) for row in file["vibration"]]
    before, with_trial = np.array(vectors[:6]), np.array(vectors[6:])
    influence = (with_trial - before) / (0.5e-3 * np.exp(1j * np.radians(20)))
    root = np.sqrt(1 + 2 * np.arange(6))
    (best,), *_ = np.linalg.lstsq((root * influence)[:, None], -root * before, rcond=None)
    own = found["correction"]["first"]["moment"] * np.exp(1j * found["correction"]["first"]["angle"])
    assert own == pytest.approx(best, rel=1e-9)
    after = [row["after"]["amplitude"] for row in found["vibration"]]
    assert after == pytest.approx(np.abs(before + influence * best), rel=1e-9)
