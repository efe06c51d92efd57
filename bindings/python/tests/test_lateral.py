"""Tests unbalances by rule and scaled responses, with a rotor whose bearing loads have a closed form."""

import re
import subprocess

import numpy as np
import pytest
from conftest import COMMAND

import whirl

RPM = np.pi / 30
TRIP = 9000
RULE = 2 * 6350e-6 / TRIP  # kg m per kg

# A uniform shaft on soft bearings at its ends, and an overhung disc beyond the right one.
CASE = """
whirl: 1
parameters: {{omega: 3000 rpm}}
rotor:
  speed: = omega
  length_scale: 1 mm
  stations:
    left: {{position: 0 m}}
    quarter: {{position: 0.4 m}}
    middle: {{position: 0.8 m}}
    three: {{position: 1.2 m}}
    right: {{position: 1.6 m}}
    end: {{position: {end} m, mass: {mass} kg}}
  elements:
    - segment: {{length: {end} m, outer: 100 mm}}
    - bearing: {{at: left, kxx: {k} MN/m, kyy: {k} MN/m, cxx: 5 kN s/m}}
    - bearing: {{at: right, kxx: {k} MN/m, kyy: {k} MN/m, cxx: 5 kN s/m}}
    - rub: {{at: middle, gap: 0.5 mm, stiffness: 1 MN/m}}
{unbalances}
study:
  unbalance:
    {{parameter: omega, from: 1000 rpm, to: 9000 rpm, points: 9, running_from: 5000 rpm, running_to: {trip} rpm{rule}}}
"""


def response(rule="", unbalances="", k=20, end=1.9, mass=20):
    text = CASE.format(rule=rule, unbalances=unbalances, k=k, end=end, mass=mass, trip=TRIP)
    return whirl.run(whirl.Case(text=text), progress=False)["unbalance"]


def placed(table):
    at = np.squeeze(table["unbalance/placed"][0])
    names = ("left", "quarter", "middle", "three", "right", "end")
    return {name: complex(*own) for name, own in zip(names, at) if own.any()}


def masses(end=1.9, mass=20):
    """Returns the masses carried by the left and the right bearing, and the overhanging mass, kg."""
    line = 7810 * np.pi * 0.1**2 / 4
    right = (line * end**2 / 2 + mass * end) / 1.6
    return line * end + mass - right, right, line * (end - 1.6) + mass


def test_first_mode_between_stiff_bearings():
    left, right, _ = masses(end=1.601, mass=0.001)
    at = placed(response(", antinodes_of: 1", k=500, end=1.601, mass=0.001))
    assert at == {"middle": pytest.approx(RULE * (left + right), rel=1e-6)}


def test_second_mode_between_stiff_bearings():
    left, right, _ = masses(end=1.601, mass=0.001)
    at = placed(response(", antinodes_of: 2", k=500, end=1.601, mass=0.001))
    assert at.keys() == {"quarter", "three"}
    assert abs(at["quarter"]) == pytest.approx(RULE * left, rel=1e-6)
    assert abs(at["three"]) == pytest.approx(RULE * right, rel=1e-6)
    assert (at["quarter"] * at["three"]).real < 0


def test_overhung_mode():
    _, _, over = masses(mass=200)
    at = placed(response(", antinodes_of: 1", mass=200))
    assert at["end"] == pytest.approx(RULE * over, rel=1e-6)


def test_at_a_station():
    *_, over = masses()
    assert placed(response(", at: end")) == {"end": pytest.approx(RULE * over, rel=1e-6)}
    assert placed(response(", at: quarter, weight: 7 kg")) == {"quarter": pytest.approx(RULE * 7)}
    with pytest.raises(whirl.Error, match="nothing hangs over at station 'quarter', expected weight"):
        response(", at: quarter")
    with pytest.raises(whirl.Error, match="has fewer forward critical speeds"):
        response(", antinodes_of: 64")


def test_weight_does_not_depend_on_gravity_or_on_the_form_of_bearings():
    """Tests that W is a mass, which gravity does not change, and that two bearings of half the stiffness at one station
    count as one."""
    own = placed(response(", antinodes_of: 1", k=60, mass=40))
    for gravity in ("1.62 m/s2", "0 m/s2"):
        on_the_moon = placed(response(", antinodes_of: 1", f"    - gravity: {gravity}", k=60, mass=40))
        assert on_the_moon == {name: pytest.approx(at, rel=1e-9) for name, at in own.items()}
    both = "\n".join(
        f"    - bearing: {{at: {at}, kxx: 30 MN/m, kyy: 30 MN/m, cxx: 2.5 kN s/m}}" for at in ("left", "right")
    )
    assert placed(response(", antinodes_of: 1", both, k=30, mass=40)) == {
        name: pytest.approx(at, rel=1e-9) for name, at in own.items()
    }


@pytest.mark.parametrize("rule", ("antinodes_of: 1", "antinodes_of: 2", "at: end"))
def test_response_is_that_of_such_unbalances(rule):
    """Tests that unbalances by rule replace those of the machine."""
    own = "    - unbalance: {at: middle, moment: 3 kg.mm, angle: 40 deg}"
    by_rule = response(", " + rule, own)
    said = [
        f"    - unbalance: {{at: {name}, moment: {abs(at):.17g}, angle: {np.angle(at):.17g}}}"
        for name, at in placed(by_rule).items()
    ]
    by_hand = response("", "\n".join(said))
    for field in ("amplitude", "axes", "probe"):
        name = "unbalance/" + field
        assert np.allclose(by_rule[name], by_hand[name], rtol=1e-10, atol=1e-16)


def test_scaled_responses():
    """Tests that the major axis at the gap is scaled by the vibration limit over the largest amplitude of a probe at
    running speeds."""
    own = "    - unbalance: {at: middle, moment: 0.3 kg.mm}"
    text = CASE.format(rule=", probes_at: left right", unbalances=own, k=20, end=1.9, mass=20, trip=TRIP)
    result = whirl.run(whirl.Case(text=text), progress=False)
    table = result["unbalance"]
    running = table["unbalance/speed"].ravel() > 4999 * RPM
    seen = 2e-3 * table["unbalance/probe"][running][:, [0, 4]].max()
    limit = 25.4e-6
    axes = 2e-3 * table["unbalance/axes"][:, 2, 0] * min(6, limit / seen)
    assert all(("\n  " if own.table else "\n") + str(own) in str(result) for own in result.statements())
    (reported,) = [own for own in result.statements() if own.what == "scaled responses"]
    assert reported.values["found"] == pytest.approx((limit, seen, min(6, limit / seen)), rel=1e-9)
    assert f"the largest that a probe sees where the machine runs {seen * 1e6:.4g} µm p-p" in reported.found
    (clearance,) = result.sheet("clearances").records(si=True)
    assert (clearance["station"], clearance["verdict"]) == ("middle", "holds")
    assert clearance["axis"] == pytest.approx(axes.max(), rel=1e-9)
    assert clearance["clearance"] == pytest.approx(1e-3, rel=1e-12)
    assert clearance["share"] == pytest.approx(100 * axes.max() / 1e-3, rel=1e-9)


def test_clearances_up_to_the_trip_speed(tmp_path):
    """Tests that clearances are checked up to the first point at or above the trip speed, and that a statement reports
    points that end below it."""
    own = "    - unbalance: {at: middle, moment: 0.3 kg.mm}"
    text = CASE.format(rule=", probes_at: left right", unbalances=own, k=20, end=1.9, mass=20, trip=2000)
    text = text.replace("running_from: 5000", "running_from: 1000")

    def scaled(trip):
        case = whirl.Case(text=text.replace("running_to: 2000 rpm", f"running_to: 2000 rpm, trip: {trip} rpm"))
        result = whirl.run(case, progress=False)
        result.save(tmp_path / "r.h5", overwrite=True)
        shown = [COMMAND, "show", tmp_path / "r.h5"]
        summary = subprocess.run(shown, capture_output=True, text=True, check=True).stdout
        (clearance,) = result.sheet("clearances").records(si=True)
        (reported,) = [own for own in result.statements() if own.what == "scaled responses"]
        return result["unbalance"], clearance, reported, summary

    table, clearance, reported, summary = scaled(2500)
    _, _, factor, trip = reported.values["found"]
    upto = table["unbalance/speed"].ravel() < 3001 * RPM
    axes = 2e-3 * factor * table["unbalance/axes"][:, 2, 0]
    assert clearance["axis"] == pytest.approx(axes[upto].max(), rel=1e-9) and axes.argmax() >= upto.sum()
    assert clearance["speed"] <= 3000.001 * RPM and trip == pytest.approx(2500 * RPM)
    assert "clearances count up to the trip speed, 2500 rpm" in summary and "2500 rpm" in reported.found
    _, clearance, reported, summary = scaled(9500)
    assert "do not reach the trip speed" in reported.found and clearance["axis"] == pytest.approx(axes.max(), rel=1e-9)
    assert "points do not reach the trip speed, 9500 rpm: compute more points" in summary
    with pytest.raises(whirl.Error, match="expected at least the highest running speed"):
        scaled(1500)


def test_responses_that_do_not_reach_over_the_running_speeds_are_not_scaled():
    own = "    - unbalance: {at: middle, moment: 0.3 kg.mm}"
    text = CASE.format(rule=", probes_at: left", unbalances=own, k=20, end=1.9, mass=20, trip=TRIP)
    beyond = whirl.run(whirl.Case(text=text.replace("from: 1000 rpm", "from: 5100 rpm")), progress=False)
    (reported,) = [own.found for own in beyond.statements() if own.what == "scaled responses"]
    assert reported.startswith("none: points do not reach over the running speeds")


# A rigid disc, m 100 kg, K 1e7 N/m, C 4000 N s/m: its decrement is 0 at Q = C sqrt(K/m).
DISC = """
whirl: 1
parameters: {{q: {q} N/m, omega: 1000 rad/s}}
rotor:
  speed: = omega
  length_scale: 1 mm
  rotation: {rotation}
  stations: {{disc: {{mass: 100 kg}}}}
  elements:
    - bearing: {{at: disc, kxx: 10 MN/m, cxx: 4 kN s/m}}
    - stage: {{at: disc, power: = q * omega * 0.5 * 0.01 / 3, diameter: 0.5 m, width: 10 mm}}
{seal}
study:
  stability: {{}}
"""
LIMIT = 4000 * np.sqrt(1e7 / 100)


def stability(q, seal="", rotation="counter-clockwise"):
    case = whirl.Case(text=DISC.format(q=q, seal=seal, rotation=rotation))
    return whirl.run(case, progress=False)["stability"]


def decrement(q, damping=4000.0):
    """Returns the decrement of m z'' + c z' + (k - i q) z = 0, z = x + i y."""
    roots = np.roots([100, damping, 1e7 - 1j * q])
    forward = roots[roots.imag > 0][0]
    return -2 * np.pi * forward.real / forward.imag


@pytest.mark.parametrize("rotation", ("counter-clockwise", "clockwise"))
@pytest.mark.parametrize("share, expected", ((0.5, 0.1986913171), (0.9, 0.0396178191)))
def test_stability_of_a_rigid_disc(share, expected, rotation):
    table = stability(share * LIMIT, rotation=rotation)
    assert table["stability/limit"].item() == pytest.approx(1264911.06, rel=1e-8)
    assert table["stability/limit"].item() == pytest.approx(LIMIT, rel=1e-9)
    assert table["stability/anticipated"].item() == pytest.approx(share * LIMIT, rel=1e-12)
    assert table["stability/basic"].item() == pytest.approx(0.3981806900, abs=5e-11)
    assert table["stability/decrement"].item() == pytest.approx(expected, abs=5e-11)
    assert table["stability/complete"].item() == table["stability/decrement"].item()
    coupling, curve = (np.ravel(table["stability/" + name]) for name in ("cross_coupling", "curve"))
    assert coupling[-1] == pytest.approx(2 * LIMIT)
    for q, own in zip(coupling, curve):
        assert own == pytest.approx(decrement(q), abs=1e-9)


def test_stability_with_a_seal():
    """Tests that a seal changes the decrement with all seals and that of its station, but not the limit of the cross
    coupling."""
    table = stability(
        0.5 * LIMIT, "    - bearing: {at: disc, kxy: 400000 N/m, kyx: -400000 N/m, cxx: 900 N s/m, role: seal}"
    )
    assert table["stability/limit"].item() == pytest.approx(LIMIT, rel=1e-9)
    assert table["stability/decrement"].item() == pytest.approx(decrement(0.5 * LIMIT), abs=1e-9)
    assert table["stability/complete"].item() == pytest.approx(decrement(0.5 * LIMIT + 400000, 4900), abs=1e-9)
    assert table["stability/part"].item() == pytest.approx(decrement(400000, 4900), abs=1e-9)


def test_no_limit():
    assert np.isnan(stability(0)["stability/limit"].item())
    assert np.isnan(stability(100)["stability/limit"].item())
    assert stability(2 * LIMIT)["stability/decrement"].item() == pytest.approx(decrement(2 * LIMIT), abs=1e-9)


FILMS = """
whirl: 1
parameters: {speed: 3000 rpm}
rotor:
  speed: = speed
  length_scale: 100 um
  stations: {left: {position: 0 m}, middle: {position: 0.5 m, mass: 60 kg}, right: {position: 1 m}}
  elements:
    - gravity: {}
    - segment: {length: 1 m, outer: 80 mm}
    - film: {at: left, clearance: 100 um, viscosity: 20 mPa.s, radius: 40 mm, length: 30 mm}
    - film: {at: right, clearance: 100 um, viscosity: 20 mPa.s, radius: 40 mm, length: 30 mm}
study:
  statics: {parameter: speed, values: [2000 rpm, 6000 rpm]}
"""


def test_coefficients_of_short_films():
    """Tests the coefficients of short films: Friswell et al. (2010), 5.5.1, give them in closed form by load and
    eccentricity ratio, with v upwards and u across."""
    table = whirl.run(whirl.Case(text=FILMS), progress=False)["statics"]
    for point, speed in enumerate((2000 * RPM, 6000 * RPM)):
        load, e = (float(table["statics/" + name][point][0]) for name in ("load", "eccentricity"))
        pi2, e2, root = np.pi**2, e * e, np.sqrt(1 - e * e)
        h = (pi2 * (1 - e2) + 16 * e2) ** -1.5
        a = (
            4 * (pi2 * (2 - e2) + 16 * e2),
            np.pi * (pi2 * (1 - e2) ** 2 - 16 * e2**2) / (e * root),
            -np.pi * (pi2 * (1 - e2) * (1 + 2 * e2) + 32 * e2 * (1 + e2)) / (e * root),
            4 * (pi2 * (1 + 2 * e2) + 32 * e2 * (1 + e2) / (1 - e2)),
        )
        across = -8 * (pi2 * (1 + 2 * e2) - 16 * e2)
        b = (
            2 * np.pi * root * (pi2 * (1 + 2 * e2) - 16 * e2) / e,
            across,
            across,
            2 * np.pi * (pi2 * (1 - e2) ** 2 + 48 * e2) / (e * root),
        )
        assert table["statics/stiffness"][point][0] == pytest.approx(h * load / 100e-6 * np.array(a), rel=1e-6)
        assert table["statics/damping"][point][0] == pytest.approx(h * load / (100e-6 * speed) * np.array(b), rel=1e-6)
        assert np.isnan(table["statics/stiffness"][point][1]).all()


def test_margins_are_asked_where_probes_are():
    def peaks(rule):
        own = "    - unbalance: {at: middle, moment: 3 kg.mm}"
        text = CASE.format(rule=rule, unbalances=own, k=20, end=1.9, mass=20, trip=TRIP)
        text = text.replace("points: 9,", "points: 321,")
        return whirl.run(whirl.Case(text=text), progress=False).sheet("peaks").records(si=True)

    everywhere, probed = peaks(""), peaks(", probes_at: [left, right]")
    assert len(everywhere) == len(probed) > 0
    assert all(peak["asked"] is not None for peak in everywhere)
    for before, after in zip(everywhere, probed):
        if after["station"] in ("left", "right"):
            assert before == after
        else:
            unjudged = {"asked": None, "margin": None, "side": "", "verdict": "not judged: no probe"}
            assert after == before | unjudged


def test_peaks_without_a_probe_are_reported(tmp_path):
    """Tests a response that peaks at the disc at a running speed, but not at the only probe, at a pedestal: the report
    names the station of the peak."""
    path = tmp_path / "case.yaml"
    path.write_text(
        """
whirl: 1
parameters: {omega: 3000 rpm}
rotor:
  speed: = omega
  length_scale: 1 mm
  stations:
    disc: {mass: 6 kg, eccentricity: 10 um, damping: 100 N s/m}
    pedestal: {mass: 6 kg, eccentricity: 10 um, damping: 1.2 kN s/m}
  elements:
    - spring: {between: [disc, ground], stiffness: 0.5 MN/m}
    - spring: {between: [pedestal, ground], stiffness: 0.2 MN/m}
study:
  unbalance: {parameter: omega, from: 200 rpm, to: 6000 rpm, points: 400, running_from: 2700 rpm,
              running_to: 3500 rpm, probes_at: pedestal}
"""
    )
    subprocess.run([COMMAND, "run", path, "-q", "-o", tmp_path / "r.h5"], check=True)
    subprocess.run([COMMAND, "report", tmp_path / "r.h5", "-q", "--lateral", "-o", tmp_path / "out"], check=True)
    page = " ".join(re.sub("<[^>]*>", " ", (tmp_path / "out/lateral.html").read_text()).split())
    assert "2 peaks of that amplification at stations without a probe not judged" in page  # x and y of the disc
    assert "no amplification of 2.5 or more at a probe at the computed speeds" in page
