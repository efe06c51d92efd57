"""Tests that all renderers draw the same description of a figure: gnuplot's scripts and Matplotlib have its data."""

import json
import re

import numpy as np
import pytest
from conftest import GOOD, MAP, ROOT, command

import whirl
import whirl.figure

plt = pytest.importorskip("matplotlib.pyplot")
to_hex = pytest.importorskip("matplotlib.colors").to_hex
to_rgb = pytest.importorskip("matplotlib.colors").to_rgb

UNBALANCE = "unbalance: {parameter: omega, from: 500 rpm, to: 1500 rpm, points: 5}"
CRITICAL = "critical_speeds: {parameter: k, from: 20 kN/m, to: 8000 kN/m, points: 4, scale: log}"
RUNUP = """whirl: 1
rotor:
  speed: 1 rad/s
  length_scale: 1 m
  stations:
    disc: {mass: 1 kg, damping: 0.1 N.s/m, eccentricity: 1 m}
  elements:
    - spring: {between: [disc, ground], stiffness: 1 N/m}
    - rub:    {at: disc, gap: 4 m, stiffness: 1 N/m, friction: 0.05, law: paper}
study:
  runup: {rate: 0.003 rad/s2, speed_from: 0.2 rad/s, duration: 500 s, rows: 50, samples: 32, spectra: 20,
          spectrum_turns: 4, orbits: 3, waveform: 4, slow_roll: 0.3 rad/s, loss_at: disc, loss_moment: 0.1 kg.m,
          loss_time: 200 s}
"""


@pytest.fixture(autouse=True)
def closed_figures():
    yield
    plt.close("all")


def at_rest(study):
    text = (ROOT / "tests/cli/modes.yaml").read_text().split("study:")[0]
    text = text.replace("omega: 1000 rpm", "omega: 1000 rpm\n  k: 80 kN/m").replace("80 kN/m}", "= k}")
    return f"{text}study:\n  {study}\n"


@pytest.fixture(scope="module")
def results(tmp_path_factory, good_file, map_files):
    """Makes files of results with figures of all kinds except those of several starts."""
    folder = tmp_path_factory.mktemp("figures")
    found = [good_file, map_files[1]]
    for name in ("branch", "tori", "modes"):
        command("run", ROOT / f"tests/cli/{name}.yaml", "-o", folder / f"{name}.h5", "-q")
        found.append(folder / f"{name}.h5")
    text = re.sub(r"  sweep: .*", "  response: {}", GOOD.read_text()).replace("analyze: [", "analyze: [waveform, ")
    (folder / "point.yaml").write_text(re.sub(r"\n  integrate", "\n  keep: {waveform: 8}\n  integrate", text))
    command("run", folder / "point.yaml", "-o", folder / "point.h5", "-q")
    found.append(folder / "point.h5")
    for name, study in (("unbalance", UNBALANCE), ("critical", CRITICAL)):
        (folder / f"{name}.yaml").write_text(at_rest(study))
        command("run", folder / f"{name}.yaml", "-o", folder / f"{name}.h5", "-q")
        found.append(folder / f"{name}.h5")
    (folder / "runup.yaml").write_text(RUNUP)
    command("run", folder / "runup.yaml", "-o", folder / "runup.h5", "-q")
    found.append(folder / "runup.h5")
    return found


def points_of(series):
    """Returns the number of points of a series that are drawn."""
    return sum(value is not None for value in series.get("x", []))


def drawn_points(artist):
    """Returns the number of points of an artist of Matplotlib."""
    if hasattr(artist, "get_xydata"):
        return int(np.isfinite(artist.get_xydata()).all(axis=1).sum())
    if hasattr(artist, "get_segments"):
        return len(artist.get_segments())
    return 1 if hasattr(artist, "get_text") else len(artist.get_paths())


def test_matplotlib_draws_the_data(results):
    kinds = set()
    for path in results:
        result = whirl.open(path)
        for name in result.figures():
            data = result.figure_data(name)
            figure = result.figure(name)
            kinds.add(re.sub(r"-[^-]*$", "", name))
            assert np.allclose(figure.get_size_inches() * 2.54, (data["width_cm"], data["height_cm"]))
            assert len(figure.axes) == len(data["panels"]) + ("scale" in data)
            for ax, panel in zip(figure.axes, data["panels"]):
                check_axes(ax, panel)
                check_series(panel, data)
            names = [
                series["name"] for series in whirl.figure.entries([p for p in data["panels"] if not p["legend_inside"]])
            ]
            legend = figure.legends[0].get_texts() if figure.legends else []
            assert [text.get_text() for text in legend] == names
            plt.close(figure)
    assert len(kinds) >= 9


def check_axes(ax, panel):
    for which in "xy":
        axis, own = panel[which], getattr(ax, f"{which}axis")
        assert np.allclose(getattr(ax, f"get_{which}lim")(), (axis["low"], axis["high"])) or panel["equal"]
        assert getattr(ax, f"get_{which}scale")() == ("log" if axis["log"] else "linear")
        assert own.get_label_text() == (axis["label"] if axis["shown"] else "")
        assert np.allclose(own.get_majorticklocs(), axis.get("ticks", []))
        texts = [tick.get_text() for tick in own.get_majorticklabels()]
        assert texts == (axis.get("tick_texts", []) if axis["shown"] else [""] * len(axis.get("ticks", [])))


def check_series(panel, data):
    """Checks every series against the artists of its axes: numbers, colours and names."""
    _, ax = plt.subplots()
    for series in panel["series"]:
        artists = whirl.figure._draw(ax, series, data.get("scale"), data["font_pt"])
        if series["shape"] == "area":
            assert points_of(series) == 0 or artists
        else:
            assert sum(map(drawn_points, artists)) == points_of(series), (data["name"], panel["name"], series["name"])
        if artists and series["shape"] in ("dots", "line"):
            assert to_hex(artists[0].get_color()) == series["colour"].lower()
    plt.close(ax.figure)


def blocks_of(path):
    """Returns the points of every block of a data file."""
    blocks = re.split(r"\n\n\n", path.read_text(encoding="utf-8"))
    return [sum(bool(line) and line[0] != "#" and "NaN" not in line for line in block.splitlines()) for block in blocks]


def test_gnuplot_is_given_the_data(results, tmp_path):
    for path in results:
        result = whirl.open(path)
        command("report", path, "-o", tmp_path, "--gnuplot", "true", "-q", "--force")
        for name in result.figures():
            data = result.figure_data(name)
            script = (tmp_path / path.stem / f"{name}.gp").read_text(encoding="utf-8")
            series = [s for panel in data["panels"] for s in panel["series"] if s.get("x") and s["shape"] != "texts"]
            expected = [
                sum(x is not None and y is not None for x, y in zip(s["x"], s["y"])) for s in series
            ]  # fmt: skip
            found = blocks_of(tmp_path / path.stem / f"{name}.dat")
            assert [max(n, 0) for n in found] == expected, name
            assert script.count("# ---- panel ") == len(data["panels"])
            for colour in {s["colour"] for s in series if "values" not in s}:
                assert f"rgb '{colour}'" in script
            for panel in data["panels"]:
                for text in panel["x"].get("tick_texts", []) if panel["x"]["shown"] else []:
                    assert f"'{text}' " in script


def test_the_command_and_python_have_one_description(results, tmp_path):
    printed = command("figure", results[0], "-o", "-").stdout
    assert json.loads(printed) == whirl.open(results[0]).figure_data() == whirl.read(results[0]).figure_data()


def test_panels_units_and_axes_are_chosen(map_files, good):
    result = whirl.read(map_files[1]).show_in("um")
    data = result.figure_data("map-radius-disc", log="y")
    assert data["scale"]["label"] == "largest radius (µm 0-p)" and data["panels"][0]["y"]["log"]
    _, ax = plt.subplots()
    figure = good.figure("bifurcation-disc", panels=["radius"], ax=ax)
    assert figure is ax.figure and ax.get_ylabel().replace("\n", " ") == "largest radius (m 0-p)"
    for wrong, words in (
        ({"name": "bifurcation-disk"}, "did you mean bifurcation-disc"),
        ({"panels": "z"}, "has no panel 'z'"),
        ({"units": "rpn"}, "did you mean rpm"),
        ({"ax": ax}, "has the panels|the panels x, y"),
    ):
        with pytest.raises(whirl.BadInput, match=words):
            good.figure(**wrong)


def test_maps_have_the_numbers_of_their_cells(map_files):
    result = whirl.open(map_files[1])
    boxes = result.figure_data("map-radius-disc", units="mm")["panels"][0]["series"][0]
    table = result["map"]
    expected = (table["orbit/max_radius"][..., 0] * table.length_scale * 1e3).ravel()
    assert np.allclose(boxes["values"], expected, rtol=1e-12) and MAP


@pytest.mark.parametrize("units", ["", "Hz, mm, p-p, rpm"])
def test_waterfalls_have_the_lines_of_all_spectra(good, units):
    data = good.figure_data("waterfall-disc", units=units)
    boxes = data["panels"][0]["series"][1]
    sweep = good["sweep"]
    lines, omega = sweep["spectrum/lines"][:, 0], sweep.values[:, None]
    order, forward, backward = (lines[..., column] for column in (0, 3, 4))
    if units:  # the length scale is 1 m
        order, omega = order * omega / (2 * np.pi), omega * 30 / np.pi
        forward, backward = 2e3 * forward, 2e3 * backward
    at = np.broadcast_to(omega, order.shape)
    expected = np.concatenate(
        [np.column_stack([side.ravel() for side in (place, at, size)])
         for place, size in ((order, forward), (-order, backward))]
    )  # fmt: skip
    largest = np.nanmax(expected[:, 2])
    expected = expected[expected[:, 2] >= 1e-3 * largest]
    middles = [(np.array(boxes[low]) + boxes[high]) / 2 for low, high in (("x", "x_to"), ("y", "y_to"))]
    found = np.column_stack([*middles, boxes["values"]])
    assert len(found) > len(sweep.values) and (np.diff(found[:, 2]) >= 0).all()  # the largest are drawn last
    assert np.allclose(found, expected[np.argsort(expected[:, 2])], rtol=1e-9, atol=1e-12)
    scale = data["scale"]
    assert scale["log"] and np.allclose((scale["low"], scale["high"]), (1e-3 * largest, largest))
    assert scale["label"] == ("amplitude (mm p-p)" if units else "amplitude (m 0-p)")


SYMBOL = r"\$?[xy]\$?(, \$y\$)?( of \w+)?|gap"


def labels_of(data):
    axes = [axis for panel in data["panels"] for axis in (panel["x"], panel["y"])] + [data.get("scale", {})]
    return [axis["label"].replace("\n", " ") for axis in axes if "label" in axis]


@pytest.mark.parametrize("way", ["0-p", "p-p", "rms"])
def test_every_length_of_every_figure_says_how_it_is_counted(results, way):
    """Tests that labels of positions name no counting of amplitudes, labels of radii "0-p", and labels of amplitudes
    the chosen one, also in figures of any field."""
    units, seen = f"um, rpm, Hz, {way}", set()
    for path in results:
        result = whirl.read(path).show_in(units)
        names = list(result.figures())
        fields = [
            (name + (f":{owner}" if owner else ""), field)
            for table in result.tables.values()
            for name, field in table.fields.items()
            if field.rows == 1 and table.values.size > 1 and table.name == list(result.tables)[0]
            for owner in [result.stations[0].name if field.extent == "station" else ""]
        ]
        for name in names:
            for label in labels_of(result.figure_data(name)):
                if "\u00b5m" not in label:
                    assert not re.search(r"amplitude|radius|distance", label) or "/" in label, (path, name, label)
                    continue
                what, counted = re.fullmatch(r"(.*) \(\u00b5m ?(0-p|p-p|rms)?\)( per radian)?", label).groups()[:2]
                seen.add((what.split()[0], counted))
                expected = way if "amplitude" in what else "0-p" if "radius" in what else None
                place = re.fullmatch(SYMBOL, what) or what.strip("$") in result.parameters
                assert counted == expected and (counted or place), (path, name, label)
        for name, field in fields:
            for column in field.column_names or [""]:
                data = result.figure_data(name + (f":{column}" if column else ""))
                label = data["scale"]["label"] if "scale" in data else data["panels"][0]["y"]["label"]
                if "\u00b5m" not in label:
                    assert field.unit != "length", (name, column, label)
                    continue
                counted = way if "0-p amplitude" in field.meaning else "0-p" if "0-p" in field.meaning else ""
                assert f"(\u00b5m {counted})" in label if counted else "(\u00b5m)" in label, (name, column, label)
                seen.add((field.name, counted))
    assert {("amplitude", way), ("largest", "0-p"), ("unbalance/amplitude", way), ("orbit/max_radius", "0-p")} <= seen


def test_scales_have_the_ticks_of_the_data(map_files):
    result = whirl.open(map_files[1])
    data, figure = result.figure_data("map-radius-disc"), result.figure("map-radius-disc")
    bar = figure.axes[-1]
    assert np.allclose(bar.yaxis.get_majorticklocs(), data["scale"]["ticks"])
    assert [tick.get_text() for tick in bar.yaxis.get_majorticklabels()] == data["scale"]["tick_texts"]
    assert len(data["scale"]["ticks"]) > 1


def test_numbers_equal_but_for_rounding_have_a_scale(tmp_path, map_files):
    text = map_files[0].read_text() if map_files[0].exists() else MAP
    flat = re.sub(r"eccentricity: [^,}]*", "eccentricity: 0 m", text)
    (tmp_path / "flat.yaml").write_text(flat)
    command("run", tmp_path / "flat.yaml", "-o", tmp_path / "flat.h5", "-q")
    result = whirl.open(tmp_path / "flat.h5")
    scale = result.figure_data("map-radius-disc")["scale"]
    assert scale["high"] > scale["low"] and scale["high"] - scale["low"] >= 1e-6 * abs(scale["high"])
    result.figure("map-radius-disc")


def test_any_field_and_any_point(good_file, map_files):
    good, grid = whirl.open(good_file), whirl.open(map_files[1])
    data = good.figure_data("orbit/mean:disc:y")
    table = good["sweep"]
    drawn = sorted((x, y) for series in data["panels"][0]["series"] for x, y in zip(series["x"], series["y"]))
    own = table["orbit/mean"][:, 0, 1] * table.length_scale
    expected = sorted(zip(table.values, own))
    assert np.allclose(drawn, expected, rtol=1e-12)
    assert good.figure_data("orbit/max_radius")["panels"] == good.figure_data("orbit/max_radius:disc")["panels"]
    boxes = grid.figure_data("orbit/max_radius", units="mm")
    radius = grid.figure_data("map-radius-disc", units="mm")
    assert boxes["panels"][0]["series"][0]["values"] == radius["panels"][0]["series"][0]["values"]
    point = good.figure_data("@#2")
    section = next(panel for panel in point["panels"] if panel["name"] == "section")["series"][0]
    assert np.allclose(section["x"], table["poincare/section"][2, 0, :, 0] * table.length_scale[2])
    value = table.values[2]
    assert good.figure_data(f"@{value:.17g}:disc") == point
    for name in (f"@{value:.17g} rad/s:disc", f"sweep/@{value:.17g} rad/s", "sweep/@#2:disc"):
        assert good.figure_data(name) == point
    scaled = good.figure_data("orbit/max_radius", units="mm, rpm")["panels"][0]
    assert "(mm 0-p)" in scaled["y"]["label"] and "(rpm)" in scaled["x"]["label"]
    drawn = sorted((x, y) for series in scaled["series"] for x, y in zip(series["x"], series["y"]))
    radius = table["orbit/max_radius"][:, 0] * table.length_scale
    assert np.allclose(drawn, sorted(zip(table.values * 30 / np.pi, radius * 1e3)), rtol=1e-12)
    assert good.figure_data("poincare/section:disc:vx")["panels"][0]["y"]["label"].endswith("(m) per radian")
    assert good.figure_data("rub/max_force")["panels"][0]["y"]["label"] == "largest normal force (N)"
    assert good.figure_data("regime/code")["title"] == "code over omega"
    for wrong, words in (
        ("orbit/meen", "did you mean orbit/mean"),
        ("orbit/mean:disk", "did you mean disc"),
        ("orbit/mean:disc:z", "no column 'z'"),
        ("@fast", "expected a number"),
        ("@nan", "expected a number"),
        ("@#99", "expected a number from 0 to 4"),
        ("@1:disk", "no station 'disk'"),
    ):
        with pytest.raises(whirl.BadInput, match=words):
            good.figure_data(wrong)
    with pytest.raises(whirl.BadInput, match="rows at every point"):
        grid.figure_data("poincare/section")


def colour_at(data, x, y):
    """Returns colour and opacity of the box at a position in a map's figure; None if there is no box."""
    for series in data["panels"][0]["series"]:
        if series["shape"] != "boxes":
            continue
        low_x, high_x, low_y, high_y = (np.array(series.get(key, [])) for key in ("x", "x_to", "y", "y_to"))
        if ((low_x < x) & (x < high_x) & (low_y < y) & (y < high_y)).any():
            return series["colour"], series["opacity"]
    return None


def test_refined_maps_are_filled(map_files):
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
    x, y = whole["map"].values[0], whole["map"].second_values[:, 0] * 1e3
    pictures = [result.figure_data("map-regime", units="mm") for result in (whole, refined)]
    cells = [[colour_at(data, at, up) for at in x for up in y] for data in pictures]
    assert None not in cells[0] + cells[1] and len(set(cells[0])) > 1
    same = np.mean([one == other for one, other in zip(*cells)])
    assert same > 0.9  # squares that were not refined have the colour of their corners


def test_a_map_shows_what_most_starts_lead_to(starts_map):
    table, data = starts_map["map"], starts_map.figure_data("map-regime")
    code, period = table["regime/code"].astype(int), table["regime/period"].astype(int)
    seen = 0
    for place in np.unique(table.place):
        own = (table.place == place) & np.isfinite(table.shares)
        best = own & (table.shares == table.shares[own].max())
        if len(set(zip(code[best], period[best]))) == 1 and code[best][0] == 1:
            name = {1: "P-1", 2: "P-2", 4: "P-4"}.get(period[best][0], "other P-k")
            at, up = (values[best][0] for values in (table.values, table.second_values))
            share = (0.4, 0.8, 1.0)[int(table["regime/confidence"][best][0])]  # of the colour; the rest is white
            mixed = share * np.array(to_rgb(whirl.plot.REGIMES[name])) + 1 - share
            assert np.allclose(to_rgb(colour_at(data, at, up)[0]), mixed, atol=1 / 255)
            seen += 1
    assert seen >= 3


def test_carried_directions_have_names():
    text = GOOD.read_text().replace("points: 5, start: state", "points: 5, start: carry, direction: both")
    result = whirl.run(whirl.Case(text=text), progress=False)
    table, panel = result["sweep"], result.figure_data("bifurcation-disc")["panels"][0]
    crosses = [series for series in panel["series"] if series.get("mark") == "cross"]
    drawn = {y for series in crosses for y in series.get("y", [])}
    down = table["poincare/section"][table.branch < 0, 0, :, 0] * table.length_scale[0]
    assert drawn and drawn <= set(down.ravel()) and {"last value to first"} <= {series["name"] for series in crosses}


def test_a_record_lies_in_the_figure_of_a_model(tmp_path):
    time = np.arange(6001) / 2000
    angle = 2 * np.pi * (30 * time - 4 * time**2)
    columns = [time, np.sin(angle), 20 * np.cos(angle), 20 * np.sin(angle)]
    file = tmp_path / "down.csv"
    np.savetxt(file, np.transpose(columns), "%.12g", ",", header="time [s],keyphasor,de x [um],de y [um]", comments="")
    record = whirl.signals.load(file)
    assert record.title == "down.csv" and "runup-de" in record.figures()
    (tmp_path / "model.yaml").write_text(
        "whirl: 1\nrotor:\n  speed: 1800 rpm\n  length_scale: 1 um\n"
        "  stations: {de: {mass: 1 kg, damping: 20 N.s/m, eccentricity: 10 um}}\n"
        "  elements: [spring: {between: [de, ground], stiffness: 35000 N/m}]\n"
        "study: {runup: {speed_from: 1800 rpm, speed_to: 600 rpm, rate: 50 rad/s2, rows: 50}}\n"
    )
    command("run", tmp_path / "model.yaml", "-o", tmp_path / "model.h5", "-q")
    model = whirl.open(tmp_path / "model.h5")
    both = model.figure_data("runup-de", other=record)
    own = record.figure_data("runup-de", units="um")
    added = [series for series in both["panels"][1]["series"] if series["dashed"]]
    assert [series["name"] for series in added] == ["$x$ at 1X, measured", "$y$ at 1X, measured"]
    assert added[0]["y"] == own["panels"][1]["series"][0]["y"]
    assert np.allclose(added[0]["y"], 20.0, rtol=1e-3)
    plt.close(model.figure("runup-de", other=record))
    file.write_text("time [s],keyphasor,de x [um]\n0,0,0\n")
    with pytest.raises(whirl.BadInput, match=r"down.csv:1:20: de has one probe"):
        whirl.signals.load(file)
