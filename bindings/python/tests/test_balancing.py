"""Tests balancing of modes by sets of weights, trial weights that models propose, and a rotor on films that is balanced
in simulation."""

import re
import numpy as np
import pytest
from conftest import ROOT

import whirl

RPM = np.pi / 30
TURN = np.exp(1j * np.arange(4))  # unit vectors with unrelated angles


def weights_text(weights):
    lines = (
        f"    - unbalance: {{at: {at}, moment: {abs(u):.17g}, angle: {np.angle(u):.17g}}}"
        for at, u in weights
        if u != 0
    )
    return "\n".join(lines)


# ---------------------------------------------------------------- a rigid rotor in closed form


def rigid(weights, omega=500.0, at=(-0.3, 0.25), mass=40.0, tilt=1.3, spin=0.5, k=8e6, c=1500.0, planes=(-0.2, 0.15)):
    """Returns the complex displacement at places on a rigid rotor in two equal, isotropic bearings."""
    z = np.array([-0.3, 0.25])
    stiff = k + 1j * omega * c
    matrix = np.array([[2 * stiff, stiff * z.sum()], [stiff * z.sum(), stiff * (z * z).sum()]])
    matrix -= omega**2 * np.diag([mass, tilt - spin])
    u = np.array(weights)
    x, slope = np.linalg.solve(matrix, omega**2 * np.array([u.sum(), (u * planes).sum()]))
    return x + np.array(at) * slope


OWN = [2e-3 * np.exp(1j * np.radians(30)), 1.2e-3 * np.exp(1j * np.radians(200))]


@pytest.mark.parametrize("at", ((-0.3, 0.25), (-0.3, 0.25, 0.05)))
def test_rigid_rotor(at):
    """Tests two planes that are balanced from two and from three probes. The expected numbers for probes at the
    bearings are from an independent computation."""
    runs = [np.array(OWN), OWN + np.array([1e-3, 0]), OWN + np.array([0, 1e-3j])]
    seen = [rigid(run, at=at) for run in runs]
    assert abs(seen[0][:2]) == pytest.approx([64.84229701e-6, 10.86143703e-6], rel=1e-9)
    assert abs(seen[2][:2]) == pytest.approx([86.45933475e-6, 60.61646727e-6], rel=1e-9)
    assert np.degrees(np.angle(seen[1][:2])) == pytest.approx([10.113970, -12.644613], abs=1e-6)
    found = whirl.balance(
        {
            "angles": "with",
            "phases": "lead",
            "planes": [{"name": "near", "radius": 0.1}, {"name": "far", "radius": 0.1, "holes": 12}],
            "trials": [
                {"run": 1, "plane": "near", "moment": 1e-3, "angle": 0.0},
                {"run": 2, "plane": "far", "moment": 1e-3, "angle": np.pi / 2},
            ],
            "vibration": [
                {"run": run, "speed": 500.0, "probe": f"p{i}", "amplitude": abs(v), "phase": float(np.angle(v))}
                for run, row in enumerate(seen)
                for i, v in enumerate(row)
            ],
            "mass": 40,
            "grade": "2.5 mm/s",
            "service_speed": 500.0,
        }
    )
    for weight, own in zip(found.correction.values(), OWN):
        assert weight.number == pytest.approx(-own, rel=1e-8)
    assert found.correction["near"].mass == pytest.approx(20e-3, rel=1e-8)
    assert found.correction["far"].holes == pytest.approx({1: 0.4167556e-3, 2: 0.8208483e-3}, rel=1e-6)
    assert found.static.number == pytest.approx(-sum(OWN), rel=1e-8)
    assert found.couple.number == pytest.approx((OWN[1] - OWN[0]) / 2, rel=1e-8)
    assert found.allowed == pytest.approx(2.5e-3 * 40 / 500)
    assert found.grade == pytest.approx(1e3 * 3.2e-3 * 500 / 40, rel=1e-8)
    assert max(row.after.size for row in found.rows) < 1e-13 and found.difference is None


# ---------------------------------------------------------------- a uniform shaft on rigid supports

LENGTH, DIAMETER, DAMPING = 1.2, 0.04, 10.0
AREA, MASS = np.pi * DIAMETER**2 / 4, 7800 * np.pi * DIAMETER**2 / 4
NATURAL = [(n * np.pi / LENGTH) ** 2 * np.sqrt(210e9 * np.pi * DIAMETER**4 / 64 / MASS) for n in range(1, 12)]
SPEEDS = [0.995 * NATURAL[0], 0.995 * NATURAL[1]]
SHAFT = """
whirl: 1
parameters: {{omega: 300 rad/s}}
rotor:
  speed: = omega
  rotation: {rotation}
  length_scale: 1 um
  materials: {{own: {{modulus: 210 GPa, density: 7800 kg/m3, poisson: 0.3}}}}
  shafts: {{main: {{material: own, shear: none, rotary_inertia: no, gyroscopic: no, mass_damping: 10 1/s}}}}
  stations: {{left: {{position: 0 m}}, {stations}, right: {{position: 1.2 m}}}}
  elements:
    - segment: {{length: 1.2 m, outer: 40 mm, elements: 24}}
    - bearing: {{at: left, kxx: 1e12 N/m, kyy: 1e12 N/m}}
    - bearing: {{at: right, kxx: 1e12 N/m, kyy: 1e12 N/m}}
{weights}
study:
  unbalance: {{parameter: omega, values: {speeds}}}
"""
UNBALANCE = [(f"s{i}", u) for i, u in zip((1, 3, 4, 8), np.array([1e-4, 2e-4, 1.5e-4, 3e-4]) * TURN)]
PROBES = {"a": "s3", "b": "s6"}


def shaft_text(weights, speeds, rotation="counter-clockwise"):
    stations = ", ".join(f"s{i}: {{position: {i / 10 * LENGTH:.6g} m}}" for i in range(1, 10))
    speeds = [float(speed) for speed in speeds]
    return SHAFT.format(stations=stations, weights=weights_text(weights), speeds=speeds, rotation=rotation)


def shaft_readings(weights, speeds=SPEEDS, rotation="counter-clockwise", probes=PROBES, **how):
    case = whirl.Case(text=shaft_text(weights, speeds, rotation))
    return whirl.readings(whirl.run(case, progress=False), probes, **how)


def place(name):
    return int(name[1:]) / 10


def modal(weights, n):
    """Returns the modal sums of modes sin(n pi x/L)."""
    return sum(u * np.sin(n * np.pi * place(name)) for name, u in weights)


def shaft_closed(weights, speed, name):
    """Returns the displacement of a Bernoulli beam by sums over modes."""
    shapes = (np.sin(n * np.pi * place(name)) for n in range(1, 12))
    terms = zip(NATURAL, shapes, (modal(weights, n) for n in range(1, 12)))
    return sum(
        2 / (MASS * LENGTH) * shape * speed**2 * u / (w**2 - speed**2 + 1j * DAMPING * speed)
        for w, shape, u in terms
    )


def closed_readings(weights, run):
    seen = [
        (speed, probe, shaft_closed(weights, speed, station)) for speed in SPEEDS for probe, station in PROBES.items()
    ]
    return [
        {"run": run, "speed": float(speed), "probe": probe, "amplitude": abs(v), "phase": float(-np.angle(v))}
        for speed, probe, v in seen
    ]


def by_sets(file, planes, read):
    """Makes a trial run with each weight set of a file; returns the correction."""
    sets = whirl.balance({**file, "vibration": read([], 1)}).sets
    trials = [{"run": 2 + n, "set": n + 1, "moment": 2e-5, "angle": 1.0 + n} for n in range(len(sets))]
    rows = read([], 1)
    for n, own in enumerate(sets):
        rows += read([(p, own.weights[p].number * 2e-5 * np.exp(1j * (1.0 + n))) for p in planes], 2 + n)
    return whirl.balance({**file, "vibration": rows, "trials": trials})


def shaft_file(planes, rigid_kept):
    return {
        "angles": "with",
        "phases": "lag",
        "planes": [{"name": name, "position": place(name) * LENGTH} for name in planes],
        "keep_rigid": rigid_kept,
    }


METHODS = [(("s3", "s6"), False), (("s2", "s4", "s6", "s8"), True), (("s2", "s4", "s6", "s8"), False)]


@pytest.mark.parametrize("planes, rigid_kept", METHODS)
def test_modes_in_closed_form(planes, rigid_kept):
    """Tests N and N + 2 planes with the shapes sin(n pi x/L): each set excites only one mode, and the correction
    removes the unbalance of each mode."""
    shapes = [[float(np.sin(n * np.pi * place(p))) for p in planes] for n in (1, 2)]
    modes = [{"speed": float(speed), "shape": shape} for speed, shape in zip(SPEEDS, shapes)]
    file = {**shaft_file(planes, rigid_kept), "modes": modes}
    found = by_sets(file, planes, lambda extra, run: closed_readings(UNBALANCE + extra, run))
    for n, own in enumerate(found.sets):
        weights = [(p, own.weights[p].number) for p in planes]
        assert max(abs(u) for _, u in weights) == pytest.approx(1)
        assert abs(modal(weights, 2 - n)) < 1e-14 < abs(modal(weights, 1 + n))
        if rigid_kept:
            assert abs(sum(u for _, u in weights)) < 1e-14
            assert abs(sum(place(p) * u for p, u in weights)) < 1e-14
        # Of all weights that fulfil the conditions, the set has the least norm.
        rows = [*shapes, [1.0] * len(planes), [place(p) for p in planes]][: 4 if rigid_kept else 2]
        vector = np.array([u for _, u in weights])
        assert vector == pytest.approx(np.linalg.pinv(rows) @ (np.array(rows) @ vector), abs=1e-13)
    # Modes 3 and above disturb the readings, so up to 1 % of the modal unbalances remains.
    after = UNBALANCE + [(p, found.correction[p].number) for p in planes]
    for n in (1, 2):
        assert abs(modal(after, n)) < 0.01 * abs(modal(UNBALANCE, n))


@pytest.mark.parametrize("planes, rigid_kept", METHODS)
def test_modes_of_a_model(tmp_path, planes, rigid_kept):
    """Tests shapes of a finite element model: at both critical speeds only the response of modes 3 and above
    remains."""
    (tmp_path / "shaft.yaml").write_text(shaft_text([], SPEEDS))
    file = {
        **shaft_file(planes, rigid_kept),
        "model": str(tmp_path / "shaft.yaml"),
        "modes": [{"speed": float(speed)} for speed in SPEEDS],
        "probes": [{"name": name, "station": station} for name, station in PROBES.items()],
    }
    found = by_sets(file, planes, lambda extra, run: shaft_readings(UNBALANCE + extra, run=run))
    for n, own in enumerate(found.sets):
        weights = [(p, own.weights[p].number) for p in planes]
        assert own.natural == pytest.approx(NATURAL[n], rel=3e-4)
        assert abs(modal(weights, 2 - n)) < 1e-5 * abs(modal(weights, 1 + n))
    assert found.difference < 1e-8  # the readings are computed by the model
    after = UNBALANCE + [(p, found.correction[p].number) for p in planes]
    for old, new in zip(shaft_readings(UNBALANCE), shaft_readings(after)):
        expected = abs(shaft_closed(after, new["speed"], PROBES[new["probe"]]))
        assert new["amplitude"] == pytest.approx(expected, rel=0.05)
        assert new["amplitude"] < 0.01 * old["amplitude"]


def test_one_mode_after_the_other(tmp_path):
    """Tests that mode 1 can be balanced first and mode 2 with the first weights mounted: the second set does not excite
    mode 1."""
    planes = ("s3", "s6")
    (tmp_path / "shaft.yaml").write_text(shaft_text([], SPEEDS))
    file = {
        **shaft_file(planes, False),
        "model": str(tmp_path / "shaft.yaml"),
        "modes": [{"speed": float(speed)} for speed in SPEEDS],
        "probes": [{"name": name, "station": station} for name, station in PROBES.items()],
        "influence": "model",
    }
    on = list(UNBALANCE)
    for stage in range(2):
        found = whirl.balance({**file, "vibration": shaft_readings(on, SPEEDS[stage : stage + 1])})
        assert [own.amount is not None for own in found.sets] == [stage == 0, stage == 1]
        on += [(p, found.correction[p].number) for p in planes]
    for old, new in zip(shaft_readings(UNBALANCE), shaft_readings(on)):
        assert new["amplitude"] < 0.02 * old["amplitude"]


# ---------------------------------------------------------------- by the model alone

ROTATIONS = ("counter-clockwise", "clockwise")


def model_file(tmp_path, rotation="counter-clockwise", **more):
    (tmp_path / "shaft.yaml").write_text(shaft_text([], SPEEDS, rotation))
    return {
        "angles": "with",
        "phases": "lag",
        "planes": [{"name": "s3"}, {"name": "s8"}],
        "model": str(tmp_path / "shaft.yaml"),
        **more,
    }


@pytest.mark.parametrize("rotation", ROTATIONS)
@pytest.mark.parametrize("angles", ("with", "against"))
def test_without_trial_runs(tmp_path, rotation, angles):
    """Tests that the correction is the unbalance turned by 180 degrees, for any position of the mark, and for all
    notations of angles and sizes."""
    own = [("s3", 2e-4 * np.exp(0.7j)), ("s8", 1e-4 * np.exp(2.2j))]
    probes = {"a": ("s2", 0.6), "b": ("s7", -1.1)}
    rows = shaft_readings(own, [250.0, 700.0], rotation, probes, keyphasor=0.4, phases="lead")
    for row in rows:
        row["amplitude"] *= 2
    file = model_file(tmp_path, rotation, influence="model", amplitudes="p-p", keyphasor=0.4, vibration=rows)
    file.update(angles=angles, phases="lead")
    file["probes"] = [{"name": name, "station": at, "angle": angle} for name, (at, angle) in probes.items()]
    found = whirl.balance(file)
    # Angles of a case are counted from x towards y, that is against the rotation of a rotor that turns clockwise.
    same = (rotation == "clockwise") == (angles == "against")
    for at, u in own:
        weight = found.correction[at].number
        assert (weight if same else np.conj(weight)) == pytest.approx(-u, rel=1e-7)


def test_error_of_the_model(tmp_path):
    """Tests that `worst` is the larger of the vibrations that remain if critical speeds are higher or lower by the
    error."""
    rows = shaft_readings(UNBALANCE, [250.0], probes={"s2": "s2", "s7": "s7"})
    found = whirl.balance(model_file(tmp_path, influence="model", model_error=0.05, vibration=rows))
    before = [row.before.size * np.exp(-1j * row.before.angle) for row in found.rows]
    left = []
    for factor in (0.95, 1.05):
        effect = [0, 0]
        for plane, weight in found.correction.items():
            seen = shaft_readings([(plane, weight.number)], [250.0 * factor], probes={"s2": "s2", "s7": "s7"})
            effect = [one + row["amplitude"] * np.exp(-1j * row["phase"]) for one, row in zip(effect, seen)]
        left.append([abs(b + e) for b, e in zip(before, effect)])
    assert [row.worst for row in found.rows] == pytest.approx(np.max(left, axis=0), rel=1e-6)
    assert all(row.after.size < 1e-9 * row.before.size for row in found.rows)


# ---------------------------------------------------------------- trial weights


def propose(tmp_path, unbalance, speed, second=0.5 * np.exp(1j), **probe):
    """Returns proposals for two planes, with the readings of two probes before and after each."""
    own = [("s3", unbalance), ("s8", second * unbalance)]
    probes = {"s3": "s3", "s7": "s7"}
    rows = shaft_readings(own, [speed], probes=probes)
    file = model_file(tmp_path, vibration=rows, probes=[{"name": "s3", **probe}])
    found = whirl.balance(file)
    after = []
    for one in found.proposals:
        seen = shaft_readings(own + [(one.plane, one.moment * np.exp(1j * one.angle))], [speed], probes=probes)
        after.append([row["amplitude"] for row in seen])
    return found, np.array([row["amplitude"] for row in rows]), np.array(after)


def test_trial_weight_by_its_force(tmp_path):
    """Tests that the force of a trial weight is a tenth of the load of a bearing (half of the shaft's weight), if that
    changes readings by 30 to 100 %."""
    found, before, after = propose(tmp_path, 1.2e-4, 250.0)
    rows = shaft_readings([("s3", 1.2e-4), ("s8", 0.6e-4 * np.exp(1j))], [250.0], probes={"s3": "s3", "s7": "s7"})
    file = model_file(tmp_path, vibration=rows, probes=[{"name": "s3"}])
    for one, seen in zip(found.proposals, after):
        assert one.reason == "force" and "a tenth of the 57.67 N" in one.sentence
        pounds = [own for own in whirl.balance(file, units="US").proposals if own.plane == one.plane]
        force = float(re.search(r"a tenth of the (\S+) lbf", pounds[0].sentence)[1])
        assert force == pytest.approx(57.67 / 4.4482216, rel=1e-3) and pounds[0].moment == one.moment
        assert one.moment == pytest.approx(0.1 * MASS * LENGTH * 9.80665 / 2 / 250.0**2, rel=1e-6)
        assert 0.3 < one.change < 1 and (seen < before).all()
    assert not found.warnings and not found.correction and found.proposals[0].plane == "s3"


@pytest.mark.parametrize("unbalance, reason, share", ((1e-3, "least", 0.3), (1e-5, "most", 1.0)))
def test_trial_weight_by_the_measured_change(tmp_path, unbalance, reason, share):
    found, before, after = propose(tmp_path, unbalance, 250.0)
    for one, seen in zip(found.proposals, after):
        assert one.reason == reason and one.change == pytest.approx(share)
        assert (seen**2).sum() < (before**2).sum()


def test_trial_weight_by_repeatability(tmp_path):
    """Tests a probe with a repeatability: the trial weight changes its reading by 5 times the repeatability."""
    rows = shaft_readings(UNBALANCE, [250.0], probes={"s3": "s3"})
    file = model_file(tmp_path, vibration=rows, probes=[{"name": "s3", "repeatability": 0.4 * rows[0]["amplitude"]}])
    for one in whirl.balance(file).proposals:
        assert one.reason == "least" and one.change == pytest.approx(2.0)


def test_trial_weight_within_limits(tmp_path):
    """Tests an unbalance couple between the critical speeds: the trial weight reduces the sum of squares, but raises
    the vibration of one probe, whose limit then limits the weight."""
    speed, couple = 700.0, -0.8
    found, before, after = propose(tmp_path, 2e-4, speed, couple)
    rising = [(n, seen[0] / before[0]) for n, seen in enumerate(after) if seen[0] > before[0]]
    assert rising
    n, factor = rising[0]
    limit = before[0] * (1 + 0.3 * (factor - 1))
    found, _, seen = propose(tmp_path, 2e-4, speed, couple, limit=limit)
    assert found.proposals[n].reason == "limit" and seen[n][0] == pytest.approx(limit, rel=1e-6)
    assert any("changes no probe by 30 %" in text for text in found.warnings)
    # The vibration of the probe is already above its limit, and the trial weight would raise it.
    found, _, seen = propose(tmp_path, 2e-4, speed, couple, limit=0.5 * before[0])
    (warning,) = [text for text in found.warnings if f"trial weight of {found.proposals[n].plane}:" in text]
    assert f"the model predicts {seen[n][0] * 1e6:.4g} um for s3" in warning and "above its limit" in warning


# ---------------------------------------------------------------- a machine that is not linear

FILMS = """
whirl: 1
parameters: {{omega: 4000 rpm, c: 100 um}}
rotor:
  speed: = omega
  length_scale: = c
  shafts: {{main: {{modes: 4, stiffness_damping: 5e-6 s}}}}
  stations:
    left: {{position: 0 mm}}
    near: {{position: 250 mm}}
    far: {{position: 500 mm}}
    right: {{position: 750 mm}}
  elements:
    - segment: {{length: 750 mm, outer: 60 mm, elements: 15}}
    - disc: {{at: near, outer: 280 mm, inner: 60 mm, width: 30 mm}}
    - disc: {{at: far, outer: 280 mm, inner: 60 mm, width: 30 mm}}
    - film: {{at: left, clearance: = c, viscosity: 20 mPa.s, radius: 25 mm, length: 25 mm}}
    - film: {{at: right, clearance: = c, viscosity: 20 mPa.s, radius: 25 mm, length: 25 mm}}
    - gravity
{weights}
study:
  response:
  initial: {{left: {{y: -0.6}}, near: {{y: -0.7}}, far: {{y: -0.7}}, right: {{y: -0.6}}}}
  integrate: {{method: rodas5p, rtol: 1e-6, atol: 1e-9, transient: 200, record: 16}}
  analyze: [spectrum, regime]
"""


def test_films_in_simulation(tmp_path):
    """Tests a rotor whose journals move over half of their clearance. The linear model is wrong for such motions, so
    that vibration remains after the first and second correction; after the third it vanishes."""
    probes = {"de": ("left", np.pi / 4), "nde": ("right", np.pi / 4)}
    (tmp_path / "films.yaml").write_text(FILMS.format(weights=""))
    on = [("near", 2e-3 * np.exp(1j)), ("far", 1.4e-3 * np.exp(3.5j))]
    file = {
        "angles": "with",
        "phases": "lag",
        "planes": [{"name": "near"}, {"name": "far"}],
        "model": str(tmp_path / "films.yaml"),
        "probes": [{"name": name, "station": at, "angle": angle} for name, (at, angle) in probes.items()],
    }

    def read(weights, run=1):
        result = whirl.run(whirl.Case(text=FILMS.format(weights=weights_text(weights))), progress=False, threads=1)
        assert result["response"].verdicts[0] == "P-1"
        return whirl.readings(result, probes, run=run)

    rows, largest, differences = read(on), [], []
    for _ in range(3):
        largest.append(max(row["amplitude"] for row in rows))
        trials, all_rows = [], list(rows)
        for run, one in enumerate(whirl.balance({**file, "vibration": rows}).proposals, 2):
            trials.append({"run": run, "plane": one.plane, "moment": one.moment, "angle": one.angle})
            all_rows += read([*on, (one.plane, one.moment * np.exp(1j * one.angle))], run)
        found = whirl.balance({**file, "vibration": all_rows, "trials": trials})
        differences.append(found.difference)
        on += [(plane, weight.number) for plane, weight in found.correction.items()]
        rows = read(on)
    largest.append(max(row["amplitude"] for row in rows))
    assert largest[0] > 30e-6 and largest[-1] < 1e-8 and sorted(largest, reverse=True) == largest
    assert differences[0] > 0.2 > 0.01 > differences[-1]
    for plane in ("near", "far"):
        assert abs(sum(u for at, u in on if at == plane)) < 1e-6  # kg m; the unbalances were about 2e-3


def test_example_of_the_guide(tmp_path, monkeypatch, capsys):
    """Tests that the example of the guide prints the unbalance of one plane, turned by 180 degrees, as the guide
    shows."""
    guide = (ROOT / "docs/guide/14-balancing.md").read_text()
    blocks = [block.split("\n", 1) for block in guide.split("```")[1::2]]
    (case,) = [text for kind, text in blocks if text.startswith("# tested: blower.yaml")]
    at = next(i for i, (kind, _) in enumerate(blocks) if kind == "python")
    (tmp_path / "blower.yaml").write_text(case)
    monkeypatch.chdir(tmp_path)
    exec(compile(blocks[at][1], "guide", "exec"), {})
    assert capsys.readouterr().out == blocks[at + 1][1] == f"900 g mm at {180 + np.degrees(0.7):.6g} deg\n"


# ---------------------------------------------------------------- what is refused

GOOD = {
    "angles": "with",
    "phases": "lag",
    "planes": [{"name": "s3"}, {"name": "s8"}],
    "vibration": [{"run": 1, "speed": 300.0, "probe": "s2", "amplitude": 1e-5, "phase": 0.1}],
}


@pytest.mark.parametrize(
    "change, sentence",
    [
        ({}, r"trials: is missing, and there is no model, mode or coefficient$"),
        ({"influence": "model"}, r"influence: is model, expected the key model as well$"),
        ({"modes": [{"speed": 300.0}]}, r"modes\[1\]\.shape: is missing, and there is no model that would give it$"),
        ({"modes": [{"speed": 300.0, "shape": [1]}]}, r"shape: is a list, expected a list of 2 numbers, one for every"),
        ({"modes": [{"speed": 300.0, "shape": [1, "x"]}]}, r"shape\[2\]: is x, expected a plain number$"),
        ({"modes": [{"speed": 300.0, "shape": [1, 1]}] * 2}, r"modes\[2\]: is a second mode at that speed"),
        (
            {"modes": [{"speed": 300.0, "shape": [1, 1]}], "keep_rigid": "yes"},
            "2 planes, expected 3 for 1 mode and the r",
        ),
        (
            {"modes": [{"speed": 300.0, "shape": [1, 1]}, {"speed": 400.0, "shape": [2, 2]}]},
            "planes do not distinguish the 2 modes",
        ),
        ({"keep_rigid": "yes"}, r"keep_rigid: applies only to weight sets: add modes"),
        (
            {"trials": [{"run": 1, "set": 2, "moment": 1e-3, "angle": 0.1}]},
            r"trials\[1\]\.set: is 2, and there are 0 mod",
        ),
        ({"trials": [{"run": 1, "moment": 1e-3, "angle": 0.1}]}, r"trials\[1\]: expected either plane or set$"),
        (
            {"probes": [{"name": "s2"}] * 2, "model": "m"},
            r"probes\[2\]: is a second probe 's2', expected names of their",
        ),
        ({"model": "none.yaml"}, r"none\.yaml"),
    ],
)
def test_refused(change, sentence):
    with pytest.raises(whirl.BadInput, match=sentence):
        whirl.balance({**GOOD, **change})


def test_readings_in_a_table_and_the_least_largest(tmp_path):
    """Tests two probes and one plane: minimizing the largest vibration makes both probes equal; least squares has the
    smaller sum of squares."""
    rows = "run,speed,probe,real [um],imag [um]\n1,300,a,5,0\n1,300,b,1,0\n2,300,a,3,0\n2,300,b,0,1\n"
    (tmp_path / "readings.csv").write_text(rows)
    file = {
        "angles": "with",
        "phases": "lag",
        "planes": [{"name": "p"}],
        "trials": [{"run": 2, "plane": "p", "moment": 1e-3, "angle": 0.0}],
        "vibration": str(tmp_path / "readings.csv"),
    }
    found = {least: whirl.balance({**file, "least": least}) for least in ("squares", "max")}
    left = {least: [row.after.size for row in found[least].rows] for least in found}
    assert found["max"].least == "max" and found["squares"].least == "squares"
    assert left["max"][0] == pytest.approx(left["max"][1], rel=1e-9)
    assert found["max"].left == pytest.approx(max(left["max"]), rel=1e-9)
    assert max(left["max"]) < max(left["squares"]) and sum(a * a for a in left["squares"]) < sum(
        a * a for a in left["max"]
    )


def test_stations_of_the_model(tmp_path):
    file = model_file(tmp_path, vibration=GOOD["vibration"], planes=[{"name": "s3"}, {"name": "hub", "station": "s99"}])
    with pytest.raises(whirl.BadInput, match="plane 'hub' is at station 's99', which the model lacks, did you mean s9"):
        whirl.balance(file)


def test_readings_need_a_spectrum():
    case = whirl.Case(text=shaft_text([], SPEEDS).replace("unbalance:", "modes:"))
    with pytest.raises(whirl.BadInput, match="no table of the result has motions once a revolution"):
        whirl.readings(whirl.run(case, progress=False))
    with pytest.raises(whirl.BadInput, match="phases are 'lags', expected lag or lead"):
        shaft_readings([], phases="lags")
