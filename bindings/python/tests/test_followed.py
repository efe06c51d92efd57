"""Tests that modes keep their names through crossings that are known from symmetry."""

import json
import subprocess

import numpy as np
import pytest
from conftest import COMMAND, ROOT, command

import whirl

# A shaft with a disc in the middle on equal bearings. In half of the modes the disc moves without tilting, so that
# gyroscopic moments do not change their frequencies. In the other half it tilts without moving. As the speed grows, the
# frequencies of backward tilting modes fall and cross those of the modes in which the disc moves.
CASE = """
whirl: 1
parameters: {omega: 3000 rpm, k: 5 MN/m}
rotor:
  speed: = omega
  length_scale: 1 mm
  stations:
    left: {position: 0 m}
    quarter: {position: 0.3 m}
    middle: {position: 0.6 m, mass: 6 kg, polar: 1.2 kg.m2, diametral: 0.7 kg.m2}
    three: {position: 0.9 m}
    right: {position: 1.2 m}
  elements:
    - segment: {length: 1.2 m, outer: 40 mm}
    - bearing: {at: left, kxx: = k, kyy: = k, cxx: 100 N s/m, cyy: 100 N s/m}
    - bearing: {at: right, kxx: = k, kyy: = k, cxx: 100 N s/m, cyy: 100 N s/m}
study:
  modes: {parameter: omega, from: FIRST rpm, to: LAST rpm, points: POINTS, count: 8}
"""


def case(first, last, points):
    return CASE.replace("FIRST", str(first)).replace("LAST", str(last)).replace("POINTS", str(points))


def named(text, tmp_path):
    """Returns frequency, decrement and motion of the disc [3][points] for each name of a mode; NaN at points without
    it."""
    path = tmp_path / "case.yaml"
    path.write_text(text)
    points = json.loads(command("run", path, "--json").stdout)["points"]
    lines = {}
    for at, point in enumerate(points):
        shapes = np.reshape(point["modes"]["stations"]["middle"]["shape"], (-1, 4))
        for i, name in enumerate(point["modes"]["name"]):
            if name is not None:
                line = lines.setdefault(name, np.full((3, len(points)), np.nan))
                line[:, at] = point["modes"]["frequency"][i], point["modes"]["decrement"][i], np.abs(shapes[i]).max()
    return lines


@pytest.mark.parametrize(("first", "last", "points"), [(200, 9000, 45), (9000, 200, 45), (500, 6000, 12)])
def test_names_stay_with_shapes_through_crossings(first, last, points, tmp_path):
    lines = named(case(first, last, points), tmp_path)
    whole = {name: line for name, line in lines.items() if np.isfinite(line).all()}
    moving = {name for name, line in whole.items() if line[2].min() > 0.05}
    tilting = {name for name, line in whole.items() if line[2].max() < 1e-6}
    assert moving | tilting == set(whole) and len(moving) >= 4 and len(tilting) >= 2
    lowest = sorted(moving, key=lambda name: whole[name][0, 0])[:2]
    assert {name[-1] for name in lowest} == {"F", "B"}
    for name in lowest:  # constant, except for the effect of the shaft's own rotary inertia
        assert np.ptp(whole[name][0]) < 5e-3 * whole[name][0, 0]
    backward = min((name for name in tilting if name[-1] == "B"), key=lambda name: whole[name][0].min())
    slow, fast = np.sort(whole[backward][0])[[0, -1]]
    assert fast > 1.3 * slow
    if abs(last - first) > 6000:  # its frequency crosses the lowest ones
        assert fast > whole[lowest[0]][0, 0] > slow
    # Frequencies of one mode change smoothly: no value is far from the middle of its neighbours.
    for line in whole.values():
        bend = np.abs(line[0, 1:-1] - (line[0, 2:] + line[0, :-2]) / 2)
        assert bend.max() < 0.03 * line[0].max()


def test_names_count_at_the_last_value(tmp_path):
    for first, last in ((200, 9000), (9000, 200)):
        lines = named(case(first, last, 45), tmp_path)
        for way in "FB":
            ends = {name: line[0, -1] for name, line in lines.items() if name[-1] == way and np.isfinite(line[0, -1])}
            assert [f"{i + 1}{way}" for i in range(len(ends))] == sorted(ends, key=ends.get)


def test_decrement_has_the_lines(tmp_path):
    lines = named(case(200, 9000, 45), tmp_path)
    result = whirl.run(whirl.Case(text=case(200, 9000, 45)), progress=False)
    before = result["modes"]["modes/before"]
    assert np.isnan(before[0]).all() and (np.sort(before[1])[:4] == [1, 2, 3, 4]).all()
    figure = result.figure("decrement")
    names = {text.get_text() for text in figure.axes[0].texts}
    assert names <= set(lines) and len(names) >= 4
    ends = {name: line[1, -1] for name, line in lines.items()}
    shown = [line.get_ydata() for line in figure.axes[0].lines if len(line.get_ydata()) >= 45]
    for name in names:
        assert any(np.isclose(ys[np.isfinite(ys)][-1], ends[name], rtol=1e-6) for ys in shown)


@pytest.mark.parametrize("shards", [("1/3", "3/3"), ("1/3", "2/3"), ("2/3", "3/3")])
def test_lines_end_where_a_result_has_gaps(shards, tmp_path):
    """Tests a result of some shards, which lacks speeds: modes are not followed across gaps, where shapes may
    change."""
    path, merged = tmp_path / "case.yaml", tmp_path / "r.h5"
    path.write_text(case(200, 9000, 90))
    for shard in shards:
        command("run", path, "-o", merged, "-q", "--shard", shard)
    assert subprocess.run([COMMAND, "merge", path, "-o", merged, "-q"], check=False).returncode == 3  # unfinished
    lines = {}
    points = json.loads(command("show", merged, "--json").stdout)["points"]
    assert 40 < len(points) < 80
    for point in points:
        shapes = np.reshape(point["modes"]["stations"]["middle"]["shape"], (-1, 4))
        for i, name in enumerate(point["modes"]["name"]):
            lines.setdefault(name, []).append(np.abs(shapes[i]).max())
    for sizes in lines.values():
        assert min(sizes) > 0.05 or max(sizes) < 1e-6


def test_one_mode_has_one_name(tmp_path):
    path = tmp_path / "case.yaml"
    path.write_text(case(200, 9000, 5).replace("count: 8", "count: 1"))
    points = json.loads(command("run", path, "--json").stdout)["points"]
    assert all(point["modes"]["name"] in ("1F", "1B", "2B") for point in points)  # a text, not a list of one


def test_modes_of_one_frequency_go_on(tmp_path):
    """Tests masses on equal springs, whose modes come in pairs of equal frequency with shapes that may mix; both modes
    of a pair are followed at all speeds."""
    path = tmp_path / "case.yaml"
    path.write_text(
        "whirl: 1\nparameters: {omega: 100 rad/s}\nrotor:\n  speed: = omega\n  length_scale: 1 mm\n  stations:\n"
        "    one: {mass: 1 kg, damping: 3 N s/m}\n    two: {mass: 1 kg, damping: 3 N s/m}\n  elements:\n"
        "    - spring: {between: [one, ground], stiffness: 10 kN/m}\n"
        "    - spring: {between: [two, ground], stiffness: 10 kN/m}\n"
        "study:\n  modes: {parameter: omega, from: 1, to: 200, points: 40}\n"
    )
    points = json.loads(command("run", path, "--json").stdout)["points"]
    assert all(sorted(point["modes"]["name"][:4]) == sorted(points[-1]["modes"]["name"][:4]) for point in points)
    assert None not in points[-1]["modes"]["name"][:4]


def test_frequencies_that_fold_have_no_names(tmp_path):
    text = (ROOT / "cases/cracked-rotor.yaml").read_text()
    path = tmp_path / "case.yaml"
    path.write_text(text.split("study:")[0] + "study:\n  modes: {parameter: w, from: 0.3, to: 2, points: 6}\n")
    for point in json.loads(command("run", path, "--json").stdout)["points"]:
        assert "name" not in point["modes"] and point["modes"]["modulo"] > 0
