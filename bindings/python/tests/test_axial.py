"""Tests axial displacements of motions in time against closed forms and SciPy."""

import json
import subprocess

import numpy as np
import pytest
from conftest import COMMAND, filled, lag_of

import whirl

solve_ivp = pytest.importorskip("scipy.integrate").solve_ivp

MASS, STIFFNESS, DAMPING, FORCE, THRUST, PHASE = 10.0, 1e5, 100.0, 40.0, 10.0, np.radians(20)

MACHINE = """
whirl: 1
title: A mass on a thrust bearing
parameters: {n: 95 rad/s}
rotor:
  speed: SPEED
  length_scale: 1 mm
  stations:
    a: {mass: 10 kg, damping: 200 N.s/m, eccentricity: 10 um, axial: yes}
    b: {mass: 12 kg, damping: 200 N.s/m}
  elements:
    - spring: {between: [a, ground], stiffness: 1e6 N/m}
    - spring: {between: [b, ground], stiffness: 1e6 N/m}
    - spring: {between: [a, ground], along: axial, stiffness: 1e5 N/m, damping: 100 N.s/m}
    - force:  {at: a, axial: 40 N, steady_axial: 10 N, phase: 20 deg}
MORE
study:
"""

SWEEP = """  sweep: {parameter: n, from: 80 rad/s, to: 120 rad/s, points: 5}
  integrate: {method: METHOD, transient: 160, record: 32, rtol: 1e-11, atol: 1e-14, steps_per_revolution: 1024}
  keep: {waveform: 2, highest_order: 3}
  analyze: [orbit, spectrum, waveform, regime]
"""

# Stations of a helical pair on thrust bearings.
GEARS = """
whirl: 1
title: A helical pair
parameters: {n: 100 rad/s}
rotor:
  speed: SPEED
  length_scale: 1 mm
  ROTATION
  stations:
    one: {mass: 10 kg, polar: 0.05 kg.m2, moves: twist, axial: yes}
    two: {mass: 20 kg, polar: 0.2 kg.m2, moves: twist, axial: yes}
  elements:
    - gear:   {between: [one, two], base_radii: [100 mm, 150 mm], stiffness: 4e6 N/m, damping: 300 N.s/m, helix: HELIX,
               backlash: BACKLASH}
    - spring: {between: [one, ground], along: axial, stiffness: 5e6 N/m, damping: 400 N.s/m}
    - spring: {between: [two, ground], along: axial, stiffness: 7e6 N/m, damping: 400 N.s/m}
MORE
study:
"""


def case(text, study, more="", speed="= n", **words):
    text = text.replace("MORE\n", more and more + "\n") + study
    return filled(text, "axial.yaml", speed=speed, **words)


def run(*of, **words):
    return whirl.run(case(*of, **words), progress=False)


def response(n, order=1.0):
    """Returns the complex amplitude of the mass under the harmonic force, m."""
    w = order * n
    return FORCE * np.exp(1j * PHASE) / (STIFFNESS - MASS * w**2 + 1j * DAMPING * w)


@pytest.mark.parametrize("method", ["rk4", "dop853", "rodas5p"])
def test_harmonic_thrust(method):
    table = run(MACHINE, SWEEP, method=method)["sweep"]
    expected = response(table.values)
    at = 2 * np.pi * np.arange(1, 1 + table["waveform/axial"].shape[2]) / table["waveform/axial"].shape[2] * 2
    for i, z in enumerate(expected):
        mean, least, largest = 1e-3 * table["orbit/axial"][i, 0]
        assert abs(mean - THRUST / STIFFNESS) < 1e-8 * abs(z)
        # Bounds are those at 1024 instants of a revolution, or more.
        assert 0 <= THRUST / STIFFNESS + abs(z) - largest < 1e-5 * abs(z)
        assert 0 <= least - THRUST / STIFFNESS + abs(z) < 1e-5 * abs(z)
        assert abs(1e-3 * table["spectrum/axial_synchronous"][i, 0] - abs(z)) < 1e-8 * abs(z)
        assert abs(table["spectrum/axial_lag"][i, 0] - lag_of(z)) < 1e-6
        order, amplitude = table["spectrum/axial_lines"][i, 0, 0]
        assert abs(order - 1) < 1e-6 and abs(1e-3 * amplitude - abs(z)) < 1e-6 * abs(z)
        wave = THRUST / STIFFNESS + np.real(z * np.exp(1j * at))
        assert np.abs(1e-3 * table["waveform/axial"][i, 0] - wave).max() < 1e-8 * abs(z)
    for field in table:
        if "axial" in field:
            assert np.isnan(table[field][:, 1]).all(), field  # b does not move along its shaft


def test_other_order():
    more = "    - force: {at: a, axial: 40 N, ratio: 1.5, phase: 20 deg}"
    table = run(MACHINE, SWEEP, more=more, method="dop853")["sweep"]
    for i, n in enumerate(table.values):
        lines = {round(order, 3): 1e-3 * size for order, size in table["spectrum/axial_lines"][i, 0, :2]}
        for order in (1.0, 1.5):
            z = response(n, order)
            assert abs(lines[order] - abs(z)) < 1e-6 * abs(z)


def test_lateral_motion_is_the_same():
    """The same machine without axial motion has the same lateral motion, and no field of axial displacements."""
    table = run(MACHINE, SWEEP, method="rk4")["sweep"]
    text = MACHINE.replace(", axial: yes", "")
    text = "\n".join(line for line in text.split("\n") if "along: axial" not in line and "steady_axial" not in line)
    lateral = run(text, SWEEP, method="rk4")["sweep"]
    assert not any("axial" in field for field in lateral)
    for field in ("orbit/max_radius", "orbit/mean", "spectrum/synchronous", "spectrum/lines", "waveform/samples"):
        assert np.nanmax(np.abs(lateral[field] - table[field])) < 1e-12, field


def test_unit_of_length():
    """The scale of length changes no axial displacement."""
    tables = [run(text, SWEEP, method="dop853")["sweep"] for text in (MACHINE, MACHINE.replace("1 mm", "40 um"))]
    for field in ("orbit/axial", "waveform/axial", "spectrum/axial_synchronous", "spectrum/axial_lag"):
        one, other = (table.si(field)[0][:, 0] for table in tables)
        assert np.allclose(one, other, rtol=1e-8, atol=1e-8 * np.abs(one).max()), field


GEAR_SWEEP = """  sweep: {parameter: n, from: 150 rad/s, to: 260 rad/s, points: 2}
  initial: {one: {x: 1}}
  integrate: {method: dop853, transient: 60, record: 16, rtol: 1e-11, atol: 1e-13}
  keep: {waveform: 2}
  analyze: [orbit, spectrum, waveform, regime]
"""
LOADS = """    - force:  {at: one, torque: TORQUE, steady_torque: 200 N.m}
    - spring: {between: [two, ground], along: twist, stiffness: 2e4, damping: 60}"""


def pair(beta, backlash, torque, y, stays=0.0, damped=0.0):
    """Slopes of a helical pair: angles, axial displacements and their rates."""
    t1, t2, w1, w2, v1, v2, u1, u2 = y
    c, s, r1, r2 = np.cos(beta), np.sin(beta), 0.1, 0.15
    closing = c * (r1 * t1 + r2 * t2) + s * (w1 - w2)
    rate = c * (r1 * v1 + r2 * v2) + s * (u1 - u2)
    half = 0.5 * backlash
    touches = closing > half or closing < -half or backlash == 0
    mesh = 4e6 * (closing - half * np.sign(closing)) + 300 * rate if touches else 0.0
    return [
        v1,
        v2,
        u1,
        u2,
        (torque - c * r1 * mesh) / 0.05,
        (-c * r2 * mesh - stays * t2 - damped * v2) / 0.2,
        (-s * mesh - 5e6 * w1 - 400 * u1) / 10,
        (s * mesh - 7e6 * w2 - 400 * u2) / 20,
    ]


@pytest.mark.parametrize("backlash", [0.0, 1e-4])
def test_helical_pair(backlash):
    """A helical mesh under a harmonic torque pushes both gears along their shafts."""
    harmonic = 300.0 if backlash else 100.0  # with 300 N m the teeth part
    words = {"helix": "25 deg", "backlash": f"{backlash} m", "rotation": "", "torque": f"{harmonic} N.m"}
    text = GEARS if backlash else GEARS.replace(",\n               backlash: BACKLASH", "")
    table = run(text, GEAR_SWEEP, more=LOADS, **words)["sweep"]
    for i, n in enumerate(table.values):

        def slopes(t, y):
            return pair(np.radians(25), backlash, 200 + harmonic * np.cos(n * t), y, 2e4, 60)

        samples, finer, period = table["waveform/axial"].shape[2] // 2, 32, 2 * np.pi / n
        at = period * (60 + np.arange(1, finer * samples + 1) / samples / finer)
        start = [1e-3, 0, 0, 0, 0, 0, 0, 0]
        motion = solve_ivp(slopes, (0, at[-1]), start, "DOP853", at, rtol=1e-10, atol=1e-14, max_step=0.1 / n).y
        parts = np.abs(np.cos(np.radians(25)) * (0.1 * motion[0] + 0.15 * motion[1])).min() < 0.5 * backlash
        assert parts == (backlash > 0)
        for station in range(2):
            wave = motion[2 + station]
            size = np.ptp(wave)
            assert size > 1e-6 and table.verdicts[i] == "P-1"
            for turn in range(2):
                own = 1e-3 * table["waveform/axial"][i, station, turn * samples : (turn + 1) * samples]
                assert np.abs(own - wave[finer - 1 :: finer]).max() < 1e-8 * size
            mean, least, largest = 1e-3 * table["orbit/axial"][i, station]
            assert abs(mean - wave.mean()) < 2e-6 * size
            assert abs(least - wave.min()) < 2e-5 * size and abs(largest - wave.max()) < 2e-5 * size


def test_mirrored_rotation():
    """A pair that turns the other way, with gears of the other hand, presses the same way."""
    up = {"helix": "25 deg", "backlash": "0.1 mm", "torque": "100 N.m", "rotation": ""}
    down = {**up, "helix": "-25 deg", "rotation": "rotation: clockwise"}
    one, other = (run(GEARS, GEAR_SWEEP, more=LOADS, **words)["sweep"] for words in (up, down))
    for field in ("orbit/axial", "waveform/axial", "spectrum/axial_synchronous", "spectrum/axial_lag"):
        size = np.abs(one[field]).max()
        assert np.abs(one[field] - other[field]).max() < 1e-7 * size, field
    same = run(GEARS, GEAR_SWEEP, more=LOADS, **{**up, "helix": "-25 deg"})["sweep"]
    assert np.allclose(same["orbit/axial"], -one["orbit/axial"][:, :, [0, 2, 1]], rtol=1e-6)


STOP = "    - spring: {between: [a, ground], along: axial, stiffness: 4e5 N/m, gap: 0.5 mm}"


def stopped(n, t, y):
    """Slopes of the mass with a stop to either side."""
    stop = 4e5 * (abs(y[0]) - 5e-4) * np.sign(y[0]) if abs(y[0]) > 5e-4 else 0.0
    force = THRUST + FORCE * np.cos(n * t + PHASE)
    return [y[1], (force - DAMPING * y[1] - STIFFNESS * y[0] - stop) / MASS]


def test_branch_with_a_stop():
    study = "  branch: {parameter: n, from: 60 rad/s, to: 90 rad/s, points: 12}\n"
    branch = run(MACHINE, study, more=STOP)["branch"]
    seen = 0
    for i in range(0, len(branch.values), 3):
        n = branch.values[i]
        start = 60 * 2 * np.pi / n
        at = np.linspace(start, start + 2 * np.pi / n, 4001)
        y = solve_ivp(lambda t, y: stopped(n, t, y), (0, at[-1]), [0, 0], "DOP853", at, rtol=1e-10, atol=1e-14).y[0]
        if np.isnan(branch["trace/axial"][i, 0, 0]) or branch["trace/unstable"][i] > 0:
            continue
        seen += 1
        least, largest = 1e-3 * branch["trace/axial"][i, 0]
        assert abs(least - y.min()) < 2e-4 * np.ptp(y) and abs(largest - y.max()) < 2e-4 * np.ptp(y)
        assert np.isnan(branch["trace/axial"][i, 1]).all()
    assert seen > 2


RUN = "  runup: {speed_from: FIRST, speed_to: LAST, rate: 20 rad/s2, rows: 60, rtol: 1e-11, waveform: 2, orbits: 5}\n"


@pytest.mark.parametrize("law", ["up", "down", "stop"])
def test_through_an_axial_resonance(law):
    n0, n1 = (150.0, 50.0) if law == "down" else (50.0, 150.0)
    rate, more = np.sign(n1 - n0) * 20.0, STOP if law == "stop" else ""
    end = abs(n1 - n0) / 20.0
    words = {"first": f"{n0} rad/s", "last": f"{n1} rad/s", "speed": "100 rad/s"}
    table = run(MACHINE, RUN, more=more, **words)["runup"]

    def angle(t):
        return n0 * t + 0.5 * rate * t**2

    def slopes(t, y):
        stop = 4e5 * (abs(y[0]) - 5e-4) * np.sign(y[0]) if law == "stop" and abs(y[0]) > 5e-4 else 0.0
        force = THRUST + FORCE * np.cos(angle(t) + PHASE)
        return [y[1], (force - DAMPING * y[1] - STIFFNESS * y[0] - stop) / MASS]

    motion = solve_ivp(
        slopes, (0, end), [THRUST / STIFFNESS, 0], "DOP853", dense_output=True, rtol=1e-12, atol=1e-15, max_step=1e-3
    ).sol
    size = np.abs(table["runup/axial_extreme"][0, 0]).max() * 1e-3
    # Extremes are located: places, times and speeds.
    t = np.linspace(0, end, 400001)
    w = motion(t)[0]
    for side, k in enumerate((w.argmin(), w.argmax())):
        fine = np.linspace(t[k - 1], t[k + 1], 20001)
        wave = motion(fine)[0]
        best = wave.argmax() if side else wave.argmin()
        assert abs(1e-3 * table["runup/axial_extreme"][0, 0, side] - wave[best]) < 1e-9 * size
        assert abs(table["runup/axial_time"][0, 0, side] - fine[best]) < 2e-6
        assert abs(table["runup/axial_speed"][0, 0, side] - n0 - rate * fine[best]) < 1e-4
    assert abs(1e-3 * table["runup/axial_place"][0, 0] - w[-1]) < 1e-9 * size
    # Means and orders are integrals over single turns, by the angle.
    nodes, weights = np.polynomial.legendre.leggauss(400)
    for row in range(0, 60, 7):
        turns = table["runup/turns"][0, row]
        if not np.isfinite(turns):
            continue
        theta = 2 * np.pi * (turns - 1 + 0.5 * (1 + nodes))
        times = (np.sqrt(n0**2 + 2 * rate * theta) - n0) / rate
        wave = motion(times)[0]
        mean, least, largest = 1e-3 * table["runup/axial"][0, 0, row]
        assert abs(mean - 0.5 * np.sum(weights * wave)) < 1e-6 * size
        assert least <= wave.min() + 1e-3 * size and largest >= wave.max() - 1e-3 * size
        for order in range(1, 5):
            z = np.sum(weights * wave * np.exp(-1j * order * theta))
            assert abs(1e-3 * table["runup/axial_amplitude"][0, 0, row, order - 1] - abs(z)) < 1e-6 * size
            if abs(z) > 1e-3 * size:
                apart = table["runup/axial_lag"][0, 0, row, order - 1] - lag_of(z)
                assert abs((apart + 180) % 360 - 180) < 1e-3 * size / abs(z)
    # Samples of waveforms and orbits.
    times, wave = table["runup/waveform_time"][0, 0], 1e-3 * table["runup/axial_waveform"][0, 0]
    there = np.isfinite(times)
    assert there.any() and np.abs(wave[there] - motion(times[there])[0]).max() < 1e-6 * size
    samples = table["runup/axial_orbit"].shape[2] // 5
    for k in range(5):
        if not np.isfinite(table["runup/orbit_time"][0, k]):
            continue
        wave = 1e-3 * table["runup/axial_orbit"][0, 0, k * samples : (k + 1) * samples]
        turn = np.round(angle(table["runup/orbit_time"][0, k]) / 2 / np.pi - 0.5)
        theta = 2 * np.pi * (turn + np.arange(samples) / samples)
        assert np.abs(wave - motion((np.sqrt(n0**2 + 2 * rate * theta) - n0) / rate)[0]).max() < 1e-6 * size
    for field in table:
        if "axial" in field:
            assert np.isnan(table[field][:, 1]).all(), field


def test_helical_pair_starts():
    """A motor starts a helical pair; the mesh pushes the gears along their shafts."""
    more = "    - drive: {at: one, torque: 300 N.m, load_at: two, load_quadratic: 0.01 N.m.s2}"
    words = {"helix": "25 deg", "backlash": "0.1 mm", "rotation": ""}
    study = "  runup: {duration: 0.1 s, speed_to: 1000 rad/s, rows: 100, rtol: 1e-11}\n"
    table = run(GEARS, study, more=more, speed="200 rad/s", **words)["runup"]

    def slopes(t, y):
        out = pair(np.radians(25), 1e-4, 300.0, y)
        out[5] += 0.01 * y[5] ** 2 / 0.2  # the wheel turns backwards, and its load brakes it
        return out

    at = np.linspace(0, 0.1, 40001)
    motion = solve_ivp(slopes, (0, 0.1), np.zeros(8), "DOP853", at, rtol=1e-11, atol=1e-15, max_step=2e-5).y
    for station in range(2):
        w = motion[2 + station]
        size = np.ptp(w)
        assert size > 1e-6
        for side, k in enumerate((w.argmin(), w.argmax())):
            assert abs(1e-3 * table["runup/axial_extreme"][0, station, side] - w[k]) < 2e-6 * size
            if abs(w[k]) > 0.1 * size:
                assert abs(table["runup/axial_time"][0, station, side] - at[k]) < 1e-5
        assert abs(1e-3 * table["runup/axial_place"][0, station] - w[-1]) < 1e-9 * size


def test_documents(tmp_path):
    """The command shows axial displacements in summaries, JSON, CSV and figures."""
    sweep = tmp_path / "sweep.h5"
    run(MACHINE, SWEEP, method="dop853").save(sweep)
    full = json.loads(subprocess.run([COMMAND, "show", "--json", sweep], capture_output=True, check=True).stdout)
    assert abs(full["points"][0]["stations"]["a"]["axial"][0] - 0.1) < 1e-6
    z = response(80.0)
    part = full["points"][0]["synchronous"]["a"]["axial"]
    assert abs(1e-3 * part["amplitude"] - abs(z)) < 1e-8 * abs(z) and abs(part["lag"] - lag_of(z)) < 1e-6
    assert full["points"][0]["synchronous"]["b"]["axial"]["amplitude"] is None
    assert abs(full["points"][0]["axial_spectrum"]["a"][0]["order"] - 1) < 1e-6
    subprocess.run([COMMAND, "figure", sweep, "@#1:a", "-o", tmp_path / "point.json"], check=True, capture_output=True)
    panels = {panel["name"]: panel for panel in json.loads((tmp_path / "point.json").read_text())["panels"]}
    wave = np.array(panels["axial"]["series"][0]["y"])
    assert abs(np.ptp(wave) - 2e3 * abs(response(90.0))) < 1e-3 * np.ptp(wave)
    runs = tmp_path / "run.h5"
    study = RUN.replace("orbits: 5", "orbits: 5, spectra: 40")
    run(MACHINE, study, first="50 rad/s", last="150 rad/s", speed="100 rad/s").save(runs)
    shown = subprocess.run([COMMAND, "show", runs], capture_output=True, check=True, text=True).stdout
    assert "Axial displacements in a run:" in shown
    listed = subprocess.run([COMMAND, "figure", runs, "--list"], capture_output=True, check=True, text=True).stdout
    names = [line.split()[0] for line in listed.splitlines()]
    for name in ("axial", "axial-waterfall", "axial-cascade", "axial-spectrogram"):
        assert f"runup-{name}-a" in names and f"runup-{name}-b" not in names
    for name in ("turn", "waveform"):
        made = tmp_path / f"{name}.json"
        subprocess.run([COMMAND, "figure", runs, f"runup-{name}-a", "-o", made], check=True, capture_output=True)
        assert "axial" in [panel["name"] for panel in json.loads(made.read_text())["panels"]]
    subprocess.run([COMMAND, "export", sweep, "--csv", tmp_path / "csv"], check=True, capture_output=True)
    headings = (tmp_path / "csv/sweep.csv").read_text()
    assert "orbit/axial a mean [mm]" in headings and "spectrum/axial_lag a [deg]" in headings
    subprocess.run([COMMAND, "figure", runs, "runup-axial-a", "-o", tmp_path / "run.json"], check=True)
    panels = {panel["name"]: panel for panel in json.loads((tmp_path / "run.json").read_text())["panels"]}
    assert list(panels) == ["displacement", "amplitude", "lag"]
    assert [one["name"] for one in panels["displacement"]["series"]] == ["mean", "least", "largest"]
