"""Tests that fits recover known parameters from files and from columns, name parameters that the data do not determine,
and refuse bad input."""

import json
import subprocess

import numpy as np
import pytest
from conftest import COMMAND

import whirl

SPRING = {
    "parameters": {"n": "100 rad/s", "k": "30 kN/m", "c": "40 N s/m", "e": "50 um", "mu": 0.1},
    "rotor": {
        "speed": "= n",
        "length_scale": "1 mm",
        "stations": {"disc": {"mass": "3 kg", "damping": "= c", "eccentricity": "= e"}},
        "elements": [
            {"shaft": {"between": ["disc", "ground"], "k1": "= k"}},
            {"rub": {"at": "disc", "gap": "5 mm", "stiffness": "1 MN/m", "friction": "= mu"}},
        ],
    },
    "study": {"response": {}},
}
TRUTH = {"k": 33e3, "c": 52.0, "e": 38e-6}


def bode():
    """Returns amplitudes and lags of a disc on a spring, by their closed form."""
    w = np.arange(60.0, 150.0, 10.0)
    response = TRUTH["e"] * w**2 / (TRUTH["k"] / 3 - w**2 + 1j * TRUTH["c"] * w / 3)
    return {"speed [rad/s]": w, "disc x [m]": abs(response), "disc x lag [rad]": -np.angle(response)}


def test_fitted_parameters_are_those_of_the_data(tmp_path):
    found = whirl.fit(SPRING, bode(), ["k", "c", "e"], tolerance=1e-10)
    assert found.end == "found" and len(found) == 3
    for name, value in TRUTH.items():
        assert found[name].value == pytest.approx(value, rel=1e-9)
        assert found[name].known == "determined"
    # A file gives the same result as columns.
    rows = np.column_stack(list(bode().values()))
    np.savetxt(tmp_path / "bode.csv", rows, "%.17g", ",", header=",".join(bode()), comments="")
    again = whirl.fit(whirl.Case(SPRING), tmp_path / "bode.csv", ["k", "c", "e"], tolerance=1e-10)
    assert [again[name].value for name in again] == [found[name].value for name in found]


def test_the_explorer_has_motions_alone(tmp_path):
    """Tests that the page gets only the numbers of measured motions, not the measured frequency of a mode."""
    rows = np.column_stack(list(bode().values()))
    np.savetxt(tmp_path / "bode.csv", rows, "%.17g", ",", header=",".join(bode()), comments="")
    head = "".join(f"{key}: {json.dumps(SPRING[key])}\n" for key in ("parameters", "rotor"))
    data = "[{frequency: 16.7 Hz, noise: 0.05 Hz}, {file: bode.csv, noise: 1 um}]"
    study = f"study:\n  fit: {{unknown: {{k: , c: , e: }}, data: {data}}}\n"
    (tmp_path / "disc.yaml").write_text(f"whirl: 1\n{head}{study}")
    for arguments in (["run", "disc.yaml", "-q", "-o", "disc.h5"], ["report", "disc.h5", "-o", "page"]):
        subprocess.run([COMMAND, *arguments], cwd=tmp_path, check=True, capture_output=True)
    path = tmp_path / "page/explorer.html"
    if not path.exists():
        pytest.skip("the explorer is not built")
    page = path.read_text()
    fits, _ = json.JSONDecoder().raw_decode(page, page.index('"fits":') + len('"fits":'))
    (fit,) = fits
    (file,) = fit["measured"]
    assert file["name"] == "file 2"
    assert file["table"]["motions"] == pytest.approx(bode()["speed [rad/s]"], rel=1e-12)
    assert sorted({number[3] for number in file["table"]["numbers"]}) == [1, 2]
    assert [unknown["determined"] for unknown in fit["unknowns"]] == ["yes"] * 3


def test_starts_and_what_is_not_known():
    bounds = {"k": ("20 kN/m", "50 kN/m"), "mu": (0.05, 0.2)}
    found = whirl.fit(SPRING, bode(), bounds, noise="1 um", starts=3)
    assert len(found.starts) == 3 and found["mu"].known == "unknown" and np.isnan(found["mu"].error)
    named = [own for own in found.result.statements() if own.what == "parameter mu"]
    assert named and named[0].verdict == "not known"
    assert set(found.frame().index) == {"k", "mu"}
    assert found.numbers.shape == (18, 9) and found.correlations.shape == (2, 2)


def test_bad_input(tmp_path):
    with pytest.raises(whirl.BadInput, match="no table"):
        whirl.fit(SPRING, "nowhere.csv", ["k"])
    with pytest.raises(whirl.BadInput, match="is no parameter"):
        whirl.fit(SPRING, bode(), ["kk"])
    with pytest.raises(whirl.BadInput, match="is no station"):
        whirl.fit(SPRING, {"speed [rad/s]": [1.0], "disk x [m]": [1.0]}, ["k"])
    with pytest.raises(whirl.BadInput, match="no unit"):
        whirl.fit(SPRING, {"speed [rad/s]": [1.0], "disc x": [1.0]}, ["k"])
    with pytest.raises(whirl.BadInput, match="rows"):
        whirl.fit(SPRING, {"speed [rad/s]": [1.0], "disc x [m]": [1.0, 2.0]}, ["k"])
    with pytest.raises(whirl.BadInput, match="expected"):
        whirl.fit(SPRING, bode(), {"k": 7})
    # A study whose table is missing is refused.
    (tmp_path / "a.yaml").write_text(
        whirl.Case(SPRING).text.split("study:")[0] + "study:\n  fit: {unknown: {k: }, data: gone.csv}\n"
    )
    with pytest.raises(whirl.BadInput, match="cannot read"):
        whirl.run(str(tmp_path / "a.yaml"))


def test_keys_are_named_as_a_case_has_them():
    """Tests that messages name keys as in a case, not as in the reference."""
    for fit, words in (
        ({"unknown": {"k": {"fron": 1, "to": 2}}, "data": ["a.csv"]}, "k.fron: fit.unknown has no key fron, did you"),
        ({"unknown": {"k": {}}, "data": [{"file": "a.csv", "sped": 3}]}, r"sped: fit.data has no key sped, expected"),
    ):
        with pytest.raises(whirl.BadInput, match=words):
            whirl.Case({**SPRING, "study": {"fit": fit}})


def waveform():
    """Returns displacements over time of the same disc at 100 rad/s, at times that are incommensurate with a
    revolution."""
    w, time = 100.0, 0.00317 * np.arange(80)
    response = TRUTH["e"] * w**2 / (TRUTH["k"] / 3 - w**2 + 1j * TRUTH["c"] * w / 3)
    turning = response * np.exp(1j * w * time)
    return time, 1e6 * turning.real, 1e6 * turning.imag


def check_waveform(data):
    found = whirl.fit(SPRING, data, ["k", "e"], at={"n": "100 rad/s", "c": "52 N s/m"}, tolerance=1e-10)
    for name in ("k", "e"):
        assert found[name].value == pytest.approx(TRUTH[name], rel=1e-5)


def test_files_of_other_programs(tmp_path):
    import h5py

    time, x, y = waveform()
    names = {"time [s]": "t", "disc x [um]": "run/x", "disc y [um]": "run/y"}
    # Read HDF5 by the names of its datasets, and with units from attributes.
    with h5py.File(tmp_path / "a.h5", "w") as file:
        file["t"], file["run/x"], file["run/y"] = time, x, y.reshape(-1, 1)
        file["note"] = "no numbers"
    check_waveform(whirl.read_measured(tmp_path / "a.h5", names))
    with h5py.File(tmp_path / "b.h5", "w") as file:
        for name, values, unit in (("time", time, "s"), ("disc x", x, "um"), ("disc y", y, "um")):
            file[name] = values
            file[name].attrs["unit"] = unit
    check_waveform(tmp_path / "b.h5")
    # Read universal files as text in single and double precision, and as binary.
    for kind in ("single", "double", "binary"):
        (tmp_path / "a.uff").write_bytes(b"".join(record(kind, d, time, v) for d, v in ((1, x), (2, y))))
        check_waveform(tmp_path / "a.uff")
    with pytest.raises(whirl.BadInput, match="has no record 'record 3', expected one of time, disc x, disc y"):
        whirl.read_measured(tmp_path / "a.uff", {"disc x [um]": 3})
    with pytest.raises(whirl.BadInput, match="has no dataset 'run/z', did you mean 'run/x'"):
        whirl.read_measured(tmp_path / "a.h5", {"disc x [um]": "run/z"})
    with pytest.raises(whirl.BadInput, match="no dataset 58"):
        (tmp_path / "b.uff").write_text("    -1\n   151\nnothing\n    -1\n")
        whirl.read_measured(tmp_path / "b.uff")
    (tmp_path / "c.mat").write_text("no file of MATLAB")
    with pytest.raises(whirl.BadInput, match="c.mat"):
        whirl.read_measured(tmp_path / "c.mat")
    cut = (tmp_path / "a.uff").read_bytes()[:700]
    (tmp_path / "c.uff").write_bytes(cut)
    with pytest.raises(whirl.BadInput, match="dataset 58 number 1, line 13: is cut off"):
        whirl.read_measured(tmp_path / "c.uff")


def test_files_of_matlab(tmp_path):
    io = pytest.importorskip("scipy.io")
    time, x, y = waveform()
    io.savemat(tmp_path / "a.mat", {"t": time, "x": x, "y": y})
    check_waveform(whirl.read_measured(tmp_path / "a.mat", {"time [s]": "t", "disc x [um]": "x", "disc y [um]": "y"}))


def record(kind, direction, time, values):
    """Returns a dataset 58 in the format of its specification (Structural Dynamics Research Laboratory, Cincinnati)."""
    number, step = (2 if kind == "single" else 4), time[1] - time[0]
    lines = [
        *("NONE",) * 5,
        f"{1:5d}{0:10d}{0:5d}{0:10d} {'disc':10s}{1:10d}{direction:4d} {'NONE':10s}{0:10d}{0:4d}",
        f"{number:10d}{len(time):10d}{1:10d}{time[0]:13.5E}{step:13.5E}{0:13.5E}",
        f"{17:10d}{0:5d}{0:5d}{0:5d} {'Time':20s} {'s':20s}",
        f"{8:10d}{0:5d}{0:5d}{0:5d} {'Displacement':20s} {'um':20s}",
        *(f"{0:10d}{0:5d}{0:5d}{0:5d} {'NONE':20s} {'NONE':20s}",) * 2,
    ]
    head = "\n".join(lines) + "\n"
    if kind == "binary":
        data = np.asarray(values, "<f8").tobytes()
        title = f"    58b{1:6d}{2:6d}{11:12d}{len(data):12d}{0:6d}{0:6d}{0:12d}{0:12d}"
        return f"    -1\n{title}\n{head}".encode() + data + b"\n    -1\n"
    form, columns = ("{:13.5E}", 6) if kind == "single" else ("{:20.12E}", 4)
    rows = ["".join(form.format(v) for v in values[i : i + columns]) for i in range(0, len(values), columns)]
    return f"    -1\n    58\n{head}{chr(10).join(rows)}\n    -1\n".encode()


def test_noise_of_probes_and_profiles():
    data = {**bode(), "disc y [m]": bode()["disc x [m]"], "disc y lag [rad]": bode()["disc x lag [rad]"] + np.pi / 2}
    options = {"at": {"c": "52 N s/m"}, "profile": True}
    found = whirl.fit(SPRING, data, ["k", "e"], noise={"disc x": "1 um", "disc y": 3e-6}, **options)
    assert set(np.unique(found.numbers[:, 8])) == {1e-6, 3e-6}
    for own in found.values():  # the data are exact, so profile intervals are nearly those of the linear model
        half = own.high - own.value
        assert own.profile_low == pytest.approx(own.low, abs=0.01 * half)
        assert own.profile_high == pytest.approx(own.high, abs=0.01 * half)
    assert np.isnan(whirl.fit(SPRING, data, ["e"], at={"c": 52.0, "k": 33e3})["e"].profile_low)
    with pytest.raises(whirl.BadInput, match="noise.disk x: is no probe"):
        whirl.fit(SPRING, data, ["k"], noise={"disk x": "1 um"})
    with pytest.raises(whirl.BadInput, match="'disc y' has no noise"):
        whirl.fit(SPRING, data, ["k"], noise={"disc x": "1 um"})


def test_a_missing_table_is_named_with_its_place(tmp_path):
    text = whirl.Case(SPRING).text.split("study:")[0] + "study:\n  fit: {unknown: {k: }, data: gone.csv}\n"
    (tmp_path / "a.yaml").write_text(text)
    line = text.count("\n")
    with pytest.raises(whirl.BadInput, match=rf"a.yaml:{line}:31: study.fit.data: cannot read .*gone.csv: No such"):
        whirl.run(str(tmp_path / "a.yaml"))


WHIRLING = {
    "parameters": {"n": "100 rad/s", "m": "3 kg", "k": "30 kN/m", "c": "30 N s/m", "q": "20 N s/m", "e": "50 um"},
    "rotor": {
        "speed": "= n",
        "length_scale": "1 mm",
        "stations": {"disc": {"mass": "= m", "eccentricity": "= e"}},
        "elements": [{"bearing": {"at": "disc", "kxx": "= k", "cxx": "= c", "kxy": "= q*n", "kyx": "= -q*n"}}],
    },
    "study": {"response": {}},
}


def test_thresholds_and_modes_are_those_of_least_squares():
    """Tests inexact data: the fit agrees with SciPy's least squares over the roots of m l^2 + c l + k -+ i q n."""
    optimize = pytest.importorskip("scipy.optimize")
    unit, sigma = np.array([30e3, 20.0, 30.0]), np.array([1.0, 0.1, 2 * np.pi * 0.01, 0.001])
    measured = np.array([160.0, 105.0, 2 * np.pi * 16.5, 0.1])

    def root(p, n, direction):
        k, q, c = p
        roots = np.roots([3.0, c, k - 1j * q * n])
        return roots[np.argmax(direction * roots.imag)]

    def model(p):
        critical = optimize.brentq(lambda n: root(p, n, 1).imag - n, 50, 200, xtol=1e-13)
        mode = root(p, 50.0, -1)
        return np.array([p[2] * np.sqrt(p[0] / 3) / p[1], critical, root(p, 100.0, 1).imag, -mode.real / abs(mode)])

    best = optimize.least_squares(
        lambda p: (model(p * unit) - measured) / sigma, [1, 1, 1], "3-point", xtol=1e-15, ftol=1e-15, gtol=1e-15
    )
    errors = unit * np.sqrt(np.diag(np.linalg.inv(best.jac.T @ best.jac)))
    data = [
        {"onset": "160 rad/s", "noise": "1 rad/s"},
        {"critical": "105 rad/s", "noise": "0.1 rad/s", "whirl": "forward"},
        {"frequency": "16.5 Hz", "noise": "0.01 Hz", "whirl": "forward"},
        {"damping": 0.1, "noise": 0.001, "mode": 1, "whirl": "backward", "at": {"n": "50 rad/s"}},
    ]
    found = whirl.fit(WHIRLING, data, ["k", "q", "c"], tolerance=1e-11)
    for name, value, error in zip(("k", "q", "c"), best.x * unit, errors):
        assert found[name].value == pytest.approx(value, rel=1e-7)
        assert found[name].error == pytest.approx(error, rel=1e-5)
    assert found.sum == pytest.approx(2 * best.cost, rel=1e-9)
    assert found.numbers[:, 7] == pytest.approx(model(best.x * unit), rel=1e-7)
    sheet = found.result.sheet("fit/values")
    assert list(sheet["what"])[:2] == ["onset of instability at rest", "critical speed"]
    assert not [name for name in found.result.figures() if name.startswith("fit")]  # nothing to draw


def test_numbers_and_tables_together():
    """Tests that an onset determines the damping, which amplitudes away from resonance do not."""
    n = np.arange(20.0, 60.0, 4.0)
    response = 50e-6 * n**2 / (11e3 - n**2 + 1j * n * (37.0 - 26.0) / 3)
    table = {"speed [rad/s]": n, "disc x [m]": abs(response)}
    onset = {"onset": 37.0 * np.sqrt(11e3) / 26.0, "noise": "0.5 rad/s", "at": {"q": "26 N s/m"}}
    alone = whirl.fit(WHIRLING, table, ["k", "c"], at={"q": "26 N s/m"}, noise="0.1 um")
    both = whirl.fit(WHIRLING, [table, onset], ["k", "c"], at=[{"q": "26 N s/m"}, None], noise="0.1 um")
    assert both["c"].value == pytest.approx(37.0, rel=1e-4) and both["c"].error < 0.1 * alone["c"].error


def rubbing_flow(speed, damping):
    """Returns the equations of RUBBING and of four perturbations. Contacts without damping change perturbations
    continuously."""
    e, weight, gap, wall, turn = 0.9, 1.2, 1.0, 10.0, np.array([[1.0, -0.05], [0.05, 1.0]])

    def slopes(t, z):
        place, velocity, r = z[:2], z[2:4], np.hypot(z[0], z[1])
        force = e * speed**2 * np.array([np.cos(speed * t), np.sin(speed * t)]) - place - [0.0, weight]
        stiffness = -np.eye(2)
        if r > gap:
            force -= wall * (1.0 - gap / r) * turn @ place
            stiffness = stiffness - wall * (1.0 - gap / r) * turn
            stiffness -= wall * gap / r**3 * np.outer(turn @ place, place)
        jacobian = np.block([[np.zeros((2, 2)), np.eye(2)], [stiffness, -2.0 * damping * np.eye(2)]])
        return np.concatenate([velocity, force - 2.0 * damping * velocity, (jacobian @ z[4:].reshape(4, 4)).ravel()])

    return slopes


def test_onset_by_a_doubling_of_the_period():
    """Tests the onset of a period doubling, which a rubbing rotor has when its speed falls to 5.47 rad/s. The expected
    speed is found by shooting with SciPy."""
    integrate, optimize = pytest.importorskip("scipy.integrate"), pytest.importorskip("scipy.optimize")

    def turned(speed, damping, x, tolerance=1e-11):
        start = np.concatenate([x, np.eye(4).ravel()])
        flow, longest = rubbing_flow(speed, damping), 0.05 if tolerance < 1e-9 else 0.3
        found = integrate.solve_ivp(
            flow, (0.0, 2.0 * np.pi / speed), start, "DOP853", rtol=tolerance, atol=0.1 * tolerance, max_step=longest
        )
        return found.y[:4, -1], found.y[4:, -1].reshape(4, 4)

    def orbit(speed, damping, x):
        for _ in range(12):
            end, matrix = turned(speed, damping, x)
            step = np.linalg.solve(np.eye(4) - matrix, end - x)
            x = x + step
            if abs(step).max() < 1e-10:
                break
        return x, matrix

    # Settle at 6 rad/s, then follow the orbit down to where a multiplier is -1.
    x = np.array([-0.9, -1.2, 0.0, -5.4])
    for _ in range(70):
        x = turned(6.0, 0.1, x, 1e-5)[0]
    places = {}

    def multiplier(speed, damping):
        places["x"], matrix = orbit(speed, damping, places.get("x", x))
        return np.linalg.det(matrix + np.eye(4))

    for speed in (6.0, 5.8, 5.6):
        multiplier(speed, 0.1)
    onset = optimize.brentq(multiplier, 5.42, 5.52, (0.1,), xtol=1e-10)
    ends = [optimize.brentq(multiplier, onset - 1e-3, onset + 1e-3, (p,), xtol=1e-11) for p in (0.0999, 0.1001)]
    change = (ends[1] - ends[0]) / 2e-4
    case = {
        "parameters": {"omega": "6 rad/s", "p": 0.11},
        "rotor": {
            "speed": "= omega",
            "length_scale": "1 m",
            "stations": {"disc": {"mass": "1 kg", "damping": "= 2*p", "eccentricity": 0.9}},
            "elements": [
                {"shaft": {"between": ["disc", "ground"], "k1": "1 N/m"}},
                {"rub": {"at": "disc", "gap": "1 m", "stiffness": 10, "friction": 0.05, "law": "paper"}},
                {"gravity": 1.2},
            ],
        },
        "study": {"initial": {"disc": {"x": 0.1, "y": -0.2}}, "response": {}},
    }
    data = {"onset": f"{onset!r} rad/s", "of": "orbit", "noise": "1e-3 rad/s", "from": "7 rad/s", "to": "4 rad/s"}
    found = whirl.fit(case, data, ["p"], transient=300, tolerance=1e-11)
    assert found["p"].value == pytest.approx(0.1, abs=1e-8)
    assert found["p"].error == pytest.approx(1e-3 / abs(change), rel=1e-5)


def statistics_case(elements, **parameters):
    return {
        "parameters": {"n": "100 rad/s", "e": "50 um", "c": "40 N s/m", "m": "3 kg", **parameters},
        "rotor": {
            "speed": "= n",
            "length_scale": "1 mm",
            "stations": {"disc": {"mass": "= m", "damping": "= c", "eccentricity": "= e"}},
            "elements": elements,
        },
        "study": {"response": {}},
    }


def test_quasi_periodic_motions_are_compared_by_statistics():
    """Tests a disc on a spring with a force at 0.618 of the speed. Its motion has two lines, the sum of whose
    amplitudes is the largest displacement."""
    k, c, e, f, ratio = 33e3, 52.0, 38e-6, 4.0, (np.sqrt(5) - 1) / 2
    elements = [
        {"shaft": {"between": ["disc", "ground"], "k1": "= k"}},
        {"force": {"at": "disc", "amplitude": "= f", "ratio": ratio}},
    ]
    case = statistics_case(elements, k="30 kN/m", f="3 N")
    n = np.array([80.0, 90.0, 100.0, 125.0])
    whirling = abs(e * n**2 / (k / 3 - n**2 + 1j * c * n / 3))
    forced = abs(f / (k - 3 * (ratio * n) ** 2 + 1j * c * ratio * n))
    data = {
        "speed [rad/s]": n,
        "disc x 1X [m]": whirling,
        "disc x 0.62X [m]": forced,
        "disc x max [m]": whirling + forced,
        "disc x min [m]": -whirling - forced,
        "disc y max [m]": whirling,
    }
    found = whirl.fit(case, data, ["k", "c", "e", "f"], noise="0.5 um", compare="statistics", record=96)
    assert found.end == "found"
    for name, value in {"k": k, "c": c, "e": e, "f": f}.items():
        assert found[name].value == pytest.approx(value, rel=2e-4)
    said = [own for own in found.result.statements() if own.what == "statistics"]
    assert "4 of 4 motions are compared by statistics of 96 revolutions, not as orbits" in str(said[0].found)
    assert "fit-1" in found.result.figures()
    # A fit of orbits reports that these motions have none.
    columns = {name: data[name] for name in ("speed [rad/s]", "disc x 1X [m]")}
    alone = whirl.fit(case, columns, ["k"], noise="0.5 um")
    assert alone.end == "no motion"
    assert any("compare: statistics" in str(own.found) for own in alone.result.statements())


def chaotic_share(n, e, count=32, before=60, after=100, steps=96):
    """Returns the share of the time in contact of a rubbing rotor at several speeds, by RK4 over an ensemble of
    starts."""
    w = np.repeat(n, count)
    state = np.zeros((4, len(w)))
    state[:2] = np.random.default_rng(1).uniform(-0.2, 0.2, (2, len(w)))

    def slope(t, s):
        x, y, vx, vy = s
        r = np.hypot(x, y)
        force = 10.0 * np.maximum(r - 1, 0) / np.maximum(r, 1e-12)
        drive = e * w**2
        return np.array(
            [
                vx,
                vy,
                -0.2 * vx - x - force * (x - 0.05 * y) + drive * np.cos(t),
                -0.2 * vy - y - force * (0.05 * x + y) + drive * np.sin(t) - 0.5,
            ]
        )

    h, touched = 2 * np.pi / steps, np.zeros(len(w))
    for i in range((before + after) * steps):
        t = i * h
        a = slope(t, state)
        b = slope(t + h / 2, state + h / 2 / w * a)
        c = slope(t + h / 2, state + h / 2 / w * b)
        d = slope(t + h, state + h / w * c)
        state = state + h / 6 / w * (a + 2 * b + 2 * c + d)
        if i >= before * steps:
            touched += np.hypot(state[0], state[1]) > 1
    shares = (touched / (after * steps)).reshape(len(n), count)
    return shares.mean(1), shares.std(1) / np.sqrt(count)


def test_the_share_of_contact_of_chaos_determines_the_unbalance():
    n = np.array([3.3, 3.35, 3.4])
    share, error = chaotic_share(n, 0.9)
    assert np.all(error < 0.006)
    elements = [
        {"shaft": {"between": ["disc", "ground"], "k1": "1 N/m"}},
        {"rub": {"at": "disc", "gap": "1 m", "stiffness": 10, "friction": 0.05, "law": "paper"}},
        {"gravity": 0.5},
    ]
    case = statistics_case(elements, n="3.3 rad/s", e=0.9, c="0.2 N s/m", m="1 kg")
    case["rotor"]["length_scale"] = "1 m"
    data = {"speed [rad/s]": n, "contact [%]": 100 * share}
    options = {"record": 320, "transient": 60, "difference": 0.03, "compare": "statistics"}
    found = whirl.fit(case, data, {"e": (0.87, 0.7, 1.1)}, noise={"contact": "1 %"}, **options)
    assert abs(found["e"].value - 0.9) < 3 * found["e"].error and found["e"].error < 0.02
    assert any(own.what == "statistics" for own in found.result.statements())
    sheet = found.result.sheet("fit/values")
    assert set(sheet["what"]) == {"share of the time in contact"} and len(sheet["speed"]) == 3


def test_statistics_are_asked_for():
    case = statistics_case([{"shaft": {"between": ["disc", "ground"], "k1": "= k"}}], k="30 kN/m")
    columns = {"speed [rad/s]": [80.0, 90.0]}
    for heading, words in (("disc x max [m]", "is a statistic, expected compare"), ("contact", "is a statistic")):
        with pytest.raises(whirl.BadInput, match=words):
            whirl.fit(case, {**columns, heading: [0.1, 0.1]}, ["k"], noise=1e-6)
    for heading, words in (("disc x lag [deg]", "is a lag, which statistics do not have"), ("contact", "has no noise")):
        with pytest.raises(whirl.BadInput, match=words):
            whirl.fit(case, {**columns, heading: [0.1, 0.1]}, ["k"], noise=1e-6, compare="statistics")
    with pytest.raises(whirl.BadInput, match="has no noise, expected the standard deviation of its statistics"):
        whirl.fit(case, {**columns, "disc x [m]": [0.1, 0.1]}, ["k"], compare="statistics")
    with pytest.raises(whirl.BadInput, match="column of instants, which statistics do not have"):
        data = {"angle [deg]": [0.0, 90.0], "disc x [m]": [0.1, 0.1]}
        whirl.fit(case, data, ["k"], noise=1e-6, compare="statistics")


def test_machines_without_an_onset_are_reported():
    data = {"onset": "30 rad/s", "noise": "1 rad/s"}
    found = whirl.fit(WHIRLING, data, ["k"])
    assert found.end == "no motion"
    said = " ".join(str(own.found) for own in found.result.statements())
    assert "no onset of instability at rest for number 1 of the data" in said


LIVE = """whirl: 1
parameters: {n: 100 rad/s, k: 30 kN/m, c: 40 N s/m}
rotor:
  speed: = n
  length_scale: 1 mm
  stations: {disc: {mass: 3 kg, damping: = c, eccentricity: 50 um}}
  elements: [{spring: {between: [disc, ground], stiffness: = k}}]
"""
BLOCK = "study:\n  fit:\n    unknown: {k: , c: }\n    data: bode.csv\n  initial:\n    disc: {x: 0.01}\n"
FLOW = "study: {fit: {unknown: {k: , c: },\n  data: bode.csv}, initial: {disc: {x: 0.01}}}\n"


@pytest.mark.parametrize("style", ["block", "flow", "json"])
def test_the_live_case_of_a_fit_may_have_any_style(style, tmp_path):
    """Tests that the explorer gets a case with the fitted values and a sweep in place of the fit, for any YAML
    style."""
    yaml = pytest.importorskip("yaml")
    n = np.arange(60.0, 150.0, 10.0)
    response = 50e-6 * n**2 / (33e3 / 3 - n**2 + 1j * n * 52.0 / 3)
    rows = "".join(f"{speed},{size!r}\n" for speed, size in zip(n.tolist(), abs(response).tolist()))
    (tmp_path / "bode.csv").write_text("speed [rad/s],disc x [m]\n" + rows)
    text = LIVE + (FLOW if style == "flow" else BLOCK)
    (tmp_path / "fit.yaml").write_text(json.dumps(yaml.safe_load(text)) if style == "json" else text)
    (tmp_path / "template.html").write_text("before @WHIRL-RUNS@ after")
    for arguments in (["run", "fit.yaml", "-q"], ["report", "fit.h5", "-o", "page", "--explorer", "template.html"]):
        subprocess.run([COMMAND, *arguments], cwd=tmp_path, check=True, capture_output=True)
    page = (tmp_path / "page" / "explorer.html").read_text()
    runs = json.loads(page[page.index("before ") + 7 : page.rindex(" after")])
    (live,) = [fit["case_text"] for fit in runs[0]["fits"]]
    case = yaml.safe_load(live)
    assert case["study"]["initial"] == {"disc": {"x": 0.01}} and "fit" not in case["study"]
    assert case["study"]["sweep"]["parameter"] == "n"
    assert float(case["study"]["sweep"]["from"].split()[0]) < 60.0
    assert float(case["parameters"]["k"].split()[0]) == pytest.approx(33.0, rel=1e-6)
    assert whirl.Case(text=live).outline() is not None
