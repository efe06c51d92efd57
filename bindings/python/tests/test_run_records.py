"""Tests records of runs, in which sensors measure at a changing speed, against SciPy and closed forms."""

import h5py
import numpy as np
import pytest

import whirl

solve_ivp = pytest.importorskip("scipy.integrate").solve_ivp

MASS, DAMPING, STIFFNESS, UNBALANCE, GRAVITY, WALL, FRICTION = 1.0, 0.2, 1.0, 0.1, 0.02, 10.0, 0.05
RATE, SAMPLES, SETTLE = 3.0, 600, 8

CASE = """
whirl: 1
title: Records of run-ups
parameters: {e: 0.1 m, gap: 9 m, low: 0.4 rad/s, high: 1.6 rad/s, rate: 0.008}
rotor:
  speed: 1 rad/s
  length_scale: 1 m
  stations:
    disc: {mass: 1 kg, damping: 0.2 N.s/m, eccentricity: = e}
  elements:
    - spring:  {between: [disc, ground], stiffness: 1 N/m}
    - rub:     {at: disc, gap: = gap, stiffness: 10 N/m, friction: 0.05, law: paper}
    - gravity: 0.02 m/s2
study:
  dataset:
    machines: 2
    records: 2
    rate: 3 Hz
    samples: 600
    conditions: {low: {from: 0.3, to: 0.5}, rate: {from: 0.006, to: 0.012}}
    runup: LAW
    labels:
      healthy:
      rub: {grade: {gap: {from: 0.4, to: 0.2}}}
    channels:
      - {sensor: proximity, at: disc}
      - {sensor: proximity, at: disc, angle: 90 deg}
      - {sensor: accelerometer, at: disc, angle: 30 deg}
      - {sensor: keyphasor, width: 40 deg}
      - {sensor: keyphasor, pulses: 8, width: 10 deg}
"""

UP = "{speed_from: = low, speed_to: = high, rate: = rate, settle: SETTLE, rtol: 1e-10}"
DOWN = "{speed_from: = high, speed_to: = low, rate: = rate, settle: SETTLE, rtol: 1e-10}"
REST = "{speed_from: 0, speed_to: 1.2, rate: = rate, rtol: 1e-10}"
TABLE = "{speeds: [[0 s, = low], [50 s, 1.2], [120 s, 1.2], [200 s, = low]], settle: SETTLE, rtol: 1e-10}"


def made(folder, law, text=CASE):
    return whirl.dataset(
        whirl.Case(text=text.replace("LAW", law).replace("SETTLE", str(SETTLE)), name="runs.yaml"),
        folder / "runs.h5",
        progress=False,
    )


def law_of(kind, frame, i):
    """Returns times and speeds of a record's law, from its table of records."""
    low, rate = frame.low[i], frame["parameter rate"][i]
    if kind == TABLE:
        return [0.0, 50.0, 120.0, 200.0], [low, 1.2, 1.2, low]
    ends = {UP: [low, 1.6], DOWN: [1.6, low], REST: [0.0, 1.2]}[kind]
    return [0.0, abs(ends[1] - ends[0]) / rate], ends


def turning(times, speeds):
    """Returns a function of time that gives the angle since time 0, the speed and its rate. The speed is linear between
    the rows, and constant before and after them."""
    times, speeds = np.array(times), np.array(speeds)
    slopes = np.append(np.diff(speeds) / np.diff(times), 0.0)
    angles = np.append(0.0, np.cumsum(np.diff(times) * 0.5 * (speeds[1:] + speeds[:-1])))

    def at(t):
        t = np.asarray(t, float)
        k = np.clip(np.searchsorted(times, t, "right") - 1, 0, len(times) - 1)
        since = np.where(t < 0.0, t, t - times[k])
        slope = np.where(t < 0.0, 0.0, slopes[k])
        return angles[k] + speeds[k] * since + 0.5 * slope * since**2, speeds[k] + slope * since, slope

    return at


def forces(at, begin, gap):
    def slopes(t, z):
        x, y, vx, vy = z
        angle, speed, rate = at(t)
        angle = angle + 2.0 * np.pi * begin
        cos, sin, r = np.cos(angle), np.sin(angle), np.hypot(x, y)
        fx = MASS * UNBALANCE * (speed**2 * cos + rate * sin) - STIFFNESS * x - DAMPING * vx
        fy = MASS * UNBALANCE * (speed**2 * sin - rate * cos) - STIFFNESS * y - DAMPING * vy - MASS * GRAVITY
        if r > gap:
            push = WALL * (1.0 - gap / r)
            fx, fy = fx - push * (x - FRICTION * y), fy - push * (FRICTION * x + y)
        return [vx, vy, fx / MASS, fy / MASS]

    return slopes


def filtered(signal, times, samples):
    """Applies the antialias filter of the guide: a sinc with a Kaiser window over 16 samples on both sides."""
    reach, ratio = 16, 4
    u = np.arange(-reach * ratio, reach * ratio + 1) / ratio
    w = np.sinc(u) * np.i0(7.857 * np.sqrt(np.maximum(0.0, 1.0 - (u / reach) ** 2)))
    first = int(np.argmin(abs(times)))
    assert abs(times[first]) < 1e-9
    return (
        np.array([signal[first + ratio * k + np.arange(len(u)) - reach * ratio] @ w for k in range(samples)]) / w.sum()
    )


def integrated(law, begin, gap):
    """Integrates the motion by SciPy, piece by piece between the corners of the law; returns instants, states and
    rates."""
    at, speed = turning(*law), law[1][0]
    times = (np.arange(4 * (SAMPLES + 36)) - 4 * 18) / (4.0 * RATE)
    ends = [
        -32.0 / RATE - SETTLE * 2.0 * np.pi / speed if speed > 0.0 else -10.0,
        *(t for t in law[0] if t < times[-1]),
        times[-1] + 1.0,
    ]
    slopes = forces(at, begin, gap)
    state = np.array([0.0, -MASS * GRAVITY / STIFFNESS, 0.0, 0.0])
    z = np.empty((4, len(times)))
    for start, end in zip(ends, ends[1:]):
        inside = (times >= start) & (times < end)
        found = solve_ivp(slopes, (start, end), state, "DOP853", np.append(times[inside], end), rtol=1e-11,
                          atol=1e-13, max_step=0.1 if gap < 1.0 else np.inf)  # fmt: skip
        z[:, inside], state = found.y[:, :-1], found.y[:, -1]
    return times, z, np.array([slopes(t, own) for t, own in zip(times, z.T)]).T


@pytest.mark.parametrize("kind", [UP, DOWN, TABLE, REST])
def test_signals_are_those_of_scipy(kind, tmp_path):
    data = made(tmp_path, kind)
    frame = data.index
    rubs = np.flatnonzero((frame.label == "rub") & (frame.contact > 0))
    assert (frame.contact[frame.label == "healthy"] == 0).all() and len(rubs) > 0
    for i in (0, *rubs[: kind in (UP, DOWN)]):
        law = law_of(kind, frame, i)
        times, z, rates = integrated(law, frame.begin[i], frame.gap[i])
        signals = data.signals[i]
        for channel, exact in ((0, z[0]), (1, z[1]), (2, np.cos(np.pi / 6) * rates[2] + 0.5 * rates[3])):
            error = abs(signals[channel] - filtered(exact, times, SAMPLES)) / abs(exact).max()
            # Leave out accelerations near jumps of the rate, where the acceleration jumps too and samples cannot show
            # it.
            corners = (min(abs(k / RATE - t) for t in law[0]) > 10 / RATE for k in range(SAMPLES))
            error = error[np.fromiter(corners, bool)] if channel == 2 else error
            assert error.max() < (2e-7 if channel < 2 else 2e-6 if i == 0 else 2e-3), (kind, i, channel)
        at = turning(*law)
        assert frame.speed[i] == pytest.approx(at(0.0)[1], rel=1e-12)
        assert frame.end_speed[i] == pytest.approx(at((SAMPLES - 1) / RATE)[1], rel=1e-12)
        assert frame.rate[i] == pytest.approx(at(0.0)[2], rel=1e-12)


@pytest.mark.parametrize("kind", [UP, DOWN, TABLE])
def test_pulses_lie_at_angles_of_the_law(kind, tmp_path):
    data = made(tmp_path, kind)
    frame = data.index
    for i in (0, 5):
        at = turning(*law_of(kind, frame, i))
        edges = (np.arange(SAMPLES + 1) - 0.5) / RATE
        turns = at(edges)[0] / (2.0 * np.pi) + frame.begin[i]
        for channel, pulses, width in ((3, 1, 40.0), (4, 8, 10.0)):
            # A sample is the share of its angle that pulses cover, from the integral of the pulses over the angle.
            half = 0.5 * width / 360.0
            passed = turns * pulses
            covered = np.floor(passed) * 2.0 * half + np.clip((passed % 1.0) / pulses, 0.0, half)
            covered += np.clip((passed % 1.0) / pulses - (1.0 / pulses - half), 0.0, half)
            share = np.diff(covered) / np.diff(turns)
            assert abs(data.signals[i, channel] - share).max() < 1e-6, (kind, i, channel)


def test_jitter_of_pulses(tmp_path):
    text = CASE.replace("width: 40 deg", "width: 40 deg, jitter: 2 deg").replace("rate: 3 Hz", "rate: 6 Hz")
    text = text.replace("samples: 600", "samples: 1600").replace("machines: 2", "machines: 4")
    data = made(tmp_path, UP, text)
    frame = data.index
    errors = []
    for i in range(len(data)):
        at = turning(*law_of(UP, frame, i))
        edges = (np.arange(1601) - 0.5) / 6.0
        turns = at(edges)[0] / (2.0 * np.pi) + frame.begin[i]
        middle, weight = 0.5 * (turns[1:] + turns[:-1]), data.signals[i, 3] * np.diff(turns)
        for pulse in range(2, int(turns[-1]) - 1):
            own = abs(middle - pulse) < 0.3
            # The rising edge cuts a sample, whose value gives the edge's exact angle; the pulse is half its width
            # later.
            begin = np.flatnonzero(own & (data.signals[i, 3] > 0.0))[0]
            rise = turns[begin + 1] - weight[begin] if data.signals[i, 3, begin + 1] > 0.0 else np.nan
            errors.append(360.0 * (rise - pulse) + 20.0)
    errors = np.array(errors)[np.isfinite(errors)]
    assert len(errors) > 400
    # Within three standard errors of the mean and of the deviation.
    assert abs(errors.mean()) < 3.0 * 2.0 / len(errors) ** 0.5
    assert abs(errors.std() - 2.0) < 3.0 * 2.0 / (2.0 * len(errors)) ** 0.5


def test_run_is_that_of_the_study(tmp_path):
    """Tests that the motion of a record has the largest radius of a run-up of the same machine that starts at the same
    angle."""
    data = made(tmp_path, UP)
    frame, table = data.index, whirl.read(tmp_path / "runs.h5")["records"]
    i = 0
    lead = 32.0 / RATE
    duration = lead + (SAMPLES + 32.0) / RATE
    low, rate = frame.low[i], frame["parameter rate"][i]
    angle = 2.0 * np.pi * frame.begin[i] - low * lead
    study = f"""study:
  runup:
    speeds: [[0 s, {float(low)!r}], [{lead!r} s, {float(low)!r}], [{float(lead + (1.6 - low) / rate)!r} s, 1.6]]
    duration: {duration!r}
    angle: {float(angle % (2.0 * np.pi))!r}
    begin: steady
    settle: {SETTLE}
    rtol: 1e-10
"""
    run = whirl.run(whirl.Case(text=CASE[: CASE.index("study:")] + study, name="run.yaml"), progress=False)["runup"]
    for name in ("runup/peak", "runup/peak_speed", "runup/end_speed", "runup/end_turns", "runup/place"):
        assert np.allclose(table[name][i], run[name][0], rtol=1e-8, atol=1e-9), name


EVENTS = """
whirl: 1
title: Records of blades that are lost, and shafts that loosen
parameters: {loss: 0 kg m, lost: 60 s, k: 1 N/m, k2: 1 N/m, low: 0.4 rad/s, rate: 0.008}
rotor:
  speed: 1 rad/s
  length_scale: 1 m
  stations:
    disc: {mass: 1 kg, damping: 0.2 N.s/m, eccentricity: 0.1 m}
  elements:
    - spring:  {between: [disc, ground], stiffness: = k}
    - gravity: 0.02 m/s2
study:
  dataset:
    machines: 3
    records: 1
    rate: 3 Hz
    samples: 600
    conditions: {low: {from: 0.3, to: 0.5}, rate: {from: 0.006, to: 0.012}}
    runup:
      speed_from: = low
      speed_to: 1.6
      rate: = rate
      settle: 8
      rtol: 1e-10
      events:
        - {time: = lost, loss_at: disc, loss_moment: = loss, loss_angle: 40 deg}
        - {WHEN, change: {k: = k2}}
    labels:
      healthy:
      blade: {grade: {loss: {from: 0.05, to: 0.2}}, vary: {lost: {from: 20, to: 80}}}
      loose: {grade: {k2: {from: 0.9, to: 0.5}}}
    channels:
      - {sensor: proximity, at: disc}
      - {sensor: proximity, at: disc, angle: 90 deg}
"""


@pytest.mark.parametrize("when", ["speed: 0.8", "when: = time > 45", "when: = speed > 0.9"])
def test_events_are_those_of_scipy(when, tmp_path):
    """An unbalance appears at a time from the first sample on, and the stiffness changes at a speed or a time."""
    data = made(tmp_path, "", EVENTS.replace("WHEN", when))
    frame = data.index
    assert list(frame.label[:3]) == ["healthy", "blade", "loose"]
    for i in range(3):
        at = turning([0.0, (1.6 - frame.low[i]) / frame["parameter rate"][i]], [frame.low[i], 1.6])
        changed = 45.0 if "time" in when else (float(when[-3:]) - frame.low[i]) / frame["parameter rate"][i]

        def slopes(t, z, i=i, at=at, changed=changed):
            x, y, vx, vy = z
            angle, speed, rate = at(t)
            angle = angle + 2.0 * np.pi * frame.begin[i]
            stiffness = frame.k2[i] if t >= changed else 1.0
            fx, fy = -stiffness * x - 0.2 * vx, -stiffness * y - 0.2 * vy - 0.02
            for moment, place in ((0.1, 0.0), (frame.loss[i] if t >= frame.lost[i] else 0.0, np.radians(40.0))):
                cos, sin = np.cos(angle + place), np.sin(angle + place)
                fx, fy = fx + moment * (speed**2 * cos + rate * sin), fy + moment * (speed**2 * sin - rate * cos)
            return [vx, vy, fx, fy]

        times = (np.arange(4 * (SAMPLES + 36)) - 4 * 18) / (4.0 * RATE)
        ends = sorted({-32.0 / RATE - 16.0 * np.pi / frame.low[i], 0.0, changed, frame.lost[i],
                       (1.6 - frame.low[i]) / frame["parameter rate"][i], times[-1] + 1.0})  # fmt: skip
        z, state = np.empty((4, len(times))), np.array([0.0, -0.02, 0.0, 0.0])
        for start, end in zip(ends, ends[1:]):
            inside = (times >= start) & (times < end)
            found = solve_ivp(slopes, (start, end - 1e-12), state, "DOP853", np.append(times[inside], end - 1e-12),
                              rtol=1e-11, atol=1e-13)  # fmt: skip
            z[:, inside], state = found.y[:, :-1], found.y[:, -1]
        for channel in range(2):
            error = abs(data.signals[i, channel] - filtered(z[channel], times, SAMPLES)) / abs(z[channel]).max()
            assert error.max() < 3e-7, (when, i, channel)
    assert data.remake(2).tobytes() == data.signals[2].tobytes()
    assert "event: time = lost, loss_at disc, loss_moment = loss" in data.datasheet


def test_files(tmp_path):
    data = made(tmp_path, UP)
    assert data.remake(5).tobytes() == data.signals[5].tobytes()
    assert "speed_from = low, speed_to = high, rate = rate" in data.datasheet
    assert "verdict" not in data.index and set(data.column("split")) <= {"train", "validation", "test"}
    with h5py.File(tmp_path / "runs.h5") as file:
        assert file["records/dataset/signals"].shape == (8, 5, SAMPLES)
        assert np.array_equal(file["records/dataset/end_speed"][()], data.column("end_speed"))


@pytest.mark.parametrize(
    ("law", "message"),
    [
        ("{speed_from: = low, rate: = rate}", "expected speed_from, speed_to and rate, or speeds"),
        ("{speeds: [[0 s, 1], [9 s, 2]], rate: 1}", "is speeds and a rate"),
        ("{speed_from: 1, speed_to: 2, rate: 1, drag: no}", "has no meaning for records"),
        (
            "{speed_from: 1, speed_to: 2, rate: 1, events: [{time: 1 s, end: yes}]}",
            "ends the run, and records need all",
        ),
        (
            "{speed_from: 1, speed_to: 2, rate: 1, events: [{time: 1 s, trip: yes}]}",
            "the speed of records follows a law",
        ),
        ("{speed_from: 1, speed_to: 1, rate: 1}", "expected two speeds"),
        ("{speed_from: 0, speed_to: 1, rate: 1, begin: steady}", "begins steady at standstill"),
    ],
)
def test_refused(law, message):
    with pytest.raises(whirl.BadInput, match=message):
        whirl.run(whirl.Case(text=CASE.replace("LAW", law), name="runs.yaml"), progress=False)


def test_sampling_by_the_angle_is_refused():
    text = CASE.replace("LAW", UP).replace("SETTLE", "8").replace("rate: 3 Hz", "samples_per_revolution: 32")
    with pytest.raises(whirl.BadInput, match="expected rate and samples"):
        whirl.Case(text=text.replace("samples: 600", "revolutions: 20"))
