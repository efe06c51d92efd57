"""Fits: what was put in comes out, of files and of columns; what cannot be known is told; bad input is refused."""

import numpy as np
import pytest

import whirl

SPRING = {
    "parameters": {"n": "100 rad/s", "k": "30 kN/m", "c": "40 N s/m", "e": "50 um", "mu": 0.1},
    "rotor": {
        "speed": "= n",
        "length_scale": "1 mm",
        "stations": {"disc": {"mass": "3 kg", "damping": "= c", "eccentricity": "= e"}},
        "elements": [
            {"shaft": {"between": ["disc", "ground"], "k1": "= k"}},
            {"rub": {"at": "disc", "gap": "5 mm", "stiffness": "1 MN/m", "friction": "= mu"}},
        ],
    },
    "study": {"response": {}},
}
TRUTH = {"k": 33e3, "c": 52.0, "e": 38e-6}


def bode():
    """Amplitudes and lags of a disc on a spring by their closed form."""
    w = np.arange(60.0, 150.0, 10.0)
    response = TRUTH["e"] * w**2 / (TRUTH["k"] / 3 - w**2 + 1j * TRUTH["c"] * w / 3)
    return {"speed [rad/s]": w, "disc x [m]": abs(response), "disc x lag [rad]": -np.angle(response)}


def test_what_was_put_in_comes_out(tmp_path):
    found = whirl.fit(SPRING, bode(), ["k", "c", "e"], tolerance=1e-10)
    assert found.end == "found" and len(found) == 3
    for name, value in TRUTH.items():
        assert found[name].value == pytest.approx(value, rel=1e-9)
        assert found[name].known == "determined"
    # A file is read as columns are.
    rows = np.column_stack(list(bode().values()))
    np.savetxt(tmp_path / "bode.csv", rows, "%.17g", ",", header=",".join(bode()), comments="")
    again = whirl.fit(whirl.Case(SPRING), tmp_path / "bode.csv", ["k", "c", "e"], tolerance=1e-10)
    assert [again[name].value for name in again] == [found[name].value for name in found]


def test_starts_and_what_is_not_known():
    bounds = {"k": ("20 kN/m", "50 kN/m"), "mu": (0.05, 0.2)}
    found = whirl.fit(SPRING, bode(), bounds, noise="1 um", starts=3)
    assert len(found.starts) == 3 and found["mu"].known == "unknown" and np.isnan(found["mu"].error)
    named = [own for own in found.result.statements() if own.what == "parameter mu"]
    assert named and named[0].verdict == "not known"
    assert set(found.frame().index) == {"k", "mu"}
    assert found.numbers.shape == (18, 9) and found.correlations.shape == (2, 2)


def test_bad_input(tmp_path):
    with pytest.raises(whirl.BadInput, match="no table"):
        whirl.fit(SPRING, "nowhere.csv", ["k"])
    with pytest.raises(whirl.BadInput, match="is no parameter"):
        whirl.fit(SPRING, bode(), ["kk"])
    with pytest.raises(whirl.BadInput, match="is no station"):
        whirl.fit(SPRING, {"speed [rad/s]": [1.0], "disk x [m]": [1.0]}, ["k"])
    with pytest.raises(whirl.BadInput, match="no unit"):
        whirl.fit(SPRING, {"speed [rad/s]": [1.0], "disc x": [1.0]}, ["k"])
    with pytest.raises(whirl.BadInput, match="rows"):
        whirl.fit(SPRING, {"speed [rad/s]": [1.0], "disc x [m]": [1.0, 2.0]}, ["k"])
    with pytest.raises(whirl.BadInput, match="expected"):
        whirl.fit(SPRING, bode(), {"k": 7})
    # A study with a table that is gone is refused by check and run alike.
    (tmp_path / "a.yaml").write_text(
        whirl.Case(SPRING).text.split("study:")[0] + "study:\n  fit: {unknown: {k: }, data: gone.csv}\n"
    )
    with pytest.raises(whirl.BadInput, match="cannot read"):
        whirl.run(str(tmp_path / "a.yaml"))


def test_keys_are_named_as_a_case_has_them():
    """Not by the names that parts of a fit have in the reference."""
    for fit, words in (
        ({"unknown": {"k": {"fron": 1, "to": 2}}, "data": ["a.csv"]}, "k.fron: fit.unknown has no key fron, did you"),
        ({"unknown": {"k": {}}, "data": [{"file": "a.csv", "sped": 3}]}, r"sped: fit.data has no key sped, expected"),
    ):
        with pytest.raises(whirl.BadInput, match=words):
            whirl.Case({**SPRING, "study": {"fit": fit}})
