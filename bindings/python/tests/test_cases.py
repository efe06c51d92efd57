"""Tests cases from files, texts and Python objects, and the errors of invalid ones."""

import numpy as np
import pytest
from conftest import GOOD, MAP

import whirl

BUILT = {
    "title": "Built in Python: a title",
    "parameters": {"omega": "1.5 rad/s", "kappa": 10},
    "rotor": {
        "speed": "= omega",
        "length_scale": "1 m",
        "stations": {"disc": {"mass": "1 kg", "damping": "0.2 N.s/m", "eccentricity": "0.9 m"}},
        "elements": [
            {"shaft": {"between": ["disc", "ground"], "k1": "1 N/m", "k2": "1 N/m"}},
            {"rub": {"at": "disc", "gap": "1 m", "stiffness": "= kappa", "friction": 0.05, "law": "paper"}},
            {"gravity": "0.5 m/s2"},
        ],
    },
    "study": {
        "sweep": {"parameter": "omega", "from": 1.0, "to": 4.0, "points": 5, "start": "state"},
        "initial": {"disc": {"x": 0.1, "y": np.float64(-0.2)}},
        "integrate": {"method": "rk4", "steps_per_revolution": 64, "transient": 20, "record": 10},
        "analyze": ["poincare", "regime", "lyapunov", "spectrum", "orbit", "rub"],
    },
}


def test_a_case_that_was_built_is_the_case_of_the_file(good):
    result = whirl.run(whirl.Case(BUILT), progress=False)
    assert result.title == "Built in Python: a title"
    for field in good["sweep"]:
        assert np.array_equal(result["sweep"][field], good["sweep"][field], equal_nan=True), field


def test_texts_are_saved_byte_for_byte():
    case = whirl.Case(GOOD)
    assert case.text == GOOD.read_text() and case.copy().text == case.text
    assert case.title == "A small Jeffcott rotor with rub" and "Jeffcott" in repr(case)


def test_parameters_are_set():
    case = whirl.Case(text=MAP)
    assert case.set("kappa", 20).parameters["kappa"].value == 20.0
    assert case.set("disc.mass", "5 kg").text != MAP
    assert whirl.Case(GOOD).set("kappa", np.float64(7)).parameters["kappa"].value == 7.0
    with pytest.raises(whirl.BadInput, match="no parameter is called kapa, did you mean kappa?"):
        case.set("kapa", 1)
    assert case.parameters["kappa"].value == 20.0


def test_all_problems_are_reported():
    with pytest.raises(whirl.BadInput) as caught:
        whirl.Case(text=MAP.replace("4 kg", "-4 kg").replace("points: 5", "points: 0"), name="my.yaml")
    assert len(caught.value.problems) == 2
    assert any("disc.mass: is -4 kg, expected a number above 0 kg" in line for line in caught.value.problems)
    assert all(line.startswith("my.yaml:") for line in caught.value.problems)
    assert isinstance(caught.value, ValueError)


@pytest.mark.parametrize("text", ["", "\0", "whirl: [", "\xff", "a: &a [*a]", "x" * 3_000_000])
def test_broken_texts_are_refused(text):
    with pytest.raises(whirl.BadInput):
        whirl.Case(text=text)


def test_missing_file():
    with pytest.raises(whirl.BadInput, match="cannot read the case 'nowhere.yaml': No such file"):
        whirl.Case("nowhere.yaml")


def test_wrong_types():
    with pytest.raises(TypeError):
        whirl.Case()
    with pytest.raises(TypeError):
        whirl.Case(GOOD, text="both")
    with pytest.raises(TypeError, match="cannot stand in a case"):
        whirl.Case({"title": object()})


@pytest.mark.parametrize(
    "title", ["a: b", "# none", "'quoted'", 'say "hi"', "yes", "- x", "ä ö", "{", "1e3", "null", "~"]
)
def test_texts_with_signs_of_yaml_come_back(title):
    assert whirl.Case({**BUILT, "title": title}).title == title


def test_numbers_of_numpy_and_pandas():
    rotor = {"speed": "= omega", "length_scale": "1 m", "stations": {"disc": {"mass": np.float32(1)}}}
    rotor["elements"] = [{"shaft": {"between": ["disc", "ground"], "k1": np.int64(1)}}]
    for values in (range(1, 4), np.arange(1, 4), np.arange(1.0, 4.0), [np.longdouble(1), 2, 3]):
        study = {"sweep": {"parameter": "omega", "values": values, "start": "rest"}, "confirm": np.bool_(False)}
        study["integrate"] = {"settle": np.True_}
        case = whirl.Case({"title": None, "parameters": {"omega": np.array(1.5)}, "rotor": rotor, "study": study})
        assert list(case.outline()["sweep"].values) == [1.0, 2.0, 3.0] and case.title == ""


@pytest.mark.parametrize("call", [lambda: whirl.Case("a\0b"), lambda: whirl.Case(text="\ud800: 1")])
def test_wrong_texts(call):
    with pytest.raises(whirl.BadInput):
        call()
    with pytest.raises(TypeError, match="expected a str"):
        whirl.Case(text=5)
    own = {}
    own["rotor"] = own
    with pytest.raises(whirl.BadInput, match="holds itself"):
        whirl.Case(own)
    with pytest.raises(whirl.BadInput, match="NUL"):
        whirl.Case(GOOD).set("kappa", "7\0junk")
