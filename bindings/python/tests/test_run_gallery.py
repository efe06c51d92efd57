"""Tests the run-ups of the gallery against numbers of independent programs, which integrate the full equations of
motion (SciPy's DOP853 at 1e-12, with the mass matrix solved at every instant). In each program the energy balance of
motors, dampers, rubs, films and loads holds to 2e-13; the docstrings give its error."""

import numpy as np
import pytest
from conftest import ROOT

import whirl

LENGTH = {"rub-run-up": 1e-4, "sommerfeld": 1e-3}


def run(name, **settings):
    case = whirl.Case(ROOT / "cases" / f"{name}.yaml")
    for key, value in settings.items():
        case = case.set(key.replace("__", "."), value)
    return whirl.run(case, progress=False)


def check(table, name, point, turns, speed, x, y):
    assert abs(table["runup/end_turns"][point] - turns) < 1e-8 * turns
    assert abs(table["runup/end_speed"][point] - speed) < 1e-8 * speed
    place = LENGTH[name] * table["runup/place"][point, 0]
    assert np.abs(place - [x, y]).max() < 1e-6 * np.hypot(x, y)


def test_run_up_with_a_rub():
    """Energy error of the program: -8e-16. The contact opens or closes 152 times."""
    result = run("rub-run-up", runup__duration="3 s", runup__rtol="1e-12", runup__spectra=0)
    table = result["runup"]
    check(table, "rub-run-up", 0, 115.351269193, 424.199960604, 1.379296311e-05, -0.0001492130187)
    assert table["runup/contact_number"][0, 0] == 76


@pytest.mark.parametrize(
    "point, turns, speed, x, y",
    [
        (0, 946.993156847, 98.9773525548, 0.004604800444, -0.009993415797),
        (1, 1443.37084796, 160.779580939, 0.0005843341526, -0.0005678464636),
    ],
)
def test_sommerfeld_effect(point, turns, speed, x, y):
    """Energy errors of the program: -1.4e-13 and -2.2e-14. One motor stays below 100 rad/s, the other one passes it."""
    table = run("sommerfeld", runup__duration="100 s", runup__rtol="1e-12", runup__stationary=0)["runup"]
    check(table, "sommerfeld", point, turns, speed, x, y)


def test_start_of_a_motor():
    """Energy error of the program: 7e-15. Compares the speeds of the stations and the largest torques of both
    couplings."""
    table = run("motor-start", runup__rtol="1e-12")["runup"]
    speeds = [182.230844673, 182.22871623, 2 * 182.22871623, 364.454569216]
    assert np.abs(table["runup/station_speed"][0, :, -1] - speeds).max() < 1e-7
    largest = sorted(table["runup/torque_extreme"][0, :, 0])
    for expected in (57.9227602818, 103.022361226):
        assert min(abs(each - expected) for each in largest) < 1e-6


def test_gears_rattle():
    """At 1.2 of the natural frequency the teeth separate once in every period. The expected orbit is composed of
    exponentials between switching times, solved with 30 digits; in a period the damper takes the energy that the torque
    supplies."""
    result = run("gear-rattle", sweep__from="1.2", sweep__to="1.3", sweep__points=2)
    table = result["sweep"]
    assert table.verdicts[0] == "P-1"
    section = table["poincare/section"][0, 0, -1]
    assert min(abs(section - 0.879500748114861)) < 1e-8
