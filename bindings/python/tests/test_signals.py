"""Measured signals: what results say of computed motions, and formulas of one's own."""

import re
import runpy
import subprocess
import sys

import numpy as np
import pytest
from conftest import ROOT

import whirl
from whirl import signals

plt = pytest.importorskip("matplotlib.pyplot")
EXAMPLE = ROOT / "examples/measured.py"


@pytest.fixture(autouse=True)
def closed_figures():
    yield
    plt.close("all")


@pytest.fixture(scope="module")
def rub():
    """A rotor that rubs every other revolution, computed: 256 revolutions of 512 samples."""
    example = runpy.run_path(str(EXAMPLE))
    return whirl.run(whirl.Case(text=example["CASE"]), progress=False), example


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Where the record of that rotor lies."""
    folder = tmp_path_factory.mktemp("measured")
    subprocess.run([sys.executable, EXAMPLE], cwd=folder, check=True)
    return folder


@pytest.fixture(scope="module")
def record(folder):
    time, a, b, keyphasor = np.loadtxt(folder / "measured.csv", delimiter=",", skiprows=1, unpack=True)
    return signals.Record(time, a, b, keyphasor=keyphasor, angles=np.radians([45, 135]), unit="um")


def run_up(rate=5000.0, seconds=2.0):
    """A shaft from 30 to 40 turns a second: times, turns, and when it has turned so often."""
    time = np.arange(int(rate * seconds)) / rate
    return time, time * (30 + 2.5 * time), lambda turns: (-30 + np.sqrt(900 + 10 * turns)) / 5


# ---------------------------------------------------------------- beside results


def test_the_package_loads_signals_when_they_are_asked_for():
    code = "import sys, whirl; assert 'numpy' not in sys.modules; whirl.signals; assert 'h5py' not in sys.modules"
    subprocess.run([sys.executable, "-c", code], check=True)


def test_samples_of_a_result_give_its_own_numbers_to_the_bit(rub):
    """Time is in turns here; that of the first pulse is the end of the record, which is a period of the motion."""
    table = rub[0]["sweep"]
    waveform = table["waveform/samples"][0, 0]
    path = np.vstack([waveform[-1:], waveform]).T
    record = signals.Record(512.0, *path, pulses=np.arange(257.0))
    assert np.array_equal(record.section()[1:], table["poincare/section"][0, 0, :, :2])
    assert np.array_equal(record.resample(512).reshape(2, -1), waveform.T)
    full = record.full_spectrum(highest_order=5.0, samples=512)
    lines = table["spectrum/lines"][0, 0]
    assert np.array_equal(full.lines, lines[np.isfinite(lines[:, 0])]) and len(full.lines) > 5
    assert np.array_equal(full.synchronous, table["spectrum/synchronous"][0, 0])
    assert np.array_equal(full.lag, table["spectrum/synchronous_lag"][0, 0])


def test_a_result_sampled_in_time_gives_its_own_section_and_spectrum(rub):
    """512/3 samples per revolution, and a keyphasor whose edge is a straight line.

    The disc leaves the stator 0.02 turns before the pulse: eight samples of 3/512 turns hardly see that kink of the
    force. With every ninth sample they do, and the section is known to 5e-6 only.
    """
    table = rub[0]["sweep"]
    motion = table["waveform/samples"][0, 0][1:-1:3]
    turns = np.arange(2, 256 * 512, 3) / 512
    after = np.remainder(turns + 0.5, 1) - 0.5
    keyphasor = np.clip(20 * after, -1, 1) * (np.abs(after) < 0.4)  # 5 V from 0.05 turns on, back at half a turn
    record = signals.Record(turns / 116.0, *motion.T, keyphasor=keyphasor, threshold=0.0, hysteresis=0.5)
    assert len(record.speed) == 254  # an even number: of an odd one half the order leaks to 1X by 1e-7
    assert np.allclose(record.speed, 2 * np.pi * 116.0, rtol=1e-11)
    section = table["poincare/section"][0, 0, :, :2]
    first = int(round(record.pulses[0] * 116.0))
    own = record.section()
    size = record.size
    assert np.abs(own - section[first - 1 : first - 1 + len(own)]).max() < 1e-8 * size
    assert record.recurrence(tolerance=1e-4).period == table["regime/period"][0] == 2
    lines = table["spectrum/lines"][0, 0]
    full = record.full_spectrum(highest_order=5.0)
    assert np.abs(full.lines[:4] - lines[:4]).max() < 1e-10 * size
    assert np.abs(full.synchronous - table["spectrum/synchronous"][0, 0]).max() < 1e-10 * size


# ---------------------------------------------------------------- beside formulas of one's own


def test_pulses_speed_and_phases_of_a_run_up():
    time, turns, time_of = run_up()
    record = signals.Record(5000.0, np.cos(2 * np.pi * turns), keyphasor=np.sin(2 * np.pi * turns))
    assert np.array_equal(record.time, time)
    count = np.arange(1, len(record.pulses) + 1)
    assert len(count) == 69 and np.abs(record.pulses - time_of(count)).max() < 1e-7  # the sine's edge is a little bent
    middles = 0.5 * (time_of(count[1:]) + time_of(count[:-1]))
    assert np.allclose(record.speed, 2 * np.pi * (30 + 5 * middles), rtol=1e-5)
    assert np.allclose(record.section(phase=np.pi / 2), 0.0, atol=1e-4)
    falling = signals.find_pulses(time, np.sin(2 * np.pi * turns), edge="falling")
    assert np.abs(falling - time_of(np.arange(len(falling)) + 0.5)).max() < 1e-7


def test_order_spectra_are_those_of_scipy():
    interpolate = pytest.importorskip("scipy.interpolate")
    time, turns, time_of = run_up()
    angle = 2 * np.pi * turns
    x = 1.5 + np.cos(angle - 0.4) + 0.3 * np.cos(2.5 * angle)
    record = signals.Record(time, x, 3 * x, pulses=time_of(np.arange(70)))
    spectrum = record.spectrum(highest_order=5.0, samples=200)
    # Times of equal angles from the formula, signals by cubic splines, the transform by NumPy.
    even = interpolate.CubicSpline(time, x)(time_of(np.arange(1, 69 * 200 + 1) / 200))
    window = np.sin(np.pi * np.arange(len(even)) / len(even)) ** 2
    mean = (even * window).sum() / window.sum()
    amplitude = 2 * np.abs(np.fft.rfft((even - mean) * window)) / window.sum()
    assert np.allclose(spectrum.orders, np.arange(346) / 69, rtol=1e-15)
    assert np.allclose(spectrum.amplitude[0], amplitude[:346], atol=2e-5)
    assert np.allclose(spectrum.amplitude[1], 3 * spectrum.amplitude[0], rtol=1e-9, atol=1e-12)
    assert np.allclose(spectrum.lines[0][:2], [[1.0, 1.0], [2.5, 0.3]], atol=1e-5)
    assert np.allclose(spectrum.lag, np.degrees(0.4), atol=1e-2)


def test_a_full_spectrum_tells_the_circles_of_an_ellipse():
    time, turns, time_of = run_up()
    x, y = 0.5 * np.cos(2 * np.pi * turns), 0.2 * np.sin(2 * np.pi * turns)
    angles = np.radians([20, 130])
    probes = [x * np.cos(angle) + y * np.sin(angle) for angle in angles]
    record = signals.Record(time, *probes, pulses=time_of(np.arange(70)), angles=angles)
    full = record.full_spectrum()
    assert np.allclose(full.lines[0], [1.0, 0.5, 0.2, 0.35, 0.15], atol=1e-5)
    assert np.allclose(record.displacements(), [x, y], atol=1e-15)
    assert record.names == ["20°", "130°"]


def logistic(r, count):
    x = np.empty(count + 1000)
    x[0] = 0.3123
    for n in range(1, len(x)):
        x[n] = r * x[n - 1] * (1 - x[n - 1])
    return x[1000:]


def correlation_k(x, c):
    """K by Gottwald and Melbourne (2009), equations 2.1 and 2.3, with the plain mean square displacement."""
    n = np.arange(len(x))
    p, q = np.cumsum((x - x.mean()) * np.cos(c * n)), np.cumsum((x - x.mean()) * np.sin(c * n))
    lags, averaged = np.arange(1, len(x) // 10 + 1), len(x) - len(x) // 10
    away = [np.mean((p[m:][:averaged] - p[:averaged]) ** 2 + (q[m:][:averaged] - q[:averaged]) ** 2) for m in lags]
    return np.corrcoef(lags, away)[0, 1]


@pytest.mark.parametrize("r, chaotic", [(3.55, False), (3.97, True)])
def test_the_logistic_map_of_gottwald_and_melbourne(r, chaotic):
    x = logistic(r, 2000)
    k = signals.zero_one(x)
    own = np.median([correlation_k(x, c) for c in np.random.default_rng(1).uniform(np.pi / 5, 4 * np.pi / 5, 100)])
    assert abs(k - own) < 0.05
    assert k > 0.95 if chaotic else abs(k) < 0.1


def test_recurrence_is_that_of_the_whole_plot():
    points = np.column_stack([logistic(3.8, 300), np.sin(np.arange(300) / 7)])
    size = signals.motion_size(points.T)
    assert size == pytest.approx(0.5 * np.hypot(*(points.max(axis=0) - points.min(axis=0))), rel=1e-15)
    plot = np.linalg.norm(points[:, None] - points[None], axis=2) <= 0.2 * size

    def runs(line):
        return [len(run) for run in re.findall("1+", "".join("01"[int(bit)] for bit in line))]

    diagonals = [run for apart in range(1, 300) for run in runs(np.diagonal(plot, apart))]
    columns = [run for column in plot for run in runs(column)]
    found = signals.recurrence(points, radius=0.2, shortest=3)
    assert found.rate == pytest.approx(sum(diagonals) / (300 * 299 / 2), rel=1e-14)
    assert found.determinism == pytest.approx(sum(run for run in diagonals if run > 2) / sum(diagonals), rel=1e-14)
    assert found.laminarity == pytest.approx(sum(run for run in columns if run > 2) / sum(columns), rel=1e-14)
    assert found.longest == max(diagonals)


# ---------------------------------------------------------------- a record as users have


def test_the_measured_rub_is_the_computed_one(rub, record):
    """With noise of 0.2 um, probes read to 0.1 um, and a speed that hunts by 1 %."""
    table, example = rub[0]["sweep"], rub[1]
    micrometres = table.length_scale[0] * 1e6
    known = np.linspace(0.0, 2.0, 2_000_001)
    exact = np.interp(np.arange(1, len(record.pulses) + 1), example["turns_at"](known), known)
    assert len(record.pulses) == 233 and np.abs(record.pulses - exact).max() < 1e-5
    lines = table["spectrum/lines"][0, 0, :4] * [1, *[micrometres] * 4]
    full = record.full_spectrum()
    assert np.abs(full.lines[:4] - lines).max() < 0.02  # um
    assert np.abs(full.lag - table["spectrum/synchronous_lag"][0, 0]).max() < 0.1  # degrees
    assert record.recurrence().period == 2 and record.recurrence().determinism > 0.999


def test_the_code_of_the_documentation_runs(folder, monkeypatch):
    text = (ROOT / "docs/python.md").read_text().split("\n## Measured signals\n")[1].split("\n## ")[0]
    blocks = re.findall(r"^```python\n(.*?)^```", text, re.M | re.S)
    monkeypatch.chdir(folder)
    names = {}
    for block in blocks:
        exec(block, names)
    rpm = names["record"].speed * 30 / np.pi
    assert len(rpm) == 232 and (round(rpm.min()), round(rpm.max())) == (6928, 7075)
    assert [f"{number:.1f}" for number in names["full"].lines[0]] == ["0.5", "22.9", "176.4", "87.8", "90.1"]
    assert names["returns"].period == 2 and round(names["returns"].distance, 3) == 0.004


def test_figures_show_the_numbers(record):
    full, left, right = record.full_spectrum(3.0), *record.plot.full_spectrum(3.0).get_lines()[:2]
    assert np.array_equal(left.get_xydata(), np.column_stack([full.orders, full.forward]))
    assert np.array_equal(right.get_xydata(), np.column_stack([-full.orders, full.backward]))
    ax = record.plot.section()
    displacements = record.displacements()
    points = ax.get_lines()[0].get_xydata()
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("x (µm)", "y (µm)") and len(points) == 233
    assert (np.abs(points - displacements.mean(axis=1)) <= np.ptp(displacements, axis=1)).all()
    path, marks = record.plot.orbit(revolutions=4).get_lines()
    assert np.array_equal(marks.get_xydata(), points[-5:]) and 4 * 83 < len(path.get_xdata()) < 4 * 88
    assert np.array_equal(record.plot.spectrum("135°").get_lines()[0].get_ydata(), record.spectrum().amplitude[1])
    speed = record.plot.speed()
    assert speed.get_ylabel() == "speed (rpm)"
    assert np.allclose(speed.get_lines()[0].get_ydata(), record.speed * 30 / np.pi, rtol=1e-15)


def test_series_and_masks_and_integers():
    pandas = pytest.importorskip("pandas")
    time, turns, time_of = run_up()
    frame = pandas.DataFrame({"inboard": np.cos(2 * np.pi * turns), "outboard": np.round(1000 * turns).astype(int)})
    record = signals.Record(time, frame.inboard, frame.outboard, pulses=time_of(np.arange(70)))
    assert record.names == ["inboard", "outboard"] and record.channel("outboard") == 1
    masked = np.ma.masked_where(time > 1.9, frame.inboard)
    with pytest.raises(whirl.BadInput, match="sample 9501 of channel 0 is nan"):
        signals.Record(time, masked, pulses=time_of(np.arange(70))).section()


# ---------------------------------------------------------------- orders over time


def two_orders():
    """The run-up of tests/unit/analyze/test_vold_kalman.c: time, angle, signal."""
    time = np.arange(80) / 200
    angle = 2 * np.pi * (5 * time + 10 * time**2)
    line = 0.2 * np.cos(2 * np.pi * 17 * time)
    return time, angle, (1 + 0.5 * time) * np.cos(angle + 0.3) + 0.4 * np.cos(2 * angle - 1.1) + line


@pytest.mark.parametrize("poles", [1, 2])
def test_vold_kalman_solves_the_dense_equations(poles):
    """NumPy's least squares of all rows, without normal equations."""
    time, angle, values = two_orders()
    found = signals.vold_kalman(values, angle, [1, 2], rate=200.0, bandwidth=2.0, poles=poles)
    weight = np.sqrt((np.sqrt(2) - 1) / (2 * np.sin(np.pi * 2.0 / 400.0)) ** (2 * poles))
    smooth = weight * np.diff(np.eye(80), poles, axis=0)
    measured = np.hstack([np.diag(np.exp(1j * k * angle)) for k in (1, 2)])
    rows = np.vstack([np.kron(np.eye(2), smooth), measured])
    dense = np.linalg.lstsq(rows, np.append(np.zeros(len(rows) - 80), values), rcond=None)[0].reshape(2, 80)
    assert np.allclose(found.vectors, [2 * dense], rtol=0, atol=1e-10)
    assert np.allclose(found.amplitude * np.exp(-1j * np.radians(found.lag)), found.vectors)
    assert found.near_end.shape == (2, 80) and found.near_end.all()  # a record of 0.4 s, a band of 2 Hz


def test_vold_kalman_of_a_record_with_a_line_of_the_mains():
    """Amplitudes over a run-up through 35 turns a second, where the first order crosses a line of 35 Hz."""
    time, turns, time_of = run_up()
    angle, line = 2 * np.pi * turns, 2 * np.pi * 35.0 * time
    signal = 3.0 * np.cos(angle - 0.7) + np.cos(3 * angle) + 0.5 * np.cos(line)
    record = signals.Record(time, signal, pulses=time_of(np.arange(70)))
    found = record.vold_kalman([1, 3], bandwidth=2.0, phases=line)
    inside = ~found.near_end.any(axis=0)
    assert found.time[0] == 0.0 and found.time[-1] <= record.pulses[-1] and inside.sum() > 4000
    expected = np.array([3.0 * np.exp(-0.7j), 1.0, 0.5])[:, None]
    assert np.abs(found.vectors[0][:, inside] - expected).max() < 1e-2
    alone = record.vold_kalman([1, 3], bandwidth=2.0)
    assert np.abs(alone.vectors[0, 0, inside] - expected[0]).max() > 0.2


def passage(angles=None):
    """A shaft that runs from 5 to 45 turns a second through its resonance at 30, 1 turn a second faster in a second, on
    a runout of 4 at the probes: a record, and the displacement vectors of x and y over turns a second."""
    time = np.arange(int(2000 * 40)) / 2000
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
    """Windows of 2 s while a shaft gains 1 turn a second in a second: 1X lies on a frequency in the middle of each."""
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


# ---------------------------------------------------------------- what is refused

T = np.arange(200) * 0.05
V = np.sin(6 * T)


@pytest.mark.parametrize(
    "make, words",
    [
        (lambda: signals.Record(T, pulses=[1, 2]), "there is no channel"),
        (lambda: signals.Record(T, V), "expected either a keyphasor or pulses"),
        (lambda: signals.Record(T, V, V[:9], pulses=[1, 2]), "channel 'y' has 9 samples, 'x' has 200"),
        (lambda: signals.Record(T[:9], V, pulses=[1, 2]), "time has 9 samples, the channels have 200"),
        (lambda: signals.Record(0.0, V, pulses=[1, 2]), "the rate is 0.0"),
        (lambda: signals.Record(T, V, keyphasor=V[:9]), "the keyphasor has 9 samples, time has 200"),
        (lambda: signals.Record(T, V, keyphasor=0 * V), "the keyphasor is 0 all the time"),
        (lambda: signals.Record(T, V, keyphasor=V, edge="up"), "the edge is 'up', expected 'rising' or 'falling'"),
        (lambda: signals.Record(T, V, keyphasor=V, threshold=5.0), "there are 0 pulses, expected at least 2"),
        (lambda: signals.Record(T, V, pulses=[]), "there are 0 pulses"),
        (lambda: signals.Record(T, V, pulses=[1, 3, 2]), "pulse 2 is at 2, not after pulse 1 at 3: time has to grow"),
        (lambda: signals.Record(T, V, pulses=[1, np.nan]), "the time of pulse 1 is nan"),
        (lambda: signals.Record(T, V, pulses=[1, 2], angles=[0, 1]), "there are 2 angles, expected one for each of 1"),
        (lambda: signals.Record(T, V, pulses=[1, 2], names=["a", "b"]), "the names a, b, expected 1"),
        (lambda: signals.Record(T, ["a"] * 200, pulses=[1, 2]), "channel 'x': could not convert"),
        (lambda: signals.Record(T, [V, V], pulses=[1, 2]), "channel 'x' has the shape"),
        (lambda: signals.Record([], [], pulses=[1, 2]).section(), "there are 0 samples"),
        (lambda: signals.Record(T, V, pulses=[1, 20]).section(), "pulse 1 is at 20, expected a time of the samples"),
        (lambda: signals.Record(T, V, pulses=[1, 2]).section(phase=7), "the phase of the section is 7 rad"),
        (lambda: signals.Record(T, V, pulses=[1, 2]).section(order=4), "the order of interpolation is 4"),
        (lambda: signals.Record(T, V, pulses=[1, 2]).spectrum(), "there are 1 revolutions, expected at least 4"),
        (lambda: signals.Record(T, V, pulses=[1, 2]).resample(1 << 30), "are too many"),
        (lambda: signals.Record(T, V, pulses=[1, 2]).resample(-1), "samples is -1"),
        (lambda: signals.Record(T, V, pulses=[1, 2]).resample(np.nan), "samples is nan, expected a whole number"),
        (lambda: signals.Record(T, V, pulses=[1, 2]).section(order=1 << 40), "the order is 1099511627776"),
        (lambda: signals.Record(T, V, V, pulses=[1, 2], angles=[1, 1]).displacements(), "not in one line"),
        (lambda: signals.Record(T, V, pulses=[1, 2]).full_spectrum(), "there is no channel 1, expected 0 to 0"),
        (lambda: signals.Record(T, V, pulses=[1, 2]).plot.spectrum("z"), "there is no channel 'z', expected one of: x"),
        (lambda: signals.Record(T, V, pulses=[1, 2]).zero_one(), "there are 2 points, expected at least 100"),
        (
            lambda: signals.vold_kalman(V, rate=20, bandwidth=1),
            "there is nothing to track, expected an angle, or phases",
        ),
        (lambda: signals.vold_kalman(V, T[:9], rate=20, bandwidth=1), "the angle has 9 samples, the signals have 200"),
        (lambda: signals.vold_kalman(V, T, [1, 1], rate=20, bandwidth=1), "the orders are 1, 1, expected different"),
        (lambda: signals.vold_kalman(V, T, 0, rate=20, bandwidth=1), "the orders are 0, expected different ones above"),
        (lambda: signals.vold_kalman(V, T, [], rate=20, bandwidth=1), "the orders are , expected different ones above"),
        (lambda: signals.vold_kalman(V, T, rate=20, bandwidth=[1, 2]), "there are 2 bandwidths, expected one for all"),
        (lambda: signals.vold_kalman(V, T, rate=20, bandwidth=-1), "the bandwidth is -1, expected above 0"),
        (lambda: signals.vold_kalman(V, T, rate=20, bandwidth=1, poles=3), "there are 3 poles, expected 1 or 2"),
        (
            lambda: signals.vold_kalman(V, 9 * T, 7, rate=20, bandwidth=1),
            "order 0 turns by 3.15 rad from sample 0 to 1",
        ),
        (lambda: signals.vold_kalman(V, phases=T[:9], rate=20, bandwidth=1), "the phases have 9 samples"),
        (
            lambda: signals.Record(T + 1e-3 * (T > 5), V, pulses=np.arange(1, 10)).vold_kalman(bandwidth=1),
            "samples 100 and 101 are 0.051 apart, others 0.0500063: expected a constant rate",
        ),
        (
            lambda: signals.bode(T, V, pulses=np.arange(1, 9), orders=0.5),
            "the order 0.5 has no whole number of periods",
        ),
        (lambda: signals.bode(T, V, pulses=np.arange(1, 9), revolutions=8), "over 8 revolutions, expected 1 to 7"),
        (lambda: signals.bode(T, V, pulses=np.arange(1, 9), revolutions=0), "over 0 revolutions, expected 1 to 7"),
        (lambda: signals.bode(T, V, pulses=np.arange(1, 9), orders=50), "an order is 50, expected 0 or more and below"),
        (lambda: signals.bode(T, V, V, pulses=np.arange(1, 9), y="z"), "there is no channel 'z'"),
        (
            lambda: signals.Record(T, V, pulses=np.arange(1, 9)).spectrogram(9.0),
            "a window has 142 samples, expected 8 to",
        ),
        (
            lambda: signals.Record(T, V, pulses=np.arange(1, 9)).spectrogram(0.1),
            "a window has 2 samples, expected 8 to",
        ),
        (lambda: signals.Record(T, V, pulses=np.arange(1, 9)).spectrogram(-1), "windows last -1 and are -0.25 apart"),
        (
            lambda: signals.Record(T, V, pulses=np.arange(1, 9)).spectrogram(1, np.nan),
            "windows last 1 and are nan apart",
        ),
        (lambda: signals.Record(T, V, pulses=np.arange(1, 9)).cascade(3), "blocks have 3 revolutions and are 1 apart"),
        (lambda: signals.Record(T, V, pulses=np.arange(1, 9)).cascade(16), "expected blocks of 4 to 7, the record's"),
        (lambda: signals.Record(T, V, pulses=np.arange(1, 9)).cascade(4, 0), "are 0 apart, expected blocks of 4 to 7"),
        (lambda: signals.sweep_kept(np.inf), "the sweep is inf"),
        (lambda: signals.zero_one([]), "there are 0 samples"),
        (lambda: signals.zero_one(np.ones(100)), "the size of the motion is 0"),
        (lambda: signals.recurrence(np.arange(20001.0)), "there are 20001 points, expected at most 20000"),
        (lambda: signals.recurrence(V, shortest=-1), "the shortest line is -1"),
        (lambda: signals.recurrence(np.where(T == 1, np.nan, V)), "sample 20 of channel 0 is nan"),
    ],
)
def test_what_means_nothing_is_said_in_a_sentence(make, words):
    with pytest.raises(whirl.BadInput) as failure:
        make()
    assert words in str(failure.value) and "\n" not in str(failure.value)


def test_a_record_stays_as_it_was_made():
    turns = np.arange(0, 20, 0.01)
    record = signals.Record(turns, np.sin(turns), np.cos(turns), pulses=np.arange(1.0, 19.0), unit="um")
    for name, value in (("channels", record.channels.astype("float32")), ("names", ["a"]), ("time", turns[:10])):
        with pytest.raises(AttributeError, match="make another one"):
            setattr(record, name, value)
    record.unit = "mm"
    assert record.section().shape == (18, 2)


@pytest.mark.parametrize("wrong", [np.arange(2000) * 1j, np.arange(2000).astype("datetime64[ns]")])
def test_what_is_no_number_is_refused(wrong):
    with pytest.raises(whirl.BadInput, match="expected numbers"):
        signals.Record(100.0, wrong, pulses=[1.0, 2.0])
    with pytest.raises(whirl.BadInput, match="expected numbers"):
        signals.Record(wrong, np.arange(2000.0), pulses=[1.0, 2.0])


# ---------------------------------------------------------------- pulses and angles that cannot be


def turning():
    """A shaft from 1500 to 1620 rpm that whirls with 40 along x: rate, angle, x, y, keyphasor."""
    rate = 5120.0
    time = np.arange(int(rate * 6)) / rate
    angle = np.cumsum(2 * np.pi * (25 + 2 * time / 6)) / rate
    return rate, angle, 40 * np.cos(angle - 0.9), 30 * np.sin(angle - 0.9), 5.0 * (np.cos(angle) > 0.97)


@pytest.mark.filterwarnings("error")
def test_missed_pulse():
    """One pulse missed or false is refused by its number, wherever it is; of many teeth every so many-th counts."""
    rate, angle, x, y, key = turning()
    good = signals.Record(rate, x, y, keyphasor=key)
    assert abs(good.full_spectrum().synchronous[0] - 40) < 2e-3
    for at in [1, 2, 3, 50, len(good.pulses) - 3]:
        with pytest.raises(whirl.BadInput, match=f"^pulse {at},.* comes (1.9|2) ?.* pulses were missed"):
            signals.Record(rate, x, y, pulses=np.delete(good.pulses, at))
    for at in [1, 2, 50, len(good.pulses) - 2]:
        false = 0.7 * good.pulses[at - 1] + 0.3 * good.pulses[at]
        with pytest.raises(whirl.BadInput, match=f"^pulse {at},.* comes 0.*one of them is false"):
            signals.Record(rate, x, y, pulses=np.insert(good.pulses, at, false))
    index = int(good.pulses[51] * rate)
    for change, words in (((index - 60, index + 60, 0.0), "missed"), ((index + 80, index + 85, 5.0), "false")):
        bad = key.copy()
        bad[change[0] : change[1]] = change[2]
        with pytest.raises(whirl.BadInput, match=words):
            signals.Record(rate, x, y, keyphasor=bad)
        assert len(signals.Record(rate, x, y, keyphasor=bad, uneven=True).speed) in (154, 156)


def test_pulses_of_a_wheel():
    rate, angle, x, y, _ = turning()
    teeth = 5.0 * (np.cos(30 * angle) > 0.5)
    with pytest.warns(UserWarning, match="once in 30 pulses.*say per_revolution=30"):
        signals.Record(rate, x, y, keyphasor=teeth)
    record = signals.Record(rate, x, y, keyphasor=teeth, per_revolution=30)
    assert abs(record.full_spectrum().synchronous[0] - 40) < 0.02
    assert 1490 < record.speed.min() * 30 / np.pi < record.speed.max() * 30 / np.pi < 1630
    with pytest.raises(whirl.BadInput, match="0 pulses per revolution"):
        signals.Record(rate, x, y, keyphasor=teeth, per_revolution=0)


def test_a_short_record_with_a_missed_pulse():
    """Fifty samples: three pulses, after 8.1 and 16.8 of them."""
    voltage = np.cos(2 * np.pi * (np.arange(50.0) - 1) / 8.3)
    voltage[30:37] = -1.0
    samples = 50.0, np.sin(np.arange(50.0))
    assert len(signals.Record(*samples, keyphasor=voltage, uneven=True).pulses) == 5
    with pytest.raises(whirl.BadInput, match="pulse 3, .* comes 2 of the usual revolution.*missed"):
        signals.Record(*samples, keyphasor=voltage)
    with pytest.raises(whirl.BadInput, match="pulse 1.* of the usual revolution"):
        signals.Record(*samples, pulses=np.array([8.0, 16.1, 32.9]) / 50)


@pytest.mark.parametrize("order", [1, -1])
def test_a_shaft_may_start_from_rest_and_run_down(order):
    """Revolutions of a constant acceleration from rest: the first is 2.4 times as long as the second."""
    pulses = np.sqrt(np.arange(40.0))
    signals.check_pulses(pulses if order > 0 else pulses[-1] - pulses[::-1])
    signals.check_pulses(pulses[:4] if order > 0 else pulses[3] - pulses[3::-1])


def test_angles_in_degrees_are_refused():
    for angles in ([45, 135], [0, 90], [-45.0, 45.0]):
        with pytest.raises(whirl.BadInput, match=r"expected rad.*degrees are numpy.radians\("):
            signals.Record(100.0, np.sin(np.arange(99.0)), np.cos(np.arange(99.0)), pulses=[0.1, 0.5], angles=angles)
    signals.Record(100.0, np.arange(99.0), np.arange(99.0), pulses=[0.1, 0.5], angles=[0, 2 * np.pi])
