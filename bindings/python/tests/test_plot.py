"""Figures show the numbers of the tables, in the units of the case."""

import numpy as np
import pytest
from conftest import GOOD, MAP, ROOT, command

import whirl
import whirl._marks

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


def points_of(ax):
    """All points of the lines, sorted."""
    drawn = np.concatenate([np.column_stack(line.get_data()) for line in ax.get_lines()])
    return drawn[np.lexsort(drawn.T)]


def test_a_diagram_has_all_points_of_its_sections(good):
    ax = good.plot.bifurcation(coordinate="y")
    section = good["sweep"]["poincare/section"][:, 0, :, 1]
    expected = np.column_stack([np.repeat(good["sweep"].values, section.shape[1]), section.ravel()])
    assert np.array_equal(points_of(ax), expected[np.lexsort(expected.T)])
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("omega (rad/s)", "y of disc (m)")


CHOICES = [
    ("", "speed (rpm)", "x of disc / c", 600.0, 1.0),  # as reports do: over the scale where that has a name
    ("mm", "speed (rpm)", "x of disc (mm)", 600.0, 0.2),
    ("um, rad/s, p-p", "speed (rad/s)", "x of disc (µm)", 20 * np.pi, 200.0),
    ("mil", "speed (rpm)", "x of disc (mil)", 600.0, 0.2e-3 / 25.4e-6),
]


@pytest.mark.parametrize("units, xlabel, ylabel, first, length", CHOICES)
def test_units_are_those_of_reports(units, xlabel, ylabel, first, length, tmp_path):
    own = MILLIMETRES + (f'  units: "{units}"\n' if units else "")
    chosen = whirl.run(whirl.Case(text=own), progress=False)
    chosen.save(tmp_path / "chosen.h5")
    whirl.run(whirl.Case(text=MILLIMETRES), progress=False).save(tmp_path / "plain.h5")
    later = whirl.open(tmp_path / "plain.h5").show_in(units)
    for result in (chosen, whirl.open(tmp_path / "chosen.h5"), whirl.read(tmp_path / "chosen.h5"), later):
        ax = result.plot.bifurcation()
        assert (ax.get_xlabel(), ax.get_ylabel()) == (xlabel, ylabel)
        table, drawn = result["sweep"], points_of(ax)
        assert np.allclose(np.unique(drawn[:, 0]), first * np.array([1.0, 1.5, 2.0]), rtol=1e-12)
        lengths = np.sort((table["poincare/section"][:, 0, :, 0] * length).ravel())
        assert np.allclose(np.sort(drawn[:, 1]), lengths, rtol=1e-12, atol=1e-15)
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
    assert ax.get_lines()[0].get_marker() == "x"


def test_axes_may_be_logarithmic(good):
    ax = good.plot.bifurcation(yscale="log", xscale="log")
    assert (ax.get_yscale(), ax.get_xscale()) == ("log", "log") and ax.get_ylim()[0] > 0
    assert good.plot.lyapunov.__doc__


def test_exponents(good):
    line = good.plot.lyapunov().get_lines()[0]
    assert np.array_equal(line.get_ydata(), good["sweep"]["lyapunov/largest"])


def test_a_section_by_index_and_by_value(good):
    for point in (2, 2.6):
        line = good.plot.poincare(point).get_lines()[0]
        assert np.array_equal(line.get_xydata(), good["sweep"]["poincare/section"][2, 0, :, :2])
    assert good.plot.poincare(2).get_title().startswith("omega = 2.5 rad/s: ")
    with pytest.raises(whirl.BadInput, match="has no point 5, expected 0 to 4"):
        good.plot.poincare(5)


def test_an_orbit_passes_through_its_sections():
    text = MILLIMETRES.replace("  analyze: [poincare]", "  keep: {waveform: 4}\n  analyze: [poincare, waveform]")
    result = whirl.run(whirl.Case(text=text), progress=False)
    path, marks = result.plot.orbit(1).get_lines()
    samples = result["sweep"]["waveform/samples"][1, 0]
    assert np.allclose(path.get_xydata(), samples, rtol=1e-12) and len(marks.get_xdata()) == 4
    from_path = np.abs(marks.get_xydata()[:, None] - path.get_xydata()[None]).max(axis=2).min(axis=1)
    assert (from_path[:-1] < 1e-12).all()  # the last revolution ends one sample beyond the path


def test_a_full_spectrum_has_backward_lines_below_zero(good):
    lines = good["sweep"]["spectrum/lines"][1, 0]
    lines = lines[np.isfinite(lines[:, 0])]
    forward, backward = good.plot.spectrum(1).collections
    ends = np.array([path[1] for path in forward.get_segments()])
    assert np.array_equal(ends, lines[:, [0, 3]])
    ends = np.array([path[1] for path in backward.get_segments()])
    assert np.array_equal(ends, lines[:, [0, 4]] * [-1, 1])


def test_a_waterfall_has_the_lines_of_all_spectra(good):
    drawn = good.plot.waterfall().collections[0]
    lines, values = good["sweep"]["spectrum/lines"][:, 0], good["sweep"].values
    at = np.broadcast_to(values[:, None], lines.shape[:2])
    forward = np.column_stack([lines[..., 0].ravel(), at.ravel(), lines[..., 3].ravel()])
    backward = np.column_stack([-lines[..., 0].ravel(), at.ravel(), lines[..., 4].ravel()])
    expected = np.concatenate([forward, backward])
    expected = expected[expected[:, 2] > 1e-3 * np.nanmax(expected[:, 2])]
    found = np.column_stack([drawn.get_offsets(), drawn.get_array()])
    assert np.array_equal(found[np.lexsort(found.T)], expected[np.lexsort(expected.T)])


def test_amplitudes_are_counted_as_the_case_says():
    text = MILLIMETRES.replace("[poincare]", "[poincare, spectrum]") + "  units: um, p-p\n"
    result = whirl.run(whirl.Case(text=text), progress=False)
    lines = result["sweep"]["spectrum/lines"][1, 0]
    ax = result.plot.spectrum(1, full=False)
    ends = np.array([path[1] for path in ax.collections[0].get_segments()])
    assert np.allclose(ends[:, 1], 400.0 * lines[np.isfinite(lines[:, 0]), 1], rtol=1e-12)
    assert ax.get_ylabel() == "amplitude of disc (µm p-p)"
    assert ax.get_title() == "speed = 900 rpm"


def test_branches_are_dashed_where_they_are_unstable(branches):
    table = branches["branch"]
    ax = branches.plot.branches()
    unstable = table["trace/unstable"] > 0
    dashed = np.concatenate([line.get_xdata() for line in ax.get_lines() if line.get_linestyle() == "--"])
    solid = np.concatenate([line.get_xdata() for line in ax.get_lines() if line.get_linestyle() == "-"])
    assert set(table.values[unstable]) <= set(dashed) and set(table.values[~unstable]) <= set(solid)
    marked = sum(len(collection.get_offsets()) for collection in ax.collections)
    assert marked == np.count_nonzero(table["trace/special"]) > 3


def test_maps_show_regimes_and_numbers(map_files):
    result = whirl.open(map_files[1])
    table = result["map"]
    ax = result.plot.map("orbit/max_radius")
    drawn = np.asarray(ax.collections[0].get_array()).reshape(3, 5)
    assert np.allclose(drawn, table["orbit/max_radius"][:, :, 0] * table.length_scale * 1e3, rtol=1e-12)
    assert ax.get_ylabel() == "c (mm)"
    colours = result.plot.map().collections[0].get_facecolor().reshape(3, 5, 4)
    from whirl.plot import REGIMES, classes

    names = np.array(list(REGIMES))[classes(table)]
    for name in np.unique(names):
        expected = [int(REGIMES[name][i : i + 2], 16) / 255 for i in (1, 3, 5)]
        assert np.allclose(colours[names == name][:, :3], expected)


def test_a_basin_shows_its_attractors(basin):
    table = basin["basin"]
    ax = basin.plot.map()
    number = table.attractors.max()
    titles = [text.get_text() for text in ax.get_legend().get_texts()]
    assert titles[0] == f"1: {table.verdicts[table.attractors == 1][0]} ({100 * (table.attractors == 1).mean():.3g} %)"
    assert len(titles) == number == 2
    cells = ax.collections[0].get_facecolor().reshape(*table.shape, 4)
    for of in (1, 2):
        assert np.allclose(cells[table.attractors == of], to_rgba(whirl.plot.attractor_colour(of)))


def test_shares_of_starts_are_drawn(starts):
    table = starts["sweep"]
    ax = starts.plot.shares()
    drawn = points_of(ax)
    told = np.column_stack([table.values, 100 * table.shares, table.attractors])[table.attractors > 0]
    expected = np.unique(told, axis=0)[:, :2]
    assert np.array_equal(drawn, expected[np.lexsort(expected.T)])
    with pytest.raises(whirl.BadInput, match="several starts"):
        whirl.Case(GOOD).outline().plot.shares()


def test_starts_are_drawn_once_an_attractor(starts):
    table = starts["sweep"]
    ax = starts.plot.bifurcation()
    lines = {line.get_label(): line.get_xdata() for line in ax.get_lines()}
    for number in range(1, table.attractors.max() + 1):
        places = np.unique(table.values[table.attractors == number])
        assert np.array_equal(np.unique(lines[str(number)]), places)
        assert len(lines[str(number)]) == len(places) * table["poincare/section"].shape[2]


def test_a_map_shows_what_most_starts_lead_to(starts_map):
    table = starts_map["map"]
    code, period = table["regime/code"].astype(int), table["regime/period"].astype(int)
    cells = starts_map.plot.map().collections[0].get_facecolor().reshape(*table.grid, 4)
    seen = 0
    for place in range(cells[..., 0].size):
        own = (table.place == place) & np.isfinite(table.shares)
        best = own & (table.shares == table.shares[own].max())
        if len(set(zip(code[best], period[best]))) == 1 and code[best][0] == 1:
            name = {1: "P-1", 2: "P-2", 4: "P-4"}.get(period[best][0], "other P-k")
            assert np.allclose(cells.reshape(-1, 4)[place, :3], to_rgba(whirl.plot.REGIMES[name])[:3])
            seen += 1
    assert seen >= 3


def test_machines_at_rest_are_drawn(tmp_path):
    modes = whirl.run(whirl.Case(ROOT / "tests/cli/modes.yaml"), progress=False)
    ax = modes.plot.campbell()
    table = modes["modes"]
    rpm = 2 * np.pi / 60
    frequency = table["modes/frequency"]
    drawn = points_of(ax)
    expected = np.column_stack([np.repeat(table.values, frequency.shape[1]) / rpm, frequency.ravel() / rpm])
    once = np.column_stack([table.values / rpm, table.values / rpm])
    expected = np.concatenate([expected, once])
    assert np.allclose(drawn, expected[np.lexsort(expected.T)], rtol=1e-12)
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("omega (rpm)", "damped frequency (rpm)")
    # Both springs are in tune with the speed where it is their own frequency: sqrt(k/m).
    critical = np.sort(np.concatenate([c.get_offsets()[:, 0] for c in ax.collections]))
    assert np.allclose(critical, np.sqrt([80e3 / 2, 200e3 / 2]) / rpm, rtol=1e-9)
    text = (ROOT / "tests/cli/modes.yaml").read_text()
    text = text.split("study:")[0] + "study:\n  unbalance: {parameter: omega, from: 500 rpm, to: 1500 rpm, points: 5}\n"
    above, below = whirl.run(whirl.Case(text=text), progress=False).plot.bode()
    speed, amplitude = above.get_lines()[0].get_data()
    turns = speed * rpm
    assert np.allclose(amplitude, 0.01 * turns**2 / np.abs(80e3 / 2 - turns**2), rtol=1e-9)  # e r^2/(1 - r^2), mm
    assert above.get_ylabel() == "amplitude of disc (mm 0-p)" and below.get_ylabel() == "lag (degrees)"


def test_a_waterfall_has_the_lines_of_all_spectra(good):
    ax = good.plot.waterfall(full=False)
    lines = good["sweep"]["spectrum/lines"][:, 0]
    large = lines[:, :, 1] > 1e-3 * np.nanmax(lines[:, :, 1])
    offsets = ax.collections[0].get_offsets()
    assert len(offsets) == large.sum() > 5
    assert np.allclose(np.sort(offsets[:, 0]), np.sort(lines[:, :, 0][large]))
    assert np.allclose(np.sort(ax.collections[0].get_array()), np.sort(lines[:, :, 1][large]))


def test_a_plane_of_a_map_is_drawn(map_files):
    case = map_files[0].read_text().replace("  integrate", "    z: {parameter: kappa, values: [5, 10]}\n  integrate")
    result = whirl.run(whirl.Case(text=case), progress=False)
    table = result["map"]
    for plane in (0, 1):
        ax = result.plot.map("orbit/max_radius", plane=plane)
        drawn = np.asarray(ax.collections[0].get_array()).reshape(3, 5)
        expected = (table["orbit/max_radius"][..., 0] * table.length_scale)[plane]
        assert np.allclose(drawn, expected * 1e3, rtol=1e-12)
        assert ax.get_title() == f"kappa = {5 * (plane + 1)}"
    with pytest.raises(whirl.BadInput, match="has 2 planes, from 0, and no plane 2"):
        result.plot.map(plane=2)


def test_refined_maps_are_filled(map_files, tmp_path):
    text = (
        map_files[0]
        .read_text()
        .replace("points: 5", "points: 17")
        .replace("transient: 20", "transient: 400")
        .replace("values: [0.1 mm, 0.15 mm, 0.2 mm]}", "from: 0.1 mm, to: 0.2 mm, points: 9}")
    )
    whole = whirl.run(whirl.Case(text=text), progress=False)
    refined = whirl.run(whirl.Case(text=text.replace("  integrate", "    refine: 4\n  integrate")), progress=False)
    assert refined["map"].grid == whole["map"].shape == (9, 17) and len(refined["map"].values) < 153
    colours = [r.plot.map().collections[0].get_facecolor() for r in (whole, refined)]
    same = (colours[0] == colours[1]).all(axis=1).mean()
    assert same > 0.9  # the squares that were not halved have the colour of their corner


def test_what_was_not_analysed_is_said(good):
    with pytest.raises(whirl.BadInput, match="has no map"):
        good.plot.map()
    with pytest.raises(whirl.BadInput, match="follows branches"):
        good.plot.branches("sweep")


def test_a_lag_is_broken_where_it_jumps():
    lag, at = whirl._marks.broken([350.0, 359.0, 1.0, 10.0, 190.0])
    assert np.array_equal(lag, [350.0, 359.0, np.nan, 1.0, 10.0, np.nan, 190.0], equal_nan=True)
    assert np.array_equal(np.insert([1.0, 2.0, 3.0, 4.0, 5.0], at, np.nan), [1, 2, np.nan, 3, 4, np.nan, 5], True)


def test_a_map_takes_the_column_and_the_station_that_are_asked_for():
    case = whirl.Case(text=MAP.replace("    disc:", "    other: {mass: 1 kg, damping: 5 N.s/m}\n    disc:"))
    result = whirl.run(case, progress=False)
    table = result["map"]
    mean = table["orbit/mean"]
    assert len(np.unique(mean[..., 1, :2])) == 10
    for which, column, label in (
        ("disc", "y", "y of disc (mm)"),
        (1, 0, "x of disc (mm)"),
        ("other", 1, "y of other (mm)"),
    ):
        ax = result.show_in("mm").plot.map("orbit/mean", which=which, column=column)
        drawn = np.asarray(ax.collections[0].get_array()).reshape(3, 5)
        own = mean[..., 1 if which != "other" else 0, 0 if column == 0 else 1]
        assert np.allclose(drawn, own * table.length_scale * 1e3, rtol=1e-12)
        assert ax.figure.axes[1].get_ylabel() == label
    wrongs = (
        ({"field": "orbit/mean", "which": 5}, "no station '5'"),
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
    drawn = np.concatenate([line.get_xydata() for line in ax.get_lines()])
    assert table.second == "kappa" and np.array_equal(drawn, np.column_stack([table.values, table.second_values]))
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["fold"]
    fold = result["branch"].values[result["branch"]["trace/special"] == 1]
    order = np.argsort(drawn[:, 1])
    assert np.isclose(np.interp(10.0, drawn[order, 1], drawn[order, 0]), fold[0], rtol=1e-6)
    with pytest.raises(whirl.BadInput, match="follows them"):
        whirl.Case(GOOD).outline().plot.curves()


def test_tori_are_drawn_with_their_branches():
    result = whirl.run(whirl.Case(ROOT / "tests/cli/tori.yaml"), progress=False)
    table = result["tori"]
    lines = [line for line in result.plot.branches().get_lines() if line.get_color() == "#009E73"]
    drawn = np.concatenate([line.get_xydata() for line in lines])
    expected = np.column_stack([table.values, table["torus/high"][:, 0, 0]])
    assert np.array_equal(drawn[np.lexsort(drawn.T)], expected[np.lexsort(expected.T)])


def test_what_is_carried_down_is_told_apart():
    text = GOOD.read_text().replace("points: 5, start: state", "points: 5, start: carry, direction: both")
    result = whirl.run(whirl.Case(text=text), progress=False)
    table = result["sweep"]
    crosses = [line for line in result.plot.bifurcation().get_lines() if line.get_marker() == "x"]
    drawn = np.concatenate([line.get_xydata() for line in crosses])
    down = table["poincare/section"][table.branch < 0, 0, :, 0]
    assert len(drawn) == down.size > 0 and np.array_equal(np.sort(drawn[:, 1]), np.sort(down.ravel()))
    with pytest.raises(whirl.BadInput, match="coordinate is 'z'"):
        result.plot.bifurcation(coordinate="z")


def test_the_quick_start_of_the_readme_runs(tmp_path, monkeypatch):
    block = (ROOT / "README.md").read_text().split("```python\n")[1].split("```")[0]
    monkeypatch.chdir(tmp_path)
    exec(block.replace("cases/jeffcott-rub.yaml", str(GOOD)), {})
    assert (tmp_path / "rub.png").stat().st_size > 10_000
