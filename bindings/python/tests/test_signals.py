"""Tests measured signals against results of computed motions and independent formulas."""

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
    """Computes a rotor that rubs every other revolution: 256 revolutions of 512 samples."""
    example = runpy.run_path(str(EXAMPLE))
    return whirl.run(whirl.Case(text=example["CASE"]), progress=False), example


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """The folder with the record of the rotor that rubs."""
    folder = tmp_path_factory.mktemp("measured")
    subprocess.run([sys.executable, EXAMPLE], cwd=folder, check=True)
    return folder


@pytest.fixture(scope="module")
def record(folder):
    time, a, b, keyphasor = np.loadtxt(folder / "measured.csv", delimiter=",", skiprows=1, unpack=True)
    return signals.Record(time, a, b, keyphasor=keyphasor, angles=np.radians([45, 135]), unit="um")


def run_up(rate=5000.0, seconds=2.0):
    """Returns a shaft from 30 to 40 turns a second: times, turns, and the times of whole turns."""
    time = np.arange(int(rate * seconds)) / rate
    return time, time * (30 + 2.5 * time), lambda turns: (-30 + np.sqrt(900 + 10 * turns)) / 5


# ---------------------------------------------------------------- compared with results


def test_the_package_loads_signals_when_they_are_asked_for():
    code = "import sys, whirl; assert 'numpy' not in sys.modules; whirl.signals; assert 'h5py' not in sys.modules"
    subprocess.run([sys.executable, "-c", code], check=True)


def test_samples_of_a_result_give_its_own_numbers_to_the_bit(rub):
    """Tests samples of a result as a record whose time is in turns. The motion is periodic, so its last sample also
    serves as the sample at time 0, the first pulse."""
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
    """Tests 512/3 samples per revolution, and a keyphasor whose edge is a straight line.

    The disc leaves the stator 0.02 turns before the pulse, where the force has a kink. The interpolation over eight
    samples, 3/512 turns apart, hardly includes the kink. With every ninth sample it does, and the section is only
    accurate to 5e-6.
    """
    table = rub[0]["sweep"]
    motion = table["waveform/samples"][0, 0][1:-1:3]
    turns = np.arange(2, 256 * 512, 3) / 512
    after = np.remainder(turns + 0.5, 1) - 0.5
    keyphasor = np.clip(20 * after, -1, 1) * (np.abs(after) < 0.4)  # rises over 0.1 turns at the pulse, 0 beyond 0.4
    record = signals.Record(turns / 116.0, *motion.T, keyphasor=keyphasor, threshold=0.0, hysteresis=0.5)
    assert len(record.speed) == 254  # an even number; with an odd one, order 1/2 leaks into 1X by 1e-7
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


# ---------------------------------------------------------------- compared with independent formulas


def test_pulses_speed_and_phases_of_a_run_up():
    time, turns, time_of = run_up()
    record = signals.Record(5000.0, np.cos(2 * np.pi * turns), keyphasor=np.sin(2 * np.pi * turns))
    assert np.array_equal(record.time, time)
    count = np.arange(1, len(record.pulses) + 1)
    assert len(count) == 69 and np.abs(record.pulses - time_of(count)).max() < 1e-7  # the sine's edge is curved
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
    # Take the times of equal angles from the formula, interpolate signals by cubic splines, and transform by NumPy.
    even = interpolate.CubicSpline(time, x)(time_of(np.arange(1, 69 * 200 + 1) / 200))
    window = np.sin(np.pi * np.arange(len(even)) / len(even)) ** 2
    mean = (even * window).sum() / window.sum()
    amplitude = 2 * np.abs(np.fft.rfft((even - mean) * window)) / window.sum()
    assert np.allclose(spectrum.orders, np.arange(346) / 69, rtol=1e-15)
    assert np.allclose(spectrum.amplitude[0], amplitude[:346], atol=2e-5)
    assert np.allclose(spectrum.amplitude[1], 3 * spectrum.amplitude[0], rtol=1e-9, atol=1e-12)
    assert np.allclose(spectrum.lines[0][:2], [[1.0, 1.0], [2.5, 0.3]], atol=1e-5)
    assert np.allclose(spectrum.lag, np.degrees(0.4), atol=1e-2)


def test_a_full_spectrum_has_the_circles_of_an_ellipse():
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
    """Returns K by Gottwald and Melbourne (2009), equations 2.1 and 2.3, with the plain mean square displacement."""
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


# ---------------------------------------------------------------- a realistic record


def test_the_measured_rub_is_the_computed_one(rub, record):
    """Tests a record with noise of 0.2 um, a resolution of 0.1 um and a speed that varies by 1 %: its analyses agree
    with the computed motion."""
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
        (lambda: signals.zero_one([]), "there are 0 samples"),
        (lambda: signals.zero_one(np.ones(100)), "the size of the motion is 0"),
        (lambda: signals.recurrence(np.arange(20001.0)), "there are 20001 points, expected at most 20000"),
        (lambda: signals.recurrence(V, shortest=-1), "the shortest line is -1"),
        (lambda: signals.recurrence(np.where(T == 1, np.nan, V)), "sample 20 of channel 0 is nan"),
    ],
)
def test_meaningless_arguments_are_refused_in_a_sentence(make, words):
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
def test_wrong_numbers_are_refused(wrong):
    with pytest.raises(whirl.BadInput, match="expected numbers"):
        signals.Record(100.0, wrong, pulses=[1.0, 2.0])
    with pytest.raises(whirl.BadInput, match="expected numbers"):
        signals.Record(wrong, np.arange(2000.0), pulses=[1.0, 2.0])


# ---------------------------------------------------------------- wrong pulses and angles


def turning():
    """Returns rate, angle, x, y and keyphasor of a shaft that runs from 1500 to 1620 rpm and whirls with an amplitude
    of 40 along x."""
    rate = 5120.0
    time = np.arange(int(rate * 6)) / rate
    angle = np.cumsum(2 * np.pi * (25 + 2 * time / 6)) / rate
    return rate, angle, 40 * np.cos(angle - 0.9), 30 * np.sin(angle - 0.9), 5.0 * (np.cos(angle) > 0.97)


@pytest.mark.filterwarnings("error")
def test_missed_pulse():
    """Tests that a missed or false pulse at any position is refused with its number; with several teeth every n-th
    pulse counts."""
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
    """Tests a record of fifty samples with three pulses, 8.1 and 16.8 samples apart."""
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
    """Tests a constant acceleration from rest, in which the first revolution takes 2.4 times as long as the second."""
    pulses = np.sqrt(np.arange(40.0))
    signals.check_pulses(pulses if order > 0 else pulses[-1] - pulses[::-1])
    signals.check_pulses(pulses[:4] if order > 0 else pulses[3] - pulses[3::-1])


def test_angles_in_degrees_are_refused():
    for angles in ([45, 135], [0, 90], [-45.0, 45.0]):
        with pytest.raises(whirl.BadInput, match=r"expected rad.*degrees are numpy.radians\("):
            signals.Record(100.0, np.sin(np.arange(99.0)), np.cos(np.arange(99.0)), pulses=[0.1, 0.5], angles=angles)
    signals.Record(100.0, np.arange(99.0), np.arange(99.0), pulses=[0.1, 0.5], angles=[0, 2 * np.pi])
