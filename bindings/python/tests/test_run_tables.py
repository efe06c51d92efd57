"""Tests laws of a run as tables in the case or in a file: closed forms, equal bits, and errors of invalid tables."""

import numpy as np
import pytest

import whirl

CASE = """
whirl: 1
rotor:
  speed: 10 rad/s
  length_scale: 1 m
  stations:
    disc: {mass: 2 kg}
  elements:
    - spring: {between: [disc, ground], stiffness: 18 N/m}
    - drive: {inertia: 4 kg.m2, torque: 1 N.m, no_load_speed: 100 rad/s}
study:
  runup: {speed_from: 10 rad/s, speed_to: 90 rad/s,
          duration: 3 s, rtol: 1e-11, rows: 2, samples: 64, begin: centre, MORE}
"""


def run(more, folder=None):
    text = CASE.replace("MORE", more)
    if folder is None:
        return whirl.run(whirl.Case(text=text), progress=False)["runup"]
    (folder / "case.yaml").write_text(text)
    return whirl.run(whirl.Case(folder / "case.yaml"), progress=False)["runup"]


def place(table):
    return table["runup/place"][0, 0]


def test_ground_and_torque_of_a_list():
    """Tests x'' + 9 x = -a with a = 2 t up to 1 s, 2 up to 2 s and 0 after the end of the table; and 4 w' = 5 t up to 1
    s, then 5."""
    torque = "torque_law: [[0 s, 0 N.m], [1 s, 5 N.m], [4 s, 5 N.m]]"
    table = run(f"ground_x: [[0 s, 0 m/s2], [1 s, 2 m/s2], [2 s, 2 m/s2]], {torque}")
    w = 3.0
    x, v = -2 * (1 - np.sin(w) / w) / w**2, -2 * (1 - np.cos(w)) / w**2
    for a in (2.0, 0.0):
        rest = -a / w**2
        x, v = (
            rest + (x - rest) * np.cos(w) + v / w * np.sin(w),
            -(x - rest) * w * np.sin(w) + v * np.cos(w),
        )
    assert abs(place(table)[0] - x) < 1e-8 and abs(place(table)[1]) < 1e-12
    assert abs(table["runup/end_speed"][0] - (10 + (2.5 + 10) / 4)) < 1e-8


def test_a_file_has_the_bits_of_the_list(tmp_path):
    """Tests files with columns in any order, units, comments and different separators."""
    of_list = run(
        "ground_y: [[0.5 s, 1 m/s2], [0.75 s, -2 m/s2], [1.5 s, 0 m/s2]], load_law: [[0 s, 0 N.m], [3 s, 3 N.m]]"
    )
    (tmp_path / "shock.csv").write_text("# a shock\nground_y [m/s2];time [ms]\n1;500\n-2;750\n0;1500\n")
    (tmp_path / "load.csv").write_text('"time [s]","load [N.m]"\n0,0\n3,3\n')
    of_file = run("ground_y: shock.csv, load_law: load.csv", tmp_path)
    assert place(of_file).tobytes() == place(of_list).tobytes()
    assert of_file["runup/end_speed"].tobytes() == of_list["runup/end_speed"].tobytes()


def test_speeds_of_a_file(tmp_path):
    (tmp_path / "ramp.csv").write_text("time [s],speed [rpm]\n0,100\n2,300\n3,200\n")
    text = CASE.replace("speed_from: 10 rad/s, speed_to: 90 rad/s,", "").replace("MORE", "speeds: ramp.csv")
    (tmp_path / "case.yaml").write_text(text)
    table = whirl.run(whirl.Case(tmp_path / "case.yaml"), progress=False)["runup"]
    assert abs(table["runup/end_speed"][0] - 200 * np.pi / 30) < 1e-12
    assert abs(table["runup/end_turns"][0] - (400 + 250) / 60) < 1e-9


def test_a_long_record_is_its_formula(tmp_path):
    """Tests 12000 rows of a sine; the relative error of linear interpolation is (0.25 ms * 20/s)^2/8."""
    t = np.linspace(0, 3, 12001)
    np.savetxt(
        tmp_path / "sine.csv", np.c_[t, np.sin(20 * t)], "%.12g", ",", header="time [s],ground_x [m/s2]", comments=""
    )
    assert np.abs(place(run("ground_x: sine.csv", tmp_path)) - place(run("ground_x: = sin(20*time)"))).max() < 1e-6


@pytest.mark.parametrize(
    "more, words",
    [
        (
            "torque_law: [[0 s, 1 N.m], [2 s, 1 N.m]]",
            "torque_law is known from 0 to 2 s and the run goes from 0 to 3 s",
        ),
        ("load_law: [[1 s, 1 N.m], [3 s, 1 N.m]]", "load_law is known from 1 to 3 s"),
        ("ground_x: [[0 s, 1 m/s2]]", "expected 2 to 256 pairs .time, ground_x., or a file"),
        ("ground_x: [[0 s, 1 m/s2], [0 s, 2 m/s2]]", "ground_x has 0 s after a later time, expected times that rise"),
        ("ground_x: [[0 s, 1 m/s2], [1 s, 2 kg]]", "kg"),
        ("ground_x: [[0 s, 1 m/s2], 3]", "expected a pair .time, ground_x."),
        ("ground_x: nowhere.csv", "nowhere.csv"),
        ("ground_x: short.csv", "short.csv:2:1: has no ground_x, expected the columns time and ground_x"),
        ("ground_x: words.csv", "words.csv:3:3"),
        ("ground_x: unknown.csv", "unknown.csv:1:10: .*is no column: sideways"),
    ],
)
def test_refusals(tmp_path, more, words):
    (tmp_path / "short.csv").write_text("time [s],ground_y [m/s2]\n0,1\n1,1\n")
    (tmp_path / "words.csv").write_text("time [s],ground_x [m/s2]\n0,1\n1,much\n")
    (tmp_path / "unknown.csv").write_text("time [s],sideways [m/s2]\n0,1\n1,1\n")
    with pytest.raises(whirl.BadInput, match=words):
        run(more, tmp_path)
