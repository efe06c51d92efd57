"""Custom systems, whose slopes dx/dt a Python callable, a Numba ``cfunc``, a function of C or a text in C computes.

>>> def duffing(t, x, p):
...     return x[1], p.gamma * np.cos(p.omega * t) - 0.3 * x[1] + x[0] - x[0] ** 3
>>> system = whirl.systems.System(duffing, [1, 0], {"gamma": 0.3, "omega": 1.2}, speed="omega")
>>> result = system.sweep("gamma", np.linspace(0.2, 0.65, 200))
>>> result.plot.bifurcation()

Such a system has the analyses, verdicts, files and figures of a rotor.
"""

from __future__ import annotations

import ctypes
import hashlib
import os
import re
import shlex
import shutil
import subprocess
import tempfile
import warnings
from collections import namedtuple
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from keyword import iskeyword
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _identity, errors
from ._forms import FORMS, address_of, callback_type, ctypes_prototype, prototype_of, words_of
from ._library import check, ffi, lib, word_bytes
from .running import compute
from .fields import FIELD

if TYPE_CHECKING:
    from numba.core.typing.templates import Signature
    from numpy.typing import ArrayLike

    from .result import Result

__all__ = ["signature", "prototype", "CFunction", "compile_c", "Event", "Happening", "Motion", "System"]


def _form(lanes, tangent):
    if lanes and tangent:
        raise errors.BadInput("lanes and tangent are both True, expected one of them: a tangent is of one machine")
    return "lanes" if lanes else "tangent" if tangent else "rates"


def signature(lanes: bool = False, tangent: bool = False) -> Signature:
    """Returns the signature of a Numba ``cfunc`` for slopes of one machine, of many machines in lanes, or for a
    tangent.

    One machine: ``f(t, x, p, slopes, context)``; many: ``f(count, row, t, x, p, slopes, context)``, where number k of
    machine i is at ``[k * row + i]``; a tangent: ``f(t, x, p, dx, slopes, context)``. Pointers become arrays by
    ``numba.carray(x, n)``; 0 is returned.
    """
    from numba import types

    kinds = {
        "double": types.float64,
        "double *": types.CPointer(types.float64),
        "size_t": types.uint64,
        "void *": types.voidptr,
    }
    return types.int32(*(kinds[word] for word in words_of(_form(lanes, tangent))))


def prototype(lanes: bool = False, tangent: bool = False) -> type:
    """Returns the form of :func:`signature` as a type of ctypes: ``prototype()(address)`` declares a function at an
    address, ``prototype()(("rates", library))`` a function of a library."""
    return ctypes_prototype(_form(lanes, tangent))


class CFunction:
    """A function of C that was compiled from its text; see :func:`compile_c`."""

    def __init__(
        self, library: ctypes.CDLL, name: str, form: str, folder: tempfile.TemporaryDirectory, identity: str
    ) -> None:
        self._library, self._folder = library, folder  # both must live as long as the function
        #: its form: "rates", "lanes" or "tangent"
        self.form = form
        #: checksum of its text, of included files, of the compiler and its flags
        self.identity = identity
        try:
            #: address in memory
            self.address = ctypes.cast(getattr(library, name), ctypes.c_void_p).value
        except AttributeError:
            raise errors.BadInput(f"the C text defines no function '{name}'") from None


def compile_c(source: str, name: str = "rates", flags: Sequence[str] = ("-O3", "-march=native")) -> CFunction:
    """Compiles the text of a C function with the system's compiler (``$CC``, or ``cc``).

    Parameters
    ----------
    source : str
        ``int rates(double t, const double *x, const double *p, double *dxdt, void *context) {...}``, which returns 0,
        or the form for lanes or a tangent (:func:`signature`). ``math.h`` and ``stddef.h`` are included before it.
    name : str
        Name of the function.
    flags : sequence of str
        Flags for the compiler.

    Returns
    -------
    CFunction

    Raises
    ------
    BadInput
        If the text does not compile, or the function has another form; with the message of the compiler.
    MissingProgram
        If there is no compiler.
    """
    compiler = shlex.split(os.environ.get("CC") or "cc")
    flags = shlex.split(flags) if isinstance(flags, str) else flags
    if not isinstance(flags, Sequence) or not all(isinstance(flag, str) for flag in flags):
        raise errors.BadInput(f"the flags are {flags!r}, expected texts for the compiler")
    if not shutil.which(compiler[0]):
        raise errors.MissingProgram(f"there is no C compiler '{compiler[0]}' (CC names another)")
    if not isinstance(source, str):
        raise errors.BadInput(f"the C text is {type(source).__name__}, expected a str")
    if not (isinstance(name, str) and name.isascii() and name.isidentifier()):
        raise errors.BadInput(f"the function is called {name!r}, expected a name in C")
    folder = tempfile.TemporaryDirectory(prefix="whirl-")
    text, library = Path(folder.name) / "system.c", Path(folder.name) / "system.so"

    def run(*words, declared=""):
        text.write_text(f"#include <math.h>\n#include <stddef.h>\n{declared}\n#line 1\n{source}")
        return subprocess.run([*compiler, "-std=c17", *flags, *words], capture_output=True, text=True)

    def compiled(*words):
        done = run(*words)
        if done.returncode != 0:
            raise errors.BadInput(f"the C text does not compile:\n{done.stderr.strip()}")
        return done.stdout

    # Find the form of the function: the first one whose prototype the compiler accepts before the text.
    said = {}
    for form in FORMS:
        words = "-shared", "-fPIC", str(text), "-o", str(library), "-lm"
        done = run(*words, declared=prototype_of(form, name) + ";")
        if done.returncode == 0:
            break
        said[form] = done.stderr.strip()
    else:
        compiled("-fsyntax-only", str(text))
        nearest = "lanes" if re.search(rf"\b{name}\s*\(\s*size_t", source) else "rates"
        raise errors.BadInput(
            f"the C text has a function '{name}' of another form, expected '{prototype_of(nearest, name)}':\n"
            + said[nearest]
        )
    version = subprocess.run([*compiler, "--version"], capture_output=True, text=True).stdout
    parts = compiled("-E", "-P", str(text)), version, repr((name, *flags))
    identity = hashlib.sha256("\0".join(parts).encode()).hexdigest()
    return CFunction(ctypes.CDLL(str(library)), name, form, folder, identity)


# Options of branches, and the prefix that their names have in the library and in results.
_TRACE = "trace_"
_OF_BRANCHES = (
    *("rest", "revolutions", "longest", "switches", "segments", "points", "step", "rtol"),
    *("tori", "torus_nodes", "torus_points", "torus_step", "torus_accuracy"),
)


def _given(function, what, values, shape):
    """Returns the result of a Python function as an array; raises BadInput unless it has the shape."""
    try:
        found = np.asarray(values)
        if found.dtype.kind == "O":
            found = np.array([float(value) for value in found.ravel()]).reshape(found.shape)
    except (TypeError, ValueError):
        found = np.asarray("")
    if found.dtype.kind not in "biuf":
        raise errors.BadInput(f"{function} gave {values!r}, expected real numbers")
    if found.shape != shape:
        raise errors.BadInput(f"{function} gave {what} of shape {found.shape}, expected {shape or 'one number'}")
    return found


def _passing(value, called):
    """Returns the direction in which the value of an event passes 0."""
    if not isinstance(value, (int, np.integer)) or value not in (-1, 0, 1):
        raise errors.BadInput(f"{called} has passing {value!r}, expected 1 for rising, -1 for falling, 0 for both")
    return int(value)


def _flag(value, what):
    if not isinstance(value, (bool, np.bool_)):
        raise errors.BadInput(f"{what} is {value!r}, expected True or False")
    return bool(value)


def _row(values, what):
    try:
        numbers = np.atleast_1d(np.array(values, dtype=float))
    except (TypeError, ValueError) as failure:
        raise errors.BadInput(f"{what}: {failure}, expected numbers") from None
    if numbers.ndim > 1:
        raise errors.BadInput(f"{what} has the shape {numbers.shape}, expected a number for every coordinate")
    return numbers


def _number(value, what):
    """Converts a number in SI; texts with units are rejected."""
    try:
        if not isinstance(value, str):
            return float(value)
    except (TypeError, ValueError):
        pass
    raise errors.BadInput(f"{what} is {value!r}, expected a number in SI")


def _mapping(given, what):
    if given is not None and not isinstance(given, Mapping):
        raise errors.BadInput(f"the {what} are {given!r}, expected a dict: their names with what they are")
    return dict(given or {})


def _did_you_mean(name, names):
    near = get_close_matches(str(name), list(names), 1)
    return f", did you mean {near[0]}?" if near else ""


def _count(number, what):
    """Returns a whole number from 0 on, or raises BadInput."""
    whole = -1 if isinstance(number, (bool, np.bool_)) else number
    if not isinstance(whole, (int, np.integer)) or not 0 <= whole < 1 << 31:
        raise errors.BadInput(f"{what} is {number!r}, expected a whole number from 0 on")
    return int(whole)


def _pair(name, pair):
    """Returns the two coordinates of a station."""
    if not isinstance(pair, (Sequence, np.ndarray)) or len(pair) != 2:
        raise errors.BadInput(f"the station '{name}' is {pair!r}, expected a pair of coordinates")
    return tuple(_count(coordinate, f"a coordinate of the station '{name}'") for coordinate in pair)


def _identity_of(what, function):
    """Returns the checksum of a function, or the identity that the user gives instead."""
    try:
        if isinstance(function, (int, ctypes._CFuncPtr, ffi.CData)):
            raise _identity.Unknown("it is an address")
        return getattr(function, "identity", None) or _identity.checksum(function)
    except _identity.Unknown as reason:
        raise errors.BadInput(
            f"a journal could not tell {what} from other functions ({reason}), expected a name and version of what is "
            'computed: System(..., identity="my rotor 1")'
        ) from None


def _followed(result):
    """Returns a result; raises an error if all its motions failed, and warns if some did."""
    for table in result.tables.values():
        if FIELD.REGIME_DIVERGED_AT in table:
            lost = (table[FIELD.REGIME_CODE] == 0) & (table[FIELD.REGIME_DIVERGED_AT] > 0)
        elif FIELD.POINCARE_SECTION in table:
            section = table[FIELD.POINCARE_SECTION]
            lost = np.isnan(section).reshape(*table.shape, -1).all(axis=-1)
        else:
            continue
        if not lost.any():
            continue
        words = (
            f"{lost.sum()} of {lost.size} motions could not be followed: the solver went on in ever shorter steps, as "
            "it does where slopes jump time and again, grow without bounds, or are rough or no numbers"
        )
        if lost.all():
            raise errors.NumericalFailure(words)
        warnings.warn(words, stacklevel=3)
    return result


def _numbers(values, name):
    """Returns an array of parameter values, and its pointer."""
    try:
        values = np.ascontiguousarray(values, dtype=float).ravel()
    except (TypeError, ValueError):
        raise errors.BadInput(f"the values of {name} are {values!r}, expected numbers in SI") from None
    return values, ffi.cast("double *", values.ctypes.data)


@dataclass(frozen=True)
class Event:
    """An event of a motion over time: when ``value(t, x, p)`` passes 0, the motion continues from another state, or
    ends.

    >>> bounce = Event(lambda t, x, p: x[0], passing=-1, reset=lambda t, x, p: [x[0], -p.restitution * x[1]])
    """

    #: ``f(t, x, p)``, a number that passes 0 where the event happens
    value: Callable
    #: 1: rising, -1: falling, 0: both ways
    passing: int = 0
    #: ``f(t, x, p)``, the state after the event
    reset: Callable | None = None
    #: whether the motion ends there
    ends: bool = False
    #: name of the event, in messages and in :class:`Happening`
    name: str = ""


@dataclass(frozen=True)
class Happening:
    """What happened at an event of a motion."""

    #: name of the event
    name: str
    #: time of the event
    time: float
    #: the states before and after it
    before: np.ndarray
    after: np.ndarray


@dataclass(frozen=True)
class Motion:
    """A motion over time."""

    #: instants that were reached [count]
    times: np.ndarray
    #: the states there [count][n]
    states: np.ndarray
    #: events that happened, in their order
    events: list[Happening]
    #: "done", "event", "accumulated" (events came faster and faster), "diverged" or "stuck"
    end: str
    #: when it ended
    time: float
    #: ... and in words, "" where it reached its last instant
    reason: str


class _Study:
    """A study of a system, before it is passed to the library."""

    def __init__(self, vary=None, analyze=(), options=None, branch=None, curves=None):
        self.vary, self.options = vary or {}, options or {}
        self.analyze = [analyze] if isinstance(analyze, str) else analyze
        self.branch, self.curves = branch, curves

    def put(self, handle):
        """Passes the study to the library."""
        for name, values in self.vary.items():
            values, pointer = _numbers(values, name)
            check(lib.whirl_user_system_vary(handle, word_bytes(name), pointer, len(values)))
        if self.branch is not None:
            name, first, last, at = self.branch
            at, pointer = _numbers(at, name)
            first, last = (_number(bound, f"a bound of {name}") for bound in (first, last))
            check(lib.whirl_user_system_branch(handle, word_bytes(name), float(first), float(last), pointer, len(at)))
        if self.curves is not None:
            name, first, last = self.curves
            check(lib.whirl_user_system_curves(handle, word_bytes(name), float(first), float(last)))
        for name in self.analyze:
            check(lib.whirl_user_system_analyze(handle, word_bytes(name)))
        for name, value in self.options.items():
            word = ("no", "yes")[bool(value)] if isinstance(value, (bool, np.bool_)) else value
            check(lib.whirl_user_system_set(handle, word_bytes(name), word_bytes(str(word))))


class System:
    """A system dx/dt = f(t, x, p) with a period in t, which is called a revolution.

    Parameters
    ----------
    rates : callable, Numba cfunc, CFunction, or function of ctypes or cffi
        A Python callable ``f(t, x, p)`` returns the slopes dx/dt, a sequence; x is an array, p has the parameters by
        their names (``p.gamma``). A compiled function must declare its form (:func:`signature`): a function of ctypes
        by ``argtypes``, an address by :func:`prototype`.
    start : sequence of float
        The initial state of motions.
    parameters : mapping of str to float
        Values in SI, in the order that compiled functions get.
    speed : str, optional
        The parameter that is the angular frequency of the excitation: the period is 2 pi over it.
    period : float, optional
        The period, in the place of a speed. One of both is needed, except for motions over time (:meth:`follow`).
    lanes : bool
        Whether ``rates`` computes many machines in one call: a Python callable then gets t [count], x [n][count] and
        parameters [count]; a compiled function has ``signature(lanes=True)``.
    displacements : int
        Number n of displacements: the first n coordinates, whose slopes are the next n coordinates. The solver then
        computes many machines in one call, which makes ``lanes`` fast.
    stations : mapping of str to pairs, optional
        Pairs of coordinates that are x and y of a station: ``{"disc": (0, 1)}``; default: the first two. If there is
        only one displacement, it is both x and y, so that radii are sqrt(2) times as large.
    angles : mapping of int to float, optional
        Coordinates that are angles, with the size of a turn: ``{0: 2 * numpy.pi}``. They count modulo a turn, so that a
        rotating pendulum moves periodically; sections have values within half a turn of 0. Slopes must have the period
        of a turn in them.
    scales : mapping of int to float, optional
        Typical sizes of coordinates in their own units: ``{0: 3e5, 1: 1e-6}`` for a pressure in Pa and a displacement
        in m. Tolerances, perturbations, distances of returns and the bound of divergence (``atol``, ``limit``) are
        multiples of them; results have the coordinates' own units. Default: 1 or, if motions are below 0.01 or above
        100, the sizes in the first revolutions.
    tangent : optional
        The derivative of the slopes applied to a perturbation: ``f(t, x, p, dx)``, or compiled with one more pointer
        after p. Default: finite differences.
    kinked : bool
        Whether slopes have kinks without jumps, as with a spring that begins to touch. Do not set it if slopes jump (a
        contact with a damper, dry friction): motions are right without it, and with it slopes that jump are an error.
    units : mapping of str to str, optional
        SI units of parameters, as UDUNITS has them: ``{"omega": "rad/s"}``.
    title : str
        Title of results.
    identity : str, optional
        A name and version of the equations, by which a journal identifies them. Default: checksums of C texts, and of
        Python functions with all objects that they use.
    """

    def __init__(
        self,
        rates: Callable | CFunction | Any,
        start: ArrayLike,
        parameters: Mapping[str, float] | None = None,
        *,
        speed: str | None = None,
        period: float | None = None,
        lanes: bool = False,
        displacements: int = 0,
        stations: Mapping[str, Sequence[int]] | None = None,
        angles: Mapping[int, float] | None = None,
        scales: Mapping[int, float] | None = None,
        tangent: Callable | CFunction | Any = None,
        kinked: bool = False,
        units: Mapping[str, str] | None = None,
        title: str = "",
        identity: str | None = None,
    ) -> None:
        if speed is not None and period is not None:
            raise errors.BadInput("a system has a period, or a parameter that is its speed: give one of both")
        self.start = _row(start, "start")
        self.parameters = {
            str(name): _number(value, f"the parameter {name}")
            for name, value in _mapping(parameters, "parameters").items()
        }
        if speed is not None and not isinstance(speed, str):
            raise errors.BadInput(f"speed is {speed!r}, expected the name of a parameter")
        period = None if period is None else _number(period, "the period")
        self.speed, self.period, self.lanes = speed, period, _flag(lanes, "lanes")
        self.displacements = _count(displacements, "displacements")
        self.angles = {
            _count(index, "an angle"): _number(turn, f"a turn of the angle {index}")
            for index, turn in _mapping(angles, "angles").items()
        }
        self.scales = {
            _count(index, "a scale"): _number(scale, f"the scale of coordinate {index}")
            for index, scale in _mapping(scales, "scales").items()
        }
        self.stations, self.kinked, self.title = _mapping(stations, "stations"), _flag(kinked, "kinked"), str(title)
        self.units, self.rates, self.tangent = _mapping(units, "units"), rates, tangent
        self.identity = None if identity is None else str(identity)
        unknown = set(self.units) - set(self.parameters)
        if unknown:
            name = sorted(unknown)[0]
            raise errors.BadInput(f"there is no parameter {name} that has a unit{_did_you_mean(name, self.parameters)}")
        self._rates_at = address_of("rates", "lanes" if self.lanes else "rates", rates)
        self._tangent_at = None if tangent is None else address_of("tangent", "tangent", tangent)
        for name in self.parameters if self._rates_at is None else ():
            if iskeyword(name) or name.startswith("_") or not name.isidentifier():
                raise errors.BadInput(f"a parameter is called '{name}', which p cannot have as an attribute in Python")
        self._build(_Study())  # errors are raised here

    # ---------------------------------------------------------------- functions

    def _state(self, pointer, rows, count=None):
        size = rows if count is None else rows * count
        values = np.frombuffer(ffi.buffer(pointer, 8 * size), float) if size else np.empty(0)
        return values if count is None else values.reshape(rows, count)

    def _copied(self, pointer, rows, count=None):
        """Returns copies of numbers, which a callable may keep: the library's arrays are valid only during the call."""
        return self._state(pointer, rows, count).copy()

    def _python_rates(self, raised):
        n, names = len(self.start), namedtuple("Parameters", self.parameters)
        many, function, count_p = self.lanes, self.rates, len(self.parameters)

        def keep(kind, value, trace):
            raised.setdefault("value", value)

        def put(slopes, to, shape):
            to[...] = _given("rates", "slopes", slopes, shape)

        @ffi.callback(callback_type("rates"), onerror=keep, error=1)
        def one(t, x, p, out, _context):
            state, values = self._copied(x, n), self._copied(p, count_p)
            if many:
                slopes = function(np.array([t]), state.reshape(n, 1), names(*values.reshape(count_p, 1)))
                put(slopes, self._state(out, n, 1), (n, 1))
            else:
                put(function(t, state, names(*values)), self._state(out, n), (n,))
            return 0

        @ffi.callback(callback_type("lanes"), onerror=keep, error=1)
        def lanes(count, row, t, x, p, out, _context):
            times, states = self._copied(t, count), self._copied(x, n, row)[:, :count]
            values = names(*self._copied(p, count_p, row)[:, :count])
            put(function(times, states, values), self._state(out, n, row)[:, :count], (n, count))
            return 0

        return lanes if many else one

    def _python_tangent(self, raised):
        n, names, count_p = len(self.start), namedtuple("Parameters", self.parameters), len(self.parameters)

        def keep(kind, value, trace):
            raised.setdefault("value", value)

        @ffi.callback(callback_type("tangent"), onerror=keep, error=1)
        def tangent(t, x, p, dx, out, _context):
            slopes = self.tangent(t, self._copied(x, n), names(*self._copied(p, count_p)), self._copied(dx, n))
            self._state(out, n)[...] = _given("tangent", "slopes", slopes, (n,))
            return 0

        return tangent

    def _put_functions(self, handle, raised):
        """Passes the functions to the library; returns the objects that must live as long as they are called."""
        address = self._rates_at
        rates = self._python_rates(raised) if address is None else ffi.cast("void *", address)
        if self.lanes:
            check(lib.whirl_user_system_lanes(handle, ffi.cast("whirl_user_lanes_fn", rates), ffi.NULL))
        else:
            check(lib.whirl_user_system_rates(handle, ffi.cast("whirl_user_rates_fn", rates), ffi.NULL))
        if self.tangent is None:
            return rates, None
        address = self._tangent_at
        tangent = self._python_tangent(raised) if address is None else ffi.cast("void *", address)
        check(lib.whirl_user_system_tangent(handle, ffi.cast("whirl_user_tangent_fn", tangent), ffi.NULL))
        return rates, tangent

    def _known(self):
        """Returns the identities of the functions for a journal."""
        if self.identity is not None:
            return self.identity
        functions = {"rates": self.rates} | ({} if self.tangent is None else {"tangent": self.tangent})
        parts = " ".join(_identity_of(what, function) for what, function in functions.items())
        return f"{'lanes' if self.lanes else 'one machine'} {hashlib.sha256(parts.encode()).hexdigest()}"

    # ---------------------------------------------------------------- runs

    def _build(self, study):
        """Makes the library's system; returns it with objects that must live as long: (handle, functions, raised)."""
        out, raised = ffi.new("whirl_user_system **"), {}
        check(lib.whirl_user_system_new(word_bytes(self.title), len(self.start), out))
        handle = ffi.gc(out[0], lib.whirl_user_system_free)
        for name, value in self.parameters.items():
            unit = self.units.get(name, "1")
            text = f"{value:.17g}" + (f" {unit}" if unit != "1" else "")
            check(lib.whirl_user_system_parameter(handle, word_bytes(name), value, word_bytes(unit), word_bytes(text)))
        for index, value in enumerate(self.start):
            check(lib.whirl_user_system_start(handle, index, value))
        check(lib.whirl_user_system_oscillates(handle, self.displacements))
        for index, turn in self.angles.items():
            check(lib.whirl_user_system_angle(handle, index, turn))
        for index, scale in self.scales.items():
            check(lib.whirl_user_system_scale(handle, index, scale))
        for name, pair in self.stations.items():
            x, y = _pair(name, pair)
            velocities = (x + self.displacements, y + self.displacements)
            check(lib.whirl_user_system_station(handle, word_bytes(str(name)), x, y, *velocities))
        if self.speed is not None:
            check(lib.whirl_user_system_speed(handle, word_bytes(self.speed)))
        elif self.period is not None:
            check(lib.whirl_user_system_period(handle, float(self.period)))
        if self.kinked:
            check(lib.whirl_user_system_kinked(handle))
        if self.identity is not None:
            check(lib.whirl_user_system_identity(handle, word_bytes(self.identity)))
        study.put(handle)
        return handle, self._put_functions(handle, raised), raised

    def run(
        self,
        vary: Mapping[str, ArrayLike] | None = None,
        analyze: Sequence[str] = (),
        *,
        threads: int | None = None,
        progress: bool | Callable[[str, float, float, float, float], object] | None = None,
        journal: str | os.PathLike | None = None,
        resume: bool = False,
        **options: str | float | bool,
    ) -> Result:
        """Computes motions of the system.

        Parameters
        ----------
        vary : mapping of str to sequences of float, optional
            Up to three parameters with their values: a sweep, a map, or a map with planes.
        analyze : sequence of str
            Default: "poincare", "regime", "lyapunov", "orbit"; also "spectrum", "exponents", "floquet", "waveform",
            ...
        threads : int, optional
            Number of threads; 0: all cores. Default: all cores for compiled functions, 1 for Python callables.
        options
            Options of case files: ``method="dop853"``, ``rtol=1e-8``, ``transient=500``, ``record=100``,
            ``confirm=True``, ``carry="up"``, ...

        Returns
        -------
        Result
            With the table "response", "sweep" or "map".

        Raises
        ------
        BadInput, OutOfMemory, FileFailure, NumericalFailure
            With the library's message. Exceptions of a Python callable are raised unchanged.
        """
        return _followed(self._run(_Study(vary or {}, analyze, options), threads, progress, journal, resume))

    def follow(self, times: ArrayLike, events: Sequence[Event] = (), **options: str | float) -> Motion:
        """Follows one motion over time, from ``start`` at the first instant, through events that may change its state.

        Parameters
        ----------
        times : sequence of float
            Increasing instants, at which the state is kept.
        events : sequence of Event
            Events, whose instants are found to the last digits. If events of one kind come ever faster (a ball that
            comes to rest in infinitely many bounces), the motion ends as "accumulated".
        options
            ``method="dop853"``, ``rtol=1e-8``, ``atol``, ``limit``.

        Returns
        -------
        Motion

        Raises
        ------
        BadInput, OutOfMemory, NumericalFailure
            With the library's message. Exceptions of a Python callable are raised unchanged.
        """
        handle, functions, raised = self._build(_Study(options=options))
        times, pointer = _numbers(times, "times")
        events = [events] if isinstance(events, Event) else list(events)
        kept = [self._put_event(handle, event, number, raised) for number, event in enumerate(events)]
        out = ffi.new("whirl_user_motion **")
        try:
            check(lib.whirl_user_system_follow(handle, pointer, len(times), out))
        except errors.Error:
            if "value" in raised:
                raise raised["value"] from None
            raise
        del functions, kept  # they had to live until here
        motion, count = ffi.gc(out[0], lib.whirl_user_motion_free), ffi.new("size_t *")
        n = len(self.start)
        states = lib.whirl_user_motion_states(motion, count)
        found, which = [], ffi.new("size_t *")
        time, sides, words = ffi.new("double *"), ffi.new("const double *[2]"), ffi.new("const char **")
        for index in range(lib.whirl_user_motion_events(motion)):
            lib.whirl_user_motion_event(motion, index, which, time, sides, sides + 1)
            both = (self._copied(sides[side], n) for side in (0, 1))
            found.append(Happening(events[which[0]].name or f"event {which[0]}", time[0], *both))
        end = lib.whirl_user_motion_end(motion, time, words)
        return Motion(
            times[: count[0]].copy(),
            self._copied(states, n, count[0]).reshape(count[0], n),
            found,
            ("done", "event", "accumulated", "diverged", "stuck")[end],
            time[0],
            ffi.string(words[0]).decode(),
        )

    def _put_event(self, handle, event, number, raised):
        """Passes an event to the library; returns what must live as long as it is called."""
        if not isinstance(event, Event):
            raise errors.BadInput(f"event {number} is {event!r}, expected whirl.systems.Event(value, ...)")
        called = f"event '{event.name or f'event {number}'}'"
        for part, function in (("value", event.value), ("reset", event.reset)):
            if not callable(function) and not (part == "reset" and function is None):
                raise errors.BadInput(f"the {part} of {called} is {function!r}, expected a Python function of t, x, p")
        passing = _passing(event.passing, called)
        n, names, count_p = len(self.start), namedtuple("Parameters", self.parameters), len(self.parameters)

        def keep(kind, value, trace):
            raised.setdefault("value", value)

        @ffi.callback("double(double, const double *, const double *, void *)", onerror=keep, error=float("nan"))
        def value(t, x, p, _context):
            found = event.value(t, self._copied(x, n), names(*self._copied(p, count_p)))
            return float(_given(f"the value of {called}", "numbers", found, ()))

        @ffi.callback("int(double, const double *, const double *, double *, void *)", onerror=keep, error=1)
        def reset(t, x, p, after, _context):
            state = event.reset(t, self._copied(x, n), names(*self._copied(p, count_p)))
            self._state(after, n)[...] = _given(f"the reset of {called}", "a state", state, (n,))
            return 0

        check(
            lib.whirl_user_system_event(
                handle,
                word_bytes(event.name or f"event {number}"),
                value,
                passing,
                reset if event.reset is not None else ffi.NULL,
                int(bool(event.ends)),
                ffi.NULL,
            )
        )
        return value, reset

    def branch(
        self,
        parameter: str,
        from_: float,
        to: float,
        at: ArrayLike = (),
        *,
        rest: bool = False,
        curves: tuple[str, float, float] | None = None,
        threads: int | None = None,
        progress: bool | Callable[[str, float, float, float, float], object] | None = None,
        journal: str | os.PathLike | None = None,
        resume: bool = False,
        **options: str | float | bool,
    ) -> Result:
        """Follows periodic orbits, stable or not, over a parameter, and finds where and why they change: at folds,
        crossings, period doublings, Neimark-Sacker and Hopf points.

        Parameters
        ----------
        parameter : str
            The parameter that varies between the bounds ``from_`` and ``to``.
        at : sequence of float
            Values at which a motion settles and a branch begins in both directions; default: ``from_``.
        rest : bool
            Whether to follow equilibria, and the orbits that begin at Hopf points, of a system without an excitation.
            The first equilibrium is searched from ``start``.
        curves : (str, float, float), optional
            A second parameter with bounds around its value, over which the special points are followed.
        options
            Options of ``branch`` in a case: ``step=0.02``, ``longest=4``, ``switches=1``, ``rtol=1e-12``,
            ``tori=True``, ...; and ``transient``, ``record`` and ``method`` of the motions that settle.
        threads, progress, journal, resume
            As for :meth:`run`.

        Returns
        -------
        Result
            With the table "branch", a row for every point, and "curves" and "tori" if they are followed.

        Raises
        ------
        BadInput, OutOfMemory, FileFailure, NumericalFailure
            With the library's message. Exceptions of a Python callable are raised unchanged.
        """
        named = {_TRACE + name if name in _OF_BRANCHES else name: value for name, value in options.items()}
        if rest:
            named[_TRACE + "rest"] = True
        study = _Study(options=named, branch=(parameter, from_, to, at), curves=curves)
        try:
            return self._run(study, threads, progress, journal, resume)
        except errors.BadInput as refusal:  # suggest a name without the prefix
            for name in named:
                if str(refusal) == f"there is no option {name}" and _did_you_mean(name, _OF_BRANCHES):
                    raise errors.BadInput(f"{refusal}{_did_you_mean(name, _OF_BRANCHES)}") from None
            raise

    def _run(self, study, threads, progress, journal, resume):
        if threads is None:
            called = self._rates_at is None or (self.tangent is not None and self._tangent_at is None)
            threads = 1 if called else 0
        if self.speed is None and self.period is None:
            raise errors.BadInput("a study needs a period, or a parameter that is the speed: give one of both")
        handle, functions, raised = self._build(study)
        if journal is not None:
            check(lib.whirl_user_system_identity(handle, word_bytes(self._known())))
        try:
            return compute(
                lambda out: lib.whirl_job_of_user_system(handle, out),
                lambda out: lib.whirl_user_system_outline(handle, out),
                (self.rates, self.tangent, functions),
                threads=threads,
                progress=progress,
                journal=journal,
                resume=resume,
            )
        except errors.Error:
            if "value" in raised:
                raise raised["value"] from None
            raise

    def response(self, **more: Any) -> Result:
        """Computes one motion with the parameters of the system; see :meth:`run`."""
        return self.run(**more)

    def sweep(self, parameter: str, values: ArrayLike, **more: Any) -> Result:
        """Computes motions along a parameter; see :meth:`run`."""
        return self.run({parameter: values}, **more)

    def map(
        self,
        x: tuple[str, ArrayLike],
        y: tuple[str, ArrayLike],
        z: tuple[str, ArrayLike] | None = None,
        **more: Any,
    ) -> Result:
        """Computes motions over two or three parameters, each (name, values), with rows along x; see :meth:`run`."""
        axes = [x, y] + ([z] if z is not None else [])
        for axis in axes:
            if isinstance(axis, str) or not isinstance(axis, Sequence) or len(axis) != 2:
                raise errors.BadInput(
                    f"an axis of the map is {axis!r}, expected a parameter with its values: (name, values)"
                )
        if len({name for name, _ in axes}) < len(axes):
            raise errors.BadInput(f"a map over {' and '.join(name for name, _ in axes)}, expected different parameters")
        return self.run(dict(axes), **more)
