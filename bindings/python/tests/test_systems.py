"""Tests custom systems: all ways to define the slopes give the closed form, and errors are sentences."""

import functools
import importlib.util
import ctypes
import os
import sys
import shutil
import threading

import numpy as np
import pytest
from conftest import ROOT

import whirl
from whirl.systems import System, compile_c, signature

ZETA, OMEGAS = 0.04, np.linspace(0.4, 1.9, 7)
# What is left of the start after so many revolutions is below the tolerances of the closed form, exp(-31).
OPTIONS = {"method": "dop853", "rtol": 1e-10, "atol": 1e-12, "transient": 200, "record": 40, "settle": False}
PARAMETERS = {"omega": 1.3, "F": 0.7}
C_ONE = """
int rates(double t, const double *x, const double *p, double *dxdt, void *context) {
    (void)context;
    dxdt[0] = x[1];
    dxdt[1] = p[1] * cos(p[0] * t) - 2.0 * 0.04 * x[1] - x[0];
    return 0;
}
"""
C_LANES = """
int rates(size_t count, size_t row, const double *t, const double *x, const double *p, double *dxdt, void *context) {
    (void)context;
    for (size_t i = 0; i < count; i++) {
        dxdt[i] = x[row + i];
        dxdt[row + i] = p[row + i] * cos(p[i] * t[i]) - 2.0 * 0.04 * x[row + i] - x[i];
    }
    return 0;
}
"""
compiler = pytest.mark.skipif(not shutil.which("cc") and not os.environ.get("CI"), reason="there is no C compiler")


def oscillator(t, x, p):
    return np.array([x[1], p.F * np.cos(p.omega * t) - 2 * ZETA * x[1] - x[0]])


def check_sweep(result, omegas=OMEGAS, velocity=2):
    """Checks that the section of the steady motion is that of the closed form at the end of a period, Re(A) and Re(i
    omega A)."""
    table = result["sweep"]
    amplitude = PARAMETERS["F"] / (1 - omegas**2 + 2j * ZETA * omegas)
    assert list(table.verdicts) == ["P-1"] * len(omegas)
    assert np.abs(table["poincare/section"][:, 0, -1, 0] - amplitude.real).max() < 1e-8
    assert np.abs(table["poincare/section"][:, 0, -1, velocity] - (1j * omegas * amplitude).real).max() < 1e-8
    assert np.array_equal(table.values, omegas)


def test_a_python_function_is_a_system(tmp_path):
    system = System(oscillator, [0.3, 0], PARAMETERS, speed="omega", units={"omega": "rad/s"}, title="Linear")
    result = system.sweep("omega", OMEGAS[2:4], **{**OPTIONS, "rtol": 1e-9})
    check_sweep(result, OMEGAS[2:4], velocity=1)  # the section is in the phase plane
    assert result.title == "Linear" and result.parameters["omega"].unit == "rad/s"
    result.save(tmp_path / "linear.h5")
    again = whirl.open(tmp_path / "linear.h5")
    assert np.array_equal(again["sweep"]["poincare/section"], result["sweep"]["poincare/section"])
    assert again.plot.bifurcation().get_xlabel() == "$ω$ (rad/s)"
    assert str(again).splitlines()[:2] == ["Linear", "sweep: 2 points over omega"]


def test_lanes_of_python_have_the_bits_of_one_machine():
    make = {"speed": "omega", "displacements": 1}
    many = System(oscillator, [0.3, 0], PARAMETERS, lanes=True, **make)
    check_sweep(many.sweep("omega", OMEGAS, **OPTIONS))
    quick = {**OPTIONS, "rtol": 1e-7, "transient": 5, "record": 5}
    sections = [
        System(oscillator, [0.3, 0], PARAMETERS, lanes=lanes, **make).sweep("omega", OMEGAS, **quick)["sweep"]
        for lanes in (False, True)
    ]
    difference = sections[0]["poincare/section"] - sections[1]["poincare/section"]
    assert np.abs(difference).max() < 1e-12  # NumPy may round the cosine of an array differently


@compiler
def test_compiled_functions_are_systems():
    one, lanes = compile_c(C_ONE), compile_c(C_LANES)
    alone = System(one, [0.3, 0], PARAMETERS, speed="omega").sweep("omega", OMEGAS, **OPTIONS)
    check_sweep(alone, velocity=1)
    make = {"speed": "omega", "displacements": 1}
    each = System(one, [0.3, 0], PARAMETERS, **make).sweep("omega", OMEGAS, threads=2, **OPTIONS)
    many = System(lanes, [0.3, 0], PARAMETERS, lanes=True, **make).sweep("omega", OMEGAS, threads=1, **OPTIONS)
    check_sweep(each)
    check_sweep(many)
    # The compiler may fuse multiply-adds in one of the two functions only.
    assert np.abs(each["sweep"]["poincare/section"] - many["sweep"]["poincare/section"]).max() < 1e-11


@compiler
def test_text_that_does_not_compile_is_refused():
    with pytest.raises(whirl.BadInput, match="does not compile:(.|\n)*1:"):
        compile_c("int rates(double t) { return thing; }")
    with pytest.raises(whirl.BadInput, match="defines no function 'slopes'"):
        compile_c(C_ONE, "slopes")
    with pytest.raises(whirl.BadInput, match="expected a name in C"):
        compile_c(C_ONE, "my rates")


# Heads of C functions, each with one error.
OTHER_FORMS = (
    "void rates(double t, const double *x, const double *p, double *dxdt, void *c)",
    "double rates(double t, const double *x, const double *p, double *dxdt, void *c)",
    "int rates(double t)",
    "int rates()",
    "int rates(const double *x, double t, const double *p, double *dxdt, void *c)",
    "int rates(double t, const double *x, double *dxdt, const double *p, void *c)",
    "int rates(double t, const double *x, double *dxdt, void *p)",
    "int rates(float t, const double *x, const double *p, double *dxdt, void *c)",
    "int rates(double t, const float *x, const float *p, float *dxdt, void *c)",
    "int rates(int n, int row, const double *t, const double *x, const double *p, double *dxdt, void *c)",
    "static int rates(double t, const double *x, const double *p, double *dxdt, void *c)",
)


@compiler
@pytest.mark.parametrize("head", OTHER_FORMS)
def test_c_functions_of_another_form_are_refused(head):
    with pytest.raises(whirl.BadInput, match=r"a function 'rates' of another form, expected 'int rates\((.|\n)*:2:"):
        compile_c("\n" + head + " { return 0; }")


@compiler
def test_forms_of_c_texts_are_found_and_compared():
    tangent = "int f(double t, const double *x, const double *p, const double *dx, double *d, void *c) { return 1; }"
    functions = compile_c(C_ONE), compile_c(C_LANES), compile_c(tangent, "f")
    assert [function.form for function in functions] == ["rates", "lanes", "tangent"]
    more = {"speed": "omega"}
    with pytest.raises(
        whirl.BadInput, match=r"rates is a function 'int rates\(size_t .*', expected 'int rates\(double"
    ):
        System(functions[1], [0.3, 0], PARAMETERS, **more)
    with pytest.raises(
        whirl.BadInput, match=r"rates is a function 'int rates\(double .*', expected 'int rates\(size_t"
    ):
        System(functions[0], [0.3, 0], PARAMETERS, lanes=True, **more)
    with pytest.raises(whirl.BadInput, match=r"tangent is a function .*, expected 'int tangent\(double"):
        System(functions[0], [0.3, 0], PARAMETERS, tangent=functions[0], **more)


POINTER = ctypes.POINTER
REAL = POINTER(ctypes.c_double)
SWAPPED = ctypes.c_double.__ctype_be__ if sys.byteorder == "little" else ctypes.c_double.__ctype_le__
NO_FORMS = (
    (ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_double, REAL, REAL, REAL), "expected 'int rates"),
    (ctypes.CFUNCTYPE(None, ctypes.c_double, REAL, REAL, REAL, ctypes.c_void_p), "'void \\(double, double \\*"),
    (ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_float, REAL, REAL, REAL, ctypes.c_void_p), "'int \\(float, double"),
    (ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_double, *4 * [ctypes.c_void_p]), "'int \\(double, void \\*, void"),
    (ctypes.CFUNCTYPE(ctypes.c_int64, ctypes.c_double, REAL, REAL, REAL, ctypes.c_void_p), "'int64_t \\(double"),
    (ctypes.CFUNCTYPE(ctypes.c_int, SWAPPED, REAL, REAL, REAL, ctypes.c_void_p), "'int \\(swapped_float64_t, double"),
    (ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_int, REAL, REAL, REAL, ctypes.c_void_p), "'int \\(int, double"),
    (ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_double, POINTER(REAL), REAL, REAL, ctypes.c_void_p), "double \\*\\*, "),
    (ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_double, REAL, REAL, REAL, ctypes.c_size_t), "double \\*, size_t\\)'"),
    (ctypes.CFUNCTYPE(ctypes.c_uint, ctypes.c_double, REAL, REAL, REAL, ctypes.c_void_p), "'uint32_t \\(double"),
)


@pytest.mark.parametrize("kind, words", NO_FORMS)
def test_functions_of_ctypes_of_another_form_are_refused(kind, words):
    with pytest.raises(whirl.BadInput, match=words):
        System(kind(lambda *_: 0), [0.3, 0], PARAMETERS, speed="omega")


@compiler
def test_functions_by_address_say_their_form():
    compiled, more = compile_c(C_ONE), {"speed": "omega"}
    undeclared = compiled._library.rates
    for unknown in (compiled.address, undeclared, ctypes.c_void_p, object()):
        with pytest.raises(whirl.BadInput, match="^rates is .*expected"):
            System(unknown() if isinstance(unknown, type) else unknown, [0.3, 0], PARAMETERS, **more)
    declared = whirl.systems.prototype()(compiled.address)
    check_sweep(System(declared, [0.3, 0], PARAMETERS, **more).sweep("omega", OMEGAS, **OPTIONS), velocity=1)
    undeclared.argtypes = whirl.systems.prototype()._argtypes_
    System(undeclared, [0.3, 0], PARAMETERS, **more)
    own = __import__("cffi").FFI()
    right = "int (*)(double, double *, double *, double *, void *)"
    System(own.cast(right, compiled.address), [0.3, 0], PARAMETERS, **more)
    for wrong in ("void *", right.replace("int", "void"), right.replace("(double,", "(float,"), right[:-1] + ", ...)"):
        with pytest.raises(whirl.BadInput, match="^rates is a .*expected 'int rates"):
            System(own.cast(wrong, compiled.address), [0.3, 0], PARAMETERS, **more)


def test_cfuncs_of_another_form_are_refused():
    numba = pytest.importorskip("numba") if not os.environ.get("CI") else __import__("numba")

    @numba.cfunc("int32(float64, CPointer(float64), CPointer(float64), CPointer(float64))")
    def as_gsl_has_it(t, x, slopes, p):
        return 0

    with pytest.raises(whirl.BadInput, match=r"'int \(double, double \*, double \*, double \*\)', expected 'int rates"):
        System(as_gsl_has_it, [0.3, 0], PARAMETERS, speed="omega")
    for result, time, state in (
        ("void", "float64", "float64"),
        ("int64", "float64", "float64"),
        ("float64", "float64", "float64"),
        ("boolean", "float64", "float64"),
        ("int32", "float32", "float64"),
        ("int32", "int64", "float64"),
        ("int32", "float64", "float32"),
    ):
        form = f"{result}({time}, CPointer({state}), CPointer(float64), CPointer(float64), voidptr)"
        other = numba.cfunc(form)((lambda t, x, p, d, c: None) if result == "void" else (lambda t, x, p, d, c: 0))
        with pytest.raises(whirl.BadInput, match=r"^rates is a function '.*', expected 'int rates"):
            System(other, [0.3, 0], PARAMETERS, speed="omega")


NO_SLOPES = (
    (lambda t, x, p: (x[1], 1j), "rates gave .* expected real numbers"),
    (lambda t, x, p: np.array([x[1], 1j]), "rates gave .* expected real numbers"),
    (lambda t, x, p: ("1", "2"), r"rates gave \('1', '2'\), expected real numbers"),
    (lambda t, x, p: (x[1], None), "rates gave .* expected real numbers"),
    (lambda t, x, p: {0: x[1], 1: 0.0}, "rates gave .* expected real numbers"),
    (lambda t, x, p: (value for value in x), "rates gave .* expected real numbers"),
    (lambda t, x, p: ([1.0, 2.0], 3.0), "rates gave .* expected real numbers"),
    (lambda t, x, p: x[1], r"rates gave slopes of shape \(\), expected \(2,\)"),
    (lambda t, x, p: [x], r"rates gave slopes of shape \(1, 2\), expected \(2,\)"),
)


@pytest.mark.parametrize("rates, words", NO_SLOPES)
def test_wrong_slopes_are_refused(rates, words):
    with pytest.raises(whirl.BadInput, match=words):
        System(rates, [0.3, 0], PARAMETERS, speed="omega").response(**OPTIONS)


@compiler
@pytest.mark.parametrize("body", ("p[k] = x[k]", "x[k] = 0.1", "out[0] = x[1]"))
def test_functions_that_write_elsewhere_are_refused(body):
    """Tests functions of ctypes whose pointers are in another order. Their type does not show the order, so it is found
    from the effect of the function on its arguments."""
    text = "int f(double t, double *x, double *p, double *out, void *c) { for (int k = 0; k < 2; k++) BODY; return 0; }"
    with pytest.raises(whirl.BadInput, match="another form"):
        compile_c(text.replace("BODY", body), "f")
    wrapped = text.replace("BODY", body).replace("int f(", "static int g(") + (
        "int f(double t, const double *x, const double *p, double *out, void *c)"
        "{ return g(t, (double *)x, (double *)p, out, c); }"
    )
    system = System(compile_c(wrapped, "f"), [0.3, 0.2], PARAMETERS, speed="omega")
    with pytest.raises(
        whirl.BadInput, match="the slopes (change the (state|parameters)|leave number 1 of 2 unwritten)"
    ):
        system.response(**OPTIONS)


def test_numba_functions_are_systems():
    numba = pytest.importorskip("numba") if not os.environ.get("CI") else __import__("numba")

    @numba.cfunc(signature())
    def rates(t, x, p, out, context):
        state, values, slopes = numba.carray(x, 2), numba.carray(p, 2), numba.carray(out, 2)
        slopes[0] = state[1]
        slopes[1] = values[1] * np.cos(values[0] * t) - 2 * ZETA * state[1] - state[0]
        return 0

    @numba.cfunc(signature(lanes=True))
    def lanes(count, row, t, x, p, out, context):
        time, state = numba.carray(t, count), numba.carray(x, (2, row))
        values, slopes = numba.carray(p, (2, row)), numba.carray(out, (2, row))
        for i in range(count):
            slopes[0, i] = state[1, i]
            slopes[1, i] = values[1, i] * np.cos(values[0, i] * time[i]) - 2 * ZETA * state[1, i] - state[0, i]
        return 0

    check_sweep(System(rates, [0.3, 0], PARAMETERS, speed="omega").sweep("omega", OMEGAS, **OPTIONS), velocity=1)
    system = System(lanes, [0.3, 0], PARAMETERS, speed="omega", displacements=1, lanes=True)
    check_sweep(system.sweep("omega", OMEGAS, **OPTIONS))


def test_exponents_follow_a_derivative_or_differences():
    def tangent(t, x, p, dx):
        return [dx[1], -2 * ZETA * dx[1] - dx[0]]

    for given in (None, tangent):
        system = System(oscillator, [0.3, 0], PARAMETERS, speed="omega", tangent=given)
        result = system.response(analyze=["exponents"], **{**OPTIONS, "rtol": 1e-8, "record": 20, "transient": 20})
        sum_of_all = result["response"]["exponents/values"].sum()
        assert abs(sum_of_all + 2 * ZETA * 2 * np.pi / 1.3) < 1e-7


def test_the_rotor_of_a_case_is_a_system():
    """Tests that the equations of a Jeffcott rotor, written by hand, give the motion of the same case."""
    text = """
whirl: 1
parameters: {omega: 1.5 rad/s}
rotor:
  speed: = omega
  length_scale: 1 m
  stations:
    disc: {mass: 1 kg, damping: 0.2 N.s/m, eccentricity: 0.3 m}
  elements:
    - shaft: {between: [disc, ground], k1: 1 N/m, k2: 1 N/m}
    - gravity: 0.5 m/s2
study:
  sweep: {parameter: omega, from: 0.7, to: 2.1, points: 5}
  integrate: {method: dop853, rtol: 1e-10, transient: 150, record: 50}
  analyze: [poincare, regime, lyapunov, orbit]
"""

    def rotor(t, x, p):
        q, v, turn = x[:2], x[2:], p.omega * t
        unbalance = 0.3 * p.omega**2 * np.array([np.cos(turn), np.sin(turn)])
        weight = np.zeros_like(q)
        weight[1] = -0.5
        return np.concatenate([v, unbalance + weight - 0.2 * v - q])

    system = System(
        rotor, [0, 0, 0, 0], {"omega": 1.5}, speed="omega", displacements=2, lanes=True, stations={"disc": (0, 1)}
    )
    case = whirl.run(whirl.Case(text=text), progress=False)["sweep"]
    own = system.sweep("omega", case.values, **OPTIONS)["sweep"]
    section, expected = own["poincare/section"][:, 0, -1], case["poincare/section"][:, 0, -1]
    assert np.abs(section[:, :2] - expected[:, :2]).max() < 1e-8
    # Velocities of a rotor are derivatives by its angle, those of a system by time.
    assert np.abs(section[:, 2:] / case.values[:, None] - expected[:, 2:]).max() < 1e-8
    assert np.abs(own["orbit/max_radius"] - case["orbit/max_radius"]).max() < 1e-8
    assert list(own.verdicts) == list(case.verdicts)


def test_maps_have_two_parameters():
    system = System(oscillator, [0.3, 0], PARAMETERS, speed="omega", displacements=1, lanes=True)
    omegas = OMEGAS[2:5]
    table = system.map(("omega", omegas), ("F", [0.3, 0.7]), **OPTIONS)["map"]
    assert table.shape == (2, 3) and table.second == "F"
    amplitude = 0.7 / (1 - omegas**2 + 2j * ZETA * omegas)
    assert np.abs(table["poincare/section"][1, :, 0, -1, 0] - amplitude.real).max() < 1e-8


def test_what_a_function_raises_comes_through():
    def fails(t, x, p):
        if t > 1:
            raise ZeroDivisionError("by hand")
        return oscillator(t, x, p)

    for more in ({}, {"displacements": 1}, {"displacements": 1, "lanes": True}):
        function = (lambda t, x, p: fails(t.max(), x, p)) if more.get("lanes") else fails
        with pytest.raises(ZeroDivisionError, match="by hand"):
            System(function, [0.3, 0], PARAMETERS, speed="omega", **more).sweep("omega", OMEGAS, **OPTIONS)
    with pytest.raises(whirl.BadInput, match=r"slopes of shape \(3,\), expected \(2,\)"):
        System(lambda t, x, p: [0, 0, 0], [0.3, 0], PARAMETERS, speed="omega").response(**OPTIONS)


def test_wrong_arguments_are_refused():
    def make(**more):
        return System(oscillator, [0.3, 0], PARAMETERS, **more)

    for words, build in [
        ("give one of both", lambda: make().response()),
        ("give one of both", lambda: make(speed="omega", period=1)),
        ("no parameter omgea, did you mean omega", lambda: make(speed="omgea")),
        ("period is -1", lambda: make(period=-1)),
        ("expected a function", lambda: System(3.5, [0], {}, period=1)),
        ("no coordinate 5", lambda: make(period=1, stations={"s": (0, 5)})),
        ("no parameter c that has a unit", lambda: make(period=1, units={"c": "m"})),
        ("cannot have as an attribute", lambda: System(oscillator, [0, 0], {"lambda": 1}, period=1)),
        ("cannot have as an attribute", lambda: System(oscillator, [0, 0], {"_a": 1}, period=1)),
        ("rates is True, expected a function", lambda: System(True, [0], {}, period=1)),
        ("rates is None, expected a function", lambda: System(None, [0], {}, period=1)),
        ("rates is -1, expected a function", lambda: System(-1, [0], {}, period=1)),
        (f"rates is {1 << 70}, expected a function", lambda: System(1 << 70, [0], {}, period=1)),
        ("tangent is -1, expected a function", lambda: make(period=1, tangent=-1)),
        ("rates is 0, expected a function", lambda: System(0, [0], {}, period=1)),
        ("displacements is -5", lambda: make(period=1, displacements=-5)),
        ("displacements is 1.7", lambda: make(period=1, displacements=1.7)),
        ("a coordinate of the station 's' is -1", lambda: make(period=1, stations={"s": (-1, 0)})),
        ("expected a pair", lambda: make(period=1, stations={"s": (0, 1, 2)})),
        ("expected different parameters", lambda: make(period=1).map(("F", [1, 2]), ("F", [1, 2]))),
        ("lanes is -3, expected True or False", lambda: make(period=1, lanes=-3)),
        ("kinked is 'no', expected True or False", lambda: make(period=1, kinked="no")),
        ("start: could not convert", lambda: System(oscillator, ["a", 0], {}, period=1)),
        (r"start has the shape \(2, 2\)", lambda: System(oscillator, [[1, 2], [3, 4]], {}, period=1)),
        ("0 coordinates", lambda: System(oscillator, [], {}, period=1)),
        ("no option rtoll, did you mean rtol", lambda: make(period=1).response(rtoll=1)),
        ("no analysis poincar", lambda: make(period=1).response(analyze=["poincar"])),
        ("is 1 after 2", lambda: make(period=1).sweep("F", [1, 2, 1])),
        ("values of F are .*, expected numbers in SI", lambda: make(period=1).sweep("F", ["a"])),
        (
            "the parameter c is '1 mm', expected a number in SI",
            lambda: System(oscillator, [0], {"c": "1 mm"}, period=1),
        ),
        ("parameters are .*, expected a dict", lambda: System(oscillator, [0], [1, 2], period=1)),
        ("angles are .*, expected a dict", lambda: make(period=1, angles=[1])),
        ("the period is '1 s', expected a number in SI", lambda: make(period="1 s")),
        ("speed is 3, expected the name of a parameter", lambda: make(speed=3)),
        ("no parameter omgea that has a unit, did you mean omega", lambda: make(period=1, units={"omgea": "rad/s"})),
        ("the unit of omega is 'furlogn', expected one", lambda: make(period=1, units={"omega": "furlogn"})),
        ("the unit of omega is rpm, .*expected an SI unit", lambda: make(period=1, units={"omega": "rpm"})),
        ("an axis of the map is 'F', expected", lambda: make(period=1).map("F", "omega")),
        ("no option stepp, did you mean step", lambda: make(period=1).branch("F", 0, 1, stepp=1)),
        (
            r"rates gave \['a', 'b'\], expected real numbers",
            lambda: System(lambda t, x, p: ["a", "b"], [0, 0], period=1).response(),
        ),
    ]:
        with pytest.raises(whirl.BadInput, match=words):
            build()


@compiler
def test_the_documentation_is_true():
    text = (ROOT / "docs/python.md").read_text().split("\n## Systems of your own\n")[1].split("\n## ")[0]
    names = {}
    text = text.replace("0.65, 512)", "0.65, 128)")  # fewer points of the same sweep
    for block in text.split("```python\n")[1:]:
        exec(block.split("```")[0], names)
    assert names["motion"]["response"].verdicts[0] == "P-5"
    assert len(names["result"]["sweep"].values) == 64 and len(names["fine"]["sweep"].values) == 128
    assert {"P-1", "P-2", "chaotic"} <= set(names["fine"]["sweep"].verdicts)
    assert (names["branch"]["trace/special"] == 3).sum() == 2
    rests = names["rests"]
    hopf = rests["trace/special"] == 5
    assert hopf.sum() == 2 and np.abs(rests.values[hopf] - 470 / 19).max() < 1e-8
    rate = (rests["trace/angle"] * rests.clock)[hopf]
    assert np.abs(rate - np.sqrt(8 / 3 * (470 / 19 + 10))).max() < 1e-8


def test_functions_may_keep_their_arguments():
    kept = []

    def slopes(t, x, p):
        kept.append((t, x, x.copy()))
        return [np.cos(t) - x[0]]

    System(slopes, [0.25], {}, period=2 * np.pi).response(method="dop853", transient=1, record=2, analyze="poincare")
    assert len(kept) > 50 and all(np.array_equal(x, copy) for _, x, copy in kept)
    assert len({float(x[0]) for _, x, _ in kept}) > 50


def test_a_single_row_keeps_its_dimension(tmp_path):
    """Tests one recorded revolution: the section keeps a dimension of one row in memory, in files and in xarray."""
    system = System(oscillator, [0.3, 0], PARAMETERS, speed="omega", stations={"a": (0, 1), "b": (1, 0)})
    options = {**OPTIONS, "transient": 0, "record": 1, "analyze": "poincare", "progress": False}
    for vary, points in (({}, (1,)), ({"F": [0.1, 0.2]}, (2,)), ({"F": [0.1, 0.2], "omega": [1.0, 1.1, 1.2]}, (3, 2))):
        result = system.run(vary, **options)
        (table,) = result.tables.values()
        section = table["poincare/section"]
        assert section.shape == (*points, 2, 1, 4)
        assert table.fields["poincare/section"].dimensions == ("station", "row", "column")
        assert np.array_equal(section[..., 0, 0, :2], section[..., 1, 0, 1::-1])
        result.save(tmp_path / "one.h5")
        (again,) = whirl.open(tmp_path / "one.h5").tables.values()
        assert np.array_equal(again["poincare/section"], section)
        if importlib.util.find_spec("xarray"):
            for each in (table, again):
                data = each.to_xarray()["poincare/section"]
                assert data.dims[-3:] == ("station", "poincare/section row", "poincare/section column")
                assert np.array_equal(data.values, section)
        (tmp_path / "one.h5").unlink()


# ---------------------------------------------------------------- journals recognize their equations


def stopped(system, journal):
    """Runs a system with a journal, and stops the run."""

    def stop(*reported):
        raise KeyError("enough")

    with pytest.raises(KeyError, match="enough"):
        gone_on(system, journal, progress=stop)


def gone_on(system, journal, **more):
    options = {"method": "rk4", "steps_per_revolution": 16, "transient": 2, "record": 5, "settle": False}
    return system.sweep("F", np.linspace(0.2, 0.6, 5), journal=journal, **{**options, "progress": False, **more})


def stiffer(k, numbers=(0.3, 0.1), **more):
    """Returns a function that closes over numbers."""
    table = np.array(numbers)

    def slopes(t, x, p):
        return x[1], p.F * np.cos(p.omega * t) - table[0] * x[1] - k * x[0] + HELD * cubed(x[0])

    return System(slopes, more.pop("start", [0.3, 0]), PARAMETERS, speed="omega", **more)


HELD = 0.0


def cubed(x):
    return -(x**3)


def test_python_journal_of_another_function(tmp_path, monkeypatch):
    """Tests that a journal continues only with the same equations: text, closed-over values, and start."""
    journal = tmp_path / "journal"
    stopped(stiffer(1.0), journal)
    others = {
        "another number": stiffer(1.5),
        "another array": stiffer(1.0, (0.2, 0.1)),
        "another start": stiffer(1.0, start=[0.3, 0.1]),
        "another form": stiffer(1.0, displacements=1),
        "kinks": stiffer(1.0, kinked=True),
        "another station": stiffer(1.0, stations={"state": (1, 0)}),
        "a derivative": stiffer(1.0, tangent=lambda t, x, p, dx: [dx[1], -0.3 * dx[1] - dx[0]]),
        "another function": System(oscillator, [0.3, 0], PARAMETERS, speed="omega"),
        "a partial one": System(functools.partial(stiffer(1.0).rates), [0.3, 0], PARAMETERS, speed="omega"),
        "a name": stiffer(1.0, identity="stiffer 1"),
    }
    for what, other in others.items():
        with pytest.raises(whirl.BadInput, match="is of another study: equations"):
            gone_on(other, journal, resume=True), what
    for name, value in (("HELD", 0.1), ("cubed", lambda x: x**2)):
        with monkeypatch.context() as changed:
            changed.setitem(globals(), name, value)
            with pytest.raises(whirl.BadInput, match="is of another study: equations"):
                gone_on(stiffer(1.0), journal, resume=True)
    result = gone_on(stiffer(1.0), journal, resume=True)
    plain = gone_on(stiffer(1.0), None)
    assert np.array_equal(result["sweep"]["orbit/max_radius"], plain["sweep"]["orbit/max_radius"])
    assert not journal.exists()


def test_a_period_and_a_long_start_are_known_again(tmp_path):
    def slopes(t, x, p):
        return p.F * np.cos(t) - x

    def system(period=6.0, last=0.0):
        return System(slopes, [0.1] * 59 + [last], {"F": 1.0}, period=period)

    stopped(system(), tmp_path / "journal")
    for other in (system(period=6.5), system(last=1e-9)):
        with pytest.raises(whirl.BadInput, match="is of another study: equations"):
            gone_on(other, tmp_path / "journal", resume=True)
    gone_on(system(), tmp_path / "journal", resume=True)


@compiler
def test_c_texts_are_known_again(tmp_path):
    def system(text, **more):
        return System(compile_c(text, **more), [0.3, 0], PARAMETERS, speed="omega")

    for path in (tmp_path / "law.h", tmp_path / "one", tmp_path / "two"):
        path.parent.mkdir(exist_ok=True)
    (tmp_path / "law.h").write_text("#define DAMPING 0.04\n")
    text = C_ONE.replace("2.0 * 0.04", "2.0 * DAMPING").replace("\nint", f'\n#include "{tmp_path}/law.h"\nint', 1)
    stopped(system(text), tmp_path / "journal")
    for other in (system(text + " "), system("// a word\n" + text)):
        assert other.rates.identity == system(text).rates.identity
    (tmp_path / "law.h").write_text("#define DAMPING 0.05\n")
    for other in (system(text), system(C_ONE, flags="-O1")):
        with pytest.raises(whirl.BadInput, match="is of another study: equations"):
            gone_on(other, tmp_path / "journal", resume=True)
    (tmp_path / "law.h").write_text("#define DAMPING 0.04\n")
    gone_on(system(text), tmp_path / "journal", resume=True)


@compiler
def test_functions_that_cannot_be_known_again_need_a_name(tmp_path):
    lock, function = threading.Lock(), compile_c(C_ONE)
    by_address = whirl.systems.prototype()(function.address)

    def locked(t, x, p):
        with lock:
            return oscillator(t, x, p)

    def evaluated(t, x, p):
        return eval("oscillator(t, x, p)")

    for rates, words in [
        (by_address, "it is an address"),
        (locked, "a lock, whose content is not known"),
        (evaluated, r"it calls eval\(\)"),
    ]:
        system = System(rates, [0.3, 0], PARAMETERS, speed="omega")
        with pytest.raises(whirl.BadInput, match=words + '.*identity="my rotor 1"'):
            gone_on(system, tmp_path / "journal")
        assert not (tmp_path / "journal").exists()
    names = [System(by_address, [0.3, 0], PARAMETERS, speed="omega", identity=name) for name in ("a 1", "a 2")]
    stopped(names[0], tmp_path / "journal")
    with pytest.raises(whirl.BadInput, match="equations was 'a 1' and is 'a 2'"):
        gone_on(names[1], tmp_path / "journal", resume=True)
    gone_on(names[0], tmp_path / "journal", resume=True)


# ---------------------------------------------------------------- contacts

BOUNCE = """
int rates(double t, const double *x, const double *p, double *dxdt, void *context) {
    (void)context;
    double h = 0.004 * cos(p[0] * t), speed = -0.004 * p[0] * sin(p[0] * t), force = 0;
    if (x[0] < h) { force = 1e5 * (h - x[0]) + p[1] * (speed - x[1]); if (force < 0) force = 0; }
    dxdt[0] = x[1];
    dxdt[1] = force - 9.81;
    return 0;
}
"""


@compiler
def test_kinked_jump():
    """Tests a mass that bounces on a shaking floor. Its section after a revolution is that of SciPy's DOP853 at 1e-12,
    with flight and contact integrated separately. If the floor has a damper, the force jumps, and `kinked` fails with
    the place of the jump."""
    slopes = compile_c(BOUNCE)

    def section(damper, **more):
        system = System(slopes, [0.05, 0], {"w": 55.0, "damper": damper}, speed="w", **more)
        options = {"method": "dop853", "rtol": 1e-9, "transient": 0, "record": 4, "progress": False}
        return system.response(**options)["response"]["poincare/section"][0, 0, 0]

    assert np.abs(section(30.0)[:2] - [0.009919727, 1.000188879]).max() < 2e-8
    assert np.abs(section(30.0, displacements=1)[[0, 2]] - [0.009919727, 1.000188879]).max() < 1e-7
    for displacements in (0, 1):
        with pytest.raises(whirl.NumericalFailure, match=r"slope 1 of the system jumps by 3\d.* at t = 0.0983.*damped"):
            section(30.0, kinked=True, displacements=displacements)
        spring = [section(0.0, kinked=kinked, displacements=displacements) for kinked in (False, True)]
        assert np.abs(spring[0] - spring[1]).max() < 1e-6


ROUGH = """
int rates(double t, const double *x, const double *p, double *dxdt, void *context) {
    static long calls;
    (void)t, (void)context;
    dxdt[0] = (p[0] > 2.5 ? calls++ % 2 ? 1e20 : -1e20 : 0.0) - x[0];
    return 0;
}
"""


@compiler
def test_motions_that_could_not_be_followed_are_reported():
    """Tests slopes that change at every call, so that every step fails: the error is reported. The shortest step is
    reached after millions of calls."""
    system = System(compile_c(ROUGH), [1], {"a": 3.0}, period=1.0)
    options = {"method": "dop853", "transient": 2, "record": 3, "progress": False, "threads": 1}
    with pytest.raises(whirl.NumericalFailure, match="1 of 1 motions could not be followed"):
        system.response(**options)
    with pytest.warns(UserWarning, match="1 of 3 motions could not be followed"):
        result = system.sweep("a", [1.0, 2.0, 3.0], **options)
    assert np.isfinite(result["sweep"]["poincare/section"][:2]).all()
