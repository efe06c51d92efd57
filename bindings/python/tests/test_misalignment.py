"""Tests cases/misalignment.yaml: the effect of each of three kinds of misalignment on the fan and on the readings of
probes."""

import copy

import numpy as np
import pytest
import yaml
from conftest import ROOT

import whirl

CASE = yaml.load((ROOT / "cases/misalignment.yaml").read_text(), yaml.BaseLoader)
STATIONS = list(CASE["rotor"]["stations"])
FAN, INNER = STATIONS.index("fan"), STATIONS.index("inner")


def at(**values):
    """Returns the table of one point at 1150 rpm, and the response to unbalance there."""
    case = copy.deepcopy(CASE)
    case["parameters"].update({"speed": "1150 rpm", **values})
    case["study"] = {
        "response": {},
        "unbalance": {},
        "integrate": {"transient": 40, "record": 4},
        "analyze": ["orbit", "spectrum"],
    }
    result = whirl.run(whirl.Case(case), progress=False)
    return result["response"], result["unbalance"]


def lines(table, station):
    """Returns 0-p amplitudes of x and y in mm by order."""
    rows = np.asarray(table["spectrum/lines"])[0, station]
    return {round(row[0]): 0.1 * np.hypot(row[1], row[2]) for row in rows if row[0] > 0}


def test_each_sense_has_its_order():
    all_of_them, response = at()
    fan = lines(all_of_them, FAN)
    assert fan[2] == pytest.approx(0.032, rel=0.02) and fan[1] == pytest.approx(0.0051, rel=0.02)

    straight = lines(at(bend="0")[0], FAN)
    assert straight.get(2, 0.0) < 0.01 * fan[2] and straight[1] == pytest.approx(fan[1], rel=0.02)

    # The 2X line is proportional to T tan b. The torque is changed only slightly, so that its steady part hardly
    # changes the stiffness of the cubic seat.
    more = lines(at(torque="152 N m")[0], FAN)
    assert more[2] / fan[2] == pytest.approx(152 / 150, rel=2e-3)

    square, _ = at(kink="0")
    assert abs(lines(square, FAN)[1] - fan[1]) > 0.2 * fan[1]

    in_line, _ = at(elevation="0 mm")
    means = [0.1 * np.asarray(one["orbit/mean"])[0, :, 1] for one in (all_of_them, in_line)]
    assert means[0][STATIONS.index("outer")] - means[1][STATIONS.index("outer")] == pytest.approx(0.3, rel=0.1)


def test_probes_read_the_shaft_and_its_runout():
    _, response = at()

    def vectors(name):
        amplitude, lag = (np.ravel(response[f"unbalance/{field}"][0, INNER]) for field in (name, f"{name}_lag"))
        return np.asarray(amplitude) * np.exp(-1j * np.deg2rad(lag))

    # 4 um at 45 degrees in units of .1 mm: the second probe sees it a quarter of a turn later.
    expected = 0.04 * np.exp(1j * np.pi / 4) * np.array([1, -1j])
    assert vectors("seen") - vectors("probe") == pytest.approx(expected, abs=1e-12)
