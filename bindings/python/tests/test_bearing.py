"""Bearings by themselves: growth.md B3 and B4 in SI, and what is asked of dicts, files and figures."""

import numpy as np
import pytest

import whirl

TWO_GROOVE = {
    "kind": "two-groove",
    "diameter": 0.1,
    "length": 0.05,
    "clearance": 1e-4,
    "viscosity": 0.02,
    "speed": "1000 rpm",
}


def load_of(sommerfeld):
    """W of S = mu N D L (R/c)^2/W at 1000 rpm."""
    return 0.02 * 1000 / 60 * 0.1 * 0.05 * 500**2 / sommerfeld


def test_rows_of_lund_and_thomsen():
    # S, eccentricity, attitude, then xx, xy, yx, yy of K c/W and C c Omega/W with x along the load: within 2e-4.
    rows = [
        (0.917, 0.3716548, 57.52602, [2.1029, 4.0229, -1.3333, 1.8690], [7.7176, 2.1038, 2.1038, 3.3056]),
        (0.379, 0.5696463, 45.52281, [3.3125, 3.6596, -0.4441, 1.7042], [6.7893, 1.9032, 1.9032, 1.9383]),
    ]
    found = whirl.bearing({**TWO_GROOVE, "load": np.array([load_of(row[0]) for row in rows])}, threads=1)
    assert found.found.all() and found.kind == "two-groove"
    for i, (sommerfeld, eccentricity, attitude, stiffness, damping) in enumerate(rows):
        assert found.sommerfeld[i] == pytest.approx(sommerfeld, rel=1e-12)
        assert found.eccentricity_ratio[i] == pytest.approx(eccentricity, abs=5e-6)
        assert np.degrees(found.attitude[i]) == pytest.approx(attitude, abs=5e-4)
        for own, expected, unit in (
            (found.stiffness[i], stiffness, 1e-4 / found.load[i]),
            (found.damping[i], damping, 1e-4 * found.speed[i] / found.load[i]),
        ):
            turned = unit * np.array([own[1, 1], -own[1, 0], -own[0, 1], own[0, 0]])
            assert turned == pytest.approx(expected, abs=3e-4 * max(expected))
        # What is told as the error bounds what is wrong, but for the digits of the rows.
        assert 1e-4 * abs(found.eccentricity_ratio[i] - eccentricity) <= found.error[i, 0] + 1e-11
    assert (found.error[:, 1:] < 1e-3).all()


def test_tilting_pads_follow():
    pads = [{"pivot": f"{18 + 72 * i} deg", "arc": "60 deg", "preload": 0.5} for i in range(5)]
    file = {**TWO_GROOVE, "kind": None, "clearance": None, "pad_clearance": 1e-4, "pads": pads, "tilting": "yes"}
    found = whirl.bearing({**file, "load": load_of(0.5), "whirl_ratio": [1, 0.5]})
    unit = 1e-4 / found.load[0]
    for number, expected in ((0, (6.47468, 7.60997, 7.40401, 8.13164)), (1, (8.24631, 9.51679, 6.36039, 7.02622))):
        stiffness, damping = found.reduced(number)
        own = unit * np.array([*np.diag(stiffness[0]), *(np.diag(damping[0]) * found.speed[0])])
        assert own == pytest.approx(expected, rel=3e-4)
    # The full matrices, tilts eliminated at a whirl ratio, are the reduced ones.
    full = found.document["points"][0]["full"]
    for number, ratio in enumerate(found.whirl_ratios):
        z = np.array(full["stiffness"]) + 1j * ratio * found.speed[0] * np.array(full["damping"])
        z = z[:2, :2] - z[:2, 2:] @ np.linalg.solve(z[2:, 2:], z[2:, :2])
        stiffness, damping = found.reduced(number)
        assert z.real == pytest.approx(stiffness[0], abs=1e-9 * abs(z).max())
        assert z.imag / (ratio * found.speed[0]) == pytest.approx(damping[0], abs=1e-9 * abs(damping[0]).max())


@pytest.mark.parametrize("grade, warm, expected", [(46, 373.15, 6.765), (46, 313.15, 46.0), (32, 373.15, 5.36)])
def test_oils_by_their_grade(grade, warm, expected):
    """Of viscosity index 100 by ASTM D2270: 46 mm2/s lie between the rows 45.33 (6.7) and 46.44 (6.8) of its table."""
    oil = {"grade": grade, "temperature": warm, "density": 1000, "viscosity": None, "fineness": 192}
    found = whirl.bearing({**TWO_GROOVE, **oil, "load": 1000})
    assert found.viscosity * 1e3 == pytest.approx(expected, rel=3e-3)


def test_heavy_loads_warn_and_impossible_ones_are_told():
    pad = {"pads": [{"pivot": "90 deg", "arc": "120 deg"}], "tilting": "no", "kind": None}
    found = whirl.bearing({**TWO_GROOVE, **pad, "load": [1000, 2000]})
    assert not found.found.any() and np.isnan(found.stiffness).all()
    assert all("no place was found" in point["failure"] for point in found.document["points"])
    heavy = whirl.bearing({**TWO_GROOVE, "load": load_of(0.005)})
    assert any("um thin, below 5 um" in warning for warning in heavy.warnings)


def test_figures_and_mistakes(tmp_path):
    found = whirl.bearing({**TWO_GROOVE, "load": [500, 1000], "fineness": 192})
    assert list(found.figures) == ["curves", "sommerfeld", "locus"]
    assert len(found.plot("curves").axes) == 6
    with pytest.raises(whirl.BadInput, match="expected curves, sommerfeld or locus"):
        found.plot("orbit")
    with pytest.raises(whirl.BadInput, match="kind: is two, expected one of plain") as raised:
        whirl.bearing({**TWO_GROOVE, "kind": "two", "load": 1000, "length": -1})
    assert len(raised.value.problems) == 2
    with pytest.raises(whirl.BadInput, match="cannot read"):
        whirl.bearing(tmp_path / "none.yaml")
