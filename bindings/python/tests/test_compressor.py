"""Tests the compressor that is part of ROSS: results agree with an independent finite element program (beam_rotor.py)
and with numbers of ROSS."""

import re

import numpy as np
import pytest
from conftest import ROOT, command

import whirl

pytest.importorskip("scipy")
from beam_rotor import Rotor, margin_asked, peak  # noqa: E402  (of which scipy is a part)

RPM = np.pi / 30
FILE = ROOT / "tests/rotors/ross/compressor.toml"
JOURNALS = (7, 48)  # nodes of the bearings
MAXIMUM = 10500  # rpm; continuous

# Keys of the shaft: all 56 nodes, and the default reduction, which keeps the displacements of stations and the 8 lowest
# modes between them.
ALL, USUAL = "reduce: no", "modes: 8"


@pytest.fixture(scope="module")
def case(tmp_path_factory):
    """Returns the imported case of the compressor without its study: [True] with bearings and seals, [False] with
    bearings alone."""
    path = tmp_path_factory.mktemp("compressor") / "case.yaml"
    command("import", FILE, "-o", path)
    text = path.read_text().partition("\nstudy:")[0]
    parts = re.split(r"(?=\n    # (?:Seal|Bearing) )", text)
    assert len(parts) == 15
    return {True: text, False: "".join(part for part in parts if "role: seal" not in part)}


@pytest.fixture(scope="module")
def rotor():
    return {seals: Rotor.of_ross(FILE, seals) for seals in (True, False)}


def run(text, study, shaft=ALL):
    assert "shaft: {shear: cowper}" in text
    text = text.replace("shaft: {shear: cowper}", f"shaft: {{shear: cowper, {shaft}}}")
    return whirl.run(whirl.Case(text=f"{text}\nstudy:\n  {study}\n"), progress=False)


def with_stiffness(text):
    return text.replace("parameters:\n", "parameters:\n  k: 100 MN/m\n", 1)


@pytest.mark.parametrize(
    "seals, speed, shaft", ((True, 10999, ALL), (False, 4001, ALL), (True, 4001, USUAL), (False, 10999, USUAL))
)
def test_modes(case, rotor, seals, speed, shaft):
    """Tests damped frequencies, decrements and directions of whirl at a speed in rpm."""
    tolerance, fastest = (1e-8, np.inf) if shaft == ALL else (5e-4, 4000)
    table = run(case[seals], f"modes: {{parameter: speed, values: [{speed} rpm]}}", shaft)["modes"]
    expected, whirling = rotor[seals].modes(speed * RPM)
    own = table["modes/growth"][0] + 1j * table["modes/frequency"][0]
    # Leave out nearly aperiodic modes, whose frequency is the root of a small difference and therefore inaccurate.
    keep = (-own.real < 0.99 * abs(own)) & (abs(own) < fastest)
    assert keep.sum() >= 6
    for value, decrement, direction in zip(
        own[keep], table["modes/decrement"][0][keep], table["modes/direction"][0][keep]
    ):
        nearest = np.argmin(abs(expected - value))
        assert abs(value - expected[nearest]) < tolerance * abs(value)
        known = -2 * np.pi * expected[nearest].real / expected[nearest].imag
        assert decrement == pytest.approx(known, rel=10 * tolerance)
        assert direction == pytest.approx(whirling[nearest], abs=0.1)


# ross/tests/test_rotor_assembly.py, test_ucs_rotor9 (commit 631a249): the four lowest forward synchronous speeds in
# rad/s on bearings of 1e6, 10^8.5 and 1e11 N/m. ROSS's tolerance is 1e-6 of each.
ROSS_MAP = (
    (89.61947056, 126.08902134, 1006.73169597, 2282.84557629),
    (670.08583401, 1971.00830161, 2100.24701415, 2383.54778909),
    (705.86888929, 2251.5657217, 3385.80171304, 4549.46314886),
)


def test_map(case, rotor):
    """Tests the forward and backward critical speeds over the stiffness of the bearings, and the bearings' own
    stiffness at these speeds."""
    study = "critical_speeds: {parameter: k, from: 1 MN/m, to: 100 GN/m, points: 3, scale: log, bearings: yes}"
    all, usual = (run(with_stiffness(case[True]), study, shaft)["critical_speeds"] for shaft in (ALL, USUAL))
    for i, stiffness in enumerate(np.logspace(6, 11, 3)):
        for forward in (True, False):
            expected = rotor[True].undamped(stiffness, JOURNALS, forward)[0]
            of = [
                table["critical_speeds/speed"][i][(table["critical_speeds/direction"][i] > 0) == forward]
                for table in (all, usual)
            ]
            assert of[0][:6] == pytest.approx(expected[:6], rel=1e-9)
            assert of[1][:4] == pytest.approx(expected[:4], rel=1e-3)
            assert of[1][:2] == pytest.approx(expected[:2], rel=2e-4)
            if forward:
                assert of[0][:4] == pytest.approx(ROSS_MAP[i], rel=1e-6)
    table = rotor[False].bearings[0][1]["kxx"]
    speeds, own = all["critical_speeds/speed"], all["critical_speeds/bearings"][:, 1, :, 0]
    within = (speeds[:, : own.shape[1]] > 420) & (speeds[:, : own.shape[1]] < 1151)
    assert within.sum() >= 3
    assert own[within] == pytest.approx(table(speeds[:, : own.shape[1]][within]), rel=1e-8)


def test_damped_critical_speeds(case, rotor):
    """Tests the damped critical speeds of the first bending modes, and the damping ratios there."""
    study = "modes: {parameter: speed, from: 6000 rpm, to: 6250 rpm, points: 2}"
    expected = [rotor[False].critical(640, forward) for forward in (False, True)]
    for shaft, tolerance in ((USUAL, 2e-5), ("modes: 24", 5e-6)):
        found = run(case[False], study, shaft)["modes"]["modes/critical"].reshape(-1, 6)
        found = found[found[:, 4] < 0.5]
        assert len(found) == 2
        for (speed, value), own in zip(expected, found):
            assert own[2] == pytest.approx(speed, rel=tolerance)
            assert own[4] == pytest.approx(-value.real / abs(value), rel=10 * tolerance)


# Nodes of the stations, in the order of the imported case: from left to right.
STATIONS = [3, 7, 18, *range(20, 37), 48]


def placed(table):
    """Returns unbalances by rule: (node, kg m, angle)."""
    at = [complex(*value) for value in table["unbalance/placed"][0].reshape(-1, 2)]
    return [(node, abs(value), np.angle(value)) for node, value in zip(STATIONS, at) if value]


def test_unbalances_by_rule(case, rotor):
    """Tests unbalances by API 617, 2 x 6350 W/N g mm: one at mid-span with W the load of both journals, and an opposite
    one at the coupling with W the overhanging mass."""
    bare = rotor[False]
    study = f"unbalance: {{running_from: 7000 rpm, running_to: {MAXIMUM} rpm, antinodes_of: 1}}"
    (coupling, at_coupling, opposite), (middle, in_the_middle, angle) = placed(
        run(case[False], study, USUAL)["unbalance"]
    )
    shape = bare.undamped(bare.bearings[0][1]["kxx"](MAXIMUM * RPM), JOURNALS)[1][:, 0]
    assert middle == max((node for node in STATIONS if node > JOURNALS[0]), key=lambda node: abs(shape[node]))
    assert coupling == 3 and shape[coupling] * shape[middle] < 0 and abs(opposite - angle) == pytest.approx(np.pi)
    rule = 2 * 6350e-6 / MAXIMUM
    assert in_the_middle == pytest.approx(rule * bare.loads(JOURNALS)[0].sum() / 9.80665, rel=1e-9)
    assert at_coupling == pytest.approx(rule * bare.mass_before(JOURNALS[0]), rel=1e-9)


@pytest.mark.parametrize("seals", (True, False))
def test_response(case, rotor, seals):
    """Tests amplitudes and lags of all stations in the response to unbalances by rule."""
    study = (
        "unbalance: {{parameter: speed, values: [{}], running_from: 7000 rpm, running_to: 10500 rpm, antinodes_of: 1}}"
    )
    few, many = "6400 rpm", ", ".join(f"{speed} rpm" for speed in range(4500, 11000, 1000))
    for shaft, values, tolerance in ((ALL, few, 1e-9), (USUAL, many, 1e-4)):
        table = run(case[seals], study.format(values), shaft)["unbalance"]
        amplitude, lag = (table["unbalance/" + field] for field in ("amplitude", "lag"))
        for i, speed in enumerate(table["unbalance/speed"].ravel()):
            expected = np.transpose(rotor[seals].response(speed, placed(table)))[STATIONS]
            own = 50e-6 * amplitude[i] * np.exp(-1j * np.radians(lag[i]))  # length scale 50 um
            assert abs(own - expected).max() < tolerance * abs(expected).max()


def test_peaks_and_margins(case, rotor):
    """Tests the peaks at the probes of the bearings: speed, amplification by half power, margins found and required."""
    study = (
        "unbalance: {parameter: speed, from: 4001 rpm, to: 10999 rpm, points: 101, running_from: 7000 rpm, "
        f"running_to: {MAXIMUM} rpm, antinodes_of: 1, probes_at: [bearing_0, bearing_1]}}"
    )
    result = run(case[False], study, USUAL)
    peaks = result.sheet("peaks").records(si=True)
    unbalances, largest = placed(result["unbalance"]), 0
    for name, node in zip(("bearing_0", "bearing_1"), JOURNALS):

        def amplitude(speed):
            return abs(rotor[False].response(speed, unbalances)[0][node])

        top, height, amplification = peak(amplitude, 4001 * RPM, 9000 * RPM)
        largest = max(largest, *(2e6 * amplitude(speed) for speed in (7000 * RPM, MAXIMUM * RPM)))
        seen = next(row for row in peaks if row["station"] == name and row["probe"] == 0)
        assert (seen["found_by"], seen["side"], seen["verdict"]) == ("half power", "below", "fails")
        speed, size, factor = seen["speed"] / RPM, 1e6 * seen["amplitude"], seen["amplification"]
        margin, asked = seen["margin"], seen["asked"]
        assert speed == pytest.approx(top / RPM, rel=1e-4)  # points are 70 rpm apart
        assert size == pytest.approx(1e6 * height, rel=3e-4)
        assert factor == pytest.approx(amplification, rel=1e-3)
        assert margin == pytest.approx(100 * (1 - top / RPM / 7000), abs=0.01)
        assert asked == pytest.approx(margin_asked(amplification, True), abs=0.06)
    scaled = next(one for one in result.statements() if one.what == "scaled responses").values["found"]
    assert 1e6 * scaled[1] == pytest.approx(largest, rel=1e-4)
    assert scaled[2] == pytest.approx(25.4 / largest, rel=1e-4)  # 10500 rpm: the limit is 25.4 um


def test_weight(case, rotor):
    """Tests that loads and sag agree with beam_rotor.py, and the load of the left bearing with ROSS, whose g is 9.8065
    m/s2."""
    loads, sag = rotor[True].loads(JOURNALS)
    text = case[True].replace("gravity: 9.8065 m/s2", "gravity: 9.80665 m/s2")
    table = run(text, "statics: {}", USUAL)["statics"]
    own = table["statics/load"][0]
    assert own[[1, -1]] == pytest.approx(loads, rel=1e-9)
    assert 50e-6 * table["statics/deflection"][0] == pytest.approx(sag[STATIONS], abs=1e-9 * abs(sag).max())
    by_ross = run(case[True], "statics: {}", USUAL)
    assert by_ross["statics"]["statics/load"][0][1] == pytest.approx(1216.2827567768297, abs=1e-6)


def test_coefficients_of_bearings(case, rotor):
    """Tests that statics reports the tables' stiffness and damping at the speed for bearings, and nothing for seals."""
    table = run(case[True], "statics: {parameter: speed, values: [5000 rpm, 10000 rpm]}", USUAL)["statics"]
    for point, speed in enumerate((5000 * RPM, 10000 * RPM)):
        for kind, key in (("stiffness", "k"), ("damping", "c")):
            own = table["statics/" + kind][point]
            assert np.isnan(own[2:-1]).all() and np.isnan(own[0]).all()
            for station, (_, tables) in zip((1, -1), rotor[False].bearings):
                expected = [float(tables[key + way](speed)) for way in ("xx", "xy", "yx", "yy")]
                assert own[station] == pytest.approx(expected, rel=1e-8, abs=1e-3)


def least(values, whirling, speed):
    """Returns the least decrement of lightly damped forward modes up to the speed, or that of the first mode if its
    frequency is above the speed."""
    light = values[(whirling > 0) & (-values.real < 0.8 * abs(values))]
    upto = light[light.imag <= max(speed, light.imag.min())]
    return min(-2 * np.pi * upto.real / upto.imag)


def test_stability(case, rotor):
    """Tests the least decrements at the highest speed of the tables, with bearings alone and with all seals."""
    speed = 1151.9
    for shaft, tolerance in ((USUAL, 5e-4), ("modes: 24", 5e-5)):
        table = run(case[True].replace("1151.9173063167 rad/s    #", f"{speed} rad/s    #"), "stability: {}", shaft)
        for field, seals in (("basic", False), ("complete", True)):
            expected = least(*rotor[seals].modes(speed), speed)
            assert table["stability"]["stability/" + field].item() == pytest.approx(expected, rel=tolerance)
