"""Fits: parameters of a machine from measured orbits and Bode plots (the study ``fit``).

>>> found = whirl.fit("fan.yaml", "bode.csv", {"k": (0.6e6, 2e6), "e": (0, 100e-6)}, noise="2 um")
>>> found["k"].value, found["k"].low, found["k"].high

libwhirl computes; numbers are those of ``whirl run`` with ``study: {fit: ...}``, bit for bit.
"""

from __future__ import annotations

import os
import re
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .case import Case, _block
from .errors import BadInput
from .fields import FIELD
from .running import run

if TYPE_CHECKING:
    import pandas

    from .result import Result

__all__ = ["Estimate", "Fit", "fit"]

_KNOWN = ("determined", "at a bound", "weak", "unknown")
_ENDS = ("found", "steps", "stuck", "no motion")
_NUMBERS = ("onset", "critical", "frequency", "damping")  # entries of the data that are numbers, not tables


@dataclass(frozen=True)
class Estimate:
    """A fitted parameter, in SI."""

    name: str  #: name of the parameter
    start: float  #: value at which the search began
    value: float  #: value found
    error: float  #: standard error; NaN if the parameter is not determined
    low: float  #: lower end of the 95 % interval; NaN if the parameter is not determined
    high: float  #: its upper end
    known: str  #: "determined", "at a bound", "weak" (the interval is as wide as the bounds or the value), "unknown"
    profile_low: float = float("nan")  #: lower end of the 95 % profile interval; NaN beyond its bounds or not asked for
    profile_high: float = float("nan")  #: its upper end


class Fit(Mapping):
    """Result of a fit: a mapping from names of parameters to :class:`Estimate`, from the start with the least sum of
    squares."""

    def __init__(self, result: Result) -> None:
        self.result = result  #: the whole :class:`Result`
        table = next(table for table in result.tables.values() if FIELD.FIT_UNKNOWN in table)
        outcomes = table[FIELD.FIT_OUTCOME].reshape(-1, 8)
        sums = np.where(np.isnan(outcomes[:, 3]), np.inf, outcomes[:, 3])
        best = int(np.argmin(sums))
        outcome = outcomes[best]
        names = list(result.parameters)
        self.end = _ENDS[int(outcome[0])]  #: "found", "steps" (too few), "stuck", "no motion" (at the start)
        self.steps = int(outcome[2])  #: evaluations of all motions
        self.sum = float(outcome[3])  #: sum of squares of residuals over noise (m2 without noise)
        self.deviation = float(outcome[4])  #: standard deviation of residuals over noise (m without noise)
        self.starts = outcomes  #: one row a start, columns of the field ``fit/outcome``
        self._estimates = {}
        unknowns = table[FIELD.FIT_UNKNOWN].reshape(len(outcomes), -1, 8)
        ends = np.full((len(unknowns[best]), 2), np.nan)
        if FIELD.FIT_PROFILE in table:
            ends = table[FIELD.FIT_PROFILE].reshape(len(outcomes), -1, 2)[best]
        for (index, start, value, error, half, _low, _high, known), profile in zip(unknowns[best], ends):
            label = _KNOWN[int(known)] if np.isfinite(known) else "unknown"
            name = names[int(index)]
            self._estimates[name] = Estimate(name, start, value, error, value - half, value + half, label, *profile)
        count = len(self._estimates)
        #: [parameters, parameters] coefficients of correlation of the errors
        self.correlations = table[FIELD.FIT_CORRELATION].reshape(len(outcomes), count, -1)[best][:, :count]
        #: one row a measured number, columns of the field ``fit/number``
        self.numbers = table[FIELD.FIT_NUMBER].reshape(len(outcomes), -1, 9)[best]

    def __getitem__(self, name: str) -> Estimate:
        return self._estimates[name]

    def __iter__(self):
        return iter(self._estimates)

    def __len__(self) -> int:
        return len(self._estimates)

    def frame(self) -> pandas.DataFrame:
        """Returns the estimates as a pandas DataFrame, one row for each parameter."""
        import pandas

        return pandas.DataFrame([vars(own) for own in self._estimates.values()]).set_index("name")

    def __repr__(self) -> str:
        lines = [f"<whirl.Fit {self.end} after {self.steps} steps>"]
        for own in self._estimates.values():
            lines.append(f"  {own.name}: {own.value:.6g}, 95 % {own.low:.6g} to {own.high:.6g} ({own.known})")
        return "\n".join(lines)


def _table_of(data: Any, folder: str, number: int) -> str:
    """Returns the path of a table: a given file, or a file that is written from a DataFrame or a dict of columns."""
    if isinstance(data, (str, os.PathLike)):
        path = Path(data)
        if not path.is_file():
            raise BadInput(f"there is no table {str(data)!r} of measured numbers")
        return str(path.resolve())
    columns = {str(name): np.asarray(data[name], float) for name in data}
    lengths = {len(column) for column in columns.values()}
    if len(lengths) != 1:
        raise BadInput(f"the columns of measured numbers have {sorted(lengths)} rows, expected as many in all")
    path = Path(folder) / f"measured-{number}.csv"
    rows = np.column_stack(list(columns.values()))
    np.savetxt(path, rows, "%.17g", ",", header=",".join(columns), comments="")
    return str(path)


def _length(value: str | float) -> str:
    return value if isinstance(value, str) else f"{float(value)!r} m"


def _where(bounds: Any) -> dict[str, Any]:
    """Returns ``{start, from, to}`` of an unknown that is given as None, (from, to), (start, from, to), or a dict."""
    if bounds is None:
        return {}
    if isinstance(bounds, Mapping):
        return dict(bounds)
    if isinstance(bounds, Sequence) and not isinstance(bounds, str) and len(bounds) in (2, 3):
        return dict(zip(("start", "from", "to")[3 - len(bounds) :], bounds))
    raise BadInput(f"an unknown is looked for in {bounds!r}, expected (from, to), (start, from, to) or a dict")


def fit(
    case: Case | str | os.PathLike | dict,
    data: Any,
    unknown: Mapping[str, Any] | Sequence[str],
    *,
    at: Mapping[str, Any] | Sequence[Mapping[str, Any]] | None = None,
    noise: str | float | Mapping[str, str | float] | None = None,
    compare: str = "orbit",
    runup: Mapping[str, Any] | None = None,
    delay: str | float | None = None,
    threads: int = 0,
    **options: Any,
) -> Fit:
    """Fits parameters of a machine to measured motions.

    Parameters
    ----------
    case : Case, file or dict
        The machine; its study is replaced.
    data : file, DataFrame, dict of columns, or a list of them
        Measured numbers. {"onset": "5200 rpm", "noise": "50 rpm"} and the like are onsets of instability, critical
        speeds, frequencies and damping ratios of modes, with the keys of a case. All others are tables, whose headings
        say what a column is: "angle [deg]" or "time [s]" with "disc x [um]" for an orbit, "speed [rpm]" with
        "disc x [um]" and "disc x lag [deg]" for orders (guide, chapter 18). Files are comma-separated values, HDF5, MAT
        (version 4 to 7.3) or universal files (dataset 58, 58b). {"file": "run.h5", "columns": {"time [s]": "t", "disc x
        [um]": "signals[:, 0]"}} chooses columns, {"file": "records.h5", "record": 17} a record of a data set.
    at : dict, or a list of one for each table, optional
        Values that parameters had in the measurement.
    noise : text, float or dict, optional
        Standard deviation of the numbers of tables: "2 um", or a number in m; or one for each probe, {"disc x": "2 um",
        "disc y": "3 um"}.
    compare : str
        "orbit" or, for tables of motions that need not be periodic, "statistics": columns "disc x max [um]",
        "disc x min [um]", "disc x 0.4X [um]" and "contact [%]"; or, with `runup`, "waveform": displacements over
        "time [s]".
    runup : dict, optional
        Keys of a run at a changing speed, {"speed_from": "600 rpm", "speed_to": "3000 rpm", "rate": "400 rpm/s"}, in
        which the tables were measured: orders over "speed [rpm]" or "time [s]". The machine is run in the same way.
        Values may be expressions of parameters.
    delay : text or float, optional
        Time of the tables at which that run begins: "0.2 s", a number in s, or an expression of parameters, "= begins".
        Default: 0.
    threads : int
        Number of threads; 0: all cores.
    **options
        Other keys of ``study: {fit: ...}``: starts, revolutions, transient, loss, huber, steps, tolerance, rtol,
        method, profile, record, difference.

    Raises
    ------
    BadInput
        If a table, a name or a unit is wrong, with its place.
    """
    case = case if isinstance(case, Case) else Case(case)
    tables = list(data) if isinstance(data, (list, tuple)) else [data]
    places = list(at) if isinstance(at, (list, tuple)) else [at] * len(tables)
    if len(places) != len(tables):
        raise BadInput(f"`at` has {len(places)} places for {len(tables)} tables, expected one for each")
    names = unknown if isinstance(unknown, Mapping) else dict.fromkeys(unknown)
    # Remove the study of the case.
    machine = re.sub(r"(?m)^study:.*\n(?:(?:[ \t#].*)?\n|[ \t#].*\Z)*", "", case.text.rstrip("\n") + "\n")
    with tempfile.TemporaryDirectory(prefix="whirl-fit-") as folder:
        items = []
        for number, (table, place) in enumerate(zip(tables, places), 1):
            number_alone = isinstance(table, Mapping) and any(key in table for key in _NUMBERS)
            named = isinstance(table, Mapping) and "file" in table
            item = dict(table) if number_alone or named else {"file": _table_of(table, folder, number)}
            if named:
                item["file"] = _table_of(item["file"], folder, number)
            if place and "at" not in item:
                item["at"] = dict(place)
            if noise is not None and not number_alone and "noise" not in item:
                item["noise"] = (
                    {k: v if k == "contact" else _length(v) for k, v in noise.items()}
                    if isinstance(noise, Mapping)
                    else _length(noise)
                )
            if compare != "orbit" and not number_alone and "compare" not in item:
                item["compare"] = compare
            if runup is not None and not number_alone and "runup" not in item:
                item["runup"] = dict(runup)
            if delay is not None and not number_alone and "delay" not in item:
                item["delay"] = delay if isinstance(delay, str) else f"{delay!r} s"
            items.append(item)
        study = {"unknown": {name: _where(bounds) for name, bounds in names.items()}, "data": items, **options}
        text = machine + _block({"study": {"fit": study}}) + "\n"
        return Fit(run(Case(text=text, name=case.name), threads=threads))
