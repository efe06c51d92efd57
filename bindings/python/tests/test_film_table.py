"""Tests the generator of the table of films of finite length: it agrees with digits of another Galerkin solution, and
with the table in the sources."""

import importlib.util
import re
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("scipy")
ROOT = Path(__file__).resolve().parents[3]


@pytest.fixture(scope="module")
def film():
    spec = importlib.util.spec_from_file_location("film_table", ROOT / "scripts/film-table.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize(
    "length, e, expected",
    [
        (0.5, 0.2, -0.033360770 + 0.150081031j),
        (0.5, 0.6, -0.576217090 + 0.727142894j),
        (0.5, 0.8, -2.463260156 + 1.830831741j),
        (1.0, 0.6, -1.255800455 + 1.936351687j),
    ],
)
def test_digits(film, length, e, expected):
    assert abs(e * film.finite_force(e, length, np.array([0.0]))[0] - expected) < 1e-9


def test_tends_to_the_short_film(film):
    angles = np.array([-2.0, 0.0, 1.0, 1.5])
    short = 1e-4 * film.short_force(0.6, angles)
    assert np.max(np.abs(film.finite_force(0.6, 0.01, angles) / short - 1.0)) < 5e-3


def test_table_is_the_generators(film):
    text = (ROOT / "src/rotor/elements/films/film_table.h").read_text()

    def rows(name):
        body = re.search(rf"{name}\[\w+\]\[\w+\] = \{{(.*?)\n\}};", text, re.DOTALL).group(1)
        return np.array([[float(n) for n in row.split(",")] for row in re.findall(r"\{([-+.0-9e,\s]+)\}", body)])

    count, numerators = len(film.powers(0)), rows("film_table")
    parts = [numerators[:count], numerators[count:], rows("film_denominator")]
    assert len(parts[1]) == len(film.powers(1))
    random = np.random.default_rng(3)
    for r in (0.13, 0.4, 1.7):
        for e in (0.3, 0.7, 0.88):
            angles = random.uniform(-np.pi, np.pi, 8)
            ratio = film.finite_force(e, r, angles) / film.short_force(e, angles) / r**2
            assert np.max(np.abs(film.ratio_of(parts, e, r, angles) / ratio - 1.0)) < 2e-4
