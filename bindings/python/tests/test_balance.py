"""Tests that weights from `whirl balance` remove the vibration of simulated rotors."""

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
    """Tests one plane with readings at three speeds, weighted differently: the correction is that of numpy's least
    squares."""
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


# ---------------------------------------------------------------- planes that act nearly alike, limits, given influence

PROBES, COUNT = 4, 3


def numbers(seed):
    """Returns influence coefficients in m/(kg m) [probes][planes], nearly equal for the last two planes, and vibrations
    in m."""
    draw = np.random.default_rng(seed)
    influence = draw.normal(size=(PROBES, COUNT, 2)) @ [1, 1j] * 1e-2
    influence[:, 2] = influence[:, 1] * (1 + 0.05 * draw.normal(size=(PROBES, 2)) @ [1, 1j])
    return influence, draw.normal(size=(PROBES, 2)) @ [1, 1j] * 1e-5


def known(influence, vibration, **more):
    """Returns the text of a file with the coefficients, in one run without weights."""
    polar = lambda v: {"amplitude": float(abs(v)), "phase": float(np.angle(v))}  # noqa: E731
    return {
        "balance": 1,
        "angles": "with",
        "phases": "lead",
        "planes": [{"name": f"p{p}"} for p in range(COUNT)],
        "coefficients": [
            {"plane": f"p{p}", "probe": f"s{i}", "speed": 300.0, **polar(influence[i, p])}
            for i in range(PROBES)
            for p in range(COUNT)
        ],
        "vibration": [{"run": 1, "speed": 300.0, "probe": f"s{i}", **polar(v)} for i, v in enumerate(vibration)],
        **more,
    }


def moments(of):
    return np.array([of[f"p{p}"]["moment"] * np.exp(1j * of[f"p{p}"]["angle"]) for p in range(COUNT)])


@pytest.mark.parametrize("seed", range(3))
def test_planes_that_act_nearly_alike(tmp_path, seed):
    """Tests that the condition number, the significances and the weights without a plane are those of numpy."""
    influence, vibration = numbers(seed)
    found = balance(tmp_path / "b.yaml", known(influence, vibration))
    best = np.linalg.lstsq(influence, -vibration, rcond=None)[0]
    assert moments(found["correction"]) == pytest.approx(best, rel=1e-8)
    values = np.linalg.svd(influence, compute_uv=False)
    assert found["condition"] == pytest.approx(values[0] / values[-1], rel=1e-6)
    left = {}
    for p in range(COUNT):
        others = np.delete(influence, p, axis=1)
        share = np.linalg.lstsq(others, influence[:, p], rcond=None)[0]
        rest = np.linalg.norm(influence[:, p] - others @ share) / np.linalg.norm(influence[:, p])
        assert found["significance"][f"p{p}"] == pytest.approx(rest, rel=1e-6)
        own = np.linalg.lstsq(others, -vibration, rcond=None)[0]
        if rest < 0.2:
            left[p] = np.sqrt(np.mean(abs(vibration + others @ own) ** 2)), np.insert(own, p, 0)
    without = min(left, key=lambda p: left[p][0])
    assert set(left) == {1, 2} and found["without"]["name"] == f"p{without}"
    assert found["without"]["left"] == pytest.approx(left[without][0], rel=1e-8)
    assert moments(found["without"]["correction"]) == pytest.approx(left[without][1], rel=1e-8, abs=1e-15)
    assert any("nearly" in text for text in found["warnings"])


@pytest.mark.parametrize("seed", range(3))
def test_limits_of_weights(tmp_path, seed):
    """Tests that weights fulfil the conditions of Karush, Kuhn and Tucker: the gradient is zero for a weight below its
    limit, and points inwards for a weight at its limit."""
    influence, vibration = numbers(seed)
    best = np.linalg.lstsq(influence, -vibration, rcond=None)[0]
    limits = abs(best) * [2.0, 0.3, 0.6]
    file = known(influence, vibration)
    file["planes"] = [{"name": f"p{p}", "limit": float(limits[p])} for p in range(COUNT)]
    own = moments(balance(tmp_path / "b.yaml", file)["correction"])
    slope = influence.conj().T @ (vibration + influence @ own)
    scale = np.linalg.norm(influence) * np.linalg.norm(vibration)
    assert (abs(own) <= limits * (1 + 1e-12)).all() and (abs(own) >= limits * (1 - 1e-9)).any()
    for u, s, limit in zip(own, slope, limits):
        inwards = -s * np.conj(u) / abs(u) if abs(u) >= limit * (1 - 1e-9) else s
        assert abs(inwards.imag) < 1e-7 * scale
        assert inwards.real > -1e-7 * scale if abs(u) >= limit * (1 - 1e-9) else abs(s) < 1e-7 * scale


def test_slow_roll_is_subtracted(tmp_path):
    influence, vibration = numbers(7)
    rolls = vibration[::-1] * 0.4j
    file = known(influence, vibration + rolls)
    file["slow_roll"] = [
        {"probe": f"s{i}", "amplitude": float(abs(v)), "phase": float(np.angle(v))} for i, v in enumerate(rolls)
    ]
    found = balance(tmp_path / "b.yaml", file)
    best = np.linalg.lstsq(influence, -vibration, rcond=None)[0]
    assert moments(found["correction"]) == pytest.approx(best, rel=1e-8)
    assert [row["before"]["amplitude"] for row in found["vibration"]] == pytest.approx(abs(vibration), rel=1e-9)
