"""Tests measured signals over time and speed: tracked orders, spectra of windows, fatigue."""

import numpy as np
import pytest

import whirl
from whirl import signals

plt = pytest.importorskip("matplotlib.pyplot")


@pytest.fixture(autouse=True)
def closed_figures():
    yield
    plt.close("all")


def run_up(rate=5000.0, seconds=2.0):
    """Returns a shaft from 30 to 40 turns a second: times, turns, and the times of whole turns."""
    time = np.arange(int(rate * seconds)) / rate
    return time, time * (30 + 2.5 * time), lambda turns: (-30 + np.sqrt(900 + 10 * turns)) / 5


# ---------------------------------------------------------------- orders over time


def two_orders():
    """Returns the run-up of tests/unit/analyze/test_vold_kalman.c: time, angle, signal."""
    time = np.arange(80) / 200
    angle = 2 * np.pi * (5 * time + 10 * time**2)
    line = 0.2 * np.cos(2 * np.pi * 17 * time)
    return time, angle, (1 + 0.5 * time) * np.cos(angle + 0.3) + 0.4 * np.cos(2 * angle - 1.1) + line


@pytest.mark.parametrize("poles", [1, 2])
def test_vold_kalman_solves_the_dense_equations(poles):
    """Tests that amplitudes are those of NumPy's least squares over all equations, without normal equations."""
    time, angle, values = two_orders()
    found = signals.vold_kalman(values, angle, [1, 2], rate=200.0, bandwidth=2.0, poles=poles)
    weight = np.sqrt((np.sqrt(2) - 1) / (2 * np.sin(np.pi * 2.0 / 400.0)) ** (2 * poles))
    assert signals.vold_kalman_weight(2.0, 200.0, poles) == pytest.approx(weight, rel=1e-14)
    smooth = weight * np.diff(np.eye(80), poles, axis=0)
    measured = np.hstack([np.diag(np.exp(1j * k * angle)) for k in (1, 2)])
    rows = np.vstack([np.kron(np.eye(2), smooth), measured])
    dense = np.linalg.lstsq(rows, np.append(np.zeros(len(rows) - 80), values), rcond=None)[0].reshape(2, 80)
    assert np.allclose(found.vectors, [2 * dense], rtol=0, atol=1e-10)
    assert np.allclose(found.amplitude * np.exp(-1j * np.radians(found.lag)), found.vectors)
    assert found.doubtful.shape == (2, 80) and found.doubtful.all()  # a record of 0.4 s, a band of 2 Hz


def test_vold_kalman_of_a_record_with_a_line_of_the_mains():
    """Tests amplitudes in a run-up in which the first order crosses a line of 35 Hz."""
    time, turns, time_of = run_up()
    angle, line = 2 * np.pi * turns, 2 * np.pi * 35.0 * time
    signal = 3.0 * np.cos(angle - 0.7) + np.cos(3 * angle) + 0.5 * np.cos(line) - 800.0  # -800: mean gap of the probe
    record = signals.Record(time, signal, pulses=time_of(np.arange(70)))
    found = record.vold_kalman([1, 3], bandwidth=2.0, phases=line)
    inside = ~found.doubtful.any(axis=0)
    assert found.time[0] == 0.0 and found.time[-1] <= record.pulses[-1] and inside.sum() > 4000
    expected = np.array([3.0 * np.exp(-0.7j), 1.0, 0.5])[:, None]
    assert np.abs(found.vectors[0][:, inside] - expected).max() < 1e-2
    alone = record.vold_kalman([1, 3], bandwidth=2.0)
    assert np.abs(alone.vectors[0, 0, inside] - expected[0]).max() > 0.2


def passage(angles=None):
    """Returns the arguments of the record of a shaft that runs up from 5 to 45 turns a second, at 1 turn/s2, through
    its resonance at 30 turns a second, with a runout of 4 at the probes; and a function that gives the vectors of the
    displacements x and y, without runout, at a speed in turns a second."""
    time = np.arange(int(1000 * 40)) / 1000
    turns, fast = 5 * time + 0.5 * time**2, 5 + time
    angle = 2 * np.pi * turns

    def vectors(speed):
        ratio = speed / 30
        response = 10 * np.exp(-0.5j) * ratio**2 / (1 - ratio**2 + 0.1j * ratio)
        return np.array([response, -0.8j * response])

    x, y = np.real(vectors(fast) * np.exp(1j * angle))
    stand = [0.0, 0.5 * np.pi] if angles is None else angles
    probes = [x * np.cos(at) + y * np.sin(at) + 4 * np.cos(angle - 2 - at) + 1 for at in stand]
    pulses = -5 + np.sqrt(25 + 2 * np.arange(int(turns[-1])))
    return (time, *probes), dict(pulses=pulses, angles=angles), vectors


@pytest.mark.parametrize("angles", [None, np.radians([45, 135]), np.radians([-30, 75])])
def test_tracked_orders_of_a_passage_with_slow_roll(angles):
    given, keys, vectors = passage(angles)
    slow = 6.0
    found = signals.bode(*given, **keys, slow_roll=2 * np.pi * slow)
    speed = found.speed / (2 * np.pi)
    x, y = vectors(speed) - vectors(np.array([slow]))
    largest = np.abs(vectors(30.0)).max()
    forward, backward = 0.5 * (x + 1j * y), 0.5 * (x - 1j * y)
    assert np.abs(found.forward[0] - forward).max() < 2e-3 * largest  # the speed changes within a turn
    assert np.abs(found.backward[0] - backward).max() < 2e-3 * largest
    assert np.allclose(found.time, speed - 5, rtol=0, atol=1e-3) and np.abs(found.mean - 1.0).max() < 2e-2 * largest
    runout = 4 * np.exp(-1j * (2 + (np.array([0, np.pi / 2]) if angles is None else angles)))
    raw = signals.bode(*given, **keys)
    assert np.allclose(raw.vectors, found.vectors + found.slow_roll[:, :, None], rtol=0, atol=1e-12)
    if angles is None:
        rolled = found.slow_roll[:, 0] - vectors(np.array([slow]))[:, 0]
        assert np.abs(rolled - runout).max() < 2e-3 * largest and np.all(raw.slow_roll == 0)
        assert np.abs(found.vectors[0, 0] - x).max() < 2e-3 * largest


def test_units_of_time_and_signals_do_not_matter():
    (time, x, y), keys, _ = passage()
    usual = signals.Record(time, x, y, **keys)
    other = signals.Record(1024 * time, 0.25 * x, 0.25 * y, pulses=1024 * keys["pulses"])
    tracked, scaled = usual.track([1, 2], slow_roll=40.0), other.track([1, 2], slow_roll=40.0 / 1024)
    assert np.array_equal(0.25 * tracked.forward, scaled.forward) and np.array_equal(tracked.lag, scaled.lag)
    first, second = usual.spectrogram(2.0, 8.0), other.spectrogram(2048.0, 8192.0)
    assert np.array_equal(0.25 * first.backward, second.backward) and np.allclose(first.kept, second.kept, atol=1e-12)
    first, second = usual.cascade(16, 200), other.cascade(16, 200)
    assert np.array_equal(0.25 * first.forward, second.forward) and np.array_equal(first.change, second.change)


def test_tracked_orders_as_a_frame_and_figures():
    pytest.importorskip("pandas")
    given, keys, _ = passage()
    record = signals.Record(*given, **keys, unit="um")
    found = record.track([0.5, 1], revolutions=2, slow_roll=40.0)
    frame = found.to_pandas()
    assert len(frame) == len(record.speed) // 2 and list(frame)[:4] == [
        "time", "speed", "x 0.5X amplitude", "x 0.5X lag"
    ]  # fmt: skip
    assert np.array_equal(frame["backward 1X lag"], np.degrees(-np.angle(found.backward[1])) % 360)
    amplitude, lag = record.plot.bode("y", orders=[0.5, 1], revolutions=2, slow_roll=40.0)
    line = amplitude.get_lines()[1]
    assert np.allclose(line.get_xdata(), found.speed * 30 / np.pi) and line.get_label() == "1X"
    assert np.array_equal(line.get_ydata(), found.amplitude[1, 1]) and amplitude.get_ylabel() == "amplitude of y (µm)"
    drawn = lag.get_lines()[1].get_ydata()
    assert np.array_equal(drawn[np.isfinite(drawn)], found.lag[1, 1]) and lag.get_xlabel() == "speed (rpm)"
    polar = record.plot.polar(slow_roll=40.0)
    tracked = record.track(slow_roll=40.0)
    assert np.array_equal(polar.get_lines()[0].get_ydata(), tracked.amplitude[0, 0])
    with pytest.raises(whirl.BadInput, match="the axes are not polar"):
        record.plot.polar(ax=plt.subplots()[1])


def test_slow_roll_within_the_record_and_below_resonances():
    given, keys, _ = passage()
    record = signals.Record(*given, **keys)
    for speed in (20.0, 300.0, np.nan):
        with pytest.raises(whirl.BadInput, match="the slow-roll speed is .* expected a speed of the record, 32.0"):
            record.track(slow_roll=speed)
    for speed in (180.0, 188.0, 220.0, 280.0):  # 188.5 rad/s is the resonance
        with pytest.raises(whirl.BadInput, match="is not below the resonances: up to a tenth above it 1X of 'x'"):
            record.track(slow_roll=speed)
    runout = signals.Record(
        given[0], 4 * np.cos(2 * np.pi * (5 * given[0] + 0.5 * given[0] ** 2)), pulses=keys["pulses"]
    )
    assert np.abs(runout.track(slow_roll=200.0).vectors).max() < 1e-2  # a shaft that does not vibrate


def test_a_spectrogram_says_what_a_sweep_loses():
    """Tests windows of 2 s in a run-up by 1 turn/s2. In the middle of each window, 1X is at a frequency of the
    spectrum."""
    time = np.arange(40 * 1000) / 1000
    pulses = -5 + np.sqrt(25 + 2 * np.arange(980))
    angle = 2 * np.pi * (5 * time + 0.5 * time**2)
    record = signals.Record(time, 7 * np.cos(angle - 0.3), 7 * np.sin(angle - 0.3), pulses=pulses)
    found = record.spectrogram(2.0, 0.5)
    assert np.allclose(found.sweep, 4.0, rtol=0, atol=1e-2) and np.allclose(found.speed, 2 * np.pi * (5 + found.time))
    assert np.allclose(found.kept, 0.8942682817821, rtol=0, atol=5e-4) and np.array_equal(found.kept, found.kept_of(1))
    assert np.allclose(found.kept_of(0.25), 0.992644641011, rtol=0, atol=1e-4)
    rows = np.arange(len(found.time))
    once = np.rint(found.speed / (2 * np.pi) / found.frequency[1]).astype(int)
    assert len(rows) == 76 and np.allclose(found.forward[rows, once], 7 * found.kept, rtol=0, atol=0.01)
    assert found.backward[rows, once].max() < 0.01
    short = record.spectrogram(0.25, y=None)
    assert short.kept.min() > 0.9999 and short.y is None and short.forward is None
    u = np.linspace(-0.5, 0.5, 200001)
    for sweep in (0.3, 7.0, 55.0):
        whole = (1 + np.cos(2 * np.pi * u)) * np.exp(1j * np.pi * sweep * u**2)
        assert abs(signals.sweep_kept(sweep) - np.abs(whole.sum() * (u[1] - u[0]))) < 1e-9


def test_a_cascade_keeps_orders_sharp():
    time, turns, time_of = run_up()
    x, y = 3 * np.cos(2 * np.pi * turns), 2 * np.sin(2 * np.pi * turns)
    record = signals.Record(time, x, y + 0.5 * np.cos(np.pi * turns), pulses=time_of(np.arange(70)))
    found = record.cascade(8, 4, highest_order=3.0)
    assert np.array_equal(found.orders, np.arange(25) / 8) and len(found.time) == 16
    assert np.allclose(found.forward[:, 8], 2.5, atol=1e-4) and np.allclose(found.backward[:, 8], 0.5, atol=1e-4)
    assert np.allclose(found.forward[:, 4], 0.25, atol=1e-4) and found.forward[:, 12:].max() < 1e-3
    assert np.allclose(found.speed, 2 * np.pi * (30 + 5 * found.time), rtol=1e-4)
    assert np.allclose(found.change, 5 * 8 / (found.speed / 2 / np.pi) ** 2, rtol=0.02)
    alone = record.cascade(8, 4, y=None)
    assert alone.forward is None and np.allclose(alone.x[:, 8], 3.0, atol=1e-4)


def test_figures_over_time_and_speed():
    given, keys, _ = passage()
    record = signals.Record(*given, **keys, unit="um")
    found, ax = record.spectrogram(2.0, 4.0, y=None), record.plot.spectrogram(2.0, step=4.0, highest=60.0)
    assert np.array_equal(ax.collections[0].get_array().reshape(found.x.T.shape), found.x.T)
    assert ax.get_ylim() == (0.0, 60.0) and ax.get_title().startswith("windows of 2 s leave 89.4")
    lines = record.plot.waterfall(2.0, step=4.0).get_lines()
    assert len(lines) == len(found.time) and lines[3].get_ydata()[-1] == pytest.approx(found.time[3], abs=1e-2)
    full, ax = record.cascade(16, 100), record.plot.cascade(16, step=100)
    line = ax.get_lines()[5]
    assert ax.get_xlabel() == "order, backward below 0" and np.array_equal(line.get_xdata()[80:], full.orders)
    scale = 0.2 * np.ptp(full.speed) * 30 / np.pi / np.hstack([full.forward[:, 1:], full.backward[:, 1:]]).max()
    assert np.allclose(line.get_ydata()[80:], full.speed[5] * 30 / np.pi + scale * full.forward[5])
    assert record.plot.cascade(16, y=None, step=100).get_xlabel() == "order"


def test_vold_kalman_says_where_an_order_is_slower_than_the_band():
    time = np.arange(20000) / 1000  # a run-up from rest by 2 turns/s2
    angle = 2 * np.pi * time**2
    found = signals.vold_kalman(np.cos(angle), angle, rate=1000.0, bandwidth=1.0)
    assert found.doubtful[0, time < 1.0].all() and not found.doubtful[0, (time > 1.01) & (time < 18.99)].any()
    assert found.amplitude[0, 0, 0] > 1.5 and np.abs(found.vectors[0, 0, 5000:15000] - 1).max() < 2e-3
    with pytest.raises(
        whirl.BadInput, match="phase 0 .from 0. has a frequency of at most 0, expected one above its bandwidth, 1"
    ):
        signals.vold_kalman(np.ones(20000), 0 * time, rate=1000.0, bandwidth=1.0)


# ---------------------------------------------------------------- fatigue


def four_points(values):
    """Returns the cycles of each range by the method of four points (Amzallag et al. 1994); the residue counts as half
    cycles."""
    turning = [values[0]]
    for value in values[1:]:
        if len(turning) > 1 and (turning[-1] - turning[-2]) * (value - turning[-1]) > 0:
            turning[-1] = value
        elif value != turning[-1]:
            turning.append(value)
    counts, left = {}, []
    for point in turning:
        left.append(point)
        while len(left) >= 4:
            before, inner, after = np.abs(np.diff(left[-4:]))
            if inner > before or inner > after:
                break
            counts[inner] = counts.get(inner, 0) + 1
            del left[-3:-1]
    for half in np.abs(np.diff(left)):
        counts[half] = counts.get(half, 0) + 0.5
    return counts


def test_rain_flow_is_that_of_four_points():
    for seed in range(40):
        values = np.random.default_rng(seed).integers(-20, 20, 300)
        ranges, cycles = signals.rain_flow(values).counts()
        assert dict(zip(ranges, cycles)) == four_points(values.tolist())
    found = signals.rain_flow([-2, 1, -3, 5, -1, 3, -4, 4, -2])
    assert found.mean.tolist() == [-0.5, -1, 1, 1, 0.5, 0, 1]
    assert [column.tolist() for column in found.counts()] == [[3, 4, 6, 8, 9], [0.5, 1.5, 0.5, 1, 0.5]]
    assert signals.rain_flow([3, 3]).range.size == 0 and signals.damage([3, 3], (100, 1e6), slope=3) == 0


def test_damage_of_a_history():
    pandas = pytest.importorskip("pandas")
    found = signals.rain_flow([-2, 1, -3, 5, -1, 3, -4, 4, -2])
    closed = sum(n * s**3 for s, n in ((3, 0.5), (4, 1.5), (6, 0.5), (8, 1), (9, 0.5))) / (10**3 * 1e6)
    assert signals.damage(found, (10, 1e6), slope=3) == pytest.approx(closed, rel=1e-14)
    assert signals.damage(found, [(10, 1e6), (1, 1e9)]) == pytest.approx(closed, rel=1e-14)
    assert signals.damage(found, (10, 1e6), 3, endurance=8) == pytest.approx(0.5 * 9**3 / 1e9, rel=1e-14)
    assert list(found.to_pandas()) == ["range", "mean", "cycles"] and isinstance(found.to_pandas(), pandas.DataFrame)


# ---------------------------------------------------------------- what is refused

T = np.arange(200) * 0.05
V = np.sin(6 * T)


@pytest.mark.parametrize(
    "make, words",
    [
        (lambda: signals.vold_kalman(V, T[:9], rate=20, bandwidth=1), "the angle has 9 samples, the signals have 200"),
        (lambda: signals.vold_kalman(V, T, [1, 1], rate=20, bandwidth=1), "the orders are 1, 1, expected different"),
        (lambda: signals.vold_kalman(V, T, 0, rate=20, bandwidth=1), "the orders are 0, expected different ones above"),
        (lambda: signals.vold_kalman(V, T, [], rate=20, bandwidth=1), "the orders are , expected different ones above"),
        (lambda: signals.vold_kalman(V, T, rate=20, bandwidth=[1, 2]), "there are 2 bandwidths, expected one for all"),
        (lambda: signals.vold_kalman(V, T, rate=20, bandwidth=-1), "the bandwidth is -1, expected above 0"),
        (lambda: signals.vold_kalman(V, T, rate=20, bandwidth=1, poles=3), "there are 3 poles, expected 1 or 2"),
        (lambda: signals.vold_kalman(V, phases=T[:9], rate=20, bandwidth=1), "the phases have 9 samples"),
        (
            lambda: signals.Record(T + 1e-3 * (T > 5), V, pulses=np.arange(1, 10)).vold_kalman(bandwidth=1),
            "samples 100 and 101 are 0.051 apart, others 0.0500063: expected a constant rate",
        ),
        (lambda: signals.bode(T, V, pulses=np.arange(1, 9), revolutions=8), "over 8 revolutions, expected 1 to 7"),
        (lambda: signals.bode(T, V, pulses=np.arange(1, 9), revolutions=0), "over 0 revolutions, expected 1 to 7"),
        (lambda: signals.bode(T, V, pulses=np.arange(1, 9), orders=50), "an order is 50, expected 0 or more and below"),
        (lambda: signals.bode(T, V, V, pulses=np.arange(1, 9), y="z"), "there is no channel 'z'"),
        (lambda: signals.Record(T, V, pulses=np.arange(1, 9)).spectrogram(-1), "windows last -1 and are -0.25 apart"),
        (lambda: signals.Record(T, V, pulses=np.arange(1, 9)).cascade(3), "blocks have 3 revolutions and are 1 apart"),
        (lambda: signals.Record(T, V, pulses=np.arange(1, 9)).cascade(16), "expected blocks of 4 to 7, the record's"),
        (lambda: signals.Record(T, V, pulses=np.arange(1, 9)).cascade(4, 0), "are 0 apart, expected blocks of 4 to 7"),
        (lambda: signals.sweep_kept(np.inf), "the sweep is inf"),
        (lambda: signals.rain_flow([]), "there are 0 samples"),
        (lambda: signals.rain_flow([1, np.nan]), "sample 1 of channel 0 is nan"),
        (lambda: signals.damage(V, (1, 2)), "the S-N curve has 1 point and no slope, expected one point and a slope"),
        (lambda: signals.damage(V, [(2, 1), (1, 2)], 3), "the S-N curve has 2 points and a slope, expected one point"),
        (lambda: signals.damage(V, [(1, 1), (0.5, 9)]), "expected at most 1, where the S-N curve begins"),
        (lambda: signals.damage(V, [1, 2, 3]), "the S-N curve has the shape (1, 3), expected points of a range and"),
        (lambda: signals.damage(V, (1, 2), slope=-3), "the slope of the S-N curve is -3"),
        (
            lambda: signals.vold_kalman(V, rate=20, bandwidth=1),
            "there is nothing to track, expected an angle, or phases",
        ),
        (
            lambda: signals.vold_kalman(V, 9 * T, 7, rate=20, bandwidth=1),
            "phase 0 (from 0) turns by 3.15 rad from sample 0 to 1",
        ),
        (
            lambda: signals.bode(T, V, pulses=np.arange(1, 9), orders=0.5),
            "the order 0.5 has no whole number of periods",
        ),
        (
            lambda: signals.Record(T, V, pulses=np.arange(1, 9)).spectrogram(9.0),
            "a window has 142 samples, expected 8 to",
        ),
        (
            lambda: signals.Record(T, V, pulses=np.arange(1, 9)).spectrogram(0.1),
            "a window has 2 samples, expected 8 to",
        ),
        (
            lambda: signals.Record(T, V, pulses=np.arange(1, 9)).spectrogram(1, np.nan),
            "windows last 1 and are nan apart",
        ),
    ],
)
def test_meaningless_arguments_are_refused_in_a_sentence(make, words):
    with pytest.raises(whirl.BadInput) as failure:
        make()
    assert words in str(failure.value) and "\n" not in str(failure.value)
