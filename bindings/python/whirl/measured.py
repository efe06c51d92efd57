"""Measured numbers from files of instruments and other programs, as columns that fits take.

>>> columns = whirl.read_measured("orbits.mat", {"angle [deg]": "theta", "disc x [um]": "x", "disc y [um]": "y"})
>>> whirl.fit("fan.yaml", columns, ["k", "e"])
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Optional, Union

import numpy as np

from ._library import check, ensure_allowed, ffi, lib, path_bytes, require_file, text, word_bytes
from .errors import BadInput

__all__ = ["read_measured"]


def read_measured(
    path: Union[str, os.PathLike], columns: Optional[Mapping[str, Union[str, int]]] = None
) -> dict[str, np.ndarray]:
    """Reads columns of measured numbers from CSV, HDF5, MATLAB's files and universal files (dataset 58, 58b).

    Parameters
    ----------
    path : path
        A table of comma-separated values, or an HDF5, MAT (version 4 to 7.3) or universal file.
    columns : dict, optional
        Headings as in a table of a fit, each with what it is called in the file: a dataset or variable
        (``"run/x"``), a part of one with an index that runs (``"run/signals[:, 2]"``), a record of a universal file
        by its point and direction (``"disc x"``) or by its number, from 1, and parts of one (``"disc x/real"``,
        ``"record 2/time"``), or a heading of a table of comma-separated values (``"CH1"``, ``"column 3"``). With a
        number the abscissa is a column, too. Without `columns` all vectors are columns under their own names and units.

    Returns
    -------
    dict
        Arrays of one length by heading.

    Raises
    ------
    BadInput
        If the file cannot be read, or has no such column.
    """
    ensure_allowed()
    require_file(path, "the file of measured numbers")
    chosen = dict(columns or {})
    numbers = [name for name in chosen.values() if isinstance(name, int)]
    chosen = {heading: f"record {name}" if isinstance(name, int) else name for heading, name in chosen.items()}
    return {**_abscissa(path, numbers), **_read(path, chosen)}


def _read(path: Union[str, os.PathLike], chosen: Mapping[str, str]) -> dict[str, np.ndarray]:
    out = ffi.new("whirl_columns **")
    headings = [ffi.new("char[]", word_bytes(heading)) for heading in chosen]
    names = [ffi.new("char[]", word_bytes(name)) for name in chosen.values()]
    check(lib.whirl_columns_read(path_bytes(path), headings, names, len(names), out))
    found = ffi.gc(out[0], lib.whirl_columns_free)
    rows, result = lib.whirl_columns_rows(found), {}
    for index in range(lib.whirl_columns_count(found)):
        name, unit = (text(of(found, index)) for of in (lib.whirl_columns_name, lib.whirl_columns_unit))
        own = ffi.buffer(lib.whirl_columns_numbers(found, index), 8 * rows)
        result[f"{name} [{unit}]" if unit else name] = np.frombuffer(own, float).copy()
    return result


def _abscissa(path: Union[str, os.PathLike], numbers: list[int]) -> dict[str, np.ndarray]:
    """Returns the abscissa of these records of a universal file, which must have the same one."""
    found: dict[str, np.ndarray] = {}
    for number in numbers:
        own: dict[str, np.ndarray] = {}
        for axis in ("time", "frequency", "speed", "order", "abscissa"):
            try:
                own = _read(path, {axis: f"record {number}/{axis}"})
                break
            except BadInput:  # the record has another abscissa, or is missing, which its own column will say
                continue
        found = found or own
        for heading, values in found.items():
            if len(own.get(heading, ())) != len(values) or not np.allclose(own[heading], values, 1e-9, 0.0):
                raise BadInput(f"{path} has records over different abscissas, expected one of all")
    return found
