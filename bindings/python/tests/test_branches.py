"""Branches of custom systems, compared with closed forms and with shooting by SciPy."""

import importlib.util
import math
import subprocess

import numpy as np
import pytest
from conftest import COMMAND

import whirl
from whirl.systems import System, compile_c

FOLD, CROSSING, DOUBLING, TORUS, HOPF = range(1, 6)  # codes of the field trace/special
DAMPING, CUBIC, FORCE = 0.2, 0.5, 0.5
QUICK = {"method": "dop853", "transient": 40, "record": 16, "rtol": 1e-11, "step": 0.1, "progress": False}
DUFFING = f"""
int rates(double t, const double *x, const double *p, double *dxdt, void *context) {{
    (void)context;
    dxdt[0] = x[1];
    dxdt[1] = {FORCE} * cos(p[0] * t) - {DAMPING} * x[1] - x[0] - {CUBIC} * x[0] * x[0] * x[0];
    return 0;
}}
"""
VAN_DER_POL = """
int rates(double t, const double *x, const double *p, double *dxdt, void *context) {
    (void)context, (void)t;
    dxdt[0] = x[1];
    dxdt[1] = (p[0] - x[0] * x[0]) * x[1] - x[0];
    return 0;
}
"""


def special(table, kind):
    return np.flatnonzero(table["trace/special"] == kind)


# ---------------------------------------------------------------- orbits


def revolve(state, omega):
    """Returns the state of Duffing's oscillator after a revolution, and its derivative, by SciPy."""
    pytest.importorskip("scipy")
    from scipy.integrate import solve_ivp

    def slopes(t, y):
        x, v = y[:2]
        jacobian = np.array([[0.0, 1.0], [-1.0 - 3.0 * CUBIC * x**2, -DAMPING]])
        force = FORCE * np.cos(omega * t) - DAMPING * v - x - CUBIC * x**3
        return [v, force, *(jacobian @ y[2:].reshape(2, 2)).ravel()]

    start = [*state, 1.0, 0.0, 0.0, 1.0]
    end = solve_ivp(slopes, (0.0, 2 * np.pi / omega), start, "DOP853", rtol=1e-12, atol=1e-13).y[:, -1]
    return end[:2], end[2:].reshape(2, 2)


def fold_near(state, omega):
    """Returns the fold by SciPy: an orbit with a multiplier of 1."""
    from scipy.optimize import fsolve

    def residual(unknown):
        end, matrix = revolve(unknown[:2], unknown[2])
        return [*(end - unknown[:2]), np.linalg.det(matrix - np.eye(2))]

    return fsolve(residual, [*state, omega], xtol=1e-11)


def duffing(displacements):
    return System(compile_c(DUFFING), [0, 0], {"omega": 0.7}, speed="omega", displacements=displacements)


@pytest.mark.parametrize("displacements", [0, 1])
def test_folds_of_duffing_are_those_of_scipy(displacements):
    """Tests that both folds of the main resonance, and the multipliers of every tenth orbit, agree with SciPy, which
    starts from guesses of two digits. Its revolutions are exact to 1e-11. The error of a fold is of the order of the
    square root of that of a multiplier, so the tolerance is 1e-7."""
    table = duffing(displacements).branch("omega", 0.7, 2.2, **QUICK)["branch"]
    folds = special(table, FOLD)
    assert len(folds) == 2 and np.count_nonzero(table["trace/special"]) == 2
    for i in folds:
        state, omega = table["trace/nodes"][i, :2], table.values[i]
        *found, where = fold_near(np.round(state, 2), round(omega, 2))
        assert abs(where - omega) < 1e-7 and np.abs(found - state).max() < 1e-5
    for i in range(0, len(table.values), 10):
        state, omega = table["trace/nodes"][i, :2], table.values[i]
        end, matrix = revolve(state, omega)
        assert np.abs(end - state).max() < 1e-9
        own = np.sort_complex(table["trace/multipliers"][i] @ [1, 1j])
        assert np.abs(own - np.sort_complex(np.linalg.eigvals(matrix))).max() < 1e-6
    between = np.arange(len(table.values))
    between = between[(between > folds[0]) & (between < folds[1])]
    assert (table["trace/unstable"][between] == 1).all() and len(between) > 3
    assert table["trace/unstable"].sum() <= len(between) + 2


# ---------------------------------------------------------------- equilibria


def test_hopf_points_of_van_der_pol():
    """Tests x'' - (mu - x^2) x' + x = 0: its Hopf point is at mu = 0 with the rate 1 and the cubic coefficient -1/4,
    and the amplitude of its orbits is 2 sqrt(mu), up to terms of mu^(3/2)."""

    system = System(compile_c(VAN_DER_POL), [0.1, 0], {"mu": -0.1}, period=2 * np.pi)
    table = system.branch("mu", -0.1, 0.05, rest=True, **QUICK)["branch"]
    (at,) = special(table, HOPF)
    assert abs(table.values[at]) < 1e-9 and abs(table["trace/angle"][at] - 1.0) < 1e-9
    assert abs(table["trace/criticality"][at] + 0.25) < 0.0025
    swings = table["trace/period"] > 0
    amplitude = table["trace/high"][swings, 0, 0]
    assert np.abs(amplitude - 2 * np.sqrt(table.values[swings])).max() < 0.01 and len(amplitude) > 2
    assert (table["trace/unstable"][swings] == 0).all()


def test_hopf_points_of_the_brusselator():
    """Tests that the Hopf point is at B = 1 + A^2 with the rate A, for every period of the system (table.clock)."""

    def slopes(t, x, p):
        return p.A - (p.B + 1) * x[0] + x[0] ** 2 * x[1], p.B * x[0] - x[0] ** 2 * x[1]

    system = System(slopes, [1, 1], {"A": 1.2, "B": 1.0}, period=3.0)
    result = system.branch("B", 1.0, 3.0, rest=True, switches=0, progress=False)
    table = result["branch"]
    (at,) = special(table, HOPF)
    assert abs(table.values[at] - 2.44) < 1e-8
    assert abs(table["trace/angle"][at] * table.clock[at] - 1.2) < 1e-8
    roots = table["trace/multipliers"] @ [1, 1j] * table.clock[:, None]
    for i, b in enumerate(table.values):
        expected = np.linalg.eigvals([[b - 1, 1.44], [-b, -1.44]])
        assert np.abs(np.sort_complex(roots[i]) - np.sort_complex(expected)).max() < 1e-7
    assert np.abs(table["trace/nodes"][:, :2] - np.stack([0 * table.values + 1.2, table.values / 1.2], 1)).max() < 1e-9


def test_results_of_branches_are_saved_and_shown(tmp_path):
    def slopes(t, x, p):
        return [p.r + x[0] ** 2]

    result = System(slopes, [-1.2], {"r": -1.0}, period=1.0).branch("r", -1.0, 0.5, rest=True, progress=False)
    table = result["branch"]
    assert abs(table.values[special(table, FOLD)]).max() < 1e-10
    # The system has one coordinate; the multipliers still have a dimension of rows.
    assert table["trace/multipliers"].shape == (len(table.values), 1, 2)
    assert table.fields["trace/multipliers"].dimensions == ("row", "column")
    result.save(tmp_path / "fold.h5")
    again = whirl.open(tmp_path / "fold.h5")["branch"]
    for name in table:
        assert again[name].shape == table[name].shape and np.array_equal(again[name], table[name], equal_nan=True)
    assert again.options == table.options and again.options["trace_rest"] == 1
    shown = subprocess.run([COMMAND, "show", tmp_path / "fold.h5"], capture_output=True, text=True)
    assert shown.returncode == 0 and "the branch turns back" in shown.stdout
    if importlib.util.find_spec("matplotlib"):
        assert len(result.plot.branches().lines) >= 2


# ---------------------------------------------------------------- runs


def test_branches_go_on_from_a_journal(tmp_path):
    """Tests that a run with a journal does not follow its first branch again. x = 2 cos t + u with u' = (r^2 - 1) - u^2
    has two branches, r < -1 and r > 1."""
    calls = [0]

    def slopes(t, x, p):
        calls[0] += 1
        u = x[0] - 2 * math.cos(t)
        return [p.r**2 - 1 - u**2 - 2 * math.sin(t)]

    def follow(at=(-1.05, 1.05), progress=False, bound=1.1, **more):
        system = System(slopes, [2.3], {"r": 1.05}, period=2 * np.pi, identity="gap 1")
        calls[0] = 0
        options = {**QUICK, "transient": 5, "rtol": 1e-9, "longest": 1, **more, "progress": progress}
        return system.branch("r", -bound, bound, at, **options)["branch"]

    def stop(stage, done, *_):
        if done > 0:
            raise KeyError("enough")

    journal = tmp_path / "journal"
    whole, all_calls = follow(), calls[0]
    assert set(np.round(whole.values[special(whole, FOLD)], 6)) == {-1.0, 1.0}
    with pytest.raises(KeyError, match="enough"):
        follow(progress=stop, journal=journal)
    for other in ({"at": (-1.05, 1.02)}, {"bound": 1.2}):
        with pytest.raises(whirl.BadInput, match="is of another study: equations: branches"):
            follow(**other, journal=journal, resume=True)
    with pytest.raises(whirl.BadInput, match="is of another study: trace_step"):
        follow(step=0.05, journal=journal, resume=True)
    again = follow(journal=journal, resume=True)
    assert calls[0] < 0.9 * all_calls and not journal.exists()
    for name in whole:
        assert np.array_equal(again[name], whole[name], equal_nan=True), name


def test_what_a_function_raises_comes_through_and_what_is_wrong_is_said():
    def slopes(t, x, p):
        if p.r > -0.2:
            raise ArithmeticError("beyond")
        return [p.r + x[0] ** 2]

    system = System(slopes, [-0.8], {"r": -1.0}, period=1.0)
    for rest in (False, True):
        with pytest.raises(ArithmeticError, match="beyond"):
            system.branch("r", -0.5, 0.5, rest=rest, transient=5, progress=False)
    with pytest.raises(whirl.BadInput, match="no parameter R, did you mean r"):
        system.branch("R", 0, 1)
    with pytest.raises(whirl.BadInput, match="begins at r = 2, expected a value from 0 to 1"):
        system.branch("r", 0, 1, at=2)
    with pytest.raises(whirl.BadInput, match="no option trace_steps|no option steps"):
        system.branch("r", 0, 1, steps=0.1)
    driven = System(lambda t, x, p: [p.r + np.cos(t) * x[0]], [0.0], {"r": 1.0}, period=2 * np.pi)
    with pytest.raises(whirl.BadInput, match="slope 0 changes with t"):
        driven.branch("r", 0, 1, rest=True)
