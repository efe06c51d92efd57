"""Measured numbers from files of instruments and other programs, as columns that fits take.

>>> columns = whirl.read_measured("orbits.mat", {"angle [deg]": "theta", "disc x [um]": "x", "disc y [um]": "y"})
>>> whirl.fit("fan.yaml", columns, ["k", "e"])
"""

from __future__ import annotations

import os
import struct
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Optional, Union

import h5py
import numpy as np

from .errors import BadInput

__all__ = ["read_measured"]

#: suffixes of HDF5 files, which the library reads itself
HDF5 = (".h5", ".hdf5", ".hdf")
_UNIVERSAL = (".uff", ".unv", ".uf", ".58", ".58b")
#: suffixes of files that fits read by :func:`read_measured`
SUFFIXES = HDF5 + _UNIVERSAL + (".mat",)


def read_measured(
    path: Union[str, os.PathLike], columns: Optional[Mapping[str, Union[str, int]]] = None
) -> dict[str, np.ndarray]:
    """Reads columns of measured numbers from HDF5, MATLAB's files and universal files (dataset 58, 58b).

    Parameters
    ----------
    path : path
        A file whose name ends in .h5, .hdf5, .mat, .uff or .unv. MATLAB's files before version 7.3 need SciPy.
    columns : dict, optional
        Headings as in a table of a fit, each with what it is called in the file: a dataset or variable
        (``"run/x"``), a part of one with an index that runs (``"run/signals[:, 2]"``), or the number of
        a record of a universal file, from 1. Without it all one-dimensional datasets or
        variables are columns under their own names, with the unit in their attribute ``unit``; records of a universal
        file are named by their point and direction, and their abscissa is ``time [s]``.

    Returns
    -------
    dict
        Arrays of one length by heading.

    Raises
    ------
    BadInput
        If the file cannot be read, or has no such column.
    """
    path = Path(path)
    suffix = path.suffix.lower()
    if suffix not in SUFFIXES:
        raise BadInput(f"{path} is no file of measured numbers, expected one of {', '.join(SUFFIXES)}")
    if not path.is_file():
        raise BadInput(f"there is no file {str(path)!r} of measured numbers")
    if suffix in _UNIVERSAL:
        found = _universal(path, columns)
    elif h5py.is_hdf5(path):
        found = _named(path, _hdf5(path), columns)
    elif suffix == ".mat":
        found = _named(path, _matlab(path), columns)
    else:
        raise BadInput(f"{path} is no HDF5 file")
    lengths = {len(column) for column in found.values()}
    if len(lengths) != 1:
        raise BadInput(f"{path} has columns of {sorted(lengths)} numbers, expected as many in all")
    return found


def _column(value: Any) -> Optional[np.ndarray]:
    """Returns the numbers of a vector, or of a matrix with one row or column; None for anything else."""
    array = np.asarray(value)
    if array.dtype.kind not in "fiu" or array.size < 2 or array.size != max(array.shape):
        return None
    return array.ravel().astype(float)


def _hdf5(path: Path) -> dict[str, tuple[np.ndarray, str]]:
    found = {}

    def take(name, item):
        numbers = _column(item[()]) if isinstance(item, h5py.Dataset) else None
        if numbers is not None:
            unit = item.attrs.get("unit", item.attrs.get("units", ""))
            found[name] = numbers, unit.decode() if isinstance(unit, bytes) else str(unit)

    try:
        with h5py.File(path, "r") as file:
            file.visititems(take)
    except (OSError, RuntimeError, ValueError) as error:
        raise BadInput(f"cannot read {path}: {error}") from None
    return found


def _part(path: Path, name: Any, found: dict[str, tuple[np.ndarray, str]]) -> Any:
    """Adds the numbers of "run/signals[:, 2]" to those found, under that name, and returns it."""
    dataset, bracket, indices = str(name).rpartition("[")
    if not bracket or not indices.endswith("]") or not h5py.is_hdf5(path):
        return name
    try:
        key = tuple(slice(None) if index.strip() == ":" else int(index) for index in indices[:-1].split(","))
        with h5py.File(path, "r") as file:
            numbers = _column(file[dataset][key]) if key.count(slice(None)) == 1 else None
    except (KeyError, ValueError, IndexError, TypeError, OSError) as error:
        raise BadInput(f"{path} has no vector {name!r}: {error}") from None
    if numbers is not None:
        found[name] = numbers, ""
    return name


def _matlab(path: Path) -> dict[str, tuple[np.ndarray, str]]:
    try:
        from scipy.io import loadmat
    except ImportError:
        raise BadInput(f"{path} is older than version 7.3 of MATLAB's files, which needs SciPy") from None
    try:
        variables = loadmat(path, squeeze_me=True)
    except Exception as error:  # of a damaged file it raises whatever it runs into
        raise BadInput(f"cannot read {path}: {error}") from None
    found = {name: _column(value) for name, value in variables.items() if not name.startswith("__")}
    return {name: (numbers, "") for name, numbers in found.items() if numbers is not None}


def _named(path: Path, found: dict[str, tuple[np.ndarray, str]], columns: Optional[Mapping]) -> dict[str, np.ndarray]:
    if columns is None:
        if not found:
            raise BadInput(f"{path} has no vector of numbers")
        return {f"{name} [{unit}]" if unit else name: numbers for name, (numbers, unit) in found.items()}
    columns = {heading: name if name in found else _part(path, name, found) for heading, name in columns.items()}
    for name in columns.values():
        if name not in found:
            raise BadInput(f"{path} has no vector {name!r}, expected one of {', '.join(sorted(found)) or 'none'}")
    return {heading: found[name][0] for heading, name in columns.items()}


# ---------------------------------------------------------------- universal files


def _universal(path: Path, columns: Optional[Mapping]) -> dict[str, np.ndarray]:
    records = _records(path)
    if not records:
        raise BadInput(f"{path} has no dataset 58")
    if columns is None:
        columns = {heading: number for number, (heading, _, _) in enumerate(records, 1)}
        if len(columns) < len(records):
            raise BadInput(f"{path} has several records of one point and direction, expected `columns` that choose")
    for number in columns.values():
        if not isinstance(number, int) or not 1 <= number <= len(records):
            raise BadInput(f"{path} has {len(records)} records, and no {number!r}")
    chosen = {heading: records[number - 1] for heading, number in columns.items()}
    time = next(iter(chosen.values()))[1]
    for _, other, _ in chosen.values():
        if len(other) != len(time) or not np.allclose(other, time, rtol=1e-9, atol=0.0):
            raise BadInput(f"{path} has records at other times, expected one time of all")
    return {"time [s]": time, **{heading: numbers for heading, (_, _, numbers) in chosen.items()}}


def _records(path: Path) -> list[tuple[str, np.ndarray, np.ndarray]]:
    """Heading, times and numbers of every dataset 58."""
    content, records, at = path.read_bytes(), [], 0

    def line() -> str:
        nonlocal at
        end = content.find(b"\n", at)
        text, at = content[at : end if end >= 0 else len(content)], end + 1 if end >= 0 else len(content)
        return text.decode("latin-1").rstrip("\r")

    while at < len(content):
        if line().strip() != "-1" or at >= len(content):
            continue
        kind = line()
        if kind[:7].strip().lower() not in ("58", "58b"):
            while at < len(content) and line().strip() != "-1":
                pass
            continue
        header = [line() for _ in range(11)]
        try:
            times, count, size, uneven = _axis(header)
            if kind[:7].strip().lower() == "58b":
                order, length = "<" if int(kind[7:13]) == 1 else ">", int(kind[31:43])
                numbers = np.frombuffer(content[at : at + length], f"{order}f{size}").astype(float)
                at += length
                if content[at : at + 1] in (b"\r", b"\n"):
                    line()
            else:
                numbers = _ascii(line, count, size, uneven)
            if uneven:
                times, numbers = numbers[0 : 2 * count : 2], numbers[1 : 2 * count : 2]
            if len(numbers) < count:
                raise ValueError(f"has {len(numbers)} of {count} numbers")
            line()  # the end of the dataset
            records.append((_heading(header), times, numbers[:count]))
        except (ValueError, IndexError) as error:
            raise BadInput(f"{path}: dataset 58 number {len(records) + 1} is damaged: {error}") from None
    return records


def _axis(header: list[str]) -> tuple[np.ndarray, int, int, bool]:
    """Times (of even spacing), count of numbers, bytes of one, and whether the spacing is uneven."""
    form = header[6]
    kind, count, even = int(form[:10]), int(form[10:20]), int(form[20:30])
    if kind not in (2, 4):
        raise ValueError("is not of real numbers")
    if int(header[7][:10]) != 17:
        raise ValueError("is not over time")
    start, step = float(form[30:43]), float(form[43:56])
    return start + step * np.arange(count), count, 4 if kind == 2 else 8, even == 0


def _ascii(line, count: int, size: int, uneven: bool) -> np.ndarray:
    widths = (13, 20) if uneven and size == 8 else (13,) if size == 4 else (20,)
    wanted, numbers = count * (2 if uneven else 1), []
    while len(numbers) < wanted:
        text, place = line(), 0
        if text.strip() == "-1" or not text:
            break
        while text[place:].strip() and len(numbers) < wanted:
            width = widths[len(numbers) % len(widths)]
            numbers.append(float(text[place : place + width]))
            place += width
    return np.array(numbers)


def _heading(header: list[str]) -> str:
    """The point and direction of a record, with its unit: "disc x [um]"."""
    form = header[5]
    name, node, direction = form[31:41].strip(), form[41:51].strip(), int(form[51:55] or 0)
    axis = {1: "x", 2: "y", 3: "z"}.get(abs(direction), str(direction))
    unit = header[8][47:67].strip()
    unit = {"NONE": "", "MM": "mm", "UM": "um", "M": "m"}.get(unit, unit)
    point = name if name and name.upper() != "NONE" else node
    return f"{point} {axis}" + (f" [{unit}]" if unit else "")
