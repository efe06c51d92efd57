"""Tests that a machine that turns clockwise is the mirror image (x becomes -x) of one that turns counter-clockwise."""

import copy
import re
import subprocess

import numpy as np
import pytest
import yaml
from conftest import COMMAND, ROOT

import whirl

# Keys that the mirror image changes, by the kind of the element. ANGLES: an angle a from the x axis becomes 180 degrees
# - a; the number is the default of an absent key, None: an absent key stays absent. SIGNS: numbers that change their
# sign. Gravity and seats act along y and do not change.
ANGLES = {
    "disc": {"eccentricity_angle": 0},
    "unbalance": {"angle": 0},
    "force": {"angle": 0},
    "crack": {"angle": 0},
    "ball_bearing": {"angle": 0, "inner_dent_angle": 0, "outer_dent_angle": 0},
    "roller_bearing": {"angle": 0, "inner_dent_angle": 0, "outer_dent_angle": 0},
    "contact": {"arc_middle": 0},
    "blade_rub": {"angle": 0},
    "magnetic": {"angle": None},
    "gravity": {"direction": None},
    "segment": {"flats_angle": None},
    "coupling": {"bore_angle": 0, "face_angle": 0},
    "joint": {"direction": 0, "yoke": 0},
    "unbalance_grade": {"angle": 0, "second_angle": None},
    "runout": {"angle": None},
    "gear": {"direction": 0},
}
SIGNS = {
    "bearing": ("kxy", "kyx", "cxy", "cyx", "mxy", "sideways"),
    "coupling_load": ("x1", "x2"),
    "gear": ("pressure_angle",),
    "pad_bearing": ("turned",),
    "tilting_pad": ("turned",),
}
ALIKE = (
    "beam cubic_spring drive fatigue film floating_ring friction induction_motor looseness mount pulsation rub seal "
    "shaft short_circuit spring squeeze stage synchronous_start timed_torque".split()
)

TWISTING = ("gear-rattle", "motor-start")  # cases in which no station moves laterally
CASES = [
    path for path in sorted((ROOT / "cases").glob("*.yaml")) if "claims" not in path.name and path.stem not in TWISTING
]
CASES += sorted((ROOT / "tests/references/motions").glob("*.yaml"))
CASES += [ROOT / "bindings/python/tests" / name for name in ("pads.yaml", "whirl-table.yaml")]


def from_other_side(angle):
    words = re.match(r"^(= *)?(.*)$", str(angle)).group
    if words(1):
        return f"= {np.pi!r} - ({words(2)})"
    number, _, unit = words(2).partition(" ")
    return f"{180 - float(number)} deg" if unit == "deg" else f"= {np.pi!r} - ({number})"


def turned_round(value):
    if isinstance(value, list):
        return [turned_round(one) for one in value]
    text = str(value)
    return f"= -({text[1:]})" if text.startswith("=") else text[1:] if text.startswith("-") else "-" + text


def mirror_keys(kind, keys):
    for key, absent in ANGLES.get(kind, {}).items():
        if keys.get(key, absent) is not None:
            keys[key] = from_other_side(keys.get(key, absent))
    for key in SIGNS.get(kind, ()):
        if key in keys:
            keys[key] = turned_round(keys[key])


def mirrored(case):
    case = copy.deepcopy(case)
    rotor = case["rotor"]
    rotor["rotation"] = "clockwise"
    for state in case["study"].get("initial", {}).values():
        state.update({key: turned_round(state[key]) for key in ("x", "vx") if key in state})
    for station in rotor["stations"].values():
        for size, angle in (("eccentricity", "eccentricity_angle"), ("skew", "skew_angle")):
            if size in station:
                station[angle] = from_other_side(station.get(angle, 0))
    for element in rotor.get("elements") or []:
        for kind, keys in element.items() if isinstance(element, dict) else ():
            if isinstance(keys, dict):
                mirror_keys(kind, keys)
    return case


def short(path):
    """Makes a case of five revolutions from an eccentric start."""
    case = yaml.load(path.read_text(), yaml.BaseLoader)
    how = case["study"].get("integrate", {})
    how = {key: how[key] for key in ("method", "steps_per_revolution") if key in how}
    first = next((name for name, keys in case["rotor"]["stations"].items() if "moves" not in (keys or {})), None)
    case["study"] = {
        "response": {},
        "initial": {first: {"x": 0.01, "y": -0.02}} if first else {},
        "integrate": {**how, "rtol": "1e-10", "transient": 1, "record": 4, "watch": 4},
        "analyze": ["poincare", "orbit", "winding", "spectrum"],
    }
    return case


def kinds_of(case):
    return {kind for one in case["rotor"].get("elements") or [] for kind in ([one] if isinstance(one, str) else one)}


def test_every_kind_of_element_has_its_mirror_image():
    reported = set(ANGLES) | set(SIGNS) | set(ALIKE)
    listed = subprocess.run([COMMAND, "describe"], capture_output=True, text=True, check=True).stdout
    part = listed[listed.index("\nelements:") :].split("\n\n")[0]
    assert set(re.findall(r"^  (\w+)", part, re.M)) == reported
    assert set().union(*(kinds_of(short(path)) for path in CASES)) == reported


@pytest.mark.parametrize("path", CASES, ids=lambda path: path.stem)
def test_a_clockwise_machine_is_the_mirror_image(path):
    case = short(path)
    ours, theirs = (whirl.run(whirl.Case(one), progress=False)["response"] for one in (case, mirrored(case)))
    sign = np.array([-1.0, 1.0])
    for name, mirror in {
        "orbit/mean": lambda a: a * sign,
        "orbit/max_radius": lambda a: a,
        "orbit/backward": lambda a: a,
        "winding/winding": lambda a: a,
        "winding/direction": lambda a: a,
        "poincare/section": lambda a: a * np.tile(sign, 2),
    }.items():
        if path.stem == "magnetic-drop" and name.startswith("winding/"):
            continue  # the retainer moves on a line before the drop, so its winding is not defined
        found, expected = np.asarray(theirs[name]), mirror(np.asarray(ours[name]))
        size = np.nanmax(np.abs(expected), initial=1e-300)
        assert np.allclose(found, expected, rtol=0, atol=1e-6 * size, equal_nan=True), name


def at_rest(path, study, points):
    case = yaml.load((ROOT / "cases" / path).read_text(), yaml.BaseLoader)
    case["study"] = {study: points}
    return [whirl.run(whirl.Case(one), progress=False)[study] for one in (case, mirrored(case))]


def test_modes_and_responses_go_forward_either_way():
    points = {"parameter": "omega", "values": ["800 rad/s", "2000 rad/s"]}
    ours, theirs = at_rest("overhung-rotor.yaml", "modes", points)
    for field in ("frequency", "growth", "direction"):
        found, expected = (np.asarray(one[f"modes/{field}"]) for one in (theirs, ours))
        assert np.allclose(found, expected, rtol=1e-6, atol=1e-6 * np.nanmax(np.abs(expected)), equal_nan=True), field
    assert np.nanmin(expected) < -0.1 and np.nanmax(expected) > 0.1
    ours, theirs = at_rest("overhung-rotor.yaml", "unbalance", points)
    for field in ("amplitude", "axes"):
        found, expected = (np.asarray(one[f"unbalance/{field}"]) for one in (theirs, ours))
        assert np.allclose(found, expected, rtol=1e-6, atol=1e-12), field


def test_a_station_that_moves_along_one_axis_has_no_displacement_along_the_other():
    text = """
whirl: 1
parameters: {omega: 2 rad/s}
rotor:
  speed: = omega
  length_scale: 1 m
  stations: {mass: {mass: 1 kg, moves: AXIS, damping: 0.4 N.s/m, eccentricity: 0.3 m}}
  elements:
    - spring: {between: [mass, ground], along: AXIS, stiffness: 1 N/m}
study:
  STUDY
"""
    size = 0.3 * 4 / np.hypot(1 - 4, 0.8)  # e w^2/|k - w^2 + i c w|
    for along, axis in enumerate("xy"):
        case = text.replace("AXIS", axis)
        motion = (
            "response: {}\n  integrate: {method: dop853, rtol: 1e-10, transient: 200}\n  analyze: [orbit, poincare]"
        )
        found = whirl.run(whirl.Case(text=case.replace("STUDY", motion)), progress=False)["response"]
        seen = size * np.array([np.cos(np.pi / 64), 1])  # the peak lies between two of 64 instants
        assert seen[0] <= found["orbit/max_radius"][0, 0] <= seen[1] * (1 + 1e-9)
        assert (
            seen[0] <= found["orbit/high"][0, 0, along] <= seen[1] * (1 + 1e-9)
            and found["orbit/high"][0, 0, 1 - along] == 0
        )
        assert np.all(found["poincare/section"][0, 0][:, [1 - along, 3 - along]] == 0)
        for study in ("unbalance", "modes"):
            at_rest = whirl.run(whirl.Case(text=case.replace("STUDY", study + ": {}")), progress=False)[study]
            if study == "unbalance":
                amplitude = at_rest["unbalance/amplitude"][0, 0]
                assert abs(amplitude[along] - size) < 1e-9 and amplitude[1 - along] == 0
            else:
                shape = np.asarray(at_rest["modes/shape"])[0, 0, 0].reshape(2, 2)
                assert np.hypot(*shape[along]) == pytest.approx(1) and np.all(shape[1 - along] == 0)
