"""Findings: statements and sheets of the library."""

from __future__ import annotations

import html
import json
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Union

import numpy as np

from ._library import check, ffi, lib, taken, word_bytes

if TYPE_CHECKING:
    import pandas

__all__ = ["Column", "Sheet", "Statement", "Statements"]

Cell = Union[None, str, float, "tuple[float, ...]"]


@dataclass(frozen=True)
class Statement:
    """One finding. ``str`` makes the sentence that summaries print."""

    table: str  #: name of the table
    what: str  #: "separation margin"
    station: str  #: name of the station, or ""
    at: str  #: value of the table's parameter; "" for the whole table
    verdict: str  #: "none asked for", "holds", "not known" or "fails"
    clause: str  #: clause of the standard, or ""
    asked: str  #: the requirement, or ""
    found: str  #: the value found
    judged: str  #: the verdict with its reason, or ""
    text: str = field(repr=False)  #: the statement as one sentence
    values: dict[str, tuple[float, ...]]  #: numbers of ``at``, ``asked``, ``found``, ``judged``, in SI

    def __str__(self) -> str:
        return self.text


class Statements(list):
    """A list of :class:`Statement`, which notebooks show as a table."""

    def to_pandas(self) -> pandas.DataFrame:
        """Returns a DataFrame with a line for each statement."""
        names = ("table", "at", "what", "station", "asked", "found", "verdict", "judged", "clause")
        return _pandas().DataFrame([[getattr(own, name) for name in names] for own in self], columns=list(names))

    def _repr_html_(self) -> str:
        names = ("table", "at", "what", "station", "asked", "found", "judged", "clause")
        rows = ([getattr(own, name) for name in names] for own in self)
        return _html_table(["table", "at", "what", "station", "asked for", "found", "verdict", "clause"], rows)


@dataclass(frozen=True)
class Column:
    """A column of a sheet."""

    key: str  #: "amplification"
    heading: str  #: heading without its unit
    unit: str  #: unit of the shown numbers, or ""
    size: float  #: size of that unit in SI: shown number = number in SI / size - ``zero``
    digits: int  #: significant digits in documents; 0 for a column of texts
    zero: float = 0.0  #: offset of temperature units: 273.15 for degC, 459.67 for degF
    between: str | None = None  #: separator of several numbers in a cell; None for single numbers
    meaning: str = ""  #: what its numbers are, in a sentence; "" if the heading says it

    @property
    def title(self) -> str:
        """The heading with its unit: "peak at (rpm)"."""
        return f"{self.heading} ({self.unit})" if self.unit else self.heading

    def shown(self, number: Cell) -> Cell:
        """Converts a cell from SI to the shown unit."""
        if isinstance(number, (str, type(None))):
            return number
        if isinstance(number, tuple):
            return tuple(own / self.size - self.zero for own in number)
        return number / self.size - self.zero


@dataclass(frozen=True)
class Sheet:
    """A table as documents show it, with numbers in the units shown, and in SI."""

    name: str  #: "peaks"
    table: str  #: name of the table
    title: str
    about: str  #: sentences that explain it, or ""
    columns: tuple[Column, ...]
    rows: tuple[tuple[Cell, ...], ...] = field(repr=False)  #: cells in the shown units; None for empty cells
    si: tuple[tuple[Cell, ...], ...] = field(repr=False)  #: cells in SI
    texts: tuple[tuple[str, ...], ...] = field(repr=False)  #: cells as documents write them

    @property
    def keys(self) -> tuple[str, ...]:
        """The keys of the columns."""
        return tuple(column.key for column in self.columns)

    def __len__(self) -> int:
        return len(self.rows)

    def __getitem__(self, key: str) -> Any:
        """Returns a column by its key, in the unit shown: an array (NaN for empty cells), or a list if cells are not
        single numbers."""
        if key not in self.keys:
            raise KeyError(f"the sheet '{self.name}' has no column '{key}', expected one of: {', '.join(self.keys)}")
        at = self.keys.index(key)
        return self._numbers(at) if self._is_plain(at) else [row[at] for row in self.rows]

    def records(self, si: bool = False) -> list[dict[str, Cell]]:
        """Returns the rows as dicts by the keys of columns, in the units shown or in SI."""
        return [dict(zip(self.keys, row)) for row in (self.si if si else self.rows)]

    def to_pandas(self) -> pandas.DataFrame:
        """Returns a DataFrame in the units shown, whose column names are headings with units. ``frame.attrs["keys"]``
        has the keys, ``frame.attrs["units"]`` the units, both in the order of the columns."""
        columns = range(len(self.columns))
        own = {at: self._numbers(at) if self._is_plain(at) else [row[at] for row in self.rows] for at in columns}
        frame = _pandas().DataFrame(own)
        frame.columns = [column.title for column in self.columns]
        frame.attrs["keys"] = list(self.keys)
        frame.attrs["units"] = [column.unit for column in self.columns]
        return frame

    def _is_plain(self, at: int) -> bool:
        return self.columns[at].digits > 0 and self.columns[at].between is None

    def _numbers(self, at: int) -> np.ndarray:
        return np.array([np.nan if row[at] is None else row[at] for row in self.rows], dtype=float)

    def _repr_html_(self) -> str:
        shown = [at for at in range(len(self.columns)) if any(row[at] for row in self.texts)]
        rows = ([row[at] for at in shown] for row in self.texts)
        about = f"<p>{html.escape(self.about)}</p>" if self.about else ""
        return f"{about}{_html_table([self.columns[at].title for at in shown], rows, self.title)}"


def _pandas():
    try:
        import pandas as pd
    except ImportError:
        raise ImportError("a DataFrame needs pandas, which is not installed: pip install pandas") from None
    return pd


def _html_table(headings: Sequence[str], rows: Any, title: str = "") -> str:
    def line(tag, cells):
        return f"<tr>{''.join(f'<{tag}>{html.escape(cell)}</{tag}>' for cell in cells)}</tr>"

    caption = f"<caption>{html.escape(title)}</caption>" if title else ""
    return f"<table>{caption}{line('th', headings)}{''.join(line('td', row) for row in rows)}</table>"


# ---------------------------------------------------------------- from the library


def text_of(handle, sheet: str | None, units: str | None, form: str) -> str:
    """Returns the library's text of a sheet, or of all findings."""
    out = ffi.new("char **")
    words = (ffi.NULL if word is None else word_bytes(word) for word in (sheet, units))
    check(lib.whirl_result_findings(handle, *words, word_bytes(form), out))
    return taken(out)


def _finite(numbers):
    """Returns numbers with NaN in the place of a null of JSON."""
    return tuple(np.nan if number is None else number for number in numbers)


def _statement(of: dict[str, Any]) -> Statement:
    phrases = {name: of.get(name, {"text": "", "values": []}) for name in ("at", "asked", "found", "judged")}
    return Statement(
        **{name: of[name] for name in ("table", "what", "verdict", "text")},
        **{name: of.get(name, "") for name in ("station", "clause")},
        **{name: phrase["text"] for name, phrase in phrases.items()},
        values={name: _finite(phrase["values"]) for name, phrase in phrases.items()},
    )


def _sheet(of: dict[str, Any]) -> Sheet:
    columns = tuple(Column(**column) for column in of["columns"])
    si = tuple(tuple(_finite(cell) if isinstance(cell, list) else cell for cell in row) for row in of["rows"])
    return Sheet(
        of["name"],
        of["table"],
        of["title"],
        of.get("about", ""),
        columns,
        tuple(tuple(column.shown(cell) for column, cell in zip(columns, row)) for row in si),
        si,
        tuple(map(tuple, of["shown"])),
    )


def statements_of(handle, units: str | None) -> Statements:
    """Returns all statements of a result."""
    return statements_in(json.loads(text_of(handle, None, units, "json")))


def sheet_of(handle, name: str, units: str | None) -> Sheet:
    """Returns a sheet of a result."""
    return _sheet(json.loads(text_of(handle, name, units, "json")))


def sheets_of(handle, units: str | None) -> dict[str, Sheet]:
    """Returns all sheets of a result by their names, "TABLE/NAME" if several tables have a sheet of the name."""
    return sheets_in(json.loads(text_of(handle, None, units, "json")))


def statements_in(document: dict[str, Any]) -> Statements:
    """Returns the statements of a document."""
    return Statements(_statement(own) for own in document["statements"])


def sheets_in(document: dict[str, Any]) -> dict[str, Sheet]:
    """Returns the sheets of a document, by the names of :func:`sheets_of`."""
    sheets = [_sheet(own) for own in document["sheets"]]
    times = Counter(sheet.name for sheet in sheets)
    return {f"{own.table}/{own.name}" if times[own.name] > 1 else own.name: own for own in sheets}
