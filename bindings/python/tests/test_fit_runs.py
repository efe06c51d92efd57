"""Tests that fits of run-ups recover the parameters of a rotor that SciPy integrates, and fits of its steady motions
do not."""

import numpy as np
import pytest

import whirl

integrate = pytest.importorskip("scipy.integrate")

FAN = {
    "parameters": {"k": "1.1 MN/m", "c": "250 N s/m", "e": "25 um", "spot": "0.3 rad", "rate": "60 rad/s2"},
    "rotor": {
        "speed": "1000 rpm",
        "length_scale": "1 mm",
        "stations": {
            "disc": {"mass": "30 kg", "damping": "= c", "eccentricity": "= e", "eccentricity_angle": "= spot"}
        },
        "elements": [{"shaft": {"between": ["disc", "ground"], "k1": "= k"}}],
    },
    "study": {"response": {}},
}
TRUTH = {"k": 1.2e6, "c": 300.0, "e": 30e-6, "spot": 0.5}
UNKNOWN = {"k": (0.6e6, 2e6), "c": (50, 2000), "e": (0, 1e-4), "spot": (-3.2, 3.2)}
RUN = {"speed_from": "100 rad/s", "speed_to": "320 rad/s", "rate": "= rate", "begin": "centre"}


def turns(first=100.0, last=320.0, rate=60.0, every=4):
    """Returns times, speeds and orders of x and y over turns of the run, by DOP853 and Gauss's rule."""
    k, c, e, spot = TRUTH.values()

    def slope(t, s):
        w, angle = first + rate * t, first * t + 0.5 * rate * t * t + spot
        force = e * (w * w - 1j * rate) * np.exp(1j * angle)
        return [s[1], force.real - (c * s[1] + k * s[0]) / 30, s[3], force.imag - (c * s[3] + k * s[2]) / 30]

    end = (last - first) / rate
    motion = integrate.solve_ivp(slope, [0, end], np.zeros(4), "DOP853", rtol=1e-12, atol=1e-18, dense_output=True)
    count = int((first + 0.5 * rate * end) * end / (2 * np.pi))
    nodes, weights = np.polynomial.legendre.leggauss(48)

    def time(turn):
        return (np.sqrt(first**2 + 4 * np.pi * rate * turn) - first) / rate

    rows = []
    for n in range(8, count, every):
        at = n + 0.5 * (nodes + 1)
        back = weights * np.exp(-2j * np.pi * at)
        x, _, y, _ = motion.sol(time(at))
        begin, after = time(n), time(n + 1)
        rows.append([0.5 * (begin + after), 2 * np.pi / (after - begin), back @ x, back @ y])
    return np.array(rows).T


def table(x, y, **axis):
    columns = {name.replace("_", " ") + (" [s]" if name == "time" else " [rad/s]"): a.real for name, a in axis.items()}
    for name, part in (("x", x), ("y", y)):
        columns |= {f"disc {name} [m]": abs(part), f"disc {name} lag [rad]": -np.angle(part)}
    return columns


def test_a_run_up_gives_the_parameters_and_steady_motions_do_not():
    _, speed, x, y = turns()
    data = table(x, y, speed=speed)
    found = whirl.fit(FAN, data, UNKNOWN, noise="2 um", runup=RUN)
    for name, value in TRUTH.items():
        assert found[name].value == pytest.approx(value, rel=1e-7)
        assert found[name].known == "determined"
    steady = whirl.fit(FAN, data, UNKNOWN, noise="2 um")
    assert steady.deviation > 10  # times the noise
    assert abs(steady["k"].value / TRUTH["k"] - 1) > 0.05
    assert abs(steady["c"].value / TRUTH["c"] - 1) > 0.2
    assert any("rows of the measured tables are compared" in str(one) for one in found.result.statements())
    assert [name for name in found.result.figures() if name.startswith("fit")] == ["fit-1"]


def test_a_coast_down_over_the_time_gives_its_rate_too():
    when, _, x, y = turns(first=320.0, last=100.0, rate=-80.0)
    down = {"speed_from": "320 rad/s", "speed_to": "100 rad/s", "rate": "= rate", "begin": "centre"}
    found = whirl.fit(FAN, table(x, y, time=when), UNKNOWN | {"rate": (40, 120)}, noise="2 um", runup=down)
    for name, value in (TRUTH | {"rate": 80.0}).items():
        assert found[name].value == pytest.approx(value, rel=1e-7)


def test_raw_signals_of_a_run_up_are_tracked_and_fitted():
    """Tests signals at 10 kHz with the times of the mark: tracking them turn by turn gives the parameters to 1e-4."""
    first, rate = 100.0, 60.0
    k, c, e, spot = TRUTH.values()

    def slope(t, s):
        w, angle = first + rate * t, first * t + 0.5 * rate * t * t + spot
        force = e * (w * w - 1j * rate) * np.exp(1j * angle)
        return [s[1], force.real - (c * s[1] + k * s[0]) / 30, s[3], force.imag - (c * s[3] + k * s[2]) / 30]

    time = np.arange(0.0, 3.6, 1e-4)
    x, _, y, _ = integrate.solve_ivp(slope, [0, 3.6], np.zeros(4), "DOP853", time, rtol=1e-11, atol=1e-16).y
    marks = (np.sqrt(first**2 + 4 * np.pi * rate * np.arange(119)) - first) / rate
    tracked = whirl.signals.bode(time, 1e6 * x, 1e6 * y, pulses=marks, names=["disc x", "disc y"])
    data = {name: column[8::4] for name, column in tracked.columns("um").items()}
    found = whirl.fit(FAN, data, UNKNOWN, noise="2 um", runup=RUN)
    for name, value in TRUTH.items():
        assert found[name].value == pytest.approx(value, rel=1e-4)
    data = {name: column[8::4] for name, column in tracked.columns("um", over="time").items()}
    assert whirl.fit(FAN, data, UNKNOWN, noise="2 um", runup=RUN)["k"].value == pytest.approx(TRUTH["k"], rel=1e-4)
    with pytest.raises(whirl.BadInput, match="expected 'speed' or 'time'"):
        tracked.columns(over="angle")
    # The displacements themselves, of a record that begins 0.2 s before the run.
    raw = {"time [s]": 0.2 + time[::40], "disc x [m]": x[::40], "disc y [m]": y[::40]}
    found = whirl.fit(FAN, raw, UNKNOWN, noise="2 um", runup=RUN, compare="waveform", delay=0.2)
    for name, value in TRUTH.items():
        assert found[name].value == pytest.approx(value, rel=1e-7)
    assert any("1800 displacements of 1 run are compared" in str(one) for one in found.result.statements())


def test_rows_that_a_run_does_not_have_are_refused():
    _, speed, x, y = turns()
    data = table(x, y, speed=speed)
    with pytest.raises(whirl.BadInput, match="is 104.* rad/s|speed is .* expected one of the run, 150 to 320 rad/s"):
        whirl.fit(FAN, data, UNKNOWN, runup=RUN | {"speed_from": "150 rad/s"})
    with pytest.raises(whirl.BadInput, match="nothing turns the shaft of the run"):
        whirl.fit(FAN, data, UNKNOWN, runup={"speed_from": "100 rad/s", "speed_to": "320 rad/s"})
    angles = {"angle [deg]": [0.0, 90.0], "disc x [um]": [1.0, 2.0]}
    with pytest.raises(whirl.BadInput, match="is no column of a run, expected speed or time"):
        whirl.fit(FAN, angles, ["k"], runup=RUN)
    late = table(x, y, time=np.linspace(1, 9, len(x)))
    with pytest.raises(whirl.BadInput, match="is outside of its run, which lasts from 0 to 3.666666667 s"):
        whirl.fit(FAN, late, UNKNOWN, runup=RUN)
