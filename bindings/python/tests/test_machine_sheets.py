"""Tests the sheets of bearings, seals, dampers, magnets and supports: they have the numbers of the case, converted by
hand, and the equilibria of the statics."""

import re

import numpy as np
import pytest
from conftest import ROOT, command

import whirl
from whirl.fields import FIELD

MACHINE = """
whirl: 1
parameters: {{q: 2 MN/m}}
rotor:
  speed: 3000 rpm
  {rotation}
  length_scale: 0.1 mm
  stations:
    pads: {{mass: 50 kg}}
    turned: {{mass: 50 kg}}
    film: {{mass: 50 kg}}
    damper: {{mass: 50 kg}}
    housing: {{mass: 50 kg}}
    magnet: {{mass: 50 kg}}
    linear: {{mass: 50 kg}}
    table: {{mass: 50 kg}}
    seal: {{mass: 50 kg}}
    ball: {{mass: 50 kg}}
  elements:
    - gravity: {{}}
    - tilting_pad: {{at: pads, shape: tilting-5, preload: 0.4, clearance: 0.1 mm, radius: 50 mm, length: 60 mm,
                    grade: 32, temperature: 50 degC, density: 860 kg/m3}}
    - tilting_pad: {{at: turned, shape: tilting-5, turned: 36 deg, clearance: 0.1 mm, radius: 50 mm, length: 60 mm,
                    kinematic_viscosity: 20 mm2/s, density: 850 kg/m3}}
    - film: {{at: film, from: housing, clearance: 80 um, load: 4 kN{supply}}}
    - squeeze: {{at: damper, from: housing, clearance: 0.15 mm, radius: 90 mm, length: 30 mm, viscosity: 10 mPa.s}}
    - spring: {{between: [damper, housing], stiffness: 12 MN/m, damping: 3 kN.s/m}}
    - spring: {{between: [ground, housing], stiffness: 100 MN/m}}
    - magnetic: {{at: magnet, gap: 0.4 mm, bias: 2 A, constant: 3e-5, proportional: 2e4, derivative: 30,
                 derivative_filter: 0.1 ms, amplifier_bandwidth: 1 kHz}}
    - bearing: {{at: linear, kxx: = q, cxx: 1 kN.s/m}}
    - bearing: {{at: table, speeds: [1000 rpm, 6000 rpm], kxx: [1e7, 2e7]}}
    - seal: {{at: seal, clearance: 0.2 mm, law: black, radius: 40 mm, length: 20 mm, density: 800 kg/m3,
             viscosity: 0.5 mPa.s, pressure: 2 MPa}}
    - ball_bearing: {{at: ball, balls: 8, stiffness: 1e9, inner: 20 mm, outer: 30 mm, clearance: 5 um}}
study: {{modes: {{parameter: q, values: [2 MN/m]}}}}
"""


def machine(rotation="", supply=""):
    return whirl.run(whirl.Case(text=MACHINE.format(rotation=rotation, supply=supply)), progress=False)


@pytest.fixture(scope="module")
def parts():
    return machine()


def rows(result, name, units=None):
    """Returns rows of a sheet by station, in the units shown."""
    return {row["station"]: row for row in result.sheet(name, units).records()}


def test_supply_of_oil_is_described_and_not_used(parts):
    supplied = machine(supply=", supply_temperature: 40 degC, supply_pressure: 1.5 bar")
    film = rows(supplied, "journal_bearings", "US")["film"]
    # 40 degC is 104 degF; a psi is 0.45359237 kg 9.80665 m/s2/(25.4 mm)^2.
    assert film["supply_temperature"] == pytest.approx(104.0)
    assert film["supply_pressure"] == pytest.approx(1.5e5 / (0.45359237 * 9.80665 / 0.0254**2))
    headings = [c.heading for c in supplied.sheet("journal_bearings").columns if c.key.startswith("supply")]
    assert len(headings) == 2 and all("not used" in heading for heading in headings)
    for field in ("modes/frequency", "modes/damping_ratio"):
        assert np.array_equal(supplied["modes"][field], parts["modes"][field], equal_nan=True)


def test_films(parts):
    own = {key: rows(parts, "journal_bearings", key) for key in ("SI", "US")}
    # ISO VG 32 of viscosity index 100 has 20.5 mm2/s at 50 degC by Walther's law between 32 and 5.36 mm2/s.
    v = lambda nu: np.log10(np.log10(nu + 0.7))  # noqa: E731
    slope = (v(32.0) - v(5.36)) / (np.log10(373.15) - np.log10(313.15))
    walther = 10**10 ** (v(32.0) - slope * (np.log10(323.15) - np.log10(313.15))) - 0.7
    pad = own["US"]["pads"]
    assert pad["diameter"] == pytest.approx(100 / 25.4) and pad["length"] == pytest.approx(60 / 25.4)
    assert pad["clearance"] == pytest.approx(0.1e3 / 25.4) and pad["assembled"] == pytest.approx(0.06e3 / 25.4)
    assert pad["temperature"] == pytest.approx(122.0) and pad["length_ratio"] == pytest.approx(0.6)
    assert pad["viscosity"] == pytest.approx(860 * walther * 1e-6 * 1e3, rel=0.01)  # cP is mPa s
    assert (pad["preload"], pad["offset"], pad["pads"], pad["arc"]) == pytest.approx((0.4, 0.5, 5, 60))
    assert (pad["kind"], pad["oil"]) == ("tilting pad, tilting-5", "ISO VG 32")
    assert own["SI"]["turned"]["viscosity"] == pytest.approx(17.0e-3 / 1e-3, rel=1e-12)
    # The pivots of tilting-5 are 72 degrees apart with the load between two pads; turned by 36 degrees, it is on a pad.
    assert sorted(np.mod(pad["pivots"], 72.0)) == pytest.approx([18.0] * 5)
    assert pad["weight"].startswith("between pads ") and own["US"]["turned"]["weight"].startswith("on pad ")
    film, squeeze = own["US"]["film"], own["US"]["damper"]
    assert film["force"] == pytest.approx(4000 / 4.4482216) and film["diameter"] is None and film["viscosity"] is None
    assert squeeze["diameter"] == pytest.approx(180 / 25.4) and squeeze["clearance"] == pytest.approx(150 / 25.4)
    assert squeeze["housing"] == film["housing"] == "housing" and squeeze["kind"] == "squeeze, short, half"
    weight, *unknown = [reported.found for reported in parts.statements() if reported.table == ""]
    assert weight == "9.80665 m/s2 across the shafts"
    assert len(unknown) == 2 and unknown[0].startswith("linear, table: ") and unknown[1].startswith("film: ")


def test_clockwise_pads_are_the_mirror_image(parts):
    """Tests a rotor that turns clockwise: the weight keeps its direction, and a pivot at an angle a is at 180 degrees -
    a."""
    mirrored = rows(machine("rotation: clockwise"), "journal_bearings")
    own = rows(parts, "journal_bearings")
    assert sorted(np.mod(180.0 - np.array(own["pads"]["pivots"]), 360.0)) == pytest.approx(
        sorted(mirrored["pads"]["pivots"])
    )
    assert mirrored["pads"]["weight"].startswith("between pads ")


def test_others(parts):
    magnet = rows(parts, "magnetic_bearings", "um")["magnet"]
    assert (magnet["bias"], magnet["proportional"], magnet["derivative"]) == (2.0, 2e4, 30.0)
    assert magnet["gap"] == pytest.approx(400.0) and magnet["pole_angle"] == pytest.approx(22.5)
    assert parts.sheet("magnetic_bearings").records(si=True)[0]["amplifier_bandwidth"] == pytest.approx(2e3 * np.pi)
    linear, table = (rows(parts, "linear_bearings", "US")[name] for name in ("linear", "table"))
    pound_inch = 4.4482216 / 0.0254
    assert linear["kxx"] * parts.sheet("linear_bearings", "US").columns[3].size == pytest.approx(2e6)
    assert linear["kyy"] == linear["kxx"] and linear["kxy"] == 0.0
    assert parts.sheet("linear_bearings", "US").columns[3].size == pytest.approx(pound_inch, rel=1e-6)
    assert table["kxx"] is None and table["speeds"] == pytest.approx((1000.0, 6000.0))
    seal = rows(parts, "seals", "US")["seal"]
    assert seal["pressure"] == pytest.approx(2e6 / 6894.757, rel=1e-6) and seal["diameter"] == pytest.approx(80 / 25.4)
    assert (seal["swirl"], seal["loss"], seal["stiffness"]) == (0.5, 0.5, None)
    ball = rows(parts, "rolling_bearings", "um")["ball"]
    assert (ball["balls"], ball["inner"], ball["outer"], ball["clearance"]) == pytest.approx((8, 40, 60, 5))
    springs = parts.sheet("supports").records()
    assert [(one["station"], one["other"]) for one in springs] == [("housing", "")]
    assert parts.sheet("supports").si[0][4] == pytest.approx(100e6)


def test_places_of_rest_are_those_of_the_statics(tmp_path):
    text = (ROOT / "cases/pump.yaml").read_text()
    text = text.replace("  statics: {}", "  statics: {parameter: speed, from: 600 rpm, to: 5400 rpm, points: 25}")
    text = re.sub(r"(?m)^  (motions|starts|integrate|analyze|modes|critical_speeds|stability):.*\n", "", text)
    text = re.sub(r"(?m)^  conditions:\n(    .*\n)*", "", text).replace("points: 97", "points: 5")
    result = whirl.run(whirl.Case(text=text), progress=False)
    statics, sheet = result["statics"], result.sheet("films")
    fields = {key: f"statics/{key}" for key in ("eccentricity", "attitude", "load")}
    names = [station.name for station in result.stations]
    speeds = []
    for row, si in zip(sheet.records(), sheet.si):
        point, station = int(np.argmin(abs(statics.values - si[0]))), names.index(row["station"])
        assert statics.values[point] == pytest.approx(si[0], rel=1e-12)
        place = np.asarray(statics.si(FIELD.STATICS_PLACE)[0]).reshape(25, len(names), 2)[point, station]
        read = {key: si[sheet.keys.index(key)] for key in ("eccentricity", "attitude", "film", "load")}
        for key, field in fields.items():
            own = np.asarray(statics[field]).reshape(25, len(names))[point, station]
            assert (read[key] is None and np.isnan(own)) or read[key] == pytest.approx(own, rel=1e-12)
        clearance = 250e-6 if row["in"] == "seal" else 90e-6
        assert np.hypot(*place) == pytest.approx(read["eccentricity"] * clearance, rel=1e-9)
        assert read["film"] == pytest.approx(clearance * (1 - read["eccentricity"]), rel=1e-6)
        speeds.append(round(row[sheet.keys[0]]))
    # The sheet has the first and the last speed, some between, and those nearest to the running speeds of 3240 and
    # 3780.
    assert sorted(set(speeds)) == [600, 1800, 3000, 3200, 3800, 4200, 5400]


def test_figure_of_places_of_rest():
    """Tests the figure of rest positions: one panel for each bearing and none for the seals, the positions of the
    statics in the figure's units, and the walls at the clearance."""
    text = (ROOT / "cases/pump.yaml").read_text()
    text = text.replace("  statics: {}", "  statics: {parameter: speed, values: [1000 rpm, 2000 rpm, 4000 rpm]}")
    text = re.sub(r"(?m)^  (motions|starts|integrate|analyze|modes|critical_speeds|stability):.*\n", "", text)
    text = re.sub(r"(?m)^  unbalance:\n(    .*\n)*", "", text)
    text = re.sub(r"(?m)^  conditions:\n(    .*\n)*", "", text)
    result = whirl.run(whirl.Case(text=text), progress=False)
    figure = result.figure_data("centreline")
    assert [panel["title"] for panel in figure["panels"]] == ["drive", "free"]  # no seals
    place = np.asarray(result["statics"].si(FIELD.STATICS_PLACE)[0]).reshape(3, -1, 2)[:, 1]
    (dots,) = [one for one in figure["panels"][0]["series"] if one["shape"] == "dots"]
    np.testing.assert_allclose(np.transpose([dots["x"], dots["y"]]), 1e6 * place, rtol=1e-9)
    wall = figure["panels"][0]["series"][0]
    np.testing.assert_allclose(np.hypot(wall["x"], wall["y"]), 90.0, rtol=1e-9)


def test_command_and_python_agree(parts, tmp_path):
    parts.save(tmp_path / "r.h5")
    assert command("table", tmp_path / "r.h5", "journal_bearings").stdout == parts.sheet_text("journal_bearings")
