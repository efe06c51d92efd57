import os
import pathlib
import subprocess

import numpy as np
import pytest

import whirl

ROOT = pathlib.Path(__file__).parents[3]
GOOD = ROOT / "tests/cli/good.yaml"
COMMAND = os.environ.get("WHIRL", str(ROOT / "build/whirl"))

MAP = """
whirl: 1
parameters: {omega: 100 rad/s, kappa: 10, c: 0.2 mm}
rotor:
  speed: = omega
  length_scale: = c
  stations:
    disc: {mass: 4 kg, damping: 20 N.s/m, eccentricity: = 0.1*c}
  elements:
    - shaft: {between: [disc, ground], k1: 100 kN/m, k2: 100 kN/m}
    - rub: {at: disc, gap: = 1.2*c, stiffness: = kappa*1e6, friction: 0.1}
study:
  map:
    x: {parameter: omega, from: 50 rad/s, to: 400 rad/s, points: 5}
    y: {parameter: c, values: [0.1 mm, 0.15 mm, 0.2 mm]}
  integrate: {method: rk4, steps_per_revolution: 64, transient: 20, record: 10}
  analyze: [poincare, regime, orbit]
"""

# A rotor above its critical speed with two attractors: depending on its start, it stays off the stator or touches it
# all around.
SEVERAL = """
whirl: 1
parameters: {omega: 220 rad/s, x0: 0, y0: 0, c: 0.2 mm, kappa: 10}
rotor:
  speed: = omega
  length_scale: = c
  stations:
    disc: {mass: 4 kg, damping: 20 N.s/m, eccentricity: = 0.1*c}
  elements:
    - shaft: {between: [disc, ground], k1: 100 kN/m, k2: 100 kN/m}
    - rub: {at: disc, gap: = 1.2*c, stiffness: = kappa*1e5, friction: 0}
study:
  integrate: {method: dop853, rtol: 1e-8, transient: 400, record: 40}
  analyze: [poincare, regime, lyapunov, orbit, rub, floquet]
"""
BASIN = """
  initial: {disc: {x: = x0, y: = y0, vx: = -y0, vy: = x0}}
  basin: {x: {parameter: x0, from: -2, to: 2, points: 9}, y: {parameter: y0, from: -1, to: 2, points: 4}}
"""
STARTS = "  starts: {count: 8, neighbours: 4, within: {disc: {x: [-2, 2], vy: [-2, 2]}}}\n"
SWEEP = STARTS + "  sweep: {parameter: omega, values: [120, 180, 220, 260]}\n"
PLANE = (
    STARTS
    + """
  map: {x: {parameter: omega, values: [120, 180, 220]}, y: {parameter: kappa, values: [10, 12]}}
"""
)


def filled(text, name, **words):
    """Returns the case of a text in which each word, written in capitals, is replaced."""
    for word, by in words.items():
        text = text.replace(word.upper(), by)
    return whirl.Case(text=text, name=name)


def lag_of(z):
    """Returns the lag of a complex amplitude, degrees from 0 to 360."""
    return -np.degrees(np.angle(z)) % 360


def command(*words, **more):
    """Runs the command whirl; the test fails if the command fails."""
    return subprocess.run([COMMAND, *map(str, words)], check=True, capture_output=True, text=True, **more)


@pytest.fixture(scope="session")
def good():
    """The result of the small case, computed by the package."""
    return whirl.run(whirl.Case(GOOD), threads=2, progress=False)


@pytest.fixture(scope="session")
def good_file(tmp_path_factory):
    """The result of the small case, computed by the command."""
    path = tmp_path_factory.mktemp("good") / "good.h5"
    command("run", GOOD, "-o", path, "-q", "--threads", 1)
    return path


@pytest.fixture(scope="session")
def map_files(tmp_path_factory):
    """A case with a map, and its result by the command."""
    folder = tmp_path_factory.mktemp("map")
    (folder / "map.yaml").write_text(MAP)
    command("run", folder / "map.yaml", "-o", folder / "map.h5", "-q")
    return folder / "map.yaml", folder / "map.h5"


def compute(text):
    return whirl.run(whirl.Case(text=text), progress=False)


@pytest.fixture(scope="session")
def basin():
    """The result of a basin: starts of one machine lead to two motions."""
    return compute(SEVERAL + BASIN)


@pytest.fixture(scope="session")
def starts():
    """The result of a sweep with several starts for every point."""
    return compute(SEVERAL + SWEEP)


@pytest.fixture(scope="session")
def starts_map():
    """The result of a map with several starts for every point."""
    return compute(SEVERAL + PLANE)
