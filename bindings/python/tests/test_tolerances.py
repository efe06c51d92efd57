"""Tests tolerances from Python: the call, sheets as pandas tables, statistics of any number, and the samples."""

import numpy as np
import pytest
import whirl

CASE = """
whirl: 1
title: A rotor whose amplitude is e/(k - 1)
parameters: {omega: 1 rad/s, e: 1 mm, k: 2 N/m}
rotor:
  speed: = omega
  length_scale: 1 mm
  stations:
    disc: {mass: 1 kg, eccentricity: = e}
  elements:
    - shaft: {between: [disc, ground], k1: = k}
study:
  # of its response
  unbalance: {parameter: omega, values: [0.5, 1]}
"""


@pytest.fixture(scope="module")
def result():
    return whirl.tolerances(
        whirl.Case(text=CASE),
        {"e": "1 mm +- 50 %", "k": {"from": "1.9 N/m", "to": "2.1 N/m"}},
        of=[{"field": "unbalance/axes", "column": "major", "at": "disc", "below": "1.25 mm"}],
        samples=256,
        seed=7,
        indices=True,
        progress=False,
    )


def test_samples(result):
    table = result["tolerances"]
    values = table["tolerances/values"]
    assert values.shape == (256 * 4 * 2, 2) and len(table.values) == 2048
    assert np.all((values[:, 0] > 0.5e-3) & (values[:, 0] < 1.5e-3) & (values[:, 1] > 1.9) & (values[:, 1] < 2.1))
    # Every sample has the amplitude of its own parameters.
    e, k = values.T
    w = table.values
    assert np.allclose(table["unbalance/axes"][:, 0, 0] * 1e-3, e * w**2 / (k - w**2), rtol=1e-12)


def test_sheets_are_tables(result):
    sheets = result.sheets()
    assert {"probabilities", "spread-1", "indices", "convergence"} <= set(sheets)
    frame = sheets["spread-1"].to_pandas()
    assert len(frame) == 3  # both speeds, and the worst of both
    indices = sheets["indices"].records(si=True)
    own = [one for one in indices if one["parameter"] == "e" and "probability" not in one["what"]]
    assert all(abs(one["total"] - 1.0) < 4 * one["total_error"] + 0.05 for one in own)
    chance = sheets["probabilities"].records(si=True)[-1]
    assert chance["from"] < 25.0 < chance["to"]  # at 1 rad/s the amplitude is near e, uniform from 0.5 to 1.5 mm


def test_any_number(result):
    sheet = result.spread("unbalance/axes", column="minor", at="disc")
    assert sheet.name == "spread" and len(sheet) == 3
    mean = sheet.records(si=True)[1]
    assert abs(mean["mean"] - 1e-3) < 4 * mean["mean_error"] + 5e-6
    chance = result.spread("unbalance/axes", column="major", at="disc", below=1e-3, what="probabilities")
    assert len(chance.records()) == 3
    assert len(result.spread("unbalance/axes", at="disc", what="indices").records()) == 6
    with pytest.raises(whirl.BadInput, match="no table of samples has the number"):
        result.spread("unbalance/nothing")


def test_figure(result):
    name = next(name for name in result.figures() if name.startswith("tolerances-"))
    panels = [panel["name"] for panel in result.figure_data(name)["panels"]]
    assert panels == ["bands", "probability", "indices"]


def test_file(result, tmp_path):
    result.save(tmp_path / "t.h5")
    again = whirl.open(tmp_path / "t.h5")
    assert again.sheet("spread-1").records() == result.sheet("spread-1").records()


def test_own_tolerances():
    text = CASE + "  tolerances: {parameters: {e: +- 1 %}}\n"
    with pytest.raises(whirl.BadInput, match="tolerances of its own"):
        whirl.tolerances(whirl.Case(text=text), {"e": "+- 1 %"})


def spread_of_lags(speed, low, high):
    """Returns the statistics of the lag along x of a disc whose unbalance lies between two angles, far below or above
    its critical speed without damping: the lag is 0 or 180 degrees less that angle."""
    found = whirl.tolerances(
        whirl.Case(
            text=f"""
whirl: 1
parameters: {{omega: 1 rad/s, a: 1 deg}}
rotor:
  speed: = omega
  length_scale: 1 mm
  stations:
    disc: {{mass: 1 kg, eccentricity: 1 mm, eccentricity_angle: = a}}
  elements:
    - shaft: {{between: [disc, ground], k1: 2 N/m}}
study:
  unbalance: {{parameter: omega, values: [{speed}, {1.01 * speed}]}}
"""
        ),
        {"a": {"from": f"{low} deg", "to": f"{high} deg"}},
        of=[{"field": "unbalance/lag", "column": "x", "at": "disc", "above": 90}],
        samples=512,
        seed=3,
        progress=False,
    )
    return found, found.spread("unbalance/lag", column="x", at="disc").records(si=True)


@pytest.mark.parametrize(("speed", "middle"), [(0.7, 0.0), (2.8, 180.0)])
def test_quantiles_of_lags_are_cut_opposite_to_their_mean(speed, middle):
    """Tests uniformly distributed angles: their quantiles are on a straight line, also if the range includes 0."""
    for low, high in ((-40, 40), (100, 260), (170, 190)):
        found, rows = spread_of_lags(speed, low, high)
        centre = (middle - 0.5 * (low + high) + 45.0) % 360.0 - 45.0
        for row in rows[:2]:
            for name, share in {"q05": 5, "q25": 25, "median": 50, "q75": 75, "q95": 95}.items():
                exact = centre + (high - low) * (share / 100.0 - 0.5)
                assert row[name] == pytest.approx(exact, abs=0.01 * (high - low)), (speed, low, share)
            assert row["mean"] == pytest.approx(centre, abs=0.005 * (high - low))
            assert row["deviation"] == pytest.approx((high - low) / 12**0.5, rel=0.01)
        # The row of the worst of all speeds is empty, as it has no meaning for an angle.
        assert rows[2]["mean"] is None and rows[2]["q95"] is None


def test_limits_of_lags_are_those_of_the_angle():
    found, _rows = spread_of_lags(0.7, -40, 40)
    chances = found.spread("unbalance/lag", column="x", at="disc", above=90, what="probabilities").records(si=True)
    # Half of the lags are from 0 to 40, half from 320 to 360.
    assert chances[0]["probability"] == pytest.approx(50.0, abs=1.0)


def test_lags_all_around_have_no_quantiles():
    _found, rows = spread_of_lags(0.7, -180, 180)
    assert all(rows[0][name] is None for name in ("q05", "median", "q95", "mean"))
    assert rows[0]["samples"] == 512 and rows[0]["failed"] == 0
