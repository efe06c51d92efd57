"""Tests that the functions of `plot` draw panels of figures for the chosen table, station, point and field."""

import json

import numpy as np
import pytest
from conftest import GOOD, MAP, ROOT, command

import whirl

plt = pytest.importorskip("matplotlib.pyplot")
to_rgba = pytest.importorskip("matplotlib.colors").to_rgba


@pytest.fixture(autouse=True)
def closed_figures():
    yield
    plt.close("all")


@pytest.fixture(scope="module")
def branches(tmp_path_factory):
    path = tmp_path_factory.mktemp("branch") / "branch.h5"
    command("run", ROOT / "tests/cli/branch.yaml", "-o", path, "-q")
    return whirl.open(path)


def drawn_in(ax):
    """Returns all points of lines, as pairs."""
    return {tuple(pair) for line in ax.get_lines() for pair in line.get_xydata() if np.isfinite(pair).all()}


def of_panel(data, panel):
    """Returns the points of the dots and lines of a panel of a figure's data."""
    own = next(each for each in data["panels"] if each["name"] == panel)
    pairs = (
        (x, y) for s in own["series"] if s["shape"] in ("dots", "line") for x, y in zip(s.get("x", []), s.get("y", []))
    )
    return {pair for pair in pairs if None not in pair}


def test_diagrams_are_panels_of_figures(good, branches):
    modes = whirl.run(whirl.Case(ROOT / "tests/cli/modes.yaml"), progress=False)
    cases = (
        (good.plot.bifurcation(), good, "bifurcation-disc", "x"),
        (good.plot.bifurcation(table="sweep", station="disc", coordinate="y"), good, "bifurcation-disc", "y"),
        (good.plot.lyapunov(), good, "bifurcation-disc", "exponent"),
        (branches.plot.branches(), branches, "branch-disc", "x"),
        (branches.plot.branches(coordinate="y", station=0), branches, "branch-disc", "y"),
        (modes.plot.campbell(), modes, "campbell", "frequency"),
    )
    for ax, result, name, panel in cases:
        data = result.figure_data(name)
        expected = of_panel(data, panel)
        assert len(expected) > 4 and drawn_in(ax) == expected, (name, panel)
        own = next(each for each in data["panels"] if each["name"] == panel)
        assert ax.get_ylabel() == own["y"]["label"]


def test_a_diagram_has_the_points_of_its_sections(good):
    """Tests that a diagram has the points of its sections; dots closer than 1/2000 of the axis are drawn once."""
    drawn = np.array(sorted(drawn_in(good.plot.bifurcation(coordinate="y"))))
    section, values = good["sweep"]["poincare/section"][:, 0, :, 1], good["sweep"].values
    near = (section.max() - section.min()) / 1000
    for value, own in zip(values, section):
        there = drawn[drawn[:, 0] == value, 1]
        assert set(there) <= set(own) and all(np.abs(there - each).min() < near for each in own)


CHOICES = [
    ("", "(rpm)", "/ ", 600.0, 1.0),  # as in reports: lengths over the scale
    ("mm", "(rpm)", "(mm)", 600.0, 0.2),
    ("um, rad/s, p-p", "(rad/s)", "(\u00b5m)", 20 * np.pi, 200.0),
    ("mil", "(rpm)", "(mil)", 600.0, 0.2e-3 / 25.4e-6),
]


@pytest.mark.parametrize("units, of_x, of_y, first, length", CHOICES)
def test_units_are_those_of_reports(units, of_x, of_y, first, length, tmp_path):
    own = MILLIMETRES + (f'  units: "{units}"\n' if units else "")
    chosen = whirl.run(whirl.Case(text=own), progress=False)
    chosen.save(tmp_path / "chosen.h5")
    whirl.run(whirl.Case(text=MILLIMETRES), progress=False).save(tmp_path / "plain.h5")
    later = whirl.open(tmp_path / "plain.h5").show_in(units)
    for result in (chosen, whirl.open(tmp_path / "chosen.h5"), whirl.read(tmp_path / "chosen.h5"), later):
        ax = result.plot.bifurcation()
        assert of_x in ax.get_xlabel() and of_y in ax.get_ylabel()
        drawn = np.array(sorted(drawn_in(ax)))
        assert np.allclose(np.unique(drawn[:, 0]), first * np.array([1.0, 1.5, 2.0]), rtol=1e-12)
        lengths = result["sweep"]["poincare/section"][:, 0, :, 0] * length
        assert np.isclose(lengths[:, :, None], drawn[:, 1], rtol=1e-12, atol=1e-15).any(axis=(0, 1)).all()
    assert chosen.show_in("mil").facts["units"] == "mil"
    for wrong, words in (("rpn", "did you mean rpm"), (None, "expected words")):
        for result in (later, chosen):
            with pytest.raises(whirl.BadInput, match=words):
                result.show_in(wrong)


MILLIMETRES = """
whirl: 1
parameters: {speed: 600 rpm, c: 0.2 mm}
rotor:
  speed: = speed
  length_scale: = c
  stations:
    disc: {mass: 4 kg, damping: 20 N.s/m, eccentricity: = 0.1*c}
  elements:
    - shaft: {between: [disc, ground], k1: 100 kN/m, k2: 100 kN/m}
study:
  sweep: {parameter: speed, from: 600 rpm, to: 1200 rpm, points: 3}
  integrate: {method: rk4, steps_per_revolution: 64, transient: 20, record: 10}
  analyze: [poincare]
"""


def test_axes_and_styles_are_taken(good):
    _, own = plt.subplots()
    ax = good.plot.bifurcation(ax=own, color="red", marker="x")
    assert ax is own and {line.get_color() for line in ax.get_lines()} == {"red"}
    assert ax.get_lines()[0].get_marker() == "x" and not ax.get_legend()  # a legend would show other colours
    assert good.plot.bifurcation().get_legend() and good.plot.lyapunov().get_legend()
    assert good.plot.bifurcation(label="first").get_legend_handles_labels()[1] == ["first"]
    _, pair = plt.subplots(2)
    with pytest.raises(whirl.BadInput, match="takes 'sise'"):
        good.plot.bifurcation(ax=pair[0], sise=3)


def test_existing_curves_are_not_cut_off(good):
    sections = good["sweep"]["poincare/section"][:, 0, :, :2]
    ax = good.plot.poincare(1)
    good.plot.poincare(3, ax=ax)
    for limits, axis in ((ax.get_xlim(), 0), (ax.get_ylim(), 1)):
        shown = sections[[1, 3], :, axis]
        assert limits[0] < shown.min() and shown.max() < limits[1]
    with pytest.raises(whirl.BadInput, match="expected numbers above 0 for log"):
        good.plot.lyapunov(yscale="log")


def test_tables_of_conditions_have_their_figures():
    text = (ROOT / "tests/cli/modes.yaml").read_text().split("study:")[0]
    text = text.replace("omega: 1000 rpm", "omega: 1000 rpm\n  k: 80 kN/m").replace("80 kN/m}", "= k}")
    study = "unbalance: {parameter: omega, from: 500 rpm, to: 1500 rpm, points: 5}"
    conditions = "conditions: {soft: {}, stiff: {k: 300 kN/m}}"
    result = whirl.run(whirl.Case(text=f"{text}study:\n  {study}\n  {conditions}\n"), progress=False)
    names = [name for name in result if "unbalance" in name]
    assert len(names) == 2
    drawn = [drawn_in(result.plot.bode(table=name)[0]) for name in names]
    assert drawn[0] != drawn[1] and drawn_in(result.plot.bode(station="disc")[0]) == drawn[0]
    listed = [name for name in result.figures() if name.startswith("unbalance-disc")]
    assert result.figure_data(f"{names[1]}/{listed[1]}") == result.figure_data(listed[1])
    for wrong, words in (
        ("nosuch/unbalance-disc", "no table and no fields 'nosuch'"),
        (f"{names[0]}/nix", f"the table {names[0]} has no figure 'nix'"),
        (f"{names[0]}/campbell", "study: {modes: {parameter"),
    ):
        with pytest.raises(whirl.BadInput, match=words):
            result.figure_data(wrong)
    with pytest.raises(whirl.BadInput, match="no table 'nosuch', expected one of"):
        result.plot.bode(table="nosuch")


def test_exponents_without_sections():
    text = GOOD.read_text().replace("poincare, ", "").replace("regime, ", "")
    result = whirl.run(whirl.Case(text=text), progress=False)
    assert "poincare/section" not in result["sweep"]
    drawn = {y for _, y in drawn_in(result.plot.lyapunov())}
    assert set(result["sweep"]["lyapunov/largest"]) <= drawn


def test_a_file_is_found_from_anywhere(good_file, monkeypatch):
    monkeypatch.chdir(good_file.parent)
    result = whirl.open(good_file.name)
    monkeypatch.chdir("/")
    assert drawn_in(result.show_in("mm").plot.bifurcation())
    data = result.figure_data("bifurcation-disc", panels="x", units="rpm")["panels"][0]
    assert "(mm)" in data["y"]["label"] and "(rpm)" in data["x"]["label"]


def test_axes_may_be_logarithmic(good):
    ax = good.plot.waterfall(yscale="log")
    assert (ax.get_xscale(), ax.get_yscale()) == ("linear", "log") and ax.get_ylim()[0] > 0
    assert good.plot.lyapunov(yscale="symlog").get_yscale() == "symlog"


def test_a_section_by_index_and_by_value(good):
    for point in ({"point": 2}, {"at": 2.6}, {"point": "2.6 rad/s"}, {"at": "24.83 rpm"}, {"at": "0.414 rps"}):
        ax = good.plot.poincare(**point)
        section = good["sweep"]["poincare/section"][2, 0, :, :2]
        assert drawn_in(ax) == {tuple(pair) for pair in section}
        assert ax.get_title().startswith("omega = 2.5 rad/s, disc: ")
    with pytest.raises(whirl.BadInput, match="has no point 5, expected 0 to 4"):
        good.plot.poincare(5)


def test_a_value_means_the_same_point_everywhere(good, good_file):
    """Tests a sweep from 1 to 4 rad/s in steps of 0.75: a value with a unit or in SI selects the nearest point, up to a
    step beyond the ends."""
    sweep, opened = good["sweep"], whirl.open(good_file)
    for given, expected in ((1, 0), (1.4, 1), ("13.4 rpm", 1), (0.26, 0), (4.74, 4), ("4.74 rad/s", 4), (2.5, 2)):
        text = given if isinstance(given, str) else repr(float(given))
        document = command("figure", good_file, f"@{text}", "-o", "-").stdout
        assert json.loads(document) == good.figure_data(f"@#{expected}")
        assert sweep.at(given) == opened["sweep"].at(given) == expected
        assert drawn_in(good.plot.poincare(at=given)) == drawn_in(opened.plot.poincare(expected))
    for given in (1e12, -5.0, 0.24, 4.76, "46 rpm", 3000.0):
        with pytest.raises(whirl.BadInput, match="omega is .*expected 1 to 4 rad/s"):
            sweep.at(given)
        with pytest.raises(whirl.BadInput, match="omega is .*expected 1 to 4 rad/s"):
            good.plot.poincare(at=given)
    for given, words in (
        ("8 kg", "expected a unit of rad/s"),
        ("2 Hz", "1 Hz = 60 rpm"),
        ("fast", "expected a number"),
    ):
        with pytest.raises(whirl.BadInput, match=words):
            good.plot.poincare(given)
    for wrong, words in (({}, "one of both"), ({"point": 1, "at": 1}, "one of both"), ({"point": 1.0}, "at=1.0")):
        with pytest.raises(whirl.BadInput, match=words):
            good.plot.poincare(**wrong)


def test_ranges_of_values_stand_in_the_unit_shown():
    result = whirl.run(whirl.Case(text=GOOD.read_text().replace("1.5 rad/s", "15 rpm")), progress=False)
    assert result["sweep"].at(1.0) == 0 and result["sweep"].at("38 rpm") == 4
    with pytest.raises(whirl.BadInput, match=r"expected 9.549.* to 38.197.* rpm \(a number without a unit is in rad/s"):
        result["sweep"].at(38.0)


def test_an_orbit_passes_through_its_sections():
    text = MILLIMETRES.replace("  analyze: [poincare]", "  keep: {waveform: 4}\n  analyze: [poincare, waveform]")
    result = whirl.run(whirl.Case(text=text), progress=False)
    ax = result.plot.orbit(1)
    path = max(ax.get_lines(), key=lambda line: len(line.get_xdata())).get_xydata()
    assert np.allclose(path, result["sweep"]["waveform/samples"][1, 0], rtol=1e-12)
    marks = np.array([pair for line in ax.get_lines() if line.get_linestyle() == "None" for pair in line.get_xydata()])
    from_path = np.abs(marks[:, None] - path[None]).max(axis=2).min(axis=1)
    assert len(marks) == 4 and (np.sort(from_path)[:-1] < 1e-12).all()  # the last one is a sample beyond the path
    assert np.allclose(sorted(drawn_in(result.plot.orbit(1, table="sweep"))), sorted(drawn_in(ax)))


def test_points_of_the_table_that_is_asked_for():
    text = GOOD.read_text().rstrip() + "\n  detail: {at: [1.0, 3.25], transient: 30, record: 12, waveform: 4}\n"
    result = whirl.run(whirl.Case(text=text), progress=False)
    for table in ("sweep", "detail"):
        for point in (0, 1):
            drawn = drawn_in(result.plot.poincare(point, table=table))
            assert drawn == {tuple(pair) for pair in result[table]["poincare/section"][point, 0, :, :2]}
    assert len(result["detail"]["poincare/section"][0, 0]) == 12
    assert result.plot.orbit(1).get_title().startswith("omega = 3.25 rad/s")  # only points in detail have waveforms
    with pytest.raises(whirl.BadInput, match="the table detail has no figure 'bifurcation-disc'"):
        result.plot.bifurcation(table="detail")


def test_a_spectrum_has_backward_lines_below_zero(good):
    lines = good["sweep"]["spectrum/lines"][1, 0]
    lines = lines[np.isfinite(lines[:, 0])]
    ends = {tuple(path[1]) for bars in good.plot.spectrum(1).collections for path in bars.get_segments()}
    assert ends == {(line[0], line[3]) for line in lines} | {(-line[0], line[4]) for line in lines}
    with pytest.raises(whirl.BadInput, match="keeps whole spectra"):
        good.plot.spectrum(1, full=False)  # no whole spectrum was kept


def test_a_waterfall_is_cut_at_an_order(good):
    ax = good.plot.waterfall(highest_order=1.5)
    assert ax.get_xlim() == (-1.5, 1.5) and len(ax.figure.axes) == 2  # the panel and its colour scale


def test_amplitudes_are_counted_as_the_case_says():
    text = MILLIMETRES.replace("[poincare]", "[poincare, spectrum]") + "  units: um, p-p\n"
    result = whirl.run(whirl.Case(text=text), progress=False)
    lines = result["sweep"]["spectrum/lines"][1, 0]
    ax = result.plot.spectrum(1)
    largest = max(path[1][1] for bars in ax.collections for path in bars.get_segments())
    assert np.isclose(largest, 400.0 * np.nanmax(lines[:, 3:]), rtol=1e-12)
    assert ax.get_ylabel() == "amplitude (\u00b5m p-p)"


def test_maps_show_regimes_and_numbers(map_files):
    result = whirl.open(map_files[1])
    table = result["map"]
    ax = result.plot.map("orbit/max_radius")
    drawn = np.asarray(ax.collections[0].get_array()).reshape(3, 5)
    assert np.allclose(drawn, table["orbit/max_radius"][:, :, 0] * table.length_scale * 1e3, rtol=1e-12)
    assert ax.get_ylabel() == "$c$ (mm)"
    from whirl.plot import REGIMES, classes

    ax = result.plot.map()
    present = {list(REGIMES)[kind] for kind in classes(table).ravel()}
    legend = {text.get_text() for text in ax.get_legend().get_texts()}
    assert present <= {name for name in REGIMES if any(name in text for text in legend)}
    _, own = plt.subplots()
    result.plot.map("orbit/max_radius", ax=own)
    assert len(own.figure.axes) == 2  # the panel and its colour bar
    assert own.figure.axes[1].get_ylabel() == result.figure_data("orbit/max_radius")["scale"]["label"]


def test_a_basin_shows_its_attractors(basin):
    from matplotlib.colors import to_rgba

    table, ax = basin["basin"], basin.plot.map()
    colours = np.concatenate([boxes.get_facecolor() for boxes in ax.collections])
    for of in (1, 2):
        assert (np.abs(colours[:, :3] - to_rgba(whirl.plot.attractor_colour(of))[:3]) < 1e-9).all(axis=1).any()
    assert table.attractors.max() == 2


def test_shares_of_starts_are_drawn(starts):
    table = starts["sweep"]
    drawn = drawn_in(starts.plot.shares())
    reported = {(value, 100 * share) for value, share, n in zip(table.values, table.shares, table.attractors) if n > 0}
    assert {(round(x, 9), round(y, 9)) for x, y in drawn} >= {(round(x, 9), round(y, 9)) for x, y in reported}
    with pytest.raises(whirl.BadInput, match="several starts"):
        whirl.Case(GOOD).outline().plot.shares()


def test_starts_are_drawn_once_an_attractor(starts):
    table = starts["sweep"]
    ax = starts.plot.bifurcation()
    for number in range(1, table.attractors.max() + 1):
        places = np.unique(table.values[table.attractors == number])
        colour = whirl.plot.attractor_colour(number)
        drawn = np.concatenate([line.get_xdata() for line in ax.get_lines() if line.get_color() == colour])
        assert np.array_equal(np.unique(drawn), places)


def test_any_of_several_starts_is_shown(starts):
    section = starts["sweep"]["poincare/section"][:, 0, :, :2]
    for point in range(0, len(section), 5):
        assert drawn_in(starts.plot.poincare(point)) == {tuple(pair) for pair in section[point]}


def test_the_response_to_unbalance():
    text = (ROOT / "tests/cli/modes.yaml").read_text()
    text = text.split("study:")[0] + "study:\n  unbalance: {parameter: omega, from: 500 rpm, to: 1500 rpm, points: 5}\n"
    result = whirl.run(whirl.Case(text=text), progress=False)
    amplitude, lag = result.plot.bode()
    speed, size = amplitude.get_lines()[0].get_data()
    turns = speed * 2 * np.pi / 60
    assert np.allclose(size, 0.01 * turns**2 / np.abs(80e3 / 2 - turns**2), rtol=1e-9)  # e r^2/(1 - r^2), mm
    assert amplitude.get_ylabel() == "amplitude (mm 0-p)" and "lag" in lag.get_ylabel()
    pair = plt.subplots(2)[1]
    assert result.plot.bode(ax=pair, linewidth=2.0) == tuple(pair)
    assert drawn_in(pair[0]) == drawn_in(amplitude) and drawn_in(pair[1]) == drawn_in(lag)


def test_a_plane_of_a_map_is_drawn(map_files):
    case = map_files[0].read_text().replace("  integrate", "    z: {parameter: kappa, values: [5, 10]}\n  integrate")
    result = whirl.run(whirl.Case(text=case), progress=False)
    table = result["map"]
    for plane in (0, 1):
        drawn = np.asarray(result.plot.map("orbit/max_radius", plane=plane).collections[0].get_array()).reshape(3, 5)
        expected = (table["orbit/max_radius"][..., 0] * table.length_scale)[plane]
        assert np.allclose(drawn, expected * 1e3, rtol=1e-12)
    with pytest.raises(whirl.BadInput, match="has 2 planes, from 0, and no plane 2"):
        result.plot.map(plane=2)


def test_missing_analyses_are_reported(good):
    wrongs = (
        (good.plot.map, "has no map"),
        (good.plot.branches, "study: {branch: ...}"),
        (good.plot.curves, "study: {branch: ..., curves: ...}"),
        (good.plot.campbell, "study: {modes: {parameter"),
        (good.plot.bode, "study: {unbalance: {parameter"),
        (good.plot.shares, "several starts"),
        (lambda: good.plot.orbit(1), "add waveform"),
        (lambda: good.plot.bifurcation(coordinate="z"), "coordinate is 'z'"),
        (lambda: good.plot.bifurcation(station="disk"), "no station 'disk', expected one of: disc"),
    )
    for call, words in wrongs:
        with pytest.raises(whirl.BadInput, match=words):
            call()
    assert not plt.get_fignums()  # none of those that failed


def test_a_map_takes_the_column_and_the_station_that_are_asked_for():
    case = whirl.Case(text=MAP.replace("    disc:", "    other: {mass: 1 kg, damping: 5 N.s/m}\n    disc:"))
    result = whirl.run(case, progress=False)
    table = result["map"]
    mean = table["orbit/mean"]
    assert len(np.unique(mean[..., 1, :2])) == 10
    for which, column in (("disc", "y"), (1, 0), ("other", 1)):
        ax = result.show_in("mm").plot.map("orbit/mean", which=which, column=column)
        own = mean[..., 1 if which != "other" else 0, 0 if column == 0 else 1]
        drawn = ax.collections[0].get_array()
        assert np.allclose(np.asarray(drawn).reshape(3, 5), own * table.length_scale * 1e3, rtol=1e-12)
    wrongs = (
        ({"field": "orbit/mean", "which": 5}, "no station 5"),
        ({"field": "orbit/mean", "column": "z"}, "no column of 'orbit/mean' 'z'"),
        ({"field": "poincare/section"}, "10 rows"),
        ({"plane": 1}, "no plane 1"),
    )
    for more, words in wrongs:
        with pytest.raises(whirl.BadInput, match=words):
            result.plot.map(**more)
    assert len(plt.get_fignums()) == 3  # none of those that failed


def test_curves_are_drawn_over_both_parameters():
    text = (
        (ROOT / "tests/cli/branch.yaml")
        .read_text()
        .replace("from: 1.05, to: 3.3, at: [1.5]", "from: 3.27, to: 3.29, at: [3.271]")
    )
    text = text.replace("switches: 1}", "switches: 0, points: 60}\n  curves: {parameter: kappa, from: 9, to: 11}")
    result = whirl.run(whirl.Case(text=text), progress=False)
    table, ax = result["curves"], result.plot.curves()
    drawn = drawn_in(ax)
    assert table.second == "kappa" and drawn == set(zip(table.values, table.second_values))
    fold = result["branch"].values[result["branch"]["trace/special"] == 1]
    at, kappa = np.array(sorted(drawn, key=lambda pair: pair[1])).T
    assert np.isclose(np.interp(10.0, kappa, at), fold[0], rtol=1e-6)


def test_the_quick_start_of_the_readme_runs(tmp_path, monkeypatch):
    block = (ROOT / "README.md").read_text().split("```python\n")[1].split("```")[0]
    monkeypatch.chdir(tmp_path)
    exec(block.replace("cases/jeffcott-rub.yaml", str(GOOD)), {})
    picture = plt.imread(tmp_path / "rub.png")
    assert picture.shape[0] > 400 and (picture[..., :3].min(axis=2) < 0.9).sum() > 2000  # frame, texts, dots


def test_orbits_side_by_side_have_one_scale(good):
    figure, pair = plt.subplots(1, 2, sharex=True, sharey=True)
    for point, ax in enumerate(pair):
        good.plot.poincare(point, ax=ax)
    figure.canvas.draw()  # fails if shared axes with equal scales had to change their limits
    assert {ax.get_aspect() for ax in pair} == {1.0}
