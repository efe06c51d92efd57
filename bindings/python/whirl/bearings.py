"""Journal bearings without a rotor, over load and speed.

>>> found = whirl.bearing("bearing.yaml")           # or a dict with the content of such a file
>>> found.speed, found.eccentricity_ratio, found.stiffness[:, 0, 1]
>>> found.plot("sommerfeld")

libwhirl computes (``whirl_bearing_json`` of ``whirl/handles.h``). All is in SI and radians.
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from ._library import ffi, lib, path_bytes, text, word_bytes
from .case import _PROBLEMS, _accept, _document
from .errors import BadInput
from .findings import Sheet, Statements, sheets_in, statements_in

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["Bearing", "bearing"]


@dataclass(frozen=True)
class Bearing:
    """Results of a bearing: arrays over the points, NaN for points without a solution."""

    title: str  #: description in one line
    kind: str  #: "two-groove", ...; "pads" for user-defined pads
    tilting: bool  #: True if pads tilt
    clearance: float  #: m, radial clearance of the bearing
    pad_clearance: float  #: m, radial clearance of the pads
    viscosity: float  #: Pa s, at the temperature of the oil or of its supply
    whirl_ratios: np.ndarray  #: whirl ratios of the reduced coefficients
    speed: np.ndarray  #: rad/s
    load: np.ndarray  #: N
    found: np.ndarray  #: bool
    sommerfeld: np.ndarray  #: mu N D L (R/c)^2/W, c of the pads
    place: np.ndarray  #: m, [points][2]
    eccentricity_ratio: np.ndarray  #: eccentricity over the clearance of the pads
    attitude: np.ndarray  #: rad from the load to the journal, with the rotation
    film: np.ndarray  #: m, least film thickness
    pressure: np.ndarray  #: Pa, highest pressure
    flow: np.ndarray  #: m3/s, flow out of both ends
    power: np.ndarray  #: W
    film_viscosity: np.ndarray  #: Pa s
    temperature: np.ndarray  #: K, temperature of the film; NaN if only its viscosity is known
    outlet: np.ndarray  #: K, temperature of the leaving oil, if it follows from the heat
    stiffness: np.ndarray  #: N/m, [points][2][2], at the first whirl ratio
    damping: np.ndarray  #: N s/m, [points][2][2], at the first whirl ratio
    critical_mass: np.ndarray  #: kg, of a rigid rotor; NaN for tilting pads, and if any mass is stable
    error: np.ndarray  #: [points][3] differences from a mesh half as fine: m, and shares of stiffness and damping
    warnings: list[str]  #: warnings about the bearing and its points, in the units of the statements
    statements: Statements = field(repr=False)  #: findings as sentences, in the units of the file
    sheets: dict[str, Sheet] = field(repr=False)  #: tables: pads, rest, coefficients, in these units
    document: dict = field(repr=False)  #: the whole result as ``whirl bearing --json`` prints it
    figures: dict = field(repr=False)  #: documents of docs/figures.md by the names curves, sommerfeld, locus

    def reduced(self, number: int = 0) -> tuple[np.ndarray, np.ndarray]:
        """Returns stiffness and damping, [points][2][2], at a whirl ratio by its index in ``whirl_ratios``."""
        if not self.tilting:
            return self.stiffness, self.damping
        rows = [p["reduced"][number] if p["found"] else None for p in self.document["points"]]
        nothing = np.full((2, 2), np.nan)
        return tuple(np.array([nothing if r is None else r[key] for r in rows]) for key in ("stiffness", "damping"))

    def plot(self, name: str = "curves") -> "Figure":
        """Draws a figure with Matplotlib: ``curves``, ``sommerfeld`` or ``locus``."""
        from .figure import draw

        if name not in self.figures:
            raise BadInput(f"there is no figure '{name}' of a bearing, expected curves, sommerfeld or locus")
        return draw(self.figures[name])


def _array(points, *keys):
    def value(point):
        for key in keys:
            point = point[key]
        return point

    return np.array([value(point) for point in points], dtype=float)


def _warnings(of: Statements) -> list[str]:
    """Returns warnings with their points, in the units of the findings."""
    return [f"at {own.at}: {own.found}" if own.at else own.found for own in of if own.what == "warning"]


def _made(of: dict[str, Any], figures: list) -> Bearing:
    points, statements = of["points"], statements_in(of)
    arrays = ("speed", "load", "sommerfeld", "place", "eccentricity_ratio", "attitude", "film", "pressure", "flow")
    arrays += ("power", "temperature", "outlet", "stiffness", "damping", "critical_mass")
    return Bearing(
        **{key: of[key] for key in ("title", "kind", "tilting", "clearance", "pad_clearance", "viscosity")},
        whirl_ratios=np.array(of["whirl_ratios"]),
        found=np.array([point["found"] for point in points]),
        **{key: _array(points, key) for key in arrays},
        film_viscosity=_array(points, "viscosity"),
        error=np.stack([_array(points, "error", key) for key in ("place", "stiffness", "damping")], axis=-1),
        warnings=_warnings(statements),
        statements=statements,
        sheets=sheets_in(of),
        document=of,
        figures={figure["name"].removeprefix("bearing-"): figure for figure in figures},
    )


def bearing(
    source: str | os.PathLike | Mapping, *, name: str | None = None, units: str | None = None, threads: int = 0
) -> Bearing:
    """Computes a journal bearing over load and speed.

    Parameters
    ----------
    source : str, path or dict
        Name of a file as ``whirl bearing`` reads it (guide, chapter 15), or a dict with its content. Numbers of a dict
        are in SI and radians, texts may have units. Keys that are None count as absent.
    name : str, optional
        Name of the file in messages.
    units : str, optional
        Units of statements, sheets, warnings and figures: "US", or words such as "um, N"; default: the units of the
        file. Arrays are in SI.
    threads : int
        Number of threads; 0: one for every core.

    Raises
    ------
    BadInput
        With the place, what was found and what is expected; ``problems`` lists all that is wrong.
    """
    if isinstance(source, Mapping):
        source = {key: _plain(value) for key, value in source.items()}
    data, name = _document(source, "bearing", name)
    problems, out, drawn = ffi.new("char[]", _PROBLEMS), ffi.new("char **"), ffi.new("char **")
    shown = ffi.NULL if units is None else word_bytes(units)
    status = lib.whirl_bearing_json(
        data, len(data), path_bytes(name), shown, int(threads), problems, _PROBLEMS, out, drawn
    )
    _accept(status, problems)
    try:
        return _made(json.loads(text(out[0])), json.loads(text(drawn[0])))
    finally:
        lib.whirl_text_free(out[0])
        lib.whirl_text_free(drawn[0])


def _plain(value):
    """Converts arrays to lists."""
    return value.tolist() if isinstance(value, (np.ndarray, np.generic)) else value
