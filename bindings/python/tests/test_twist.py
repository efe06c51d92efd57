"""Tests twists of stations that also move along x and y, in time, against closed forms and SciPy."""

import json
import subprocess

import numpy as np
import pytest
from conftest import COMMAND, filled, lag_of

import whirl

solve_ivp = pytest.importorskip("scipy.integrate").solve_ivp

POLAR, STIFFNESS, DAMPING, TORQUE, STEADY, PHASE = 0.2, 2000.0, 3.0, 8.0, 2.0, np.radians(20)

# Station a moves in all directions, b only along x and y.
MACHINE = """
whirl: 1
title: A disc on a torsion spring
parameters: {n: 95 rad/s}
rotor:
  speed: SPEED
  length_scale: 1 mm
  ROTATION
  stations:
    a: {mass: 10 kg, damping: 200 N.s/m, eccentricity: 10 um, polar: 0.2 kg.m2, moves: all}
    b: {mass: 12 kg, damping: 200 N.s/m}
  elements:
    - spring: {between: [a, ground], stiffness: 1e6 N/m}
    - spring: {between: [b, ground], stiffness: 1e6 N/m}
    - spring: {between: [a, ground], along: twist, stiffness: 2000, damping: 3}
    - force:  {at: a, torque: 8 N.m, steady_torque: 2 N.m, phase: 20 deg}
study:
"""

SWEEP = """  sweep: {parameter: n, from: 80 rad/s, to: 120 rad/s, points: 5}
  integrate: {method: METHOD, transient: 160, record: 32, rtol: 1e-11, atol: 1e-14, steps_per_revolution: 1024}
  keep: {waveform: 2, highest_order: 3}
  analyze: [orbit, spectrum, waveform, regime]
"""


def case(text, study, **words):
    return filled(text + study, "twist.yaml", **{"speed": "= n", "rotation": "", **words})


def run(*of, **words):
    return whirl.run(case(*of, **words), progress=False)


def response(w):
    """Returns the complex amplitude of the twist, rad."""
    return TORQUE * np.exp(1j * PHASE) / (STIFFNESS - POLAR * w**2 + 1j * DAMPING * w)


@pytest.mark.parametrize("method", ["rk4", "dop853", "rodas5p"])
def test_harmonic_torque(method):
    table = run(MACHINE, SWEEP, method=method)["sweep"]
    count = table["waveform/twist"].shape[2]
    at = 2 * np.pi * np.arange(1, 1 + count) / count * 2
    for i, z in enumerate(response(table.values)):
        mean, least, largest = table["orbit/twist"][i, 0]
        rest = STEADY / STIFFNESS
        assert abs(mean - rest) < 1e-8 * abs(z)
        assert 0 <= rest + abs(z) - largest < 1e-5 * abs(z)
        assert 0 <= least - rest + abs(z) < 1e-5 * abs(z)
        assert abs(table["spectrum/twist_synchronous"][i, 0] - abs(z)) < 1e-8 * abs(z)
        assert abs(table["spectrum/twist_lag"][i, 0] - lag_of(z)) < 1e-6
        order, amplitude = table["spectrum/twist_lines"][i, 0, 0]
        assert abs(order - 1) < 1e-6 and abs(amplitude - abs(z)) < 1e-6 * abs(z)
        wave = rest + np.real(z * np.exp(1j * at))
        assert np.abs(table["waveform/twist"][i, 0] - wave).max() < 1e-8 * abs(z)
    assert table["orbit/max_radius"].shape[1] == 2
    for field in table:
        if "twist" in field:
            assert np.isnan(table[field][:, 1]).all(), field  # b does not twist


def test_lateral_motion_is_the_same():
    """The same machine without twist has the same lateral motion, and no field of twists."""
    table = run(MACHINE, SWEEP, method="rk4")["sweep"]
    text = MACHINE.replace(", polar: 0.2 kg.m2, moves: all", "")
    text = "\n".join(line for line in text.split("\n") if "along: twist" not in line and "steady_torque" not in line)
    lateral = run(text, SWEEP, method="rk4")["sweep"]
    assert not any("twist" in field for field in lateral)
    for field in ("orbit/max_radius", "orbit/mean", "spectrum/synchronous", "spectrum/lines", "waveform/samples"):
        assert np.nanmax(np.abs(lateral[field] - table[field])) < 1e-12, field


def test_unit_of_length_and_mirrored_rotation():
    """The scale of length changes no twist. Torques are along the rotation: a mirrored machine twists back."""
    own = run(MACHINE, SWEEP, method="dop853")["sweep"]
    finer = run(MACHINE.replace("1 mm", "40 um"), SWEEP, method="dop853")["sweep"]
    for field in ("orbit/twist", "waveform/twist", "spectrum/twist_synchronous", "spectrum/twist_lag"):
        one, other = own[field][:, 0], finer[field][:, 0]
        assert np.allclose(one, other, rtol=1e-8, atol=1e-8 * np.abs(one).max()), field
    back = run(MACHINE, SWEEP, method="dop853", rotation="rotation: clockwise")["sweep"]
    assert np.allclose(back["waveform/twist"][:, 0], -own["waveform/twist"][:, 0], rtol=0, atol=1e-10)
    assert np.allclose(back["orbit/twist"][:, 0, 1:], -own["orbit/twist"][:, 0, :0:-1], rtol=0, atol=1e-10)


RIGID = """
whirl: 1
title: Rigid gears
parameters: {n: 100 rad/s}
rotor:
  speed: = n
  length_scale: 0.2 mm
  stations:
    wheel:  {mass: 20 kg, damping: 500 N.s/m, polar: 0.3 kg.m2, moves: all}
    pinion: {mass: 8 kg, damping: 500 N.s/m, polar: 0.02 kg.m2, moves: all}
  elements:
    - spring: {between: [wheel, ground], stiffness: 5e6 N/m}
    - spring: {between: [pinion, ground], stiffness: 5e6 N/m}
    - spring: {between: [wheel, ground], along: twist, stiffness: 6000, damping: 9}
    - gear:   {between: [wheel, pinion], base_radii: [150 mm, 60 mm]}
    - force:  {at: wheel, torque: 10 N.m, steady_torque: 3 N.m}
study:
  sweep: {parameter: n, values: [90 rad/s]}
  integrate: {method: dop853, transient: 200, record: 32, rtol: 1e-11, atol: 1e-14, steps_per_revolution: 256}
  keep: {waveform: 2}
  analyze: [orbit, spectrum, waveform]
"""


def test_rigid_gears():
    """The pinion twists against the wheel, by the ratio of the radii: so do least and largest, and lags."""
    table = run(RIGID, "")["sweep"]
    w, inertia = 90.0, 0.3 + 2.5**2 * 0.02
    z = 10.0 / (6000 - inertia * w**2 + 9j * w)
    assert abs(table["spectrum/twist_synchronous"][0, 0] - abs(z)) < 1e-8 * abs(z)
    assert abs(table["spectrum/twist_synchronous"][0, 1] - 2.5 * abs(z)) < 1e-8 * abs(z)
    assert abs((table["spectrum/twist_lag"][0, 1] - lag_of(-z) + 180) % 360 - 180) < 1e-6
    wave = table["waveform/twist"][0]
    assert np.abs(wave[1] + 2.5 * wave[0]).max() < 1e-14
    mean, least, largest = table["orbit/twist"][0, 1]
    assert least < mean < largest and abs(mean + 2.5 * 3.0 / 6000) < 1e-9
    assert abs(largest + 2.5 * table["orbit/twist"][0, 0, 1]) < 1e-14


def test_rigid_gears_that_only_twist():
    """So it is where both stations move no other way: their twists are displacements 1 m from the axis."""
    text = RIGID.replace("moves: all", "moves: twist").replace("damping: 500 N.s/m, ", "")
    text = text.replace("mass: 20 kg, ", "").replace("mass: 8 kg, ", "")
    text = "\n".join(line for line in text.split("\n") if "ground], stiffness: 5e6" not in line)
    both, only = run(RIGID, "")["sweep"], run(text, "")["sweep"]
    wave = both["waveform/twist"][0]
    assert np.abs(2e-4 * only["waveform/samples"][0, :, :, 0] - wave).max() < 1e-10
    for field, column in (("orbit/low", 1), ("orbit/high", 2)):
        assert np.abs(2e-4 * only[field][0, :, 0] - both["orbit/twist"][0, :, column]).max() < 1e-10
    assert np.abs(2e-4 * only["spectrum/synchronous"][0, :, 0] - both["spectrum/twist_synchronous"][0]).max() < 1e-10


STOP = "    - spring: {between: [a, ground], along: twist, gap_angle: 0.3 deg, stiffness: 5000}\n"


def test_branch_with_a_stop():
    """A branch of motions against a stop has the least and largest twist of SciPy's periodic motion."""
    study = """  branch: {parameter: n, from: 85 rad/s, to: 95 rad/s, points: 3}
  integrate: {method: dop853, rtol: 1e-11, atol: 1e-14}
"""
    table = run(MACHINE.replace("study:\n", STOP + "study:\n"), study)["branch"]
    gap = np.radians(0.3)
    for i in (0, table["trace/twist"].shape[0] - 1):
        n = table["trace/parameter"][i].ravel()[0] if "trace/parameter" in table else table.values[i]

        def slopes(t, y):
            stop = 5000 * (abs(y[0]) - gap) * np.sign(y[0]) if abs(y[0]) > gap else 0.0
            torque = STEADY + TORQUE * np.cos(n * t + PHASE)
            return [y[1], (torque - DAMPING * y[1] - STIFFNESS * y[0] - stop) / POLAR]

        period = 2 * np.pi / n
        at = np.linspace(200 * period, 201 * period, 4001)
        w = solve_ivp(slopes, (0, at[-1]), [1e-3, 0], "DOP853", at, rtol=1e-11, atol=1e-14, max_step=period / 100).y[0]
        assert np.abs(w).max() > gap
        least, largest = table["trace/twist"][i, 0]
        assert abs(least - w.min()) < 1e-4 * np.ptp(w) and abs(largest - w.max()) < 1e-4 * np.ptp(w)


TRAIN = """
whirl: 1
title: A train whose stations also move along x and y
rotor:
  speed: 150 rad/s
  length_scale: 1 mm
  stations:
    motor: {mass: 30 kg, damping: 900 N.s/m, eccentricity: ECCENTRICITY, polar: 0.1 kg.m2, moves: all}
    fan:   {mass: 50 kg, damping: 900 N.s/m, polar: 0.4 kg.m2, moves: all}
  elements:
    - spring:       {between: [motor, ground], stiffness: 1e6 N/m}
    - spring:       {between: [fan, ground], stiffness: 1e6 N/m}
    - coupling:     {between: [motor, fan], twist: 900 N.m/rad, twist_damping: 0.4 N.m.s/rad}
    - drive:        {at: motor, torque: 60 N.m, no_load_speed: 150 rad/s, load_at: fan, load_quadratic: 0.001 N.m.s2}
    - timed_torque: {at: fan, times: [0 s, 0.4 s, 0.41 s, 9 s], torques: [0 N.m, 0 N.m, -12 N.m, -12 N.m]}
study:
  runup: {duration: 1.5 s, rows: 40, rtol: 1e-11, orbits: 6, waveform: 6, spectra: 20, spectrum_turns: 2EVENTS}
"""


def train(t, y):
    """Slopes of the angles and speeds of motor and fan."""
    carried = 900 * (y[0] - y[1]) + 0.4 * (y[2] - y[3])
    at = np.clip((t - 0.4) / 0.01, 0, 1)
    load = 0.001 * y[3] ** 2 + 12 * (3 - 2 * at) * at**2  # monotone cubics between the rows
    return [y[2], y[3], (60 * (1 - y[2] / 150) - carried) / 0.1, (carried - load) / 0.4]


def test_start_of_a_train():
    """Twists are relative to the mean turn, weighted by inertia; extremes are located."""
    table = run(TRAIN, "", eccentricity="0 um", events="")["runup"]
    motion = [
        solve_ivp(train, span, start, "DOP853", dense_output=True, rtol=1e-12, atol=1e-14, max_step=1e-3)
        for span, start in (((0, 0.4), np.zeros(4)),)
    ]
    motion.append(
        solve_ivp(train, (0.4, 0.41), motion[0].y[:, -1], "DOP853", dense_output=True, rtol=1e-12, atol=1e-14)
    )
    motion.append(
        solve_ivp(
            train, (0.41, 1.5), motion[1].y[:, -1], "DOP853", dense_output=True, rtol=1e-12, atol=1e-14, max_step=1e-3
        )
    )

    def twist(t):
        t = np.atleast_1d(t)
        y = np.where(t < 0.4, motion[0].sol(np.minimum(t, 0.4)), motion[1].sol(np.clip(t, 0.4, 0.41)))
        y = np.where(t > 0.41, motion[2].sol(np.maximum(t, 0.41)), y)
        mean = (0.1 * y[0] + 0.4 * y[1]) / 0.5
        return np.array([y[0] - mean, y[1] - mean])

    t = np.linspace(0, 1.5, 300001)
    w = twist(t)
    for station in range(2):
        size = np.ptp(w[station])
        assert size > 1e-3
        for side, k in enumerate((w[station].argmin(), w[station].argmax())):
            fine = np.linspace(t[max(k - 1, 0)], t[min(k + 1, len(t) - 1)], 4001)
            wave = twist(fine)[station]
            best = wave.argmax() if side else wave.argmin()
            assert abs(table["runup/twist_extreme"][0, station, side] - wave[best]) < 1e-7 * size
            if fine[best] > 0:
                assert abs(table["runup/twist_time"][0, station, side] - fine[best]) < 1e-5
        assert abs(table["runup/twist_place"][0, station] - w[station, -1]) < 1e-7 * size
        rows = np.isfinite(table["runup/twist"][0, station, :, 0])
        mean, least, largest = table["runup/twist"][0, station, rows].T
        assert (least <= mean).all() and (mean <= largest).all()
        times, wave = table["runup/waveform_time"][0, station], table["runup/twist_waveform"][0, station]
        there = np.isfinite(times) & np.isfinite(wave)
        if there.any():
            assert np.abs(wave[there] - twist(times[there])[station]).max() < 1e-4 * size
    # Both twists hold no angular momentum.
    orbits = table["runup/twist_orbit"][0]
    assert np.nanmax(np.abs(0.1 * orbits[0] + 0.4 * orbits[1])) < 1e-10


def test_events_by_twist():
    """An event happens when the twist of a station passes a value."""
    events = ", events: [{name: t, when: = motor_twist > 0.02, end: yes}]"
    table = run(TRAIN, "", eccentricity="0 um", events=events)["runup"]
    sol = solve_ivp(
        train, (0, 0.3), np.zeros(4), "DOP853", dense_output=True, rtol=1e-12, atol=1e-14, max_step=1e-4
    ).sol

    def over(t):
        y = sol(t)
        return y[0] - (0.1 * y[0] + 0.4 * y[1]) / 0.5 - 0.02

    t = np.linspace(0, 0.3, 30001)
    k = np.argmax(over(t) > 0)
    low, high = t[k - 1], t[k]
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if over(middle) < 0 else (low, middle)
    assert abs(table["runup/end_time"].ravel()[0] - low) < 1e-8


def test_derivatives_of_twists():
    """Derivatives of twists are those of the closed form."""
    study = """  sweep: {parameter: n, values: [90 rad/s]}
  integrate: {method: dop853, transient: 160, record: 32, rtol: 1e-11, atol: 1e-14}
  analyze: [orbit, spectrum, regime]
  sensitivity: {parameters: [n], of: [{field: orbit/twist, column: largest, at: a},
                {field: spectrum/twist_synchronous, at: a}, {field: spectrum/twist_lag, at: a}]}
"""
    try:
        table = run(MACHINE, study)["sweep"]
    except whirl.Error as error:
        pytest.fail(str(error))
    w, h = 90.0, 1e-4
    size = (abs(response(w + h)) - abs(response(w - h))) / (2 * h)
    lag = -np.degrees(np.angle(response(w + h) / response(w - h))) / (2 * h)
    slopes = table["sensitivity/slopes"][0].reshape(-1, 2)[:, 0]
    assert np.allclose(slopes, [size, size, lag], rtol=1e-5)


def test_usual_numbers_of_tolerances(tmp_path):
    """Without a choice, tolerances show the twists of stations that twist, and of no others."""
    text = MACHINE.replace("{n: 95 rad/s}", "{n: 95 rad/s, k: 2000}").replace("stiffness: 2000", "stiffness: = k")
    study = SWEEP + "  tolerances: {samples: 64, parameters: {k: 2000 +- 5 %}}\n"
    made = tmp_path / "spread.h5"
    run(text, study, method="dop853").save(made)
    shown = subprocess.run([COMMAND, "show", made], capture_output=True, check=True, text=True).stdout
    assert "Spread of largest twist at a" in shown and "twist at b" not in shown


def test_documents(tmp_path):
    """The command shows twists in summaries, JSON and figures."""
    sweep = tmp_path / "sweep.h5"
    run(MACHINE, SWEEP, method="dop853").save(sweep)
    full = json.loads(subprocess.run([COMMAND, "show", "--json", sweep], capture_output=True, check=True).stdout)
    assert abs(full["points"][0]["stations"]["a"]["twist"][0] - STEADY / STIFFNESS) < 1e-9
    z = response(80.0)
    part = full["points"][0]["synchronous"]["a"]["twist"]
    assert abs(part["amplitude"] - abs(z)) < 1e-8 * abs(z) and abs(part["lag"] - lag_of(z)) < 1e-6
    assert full["points"][0]["synchronous"]["b"]["twist"]["amplitude"] is None
    assert abs(full["points"][0]["twist_spectrum"]["a"][0]["order"] - 1) < 1e-6
    subprocess.run([COMMAND, "figure", sweep, "@#1:a", "-o", tmp_path / "point.json"], check=True, capture_output=True)
    panels = {panel["name"]: panel for panel in json.loads((tmp_path / "point.json").read_text())["panels"]}
    wave = np.radians(panels["twist"]["series"][0]["y"])
    assert abs(np.ptp(wave) - 2 * abs(response(90.0))) < 1e-3 * np.ptp(wave)
    runs = tmp_path / "run.h5"
    run(TRAIN, "", eccentricity="20 um", events="").save(runs)
    shown = subprocess.run([COMMAND, "show", runs], capture_output=True, check=True, text=True).stdout
    assert "Twists in a run:" in shown and "largest twist: " in shown
    listed = subprocess.run([COMMAND, "figure", runs, "--list"], capture_output=True, check=True, text=True).stdout
    names = [line.split()[0] for line in listed.splitlines()]
    for name in ("twist", "twist-waterfall", "twist-cascade", "twist-spectrogram"):
        assert f"runup-{name}-fan" in names
        subprocess.run([COMMAND, "figure", runs, f"runup-{name}-fan", "-o", tmp_path / f"{name}.json"], check=True)
    for name in ("turn", "waveform"):
        made = tmp_path / f"{name}.json"
        subprocess.run([COMMAND, "figure", runs, f"runup-{name}-motor", "-o", made], check=True, capture_output=True)
        assert "twist" in [panel["name"] for panel in json.loads(made.read_text())["panels"]]
