"""Tests bearings of pads as elements of a machine: the equilibrium of the journal and its motions agree with reference
values on which two independent methods agree (tests/validation/test_pads.c)."""

import numpy as np
import pytest

import whirl

SPEED, VISCOSITY, RADIUS, CLEARANCE, GRAVITY = 628.3185307179586, 0.02, 0.05, 1e-4, 9.80665

CASE = """
whirl: 1
rotor:
  speed: {speed} rad/s
  length_scale: 0.1 mm
  stations:
    journal: {{mass: {mass} kg}}
  elements:
    - gravity: {{}}
    - unbalance: {{at: journal, moment: {moment} kg.m}}
    - {kind}: {{at: journal, clearance: 0.1 mm, viscosity: 20 mPa.s, radius: 50 mm, length: {length} m, {keys}}}
study:
{study}
"""


def strength(ratio):
    """Returns mu Omega R L (R/c)^2."""
    return VISCOSITY * SPEED * RADIUS * 2 * RADIUS * ratio * (RADIUS / CLEARANCE) ** 2


def run(kind, keys, ratio, load, study):
    """Runs a mass with an unbalance of 1e-4 of the clearance; its weight is `load` times strength(ratio)."""
    mass = load * strength(ratio) / GRAVITY
    text = CASE.format(
        speed=SPEED,
        mass=mass,
        moment=1e-4 * mass * CLEARANCE,
        length=2 * RADIUS * ratio,
        kind=kind,
        keys=keys,
        study=study,
    )
    return mass, whirl.run(whirl.Case(text=text), progress=False)


def in_newtons(of_load, weight):
    """Returns K (or C Omega) in the frame of the case from K c/W (or C c Omega/W) in Lund's frame, whose x axis is
    along the load."""
    k = np.array(of_load, float).reshape(2, 2) * weight / CLEARANCE
    turn = np.array([[0, -1], [1, 0]], float)  # rows: axes of Lund's frame; the load is along -y
    return turn.T @ k @ turn


ROWS = {
    ("elliptical", 0.5, 0.5, 0.4): (
        (0.28524461, -0.03526400),
        (7.1951, 4.0038, -3.1440, 1.1600),
        (11.5128, -1.7321, -1.7321, 3.7053),
    ),
    ("two-groove", 0, 0.5, 0.379): (
        (0.40645939, -0.39910856),
        (3.3125, 3.6596, -0.4441, 1.7042),
        (6.7893, 1.9032, 1.9032, 1.9383),
    ),
}


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row[0])
def test_fixed_pads(row):
    """Tests that the equilibrium agrees to 2e-3 of the clearance, and the slowest eigenvalue to 1 % with that of the
    published K and C."""
    shape, preload, ratio, sommerfeld = row
    place, stiffness, damping = ROWS[row]
    load = 1 / (np.pi * sommerfeld)
    mass, result = run("pad_bearing", f"shape: {shape}, preload: {preload}", ratio, load, "  modes: {}")
    modes = result["modes"]
    assert np.squeeze(modes["modes/rest"]) == pytest.approx(place, abs=2e-3)
    k, c = (in_newtons(one, mass * GRAVITY) for one in (stiffness, damping))
    c /= SPEED
    states = np.block([[np.zeros((2, 2)), np.eye(2)], [-k / mass, -c / mass]])
    slowest = max(np.linalg.eigvals(states), key=lambda root: root.real)
    growth = np.squeeze(modes["modes/stability"])
    assert growth == pytest.approx(slowest.real, abs=0.01 * abs(slowest))


@pytest.mark.parametrize("keys, method", [("inertia: 1e-5 kg m2", "rodas5p"), ("count: 1", "dop853")])
def test_tilting_pads(keys, method):
    """Tests five pads with the load between two of them. The unbalance response and the amplitude of the motion agree
    to 1 % with the reduced coefficients at the whirl ratio 1."""
    load, reduced = 1 / (np.pi * 0.5), ((6.47468, 7.60997), (7.40401, 8.13164))
    study = f"""  unbalance: {{}}
  response: {{}}
  integrate: {{method: {method}, transient: 30, record: 4}}
  analyze: [poincare, regime, spectrum]
"""
    mass, result = run("tilting_pad", f"shape: tilting-5, preload: 0.5, {keys}", 0.5, load, study)
    weight = mass * GRAVITY
    k, c = (np.array(one) * weight / CLEARANCE for one in reduced)
    force = 1e-4 * mass * CLEARANCE * SPEED**2
    expected = np.abs(force / (k + 1j * c - mass * SPEED**2)) / 1e-4
    for name, table in (("unbalance/amplitude", "unbalance"), ("spectrum/synchronous", "response")):
        found = np.squeeze(result[table][name])[:2]
        assert found == pytest.approx(expected, rel=0.01), name


@pytest.mark.parametrize("shape", ["three-lobe", "four-lobe", "offset-half", "tilting-4"])
def test_every_usual_bearing_rests_as_by_itself(shape):
    load, tilts = 0.4, shape.startswith("tilting")
    keys = f"shape: {shape}, preload: 0.4" + (", inertia: 1e-4 kg m2" if tilts else "")
    mass, result = run("tilting_pad" if tilts else "pad_bearing", keys, 0.5, load, "  modes: {}")
    file = {"kind": shape, "preload": 0.4, "radius": RADIUS, "length": RADIUS, "pad_clearance": CLEARANCE}
    alone = whirl.bearing({**file, "viscosity": VISCOSITY, "speed": SPEED, "load": mass * GRAVITY})
    assert np.squeeze(result["modes"]["modes/rest"]) * 1e-4 == pytest.approx(alone.place[0], abs=2e-3 * CLEARANCE)


@pytest.mark.parametrize("inertia", [1e-4, 0])
def test_pivots_that_yield(inertia):
    """Tests elastic pivots: the response to unbalance and the motion agree with the reduced coefficients of the bearing
    computed without a rotor; very stiff pivots give the result of rigid ones."""
    load, keys = 1 / (np.pi * 0.5), f"shape: tilting-5, preload: 0.5, inertia: {inertia} kg m2"
    pivot = {"pivot_stiffness": 2e8, "pivot_damping": 2e4, "pad_mass": 0.8}
    study = """  unbalance: {}
  response: {}
  integrate: {method: rodas5p, transient: 40, record: 4}
  analyze: [poincare, regime, spectrum]
"""
    said = ", ".join(f"{key}: {value}" for key, value in pivot.items())
    mass, result = run("tilting_pad", f"{keys}, {said}", 0.5, load, study)
    file = {"kind": "tilting-5", "preload": 0.5, "radius": RADIUS, "length": RADIUS, "pad_clearance": CLEARANCE}
    file |= {"viscosity": VISCOSITY, "speed": SPEED, "load": mass * GRAVITY, "pad_inertia": 1e-4}
    alone = whirl.bearing({**file, **pivot})  # an inertia of 1e-4 has hardly any effect
    force = 1e-4 * mass * CLEARANCE * SPEED**2
    z = np.diag(alone.stiffness[0]) + 1j * SPEED * np.diag(alone.damping[0]) - mass * SPEED**2
    expected = np.abs(force / z) / CLEARANCE
    for name, table in (("unbalance/amplitude", "unbalance"), ("spectrum/synchronous", "response")):
        assert np.squeeze(result[table][name])[:2] == pytest.approx(expected, rel=0.01), name
    rigid = np.squeeze(run("tilting_pad", keys, 0.5, load, "  unbalance: {}")[1]["unbalance"]["unbalance/amplitude"])
    stiff = run("tilting_pad", f"{keys}, pivot_stiffness: 1e15, pad_mass: 0.8", 0.5, load, "  unbalance: {}")[1]
    assert np.squeeze(stiff["unbalance"]["unbalance/amplitude"]) == pytest.approx(rigid, rel=1e-6)
    assert abs(expected / rigid[:2] - 1).max() > 0.1  # elastic pivots change the response


def test_without_inertia_all_else():
    """Tests that turbulent films on elastic pivots have the same equilibrium and response with pads of a tiny inertia
    and without inertia."""
    oil = "density: 4000 kg/m3, turbulence: ng-pan, pivot_stiffness: 2e8, pivot_damping: 2e4, pad_mass: 0.8"
    keys, rests = f"shape: tilting-5, preload: 0.5, tilt_stiffness: 20 N.m/rad, {oil}", {}
    for inertia in (1e-6, 0):
        found = run("tilting_pad", f"{keys}, inertia: {inertia} kg m2", 0.5, 1 / np.pi, "  modes: {}\n  unbalance: {}")[
            1
        ]
        rests[inertia] = [found["modes"]["modes/rest"], found["unbalance"]["unbalance/amplitude"]]
    for one, other in zip(*rests.values()):
        assert np.squeeze(other)[:2] == pytest.approx(np.squeeze(one)[:2], rel=1e-3, abs=1e-9)


def test_turbulent_pads():
    """Tests that equilibrium and growth of the slowest mode are those of the bearing computed without a rotor, with the
    same turbulence factors."""
    load, ratio, speed, study = 0.5, 0.5, SPEED, "  modes: {}"
    oil = ", density: 4000, turbulence: ng-pan"  # Reynolds number 628
    mass, result = run("pad_bearing", "shape: two-groove" + oil, ratio, load, study)
    file = {"kind": "two-groove", "radius": RADIUS, "length": 2 * RADIUS * ratio, "clearance": CLEARANCE}
    file |= {"viscosity": VISCOSITY, "density": 4000, "speed": speed, "load": mass * GRAVITY}
    alone, laminar = whirl.bearing({**file, "turbulence": "ng-pan"}), whirl.bearing(file)
    rest = np.squeeze(result["modes"]["modes/rest"]) * 1e-4
    assert rest == pytest.approx(alone.place[0], abs=2e-3 * CLEARANCE)
    assert abs(laminar.place[0] - alone.place[0]).max() > 0.02 * CLEARANCE
    block = [[np.zeros((2, 2)), np.eye(2)], [-alone.stiffness[0] / mass, -alone.damping[0] / mass]]
    slowest = max(np.linalg.eigvals(np.block(block)), key=lambda root: root.real)
    assert np.squeeze(result["modes"]["modes/stability"]) == pytest.approx(slowest.real, abs=0.01 * abs(slowest))


def test_journals_of_other_shafts():
    """Tests that the films of a shaft with a speed ratio are those of a rotor that turns at the shaft's speed, in
    either direction."""

    def modes(speed, ratio, shape, more=""):
        text = f"""
whirl: 1
rotor:
  speed: {speed} rad/s
  length_scale: 0.1 mm
  shafts: {{low: {{}}, own: {{ratio: {ratio}}}}}
  stations:
    slow: {{shaft: low, position: 0 m}}
    other: {{shaft: low, position: 0.2 m}}
    a: {{shaft: own, position: 0 m, mass: 20 kg}}
    b: {{shaft: own, position: 0.3 m, mass: 20 kg}}
  elements:
    - gravity: {{}}
    - segment: {{shaft: low, length: 0.2 m, outer: 20 mm}}
    - segment: {{shaft: own, length: 0.3 m, outer: 80 mm}}
    - spring: {{between: [slow, ground], stiffness: 1e8 N/m, damping: 1e4 N s/m}}
    - spring: {{between: [other, ground], stiffness: 1e8 N/m, damping: 1e4 N s/m}}
    - pad_bearing: {{at: a, {shape}, clearance: 0.1 mm, viscosity: 20 mPa.s, radius: 40 mm, length: 40 mm}}
    - pad_bearing: {{at: b, {shape}, clearance: 0.1 mm, viscosity: 20 mPa.s, radius: 40 mm, length: 40 mm}}
{more}
study:
  modes: {{}}
"""
        found = whirl.run(whirl.Case(text=text), progress=False)["modes"]
        return np.squeeze(found["modes/rest"]), np.squeeze(found["modes/stability"])

    shape = "shape: elliptical, preload: 0.3"
    rest, growth = modes(300, 1, shape)
    for speed, ratio in ((150, 2), (600, 0.5)):
        own, grown = modes(speed, ratio, shape)
        assert own == pytest.approx(rest, abs=1e-8) and grown == pytest.approx(growth, rel=1e-6)
    back, _ = modes(150, -2, shape)  # turning backwards gives the mirror image
    assert np.abs(back) == pytest.approx(np.abs(rest), abs=1e-8) and not np.allclose(back, rest)
    # A film between two shafts takes the speeds of both; pads are not allowed there.
    film = "    - film: {at: slow, from: a, law: finite, clearance: 1 mm, viscosity: 0.1 Pa.s"
    film += ", radius: 3 cm, length: 3 cm"
    own, _ = modes(150, 2, shape, film + "}")
    given, _ = modes(150, 2, shape, film + ", housing_ratio: 2}")
    other, _ = modes(150, 2, shape, film + ", housing_ratio: 0}")
    assert np.array_equal(own, given) and not np.allclose(own, other, atol=1e-6)
    with pytest.raises(whirl.Error, match="has its pads on a shaft that turns"):
        modes(150, 2, shape, "    - pad_bearing" + film[10:].replace("law: finite", shape) + "}")


TRANSIENT = """  response: {{}}
  integrate: {{method: {method}, rtol: 1e-7, transient: 0, record: 1, settle: no}}
  initial: {{journal: {{x: 0.2, y: 0.3}}}}
  analyze: [poincare]
"""


@pytest.mark.parametrize("keys", ["tilt_stiffness: 20 N.m/rad", "offset: 0.6", "tilt_damping: 0.4 N.m.s/rad"])
def test_without_inertia(keys):
    """Tests a journal that is released and falls, so that some pads are unloaded. With both methods, pads without
    inertia give the motion of pads with 1e-6 kg m2. It agrees to 2e-4 of the clearance, limited by the least damping
    that pads without inertia have, and to 2e-6 if pads are damped more.
    """
    load, ends = 1 / (np.pi * 0.5), {}
    shape = "shape: tilting-5"
    if keys.startswith("offset"):
        shape = "pivots: [18 deg, 90 deg, 162 deg, 234 deg, 306 deg], arc: 60 deg"
    for inertia, method in ((0, "dop853"), (0, "rodas5p"), (1e-6, "rodas5p")):
        study = TRANSIENT.format(method=method)
        _, result = run("tilting_pad", f"{shape}, preload: 0.4, {keys}, inertia: {inertia} kg m2", 0.5, load, study)
        ends[inertia, method] = np.squeeze(result["response"]["poincare/section"])[:2]
    assert ends[0, "rodas5p"] == pytest.approx(ends[0, "dop853"], abs=1e-6)
    assert ends[1e-6, "rodas5p"] == pytest.approx(
        ends[0, "dop853"], abs=2e-4 if keys.startswith(("tilt_s", "off")) else 2e-6
    )


def test_wrong_options():
    for keys, wrong in (
        ("shape: elliptical, pivots: [90 deg]", "has both shape and pivots"),
        ("preload: 0.5", "has neither shape nor pivots"),
        ("pivots: [90 deg, 270 deg]", "has pivots without arc"),
        ("shape: elliptical, arc: 100 deg", "has arc and shape"),
        ("shape: two-groove, turbulence: ng-pan", "expected the oil's density"),
    ):
        with pytest.raises(whirl.Error, match=wrong):
            run("pad_bearing", keys, 0.5, 0.5, "  modes: {}")
    for keys, wrong in (
        ("pivot_stiffness: 1e8", "has pivot_stiffness without pad_mass"),
        ("pad_mass: 1", "has pad_mass without pivot_stiffness"),
    ):
        with pytest.raises(whirl.Error, match=wrong):
            run("tilting_pad", f"shape: tilting-5, inertia: 1e-4, {keys}", 0.5, 0.5, "  modes: {}")
