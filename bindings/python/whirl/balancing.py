"""Balancing: finds weights that remove a rotor's vibration, and makes readings from simulations.

>>> found = whirl.balance("fan-3.yaml")             # or a dict with the content of such a file
>>> found.correction["drive"].moment, found.correction["drive"].angle
>>> rows = whirl.readings(result, {"de": "left", "nde": ("right", numpy.radians(45))}, run=1)

libwhirl computes (``whirl_balance_json`` of ``whirl/handles.h``). All is in SI and radians; angles and phases have the
sense that the file chooses.
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NamedTuple, Optional

import numpy as np

from ._library import ffi, lib, path_bytes, text, word_bytes
from .case import _PROBLEMS, _accept, _document
from .errors import BadInput
from .fields import FIELD
from .findings import Sheet, Statements, sheets_in, statements_in

if TYPE_CHECKING:
    from .result import Result
    from .table import Table

__all__ = ["Vector", "Weight", "Row", "Set", "Proposal", "Without", "Balance", "balance", "readings"]

_WANTED = "expected the analysis spectrum or the study unbalance"


class Vector(NamedTuple):
    """A size with an angle, or an amplitude with its phase."""

    size: float  #: kg m, m, or m/(kg m)
    angle: float  #: rad, 0 to 2 pi, in the file's sense of angles or phases

    @property
    def number(self) -> complex:
        """size exp(i angle)."""
        return self.size * np.exp(1j * self.angle)


@dataclass(frozen=True)
class Weight:
    """The weight of a plane."""

    moment: float  #: kg m
    angle: float  #: rad on the rotor, in the file's sense of angles
    mass: Optional[float]  #: kg at the radius of the plane; None if the file gives no radius
    holes: dict[int, float]  #: kg m in each of the two holes next to the angle; empty if the plane has no holes

    @property
    def number(self) -> complex:
        """moment exp(i angle)."""
        return self.moment * np.exp(1j * self.angle)


@dataclass(frozen=True)
class Row:
    """A probe at a speed."""

    probe: str  #: its name
    speed: float  #: rad/s
    before: Vector  #: vibration without weights
    after: Optional[Vector]  #: vibration with the correction, by the coefficients; None without a correction
    worst: Optional[
        float
    ]  #: amplitude after if the model's critical speeds are wrong; None unless ``influence: model``
    influence: dict[
        str, Vector
    ]  #: vibration for one kg m in each plane; empty without a correction, or if sets were tried
    influence_of_sets: list[Optional[Vector]]  #: vibration for one kg m of each set; None for sets that were not tried
    model: dict[str, Vector]  #: vibration for one kg m in each plane, by the model; empty without a model


@dataclass(frozen=True)
class Set:
    """Weights that act on one mode and on no other mode."""

    speed: float  #: rad/s, near which it is balanced
    natural: Optional[float]  #: rad/s of the model's mode there
    weights: dict[str, Vector]  #: relative weights in the planes; the largest is 1
    amount: Optional[Vector]  #: kg m of the set in the correction; None if it has no part of it


@dataclass(frozen=True)
class Proposal:
    """A trial weight, or set of them, that the model proposes."""

    plane: Optional[str]  #: the plane of a weight
    set: Optional[int]  #: the number of a set, from 1
    moment: float  #: kg m
    angle: float  #: rad
    weights: dict[str, Vector]  #: kg m in the planes
    reason: str  #: reason for its size: "force", "least", "most", "limit", "nothing"
    sentence: str  #: the reason in words
    change: Optional[float]  #: largest relative change of a vibration


@dataclass(frozen=True)
class Without:
    """The correction without a plane or set that acts nearly as the others do."""

    name: str  #: name of the plane, or "set 2"
    correction: dict[str, Vector]  #: kg m in the planes
    left: float  #: m, as ``left`` of :class:`Balance`


@dataclass(frozen=True)
class Balance:
    """What balancing found."""

    title: str  #: title of the file
    angles: str  #: "with" or "against" the rotation
    phases: str  #: "lag" or "lead"
    correction: dict[str, Weight]  #: weights by planes; empty without trial runs
    rows: list[Row]  #: probes at speeds
    sets: list[Set]  #: of modes
    proposals: list[Proposal]  #: trial weights, if there is a model and no trial run
    unbalance: Optional[float]  #: kg m in all planes together, as the rotor was
    grade: Optional[float]  #: mm/s, balance quality grade G of that unbalance (ISO 21940-11)
    allowed: Optional[float]  #: kg m, the residual unbalance that the file's grade allows
    static: Optional[Vector]  #: kg m, for two planes: the sum of both weights
    couple: Optional[
        Vector
    ]  #: kg m, for two planes: half of their difference, in the first plane; its opposite in the second
    least: Optional[str]  #: the criterion that the weights minimise: "squares", or "max", the largest vibration
    left: Optional[float]  #: m, root of the weighted mean square of the predicted vibrations, or the largest one
    condition: Optional[float]  #: condition number of the influence matrix: largest over smallest singular value
    significance: dict[
        str, Optional[float]
    ]  #: significance of planes or sets: the share of the effect that the others cannot replace (Darlow)
    without: Optional[Without]  #: the correction without the least significant plane; None if all are needed
    difference: Optional[float]  #: difference of the model's coefficients from those of runs, over the largest
    warnings: list[str]  #: warnings about the results
    statements: Statements = field(repr=False)  #: findings as sentences, in the units of the file
    sheets: dict[str, Sheet] = field(repr=False)  #: tables: correction, vibration, influence, ... in these units
    document: dict = field(repr=False)  #: the whole result as ``whirl balance --json`` prints it


def _vector(of, size):
    return None if of is None else Vector(of[size], of["angle"])


def _vectors(of, size):
    return {name: _vector(one, size) for name, one in (of or {}).items()}


def _row(of) -> Row:
    return Row(
        of["probe"],
        of["speed"],
        _vector(of["before"], "amplitude"),
        _vector(of.get("after"), "amplitude"),
        of.get("worst"),
        _vectors(of.get("influence"), "amplitude"),
        [_vector(one, "amplitude") for one in of.get("influence_of_sets", [])],
        _vectors(of.get("model"), "amplitude"),
    )


def _weight(of) -> Weight:
    return Weight(of["moment"], of["angle"], of.get("mass"), {one["hole"]: one["moment"] for one in of["holes"]})


def _proposal(of) -> Proposal:
    weights = _vectors(of["weights"], "moment")
    words = (of[key] for key in ("moment", "angle"))
    return Proposal(of.get("plane"), of.get("set"), *words, weights, of["reason"], of["sentence"], of["change"])


def _without(of) -> Optional[Without]:
    return None if of is None else Without(of["name"], _vectors(of["correction"], "moment"), of["left"])


def _made(of) -> Balance:
    return Balance(
        title=of["title"],
        angles=of["angles"],
        phases=of["phases"],
        correction={name: _weight(one) for name, one in of.get("correction", {}).items()},
        rows=[_row(one) for one in of["vibration"]],
        sets=[
            Set(
                one["speed"],
                one.get("natural"),
                _vectors(one["weights"], "weight"),
                _vector(one.get("amount"), "moment"),
            )
            for one in of["sets"]
        ],
        proposals=[_proposal(one) for one in of["proposals"]],
        unbalance=of.get("unbalance"),
        grade=of.get("grade"),
        allowed=of["allowed"],
        static=_vector(of.get("static"), "moment"),
        couple=_vector(of.get("couple"), "moment"),
        least=of.get("least"),
        left=of.get("left"),
        condition=of.get("condition"),
        significance=of.get("significance", {}),
        without=_without(of.get("without")),
        difference=of["difference"],
        warnings=of["warnings"],
        statements=statements_in(of),
        sheets=sheets_in(of),
        document=of,
    )


def balance(source: str | os.PathLike | Mapping, *, name: str | None = None, units: str | None = None) -> Balance:
    """Finds the weights that balance a rotor, or proposes trial weights.

    Parameters
    ----------
    source : str, path or dict
        Name of a file as ``whirl balance`` reads it (guide, chapter 14), or a dict with its content. Numbers of a dict
        are in SI and radians, texts may have units. Keys that are None count as absent.
    name : str, optional
        Name of the file in messages; a ``model`` is looked for in its folder.
    units : str, optional
        Units of statements, sheets and warnings: "US", or words such as "um, g"; default: the units of the file.
        Numbers of the other fields are in SI.

    Raises
    ------
    BadInput
        With the place, what was found and what is expected; ``problems`` lists all that is wrong.
    """
    if isinstance(source, Mapping) and isinstance(source.get("model"), os.PathLike):
        source = {**source, "model": os.fspath(source["model"])}
    data, name = _document(source, "balance", name)
    problems, out = ffi.new("char[]", _PROBLEMS), ffi.new("char **")
    shown = ffi.NULL if units is None else word_bytes(units)
    status = lib.whirl_balance_json(data, len(data), path_bytes(name), shown, problems, _PROBLEMS, out)
    _accept(status, problems)
    try:
        return _made(json.loads(text(out[0])))
    finally:
        lib.whirl_text_free(out[0])


# ---------------------------------------------------------------- readings


def _parts(table):
    """Returns complex vectors once a revolution along x and y, A exp(-i lag) in m: [points][stations][2]."""
    for size, lag in (
        (FIELD.SPECTRUM_SYNCHRONOUS, FIELD.SPECTRUM_SYNCHRONOUS_LAG),
        (FIELD.UNBALANCE_AMPLITUDE, FIELD.UNBALANCE_LAG),
    ):
        if size in table:
            amplitude, lags = table.si(size)[0], np.nan_to_num(table[lag])
            vectors = amplitude * np.exp(-1j * np.radians(lags))
            return vectors.reshape(-1, *vectors.shape[-2:])[..., :2]
    raise BadInput(f"the table '{table.name}' has no motion once a revolution, {_WANTED}")


def readings(
    source: "Result | Table",
    probes: "Mapping | None" = None,
    run: int = 1,
    *,
    phases: str = "lag",
    keyphasor: float = 0.0,
    points: "list[int] | None" = None,
) -> list[dict]:
    """Returns what probes would read once a revolution in a simulated run: rows of ``vibration`` for :func:`balance`.

    Readings are the part once a revolution of motions in time (analysis ``spectrum``), also of nonlinear machines, or
    the synchronous response of the study ``unbalance``. If shafts have a ``runout``, readings of motions in time
    contain it; readings of ``unbalance`` do not (the field ``unbalance/seen`` does).

    Parameters
    ----------
    source : Result or Table
        A table, or a result, of which the first table with such motions is taken.
    probes : dict, optional
        For each name of a probe its station, or a pair of station and angle in rad from the x axis towards y. Default:
        a probe along x at every station.
    run : int
        Number of the run.
    phases : str
        "lag" or "lead", as in the file.
    keyphasor : float
        Angle of the keyphasor in rad from the x axis towards y.
    points : list of int, optional
        Points of the table by index; default: all of them.
    """
    table = source
    if not isinstance(getattr(source, "fields", None), dict):
        wanted = (FIELD.SPECTRUM_SYNCHRONOUS, FIELD.UNBALANCE_AMPLITUDE)
        tables = [one for one in source.values() if any(name in one for name in wanted)]
        if not tables:
            raise BadInput(f"no table of the result has motions once a revolution, {_WANTED}")
        table = tables[0]
    if phases not in ("lag", "lead"):
        raise BadInput(f"phases are {phases!r}, expected lag or lead")
    stations, vectors = table._about.stations, _parts(table)
    speeds = (table[FIELD.UNBALANCE_SPEED] if FIELD.UNBALANCE_SPEED in table else table.clock).ravel()
    probes = {one.name: one.name for one in stations} if probes is None else probes
    rows = []
    for point in range(len(vectors)) if points is None else points:
        for name, place in probes.items():
            station, angle = place if isinstance(place, tuple) else (place, 0.0)
            which = table.station(station)
            way = -1.0 if stations[which].clockwise else 1.0
            x, y = vectors[point, which]
            seen = (np.cos(angle) * x + np.sin(angle) * y) * np.exp(1j * way * keyphasor)
            if not np.isfinite(seen):
                raise BadInput(f"station '{station}' has no vibration at point {point}: the motion left its bounds")
            phase = float(np.angle(seen)) * (1.0 if phases == "lead" else -1.0)
            rows.append({"run": run, "speed": float(speeds[point]), "probe": name, "amplitude": float(abs(seen)),
                         "phase": phase})  # fmt: skip
    return rows
