"""Tests that results in memory and in files have the bits of the command's results."""

import errno
import gc
import importlib.util
import json
import pickle
import subprocess
import weakref

import h5py
import numpy as np
import pytest

import whirl
from conftest import COMMAND, GOOD
from whirl.fields import FIELD


def same(one, other):
    """Returns true if arrays are equal to the bit, NaN included."""
    one, other = np.ascontiguousarray(one), np.ascontiguousarray(other)
    return one.shape == other.shape and one.dtype == other.dtype and one.tobytes() == other.tobytes()


def check_same(memory, file, path):
    """Compares all of a result in memory with a file, read by this package and by h5py alone."""
    assert list(memory.tables) == list(file.tables)
    assert memory.parameters == file.parameters and memory.stations == file.stations
    assert memory.contacts == file.contacts and memory.case_text == file.case_text
    assert (memory.speed, memory.length_scale, memory.force_scale) == (file.speed, file.length_scale, file.force_scale)
    with h5py.File(path) as plain:
        for name, table in memory.tables.items():
            other, group = file.tables[name], plain[name]
            assert len(table) > 3 and list(table) == list(other)
            for field in table:
                np.testing.assert_equal(vars(table.fields[field]), vars(other.fields[field]))  # NaN is equal to NaN
            assert table.options == other.options
            assert same(table.values, group["values"][()]) and same(other.values, group["values"][()])
            assert np.array_equal(table.branch, group["branch"][()])
            assert np.array_equal(table.point, group["point"][()])
            assert same(table.length_scale, group["length_scale"][()])
            assert np.array_equal(table.verdicts, group["verdict/name"].asstr()[()])
            assert np.array_equal(other.reasons, table.reasons)
            for field in table:
                assert same(table[field], group[field][()]), field
                assert same(other[field], group[field][()]), field


def test_run_gives_the_bits_of_the_command(good, good_file):
    check_same(good, whirl.open(good_file), good_file)


def test_maps_have_two_dimensions(map_files):
    case, path = map_files
    result = whirl.run(case, progress=False)
    check_same(result, whirl.open(path), path)
    table = result["map"]
    assert table.shape == (3, 5) and table.second == "c" and table["orbit/max_radius"].shape == (3, 5, 1)
    assert np.allclose(table.second_values[:, 0], [0.1e-3, 0.15e-3, 0.2e-3], rtol=1e-15)
    radius, unit = table.si("orbit/max_radius")
    assert unit == "m" and same(radius[0], table["orbit/max_radius"][0] * table.second_values[0, 0])


def test_planes_are_a_dimension(map_files, tmp_path):
    case = (
        map_files[0].read_text().replace("c: 0.2 mm}", "c: 0.2 mm, f: 0.1}").replace("friction: 0.1", "friction: = f")
    )
    case = case.replace("  integrate", "    z: {parameter: f, values: [0.3, 0.1]}\n  integrate")
    result = whirl.run(whirl.Case(text=case), progress=False)
    result.save(tmp_path / "planes.h5")
    check_same(result, whirl.open(tmp_path / "planes.h5"), tmp_path / "planes.h5")
    plane = whirl.run(whirl.Case(map_files[0]), progress=False)["map"]
    for table in (result["map"], whirl.open(tmp_path / "planes.h5")["map"]):
        assert table.shape == (2, 3, 5) and table.grid == (3, 5) and table.planes == 2 and table.third == "f"
        assert same(table["orbit/max_radius"][1], plane["orbit/max_radius"])  # f = 0.1
        array = table.to_xarray()
        assert array["orbit/max_radius"].dims == ("z", "y", "x", "station")
        assert list(array.z.values) == [0.3, 0.1] and array.z.attrs["parameter"] == "f"
        assert same(np.asarray(array.y.values), plane.second_values[:, 0])
        assert same(np.asarray(array.x.values), plane.values[0])
        assert list(table.to_pandas()["f"]) == [0.3] * 15 + [0.1] * 15


def share_of(hits):
    return hits.mean(), np.sqrt(hits.mean() * (1 - hits.mean()) / hits.size)


def test_attractors_of_a_basin(basin):
    table = basin["basin"]
    number = table.attractors
    assert number.shape == table.shape == (4, 9) and table.role == "basin"
    assert set(np.unique(number)) == {1, 2} and (number == 1).sum() > (number == 2).sum()
    for of in (1, 2):
        share, error = share_of(number == of)
        assert np.allclose(table.shares[number == of], share, rtol=1e-14)
        assert np.allclose(table.share_errors[number == of], error, rtol=1e-14)
        assert len(set(table.verdicts[number == of])) == 1
    # Both motions are synchronous circles of radius r: |k + contact - m w^2 + i d w| r = e m w^2, all lengths in
    # clearances, with `contact` = 1e6 (1 - 1.2/r) while the disc touches.
    radius, forced = table["orbit/max_radius"][..., 0], 4 * 220**2
    inertia = 1e5 - forced + 20j * 220
    assert np.allclose(radius[number == 2], abs(0.1 * forced / inertia), rtol=1e-6)
    leans = radius[number == 1]
    assert np.allclose(abs(inertia + 1e6 * (1 - 1.2 / leans)) * leans, 0.1 * forced, rtol=1e-6)


@pytest.mark.parametrize("name", ["starts", "starts_map"])
def test_attractors_of_several_starts(name, request):
    result = request.getfixturevalue(name)
    (table,) = result.tables.values()
    number = table.attractors
    own = table["starts/neighbour"] == 0  # starts from neighbours are not part of the random sample
    assert number.max() >= 2 and table.place.max() == (3 if name == "starts" else 5)
    for place in np.unique(table.place):
        here = table.place == place
        for of in np.unique(number[here & (number > 0)]):
            share, error = share_of(number[here & own] == of)
            assert np.allclose(table.shares[here & (number == of)], share, rtol=1e-14)
            assert np.allclose(table.share_errors[here & (number == of)], error, rtol=1e-14, atol=1e-15)
    assert np.isnan(table.shares[number == 0]).all()


@pytest.mark.parametrize("name", ["basin", "starts", "starts_map"])
def test_attractors_in_files(name, request, tmp_path):
    result = request.getfixturevalue(name)
    result.save(tmp_path / "a.h5")
    with whirl.open(tmp_path / "a.h5") as opened:
        for table in result.tables.values():
            of = opened[table.name]
            assert (of.grid, of.planes, of.role) == (table.grid, table.planes, table.role)
            for what in ("place", "attractors", "shares", "share_errors"):
                assert np.array_equal(getattr(of, what), getattr(table, what), equal_nan=True), what
            frame = of.to_pandas()
            assert np.array_equal(frame["attractor"], table.attractors.ravel())
            assert "share" in of.to_xarray()


def test_other_tables_have_no_attractors(good):
    table = good["sweep"]
    assert not table.has_attractors and table.attractors is None and table.shares is None


def test_read_checks_the_file(good_file, tmp_path):
    check_same(whirl.read(good_file), whirl.open(good_file), good_file)
    data = bytearray(good_file.read_bytes())
    data[len(data) // 2] ^= 0x40
    (tmp_path / "broken.h5").write_bytes(data)
    with pytest.raises(whirl.Error):
        whirl.read(tmp_path / "broken.h5")


def test_saved_results_are_files_of_the_command(good, good_file, tmp_path):
    good.save(tmp_path / "saved.h5")
    check_same(good, whirl.open(tmp_path / "saved.h5"), good_file)
    assert whirl.open(tmp_path / "saved.h5").facts["program"] == "Python"
    whirl.open(good_file).save(tmp_path / "copied.h5")
    assert (tmp_path / "copied.h5").read_bytes() == good_file.read_bytes()


def test_arrays_are_not_copied_and_outlive_their_result(good_file):
    result = whirl.read(good_file)
    radius, again = result["sweep"]["orbit/max_radius"], result["sweep"]["orbit/max_radius"]
    assert radius.ctypes.data == again.ctypes.data and not radius.flags.writeable and not radius.flags.owndata
    expected, gone = radius.copy(), weakref.ref(result)
    del result, again
    gc.collect()
    assert gone() is None
    rubbish = [whirl.read(good_file)["sweep"].values for _ in range(20)]  # these would overwrite freed memory
    assert len(rubbish) == 20 and same(radius, expected)


def test_opening_reads_no_field(good_file, tmp_path):
    """Tests that a file with damaged numbers opens, and that only reading these numbers fails."""
    path = tmp_path / "damaged.h5"
    path.write_bytes(good_file.read_bytes())
    with h5py.File(path) as file:
        dataset = file["sweep/poincare/section"]
        place = dataset.id.get_chunk_info(0).byte_offset
    data = bytearray(path.read_bytes())
    data[place + 100] ^= 1
    path.write_bytes(data)
    table = whirl.open(path)["sweep"]
    assert len(table.values) == 5 and table["orbit/max_radius"].shape == (5, 1)
    with pytest.raises(whirl.FileFailure, match="damaged.h5' is damaged or was changed"):
        table["poincare/section"]


@pytest.mark.parametrize("place", ["stations", "sweep", "sweep/values", "sweep/orbit", "parameters/name"])
def test_files_that_lack_something_are_refused_in_a_sentence(good_file, tmp_path, place):
    path = tmp_path / "lacks.h5"
    path.write_bytes(good_file.read_bytes())
    with h5py.File(path, "r+") as file:
        del file[place]
    with pytest.raises(whirl.Error, match="lacks.h5"):
        result = whirl.open(path)
        for table in result.tables.values():
            [table[field] for field in table]
        result.stations, result.parameters, table.values


def test_unknown_names(good):
    with pytest.raises(KeyError, match="did you mean 'orbit/max_radius'"):
        good["sweep"]["orbit/maxradius"]
    with pytest.raises(KeyError, match="expected one of: sweep"):
        good["map"]
    with pytest.raises(whirl.BadInput, match="of an outline has no numbers"):
        good.case.outline()["sweep"]["orbit/max_radius"]
    with pytest.raises(whirl.BadInput, match="expected one of: disc"):
        good["sweep"].station("disk")


@pytest.mark.parametrize("data", [b"", b"no HDF5", None])
def test_other_files_are_refused(tmp_path, data):
    path = tmp_path / "x.h5"
    if data is not None:
        path.write_bytes(data)
    for reader in (whirl.open, whirl.read):
        with pytest.raises(whirl.Error, match="x.h5"):
            reader(path)


def test_files_of_other_programs_are_refused(tmp_path):
    with h5py.File(tmp_path / "x.h5", "w") as file:
        file["numbers"] = [1.0]
    with pytest.raises(whirl.BadInput, match="is no result of whirl"):
        whirl.open(tmp_path / "x.h5")


def test_pandas(good):
    pytest.importorskip("pandas")
    table = good["sweep"]
    frame = table.to_pandas()
    assert list(frame.columns[:4]) == ["point", "omega", "branch", "verdict"]
    assert same(frame["omega"].to_numpy(), table.values)
    assert same(frame["orbit/mean disc y"].to_numpy(), table["orbit/mean"][:, 0, 1])
    assert frame.attrs["units"]["orbit/max_radius disc"] == "length" and frame.attrs["units"]["omega"] == "rad/s"


def test_xarray(good, map_files):
    pytest.importorskip("xarray")
    data = good["sweep"].to_xarray()
    assert data["poincare/section"].dims[:2] == ("point", "station")
    assert list(data["poincare/section column"].values) == ["x", "y", "vx", "vy"]
    table = whirl.open(map_files[1])["map"]
    lazy = table.to_xarray()
    assert lazy["orbit/max_radius"].dims == ("y", "x", "station")
    assert lazy.x.attrs == {"unit": "rad/s", "parameter": "omega"}
    radius = lazy["orbit/max_radius"].sel(x=50, station="disc")
    assert float(radius[0]) == table["orbit/max_radius"][0, 0, 0]
    if importlib.util.find_spec("dask"):
        assert not isinstance(lazy["orbit/max_radius"].data, np.ndarray)


def test_points_of_xarray_are_chosen_by_the_parameter(good):
    xarray = pytest.importorskip("xarray")
    if not hasattr(xarray.Dataset, "set_xindex"):
        pytest.skip("an xarray before 2022.11")
    table, data = good["sweep"], good["sweep"].to_xarray()
    near = data.sel({table.parameter: table.values[3] * 1.0001}, method="nearest")
    assert float(near["orbit/max_radius"][0]) == table["orbit/max_radius"][3, 0]


def test_results_and_tables_are_as_dictionaries(good):
    assert "sweep" in good and "map" not in good and bool(good)
    assert list(good) == list(good.keys()) == ["sweep"] and len(good) == 1
    assert dict(good.items())["sweep"] is good["sweep"] and list(good.values()) == [good["sweep"]]
    assert list(good["sweep"].keys()) == list(good["sweep"])
    assert good.get("sweep") is good["sweep"] and good.get("modes") is None


def test_a_notebook_shows_something(good, monkeypatch):
    monkeypatch.setattr("whirl.result.find_template", lambda: None)
    assert "<td>sweep</td><td>5</td><td>omega</td>" in good._repr_html_()


def test_the_explorer_holds_the_result(good, good_file, tmp_path):
    (tmp_path / "empty.html").write_text("<html></html>")
    with pytest.raises(whirl.BadInput, match="has no place for results"):
        good.explorer(template=tmp_path / "empty.html")
    (tmp_path / "template.html").write_text("<html>@WHIRL-RUNS@</html>")
    page = good.explorer(template=tmp_path / "template.html")
    assert good.title in page and len(page) > 1000
    whirl.open(good_file).explorer(tmp_path / "page.html", template=tmp_path / "template.html")
    assert good.title in (tmp_path / "page.html").read_text()


SPEEDS = """
whirl: 1
parameters: {n: 50, omega: = 2*pi*n, order: 1}
rotor:
  speed: = %s
  length_scale: 0.2 mm
  stations:
    disc: {mass: 4 kg, damping: 20 N.s/m, eccentricity: 0.02 mm}
  elements:
    - shaft: {between: [disc, ground], k1: 100 kN/m, k2: 100 kN/m}
study:
  sweep: {parameter: n, values: [20, 35, 50]}
  integrate: {method: dop853, rtol: 1e-10, transient: 60, record: 400}
  analyze: [poincare, lyapunov]
"""


@pytest.mark.parametrize("speed, hertz", [("omega", [20, 35, 50]), ("2*pi*50", 50), ("omega+n^2", np.nan)])
def test_si_where_the_speed_changes(speed, hertz, tmp_path):
    result = whirl.run(whirl.Case(text=SPEEDS % speed), progress=False)
    result.save(tmp_path / "speeds.h5")
    with whirl.open(tmp_path / "speeds.h5") as opened:
        for table in (result["sweep"], opened["sweep"], whirl.read(tmp_path / "speeds.h5")["sweep"]):
            assert np.allclose(table.clock / (2 * np.pi), hertz, rtol=1e-14, equal_nan=True)
            exponent, unit = table.si("lyapunov/largest")
            assert unit == "1/s" and np.allclose(exponent, table["lyapunov/largest"] * hertz, equal_nan=True)
            if np.isfinite(hertz).all() and speed == "omega":
                # A perturbation of a linear rotor decays as exp(-d t/(2 m)) at every speed. Its norm includes
                # velocities divided by the speed, so it oscillates by a factor of natural frequency over speed, at most
                # 2. The error of the exponent is therefore up to log(2) over the length of the record, at least 8 s.
                assert np.allclose(exponent, -2.5, atol=np.log(2) / 8 + 0.02)


def test_clocks_of_keyphasors_and_of_own_systems(map_files):
    text = (SPEEDS % "omega").replace(
        "    - shaft", "    - force: {at: disc, amplitude: 1 N, ratio: %s, keyphasor: yes}\n    - shaft"
    )
    for ratio, varied, clock in (("1.5", "order", 150 * np.pi), ("= order", "order", np.nan), ("1.5", "n", np.nan)):
        case = text.replace("parameter: n, values: [20, 35, 50]", f"parameter: {varied}, values: [1, 2]") % ratio
        if varied == "order" and ratio != "= order":
            case = case.replace("damping: 20 N.s/m", "damping: = 20*order")
        assert np.allclose(whirl.Case(text=case).outline()["sweep"].clock, clock, equal_nan=True), (ratio, varied)
    own = whirl.systems.System(lambda t, x, p: [-x[0]], [1.0], {"w": 1.0}, speed="w")
    table = own.sweep("w", [1.0, 1.2, 2.0], transient=1, record=2, analyze="poincare")["sweep"]
    assert np.array_equal(table.clock, [1.0, 1.2, 2.0])
    with whirl.open(map_files[1]) as opened:
        assert np.array_equal(opened["map"].clock, opened["map"].values)
        with pytest.raises(ValueError, match="read-only"):
            opened["map"].second_values[0] = 1.0
    assert np.array_equal(np.unique(whirl.Case(map_files[0]).outline()["map"].clock), np.linspace(50, 400, 5))


@pytest.mark.parametrize("name, value", [("plane", 0), ("starts", 0), ("clock_of", -1), ("clock_of", 5)])
def test_attributes_that_cannot_be(map_files, tmp_path, name, value):
    (tmp_path / "bad.h5").write_bytes(map_files[1].read_bytes())
    with h5py.File(tmp_path / "bad.h5", "r+") as file:
        file["map"].attrs[name] = value
    with pytest.raises(whirl.FileFailure, match="damaged"):
        whirl.open(tmp_path / "bad.h5")["map"].clock


def test_orders_are_no_lengths(good):
    lines, unit = good["sweep"].si("spectrum/lines")
    plain = good["sweep"]["spectrum/lines"]
    assert unit == "m" and np.array_equal(lines[..., 0], plain[..., 0], equal_nan=True)
    assert np.allclose(lines[..., 1:], plain[..., 1:] * good.length_scale, equal_nan=True)


def test_stored_numbers_are_not_written_to(good, good_file):
    with whirl.open(good_file) as opened:
        for table in (good["sweep"], opened["sweep"]):
            for array in (table.values, table.length_scale, table.point, table.branch, table.verdicts, table.clock):
                with pytest.raises(ValueError, match="read-only"):
                    array[0] = array[1]


@pytest.mark.parametrize("name", ["branch", "point", "verdict", "station", "x"])
def test_parameters_may_be_called_as_columns(name):
    text = (
        SPEEDS.replace("n: 50", f"{name}: 50")
        .replace("2*pi*n", f"2*pi*{name}")
        .replace("parameter: n", f"parameter: {name}")
    )
    table = whirl.run(whirl.Case(text=text % "omega"), progress=False)["sweep"]
    frame = table.to_pandas()
    assert list(frame[f"parameter {name}"]) == [20, 35, 50] and list(frame["point"]) == [1, 2, 3]
    assert list(table.to_xarray()[f"parameter {name}"].values) == [20, 35, 50]


def test_errors_of_files_are_sentences(good_file, tmp_path):
    opened = whirl.open(good_file)
    opened.close()
    with pytest.raises(whirl.BadInput, match="was closed"):
        opened["sweep"]
    with pytest.raises(TypeError):
        whirl.open(5)
    with pytest.raises(whirl.BadInput, match="the name of a file has a NUL"):
        whirl.open("a\0b.h5")
    with whirl.open(good_file) as opened:
        with pytest.raises(whirl.FileFailure, match="cannot write"):
            opened.save(tmp_path / "nowhere" / "a.h5")
        with pytest.raises(whirl.FileFailure, match="cannot write"):
            opened.save(tmp_path)
        with pytest.raises(KeyError, match="by their names"):
            opened["sweep"][5]
        with pytest.raises(whirl.BadInput, match="value is nan, expected a number"):
            opened["sweep"].at(np.nan)
        opened.save(tmp_path / "copy.h5")
    assert [path.name for path in tmp_path.iterdir()] == ["copy.h5"]
    assert (tmp_path / "copy.h5").read_bytes() == good_file.read_bytes()
    with pytest.raises(whirl.BadInput, match="NUL"):
        whirl.read(good_file).save("a\0b.h5")


def test_laws_that_are_left_are_reported():
    case = whirl.Case(
        {
            "parameters": {"load": "10 m/s2"},
            "rotor": {
                "speed": "3000 rpm",
                "length_scale": "0.1 mm",
                "stations": {"journal": {"mass": "20 kg"}},
                "elements": [
                    {
                        "film": {
                            "at": "journal",
                            "law": "finite",
                            "clearance": "0.1 mm",
                            "viscosity": "18 mPa.s",
                            "radius": "25 mm",
                            "length": "25 mm",
                        }
                    },
                    {"gravity": "= load"},
                ],
            },
            "study": {"modes": {"parameter": "load", "values": [10, 2000]}},
        }
    )
    result = whirl.run(case, progress=False)
    assert list(result["modes"][FIELD.RANGES_LEFT].ravel()) == [0, 1]
    (reported,) = result.beyond
    assert (
        reported.startswith("modes: film at journal: eccentricity ratio up to 0.95") and "(1 of 2 points)" in reported
    )


def test_contacts_that_hold_a_machine_at_rest():
    """Tests a weight of 200 N: the spring of 400 kN/m carries 80 N at the gap, and the stator of 2 MN/m then takes 100
    N."""
    case = whirl.Case(
        {
            "parameters": {"load": "10 m/s2"},
            "rotor": {
                "speed": "200 rad/s",
                "length_scale": "0.1 mm",
                "stations": {"disc": {"mass": "10 kg", "damping": "600 N.s/m"}},
                "elements": [
                    {"spring": {"between": ["disc", "ground"], "stiffness": "400 kN/m"}},
                    {"rub": {"at": "disc", "gap": "0.2 mm", "stiffness": "2 MN/m", "friction": 0}},
                    {"gravity": "= load"},
                ],
            },
            "study": {"modes": {"parameter": "load", "values": [1, 20]}},
        }
    )
    result = whirl.run(case, progress=False)
    assert result.held == ["modes: rub at disc with 100 N (1 of 2 points)"]


def test_tables_after_a_stop_are_empty(tmp_path):
    (tmp_path / "case.yaml").write_text(
        "whirl: 1\nparameters: {load: 10 m/s2}\nrotor:\n  speed: 200 rad/s\n  length_scale: 0.1 mm\n  stations:\n"
        "    disc: {mass: 10 kg, damping: 600 N.s/m}\n  elements:\n"
        "    - spring: {between: [disc, ground], stiffness: 400 kN/m}\n"
        "    - rub: {at: disc, gap: 0.2 mm, stiffness: 2 MN/m, radius: 50 mm}\n    - gravity: = load\nstudy:\n"
        "  modes: {parameter: load, from: 1, to: 2, points: 1000000}\n"
        "  unbalance: {parameter: load, from: 1, to: 2, points: 9}\n"
    )
    words = [COMMAND, "run", "case.yaml", "-q", "-o", "case.h5", "--max-time", "0.3 s"]
    assert subprocess.run(words, cwd=tmp_path, stderr=subprocess.DEVNULL).returncode == 3
    result = whirl.open(tmp_path / "case.h5")
    assert len(result["unbalance"].values) == 0
    assert result.held == [] and result.beyond == []


WARNED = """
whirl: 1
parameters: {speed: 6000}
rotor:
  speed: = speed
  length_scale: 1 mm
  stations: {d: {mass: 10 kg, eccentricity: 1 um}}
  elements:
    - shaft: {between: [d, ground], k1: 1 MN/m}
    - film: {at: d, clearance: 100 um, viscosity: 2 mPa.s, radius: 25 mm, length: 200 mm}
study: {response: {}, integrate: {transient: 5, record: 5}}
"""


def test_warnings_of_the_library_are_shown(tmp_path):
    case = whirl.Case(text=WARNED)
    with pytest.warns(UserWarning, match="film.length: is 4 times the diameter") as shown:
        result = whirl.run(case, progress=False)
    (reported,) = case.warnings
    assert [str(one.message) for one in shown] == [reported] == result.warnings and shown[0].filename == __file__
    assert repr(result).endswith(", 1 warning>")
    lines = str(result).splitlines()
    assert lines[1:4] == [f"warning: {reported}", "response: 1 point", f"  motion: {result['response'].verdicts[0]}"]
    assert lines[4].startswith("  reason: ") and lines[-1] == "weight: none: the machine has no gravity"
    result.save(tmp_path / "a.h5")
    for again in (whirl.open(tmp_path / "a.h5"), whirl.read(tmp_path / "a.h5")):
        assert again.warnings == [reported] and repr(again).endswith(", 1 warning>")


def test_warnings_are_in_the_units_of_the_case():
    text = "rotor: {{speed: 300, length_scale: 1 mm, stations: {{a: {{mass: 1 kg}}}}, elements: [{}]}}"
    film = "{film: {at: a, clearance: 30 mm, viscosity: 0.1, radius: 12.7 m, length: 1 m}}"
    case = whirl.Case(text=f"whirl: 1\n{text.format(film)}\nstudy: {{modes: {{}}, units: US}}\n")
    (reported,) = [words for words in case.warnings if "bearings have up to" in words]
    assert reported.endswith("radius: is 500000 mil, and bearings have up to 393700 mil")


def test_no_warning_where_there_is_none(good):
    assert good.warnings == [] and "warning" not in repr(good)


def test_copies_are_read_only(good, good_file):
    case = whirl.Case(GOOD)
    for copy, words in (
        (case.parameters, "case.set"),
        (good.parameters, "case.set"),
        (good.facts, "facts"),
        (good.tables, "tables"),
        (good["sweep"].fields, "fields"),
        (good["sweep"].options, "case.set"),
        (whirl.open(good_file)["sweep"].options, "case.set"),
    ):
        before = dict(copy)
        for change in (
            lambda copy: copy.__setitem__("a", 1),
            lambda copy: copy.__delitem__(next(iter(copy))),
            lambda copy: copy.update(a=1),
            lambda copy: copy.clear(),
            lambda copy: copy.pop(next(iter(copy))),
            lambda copy: copy.setdefault("a", 1),
            lambda copy: copy.__ior__({"a": 1}),
        ):
            with pytest.raises(TypeError, match=f"is a copy.*{words}"):
                change(copy)
        assert dict(copy) == before == copy.copy() and type(copy.copy()) is dict
    assert json.loads(json.dumps(good.facts)) == good.facts == pickle.loads(pickle.dumps(good.facts))


def test_existing_files_are_not_replaced(good, good_file, tmp_path):
    mine, page = tmp_path / "mine.h5", tmp_path / "template.html"
    page.write_text("@WHIRL-RUNS@")
    for result in (good, whirl.open(good_file), whirl.read(good_file)):
        for write in (result.save, lambda path, **more: result.explorer(path, template=page, **more)):
            mine.write_text("mine")
            with pytest.raises(FileExistsError, match="is there already and is kept: overwrite=True") as caught:
                write(mine)
            assert isinstance(caught.value, whirl.FileFailure) and mine.read_text() == "mine"
            write(mine, overwrite=True)
            assert mine.read_bytes()[:4] != b"mine"
    for name in ("a.csv", "a.TXT", "fan.json", "fan.yaml", "a.mat"):
        with pytest.raises(whirl.BadInput, match="ending of another kind of file, expected the name of a result"):
            good.save(tmp_path / name)
        assert not (tmp_path / name).exists()
    for name in ("a", "a.hdf5", "omega-1.5", "a.csv.h5"):
        good.save(tmp_path / name)


def test_notebooks_find_the_explorer_next_to_the_command(good, tmp_path, monkeypatch):
    bin_folder, page = tmp_path / "bin", tmp_path / "share/whirl/explorer.html"
    bin_folder.mkdir(), page.parent.mkdir(parents=True)
    (bin_folder / "whirl").write_text("#!/bin/sh\n")
    (bin_folder / "whirl").chmod(0o755)
    monkeypatch.delenv("WHIRL_EXPLORER", raising=False)
    monkeypatch.setenv("PATH", str(bin_folder))
    if whirl.result.find_template() is None:  # no explorer is installed on this computer
        assert "make explorer" in good._repr_html_() and "<table>" in good._repr_html_()
    page.write_text("@WHIRL-RUNS@")
    assert whirl.result.find_template() == page and "<iframe" in good._repr_html_()


def test_missing_files_are_missing_files(tmp_path):
    missing = tmp_path / "no.h5"
    reads = (whirl.open, whirl.read, whirl.Case, whirl.run, whirl.balance, whirl.bearing)
    for read in reads:
        with pytest.raises(FileNotFoundError, match="^cannot read .*no.h5'?: No such file") as caught:
            read(missing)
        assert isinstance(caught.value, whirl.BadInput) and caught.value.errno == errno.ENOENT


def test_a_wrong_kind_of_thing_is_one_sentence(good, good_file):
    for call, kind, words in (
        (lambda: good.figure(3), whirl.BadInput, "3 is no text"),
        (lambda: good.parameters["omgea"], KeyError, "there is no 'omgea', did you mean 'omega'"),
        (lambda: good.plot.bifurcation(ax=3), whirl.BadInput, "ax is 3, expected axes of Matplotlib"),
        (lambda: whirl.Case(good_file), whirl.BadInput, "is a result, expected a case: whirl.open"),
        (lambda: whirl.open(GOOD), whirl.BadInput, "it is no HDF5 file, expected a result"),
        (lambda: whirl.Case([1]), TypeError, r"a case is \[1\], expected the name of a file or a dict"),
        (lambda: whirl.Case(GOOD).spend("10 s"), whirl.BadInput, "to spend are '10 s', expected a number"),
    ):
        with pytest.raises(kind, match=words):
            call()
