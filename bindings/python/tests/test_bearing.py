"""Tests bearings without a rotor: reference coefficients in SI, input as dicts and files, and figures."""

import re

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
    """Returns W of S = mu N D L (R/c)^2/W at 1000 rpm."""
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
        # The reported error bounds the true error, to the digits of the rows.
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
    # Eliminating the tilts from the full matrices at a whirl ratio gives the reduced matrices.
    full = found.document["points"][0]["full"]
    for number, ratio in enumerate(found.whirl_ratios):
        z = np.array(full["stiffness"]) + 1j * ratio * found.speed[0] * np.array(full["damping"])
        z = z[:2, :2] - z[:2, 2:] @ np.linalg.solve(z[2:, 2:], z[2:, :2])
        stiffness, damping = found.reduced(number)
        assert z.real == pytest.approx(stiffness[0], abs=1e-9 * abs(z).max())
        assert z.imag / (ratio * found.speed[0]) == pytest.approx(damping[0], abs=1e-9 * abs(damping[0]).max())


@pytest.mark.parametrize("grade, warm, expected", [(46, 373.15, 6.765), (46, 313.15, 46.0), (32, 373.15, 5.36)])
def test_oils_by_their_grade(grade, warm, expected):
    """Tests oils of viscosity index 100 by ASTM D2270, in whose table 46 mm2/s at 40 degC are between the rows 45.33
    (6.7 mm2/s at 100 degC) and 46.44 (6.8)."""
    oil = {"grade": grade, "temperature": warm, "density": 1000, "viscosity": None, "fineness": 192}
    found = whirl.bearing({**TWO_GROOVE, **oil, "load": 1000})
    assert found.viscosity * 1e3 == pytest.approx(expected, rel=3e-3)


def walther(temperature, at_40, at_100):
    """Returns viscosities in m2/s by Walther's law; `at_40` and `at_100`: viscosities in mm2/s at 40 and 100 degC."""
    own = lambda nu: np.log10(np.log10(nu + 0.7))
    slope = (own(at_100) - own(at_40)) / np.log10(373.15 / 313.15)
    return 1e-6 * (10**10 ** (own(at_40) + slope * np.log10(temperature / 313.15)) - 0.7)


@pytest.mark.parametrize("grade, hot", [(32, 5.25), (46, 6.60)])
def test_oils_between_two_temperatures(grade, hot):
    """Tests oils given by viscosities at 40 and 100 degC (viscosity index about 95): between them Walther's law holds,
    and a table of the two viscosities gives the same."""
    oil = {**TWO_GROOVE, "viscosity": None, "density": 870, "fineness": 192, "load": 1000}
    for warm in (313.15, 343.15, 373.15):
        nu = walther(warm, grade, hot)
        own = whirl.bearing({**oil, "grade": grade, "kinematic_100": hot * 1e-6, "temperature": warm})
        assert own.viscosity == pytest.approx(870 * nu, rel=1e-12)
        assert own.temperature[0] == warm and own.film_viscosity[0] == own.viscosity
        rows = {"temperatures": [313.15, 373.15], "viscosities": [870e-6 * grade, 870e-6 * hot]}
        table = whirl.bearing({**oil, **rows, "temperature": warm})
        assert table.viscosity == pytest.approx(own.viscosity, rel=1e-12)
    assert whirl.bearing({**oil, "grade": grade, "kinematic_100": hot * 1e-6, "temperature": "100 degC"}).viscosity == (
        pytest.approx(870e-6 * hot, rel=1e-12)
    )


def test_film_as_warm_as_its_heat():
    """Tests a light load. The power is that of Petroff for two pads of 160 degrees, the flow that of grooves into a
    concentric gap (Laplace's equation, as a series), and the temperature follows from power and flow."""
    speed, radius, clearance, length, groove, pressure = 3000 * np.pi / 30, 0.05, 1e-4, 0.05, 0.75, 2e5
    file = {
        **{"kind": "two-groove", "radius": radius, "length": length, "clearance": clearance, "speed": speed, "load": 2},
        **{"grade": 46, "kinematic_100": 6.6e-6, "supply_temperature": "40 degC", "heat_share": 0.8},
        **{"supply_pressure": pressure, "groove": groove, "density": 870, "specific_heat": 1950},
    }
    found = whirl.bearing(file)
    l = (np.arange(1, 2000) - 0.5) * np.pi
    a = 2 * np.cos(l * groove) / ((1 - groove) * l**2)
    # Flow out of both ends of both pads: c^3/(12 mu) dp/dz, integrated along the arc.
    along = np.sum(
        a * np.sin(l) * l * np.tanh(l * 2 * radius / length * np.radians(80)) / (l * 2 * radius / length) * 2
    )
    flow = lambda mu: 4 * clearance**3 / (12 * mu) * pressure * (2 / length) * radius * along
    power = lambda mu: 2 * np.radians(160) * mu * speed**2 * radius**3 * length / clearance
    low, high = 313.15, 473.15
    for _ in range(60):
        warm = 0.5 * (low + high)
        mu = 870 * walther(warm, 46, 6.6)
        hotter = 313.15 + 0.5 * 0.8 * power(mu) / (870 * 1950 * flow(mu)) > warm
        low, high = (warm, high) if hotter else (low, warm)
    assert found.power[0] == pytest.approx(power(mu), rel=1e-3)
    assert found.flow[0] == pytest.approx(flow(mu), rel=3e-3)
    assert found.temperature[0] - 313.15 == pytest.approx(warm - 313.15, rel=3e-3)
    assert found.outlet[0] - 313.15 == pytest.approx(2 * (found.temperature[0] - 313.15), abs=3e-3)
    # With heavier loads, temperature, power and flow fulfil the heat balance; a flow that cannot carry the heat fails.
    found = whirl.bearing({**file, "load": [1000, 5000]})
    rise = 0.8 * found.power / (870 * 1950 * found.flow)
    assert found.temperature == pytest.approx(313.15 + 0.5 * rise, abs=2e-3)
    assert found.film_viscosity == pytest.approx(870 * walther(found.temperature, 46, 6.6), rel=1e-12)
    hot = whirl.bearing({**file, "supply_pressure": None, "groove": None, "load": 0.01})
    assert not hot.found[0] and "does not carry the heat" in hot.document["points"][0]["failure"]


def test_turbulence_and_soft_pivots():
    water = {**TWO_GROOVE, "viscosity": 1e-3, "density": 1000, "load": 200, "fineness": 192}
    fast = {**water, "speed": ["1000 rpm", "3000 rpm", "8000 rpm"]}
    laminar, found = whirl.bearing(fast), whirl.bearing({**fast, "turbulence": "ng-pan"})
    assert any("add turbulence: ng-pan" in warning for warning in laminar.warnings)
    assert [any(word in w for w in found.warnings) for word in ("is laminar", "between laminar")] == [True, True]
    assert (found.eccentricity_ratio < laminar.eccentricity_ratio).all() and (found.power > laminar.power).all()
    pads = {**TWO_GROOVE, "kind": "tilting-5", "preload": 0.5, "load": load_of(0.5), "fineness": 192}
    soft = whirl.bearing({**pads, "pivot_stiffness": 2e7, "pivot_damping": 1e3, "pad_mass": 2, "whirl_ratio": 0.6})
    full, rate = soft.document["points"][0]["full"], 0.6 * soft.speed[0]
    z = np.array(full["stiffness"]) + 1j * rate * np.array(full["damping"])
    assert z.shape == (12, 12)
    z[range(7, 12), range(7, 12)] -= 2 * rate**2
    z = z[:2, :2] - z[:2, 2:] @ np.linalg.solve(z[2:, 2:], z[2:, :2])
    assert z.real == pytest.approx(soft.stiffness[0], abs=1e-9 * abs(z).max())
    assert z.imag / rate == pytest.approx(soft.damping[0], abs=1e-9 * abs(soft.damping[0]).max())
    for pad in soft.document["points"][0]["pads"]:  # the journal is centred, so the force of the film is radial
        assert pad["yield"] == pytest.approx(pad["load"] / 2e7, rel=1e-6)


@pytest.mark.parametrize(
    "keys, wrong",
    [
        ({"supply_pressure": 1e5, "kind": "tilting-5", "preload": 0.2}, "pads that tilt have no grooves"),
        ({"groove": 0.5}, "belongs to supply_pressure, which is not given"),
        ({"pivot_stiffness": 1e8}, "and the pads do not tilt"),
        ({"pad_mass": 1, "kind": "tilting-5", "preload": 0.2}, "belongs to pivot_stiffness, which is not given"),
        ({"supply_temperature": 313.15}, "belongs to grade or temperatures, which is not given"),
        ({"heat_share": 0.5}, "belongs to supply_temperature, which is not given"),
        ({"viscosity": None, "temperatures": [313.15, 373.15], "temperature": 330}, "viscosities: is missing"),
        (
            {"viscosity": None, "temperatures": [373.15, 313.15], "viscosities": [0.02, 0.01], "temperature": 330},
            "temperatures: does not rise",
        ),
        (
            {"viscosity": None, "temperatures": [313.15, 373.15], "viscosities": [0.01, 0.02], "temperature": 330},
            "viscosities: does not fall",
        ),
        ({"viscosity": None, "grade": 46}, "expected that of the film, or supply_temperature"),
        ({"turbulence": "ng-pang"}, "did you mean ng-pan"),
        (
            {"supply_pressure": 1e5, "kind": None, "pads": [{"pivot": 0, "arc": 2}], "tilting": "no"},
            "expected grooves of at most 90 degrees",
        ),
    ],
)
def test_contradicting_keys_are_refused(keys, wrong):
    with pytest.raises(whirl.BadInput, match=wrong):
        whirl.bearing({**TWO_GROOVE, "load": 1000, **keys})


def test_heavy_loads_warn_and_impossible_ones_are_refused():
    pad = {"pads": [{"pivot": "90 deg", "arc": "120 deg"}], "tilting": "no", "kind": None}
    found = whirl.bearing({**TWO_GROOVE, **pad, "load": [1000, 2000]})
    assert not found.found.any() and np.isnan(found.stiffness).all()
    assert all("no place was found" in point["failure"] for point in found.document["points"])
    heavy = whirl.bearing({**TWO_GROOVE, "load": load_of(0.005)})
    assert any("um thin, below 5 um" in warning for warning in heavy.warnings)


def test_warnings_are_in_the_units_asked_for():
    """Tests that warnings, documents and statements have the same numbers in the requested units; arrays stay in SI."""
    file = {**TWO_GROOVE, "load": load_of(0.005), "fineness": 192}
    metric, own = whirl.bearing(file), whirl.bearing(file, units="US")
    np.testing.assert_array_equal(metric.film, own.film)
    (warning,) = [text for text in own.warnings if "thin, below" in text]
    place, _, reported = warning.partition(": ")
    speed, force = re.fullmatch(r"at (\S+) rpm, (\S+) lbf", place).groups()
    film, least = re.search(r"the film is (\S+) mil thin, below (\S+) mil", reported).groups()
    assert float(speed) == pytest.approx(own.speed[0] * 30 / np.pi, rel=1e-5)
    assert float(force) == pytest.approx(own.load[0] / 4.4482216, rel=1e-5)
    assert (float(film), float(least)) == pytest.approx((own.film[0] / 25.4e-6, 5 / 25.4), rel=5e-3)
    assert reported in own.document["points"][0]["warnings"]
    assert whirl.bearing({**file, "units": "US"}).warnings == own.warnings
    with pytest.raises(whirl.BadInput, match="did you mean"):
        whirl.bearing(file, units="rpn")


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


def test_findings_in_the_customers_units():
    oil = {"grade": 46, "supply_temperature": "45 degC", "load": 5e3, "speed": "9000 rpm", "fineness": 192}
    case = {key: value for key, value in TWO_GROOVE.items() if key not in ("viscosity", "speed")}
    found = whirl.bearing({**case, **oil, "units": "US"}, threads=1)
    rest = found.sheets["rest"]
    sizes = {"film": 25.4e-6, "pressure": 6894.757, "load": 4.448222, "critical_mass": 0.45359237}  # NIST SP 811
    for key, size in sizes.items():
        assert rest[key] == pytest.approx(getattr(found, key) / size, rel=1e-6)
    assert rest["temperature"] == pytest.approx(found.temperature * 9 / 5 - 459.67, rel=1e-12)
    assert rest.columns[rest.keys.index("temperature")].title == "film at (degF)"
    assert any("at 113 degF, where oil comes in" in str(own) for own in found.statements)
