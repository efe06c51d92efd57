"""A table of a result: the points of one part of a study, with all their numbers."""

from __future__ import annotations

from collections.abc import Iterator, KeysView, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from . import errors
from ._readonly import ReadOnly
from .fields import FIELD

if TYPE_CHECKING:
    import pandas
    import xarray

__all__ = ["Field", "Table"]

_TAKEN = {"point", "branch", "verdict", "attractor", "share", "station", "contact", "x", "y", "z"}


def _apart(name):
    """Returns the name of a parameter that does not collide with columns and dimensions."""
    return f"parameter {name}" if name in _TAKEN else name


@dataclass(frozen=True)
class Field:
    """A field: numbers of an analysis for every point of a table."""

    name: str  #: "orbit/max_radius"
    unit: str  #: "length" and "force" (in the scales of the result), "1", "revolution", "order", ...
    meaning: str  #: meaning in words
    extent: str  #: unit that has a block of numbers: "point", "station" or "contact"
    repeat: int  #: number of these blocks
    rows: int  #: rows of each block; 1 for single numbers
    columns: int  #: columns of each row; of signals their samples
    has_rows: bool  #: True if rows are a dimension (as in a section), even if there is only one row
    si_factor: float  #: factor to SI; NaN for lengths if the parameter changes the scale
    si_unit: str  #: name of the SI unit
    column_names: list[str]  #: "x", "y", ...; empty for columns without names
    singles: int = 0  #: samples of a signal in single precision (float32); 0 for fields in double precision

    @property
    def dimensions(self) -> tuple[str, ...]:
        """Names of the dimensions after those of the points."""
        if self.singles:
            return "channel", "sample"
        sizes = (self.extent, self.extent != "point"), ("row", self.has_rows), ("column", self.columns != 1)
        return tuple(name for name, there in sizes if there)

    def _shaped(self, numbers: np.ndarray, points: int) -> np.ndarray:
        """Returns numbers in the shape of files: with a dimension of rows if the field has rows, even if there is
        only one row."""
        if not self.has_rows or self.rows != 1 or self.singles:
            return numbers
        before = points + (self.extent != "point")
        return numbers.reshape(numbers.shape[:before] + (1,) + numbers.shape[before:])


def _fixed(numbers):
    """Makes an array read-only, and returns it."""
    if numbers is not None:
        numbers.flags.writeable = False
    return numbers


class Table(Mapping):
    """The points of one part of a study: ``table["orbit/max_radius"]`` is an array of a field, points first.

    Arrays of a result in memory are read-only views of the library's own numbers, which live as long as the arrays;
    arrays of a file are read when they are used. Numbers are in the scaling of the result (:meth:`si` converts). A
    complete map has two dimensions of points, rows and columns; with a third parameter, planes before these.
    """

    def __init__(self, about: Any, source: Any) -> None:
        self._about, self._source = about, source
        self.name = source.name  #: "sweep", "map", "branch", ...
        #: role of the table in the study: "point", "survey", "detail", "map", "basin", "branches", "curves", "tori",
        #: "motions", "rest", "tolerances" or "records"
        self.role = source.role
        self.parameter = source.parameter  #: the varied parameter, "" for a single point
        self.second = source.second  #: the second parameter of a map or of curves, else ""
        self.third = source.third  #: the third parameter, from plane to plane of a map, else ""
        self.shape = source.shape  #: (points,), or ([planes,] rows, columns) for a whole map
        self.grid = source.grid  #: (rows, columns) of a map, also with missing points or refinement; else None
        self.planes = source.planes  #: planes of a map, 1 without a third parameter; 0 for other tables

    @cached_property
    def fields(self) -> dict[str, Field]:
        """The fields by their names, in the order of the file."""
        fields = {about["name"]: Field(**about) for about in self._source.fields()}
        return ReadOnly(fields, "the fields of a table cannot be replaced")

    @cached_property
    def values(self) -> np.ndarray:
        """The parameter at every point, in SI; NaN without a parameter."""
        return _fixed(self._source.values())

    @cached_property
    def second_values(self) -> np.ndarray | None:
        """The second parameter at every point of a map or of curves, in SI; None if there is none."""
        name = FIELD.MAP_SECOND if FIELD.MAP_SECOND in self.fields else FIELD.TRACE_SECOND if self.second else None
        return _fixed(self[name]) if name in self.fields else None

    @cached_property
    def third_values(self) -> np.ndarray | None:
        """The third parameter at every point of a map with planes, in SI; None if there is none."""
        return _fixed(self[FIELD.MAP_THIRD]) if FIELD.MAP_THIRD in self.fields else None

    @cached_property
    def branch(self) -> np.ndarray:
        """+1 at points whose motions were carried from the first value on, -1 from the last, 0 not carried."""
        return _fixed(self._source.branch())

    @cached_property
    def point(self) -> np.ndarray:
        """The number of each point in the study, from 1. Numbers are missing only if the run was stopped."""
        return _fixed(self._source.point())

    @cached_property
    def place(self) -> np.ndarray:
        """The place of each point in the study, from 0, row by row and plane by plane of a map; several starts have one
        place."""
        return _fixed(self._source.place())

    @cached_property
    def length_scale(self) -> np.ndarray:
        """Length scale at every point: m per unit of length."""
        return _fixed(self._source.length_scale())

    @cached_property
    def clock(self) -> np.ndarray:
        """Rate at every point, rad/s, of the phase whose turn is a revolution and by which sections are taken. It is
        the speed of the shaft, unless the case has another keyphasor; NaN if unknown."""
        return _fixed(self._source.clock(self, self._about.clock))

    @cached_property
    def _words(self):
        return tuple(_fixed(words) for words in self._source.words())

    @property
    def verdicts(self) -> np.ndarray:
        """The verdict on every point in words ("P-2", "chaotic", ...); "" without the analysis regime."""
        return self._words[0]

    @property
    def reasons(self) -> np.ndarray:
        """The reason of every verdict, a sentence."""
        return self._words[1]

    @cached_property
    def _attractors(self):
        return tuple(map(_fixed, self._source.attractors())) if self.has_attractors else (None, None, None)

    @property
    def has_attractors(self) -> bool:
        """True if points are different starts of one machine, as in a basin or with several starts at a place."""
        return self.role == "basin" or FIELD.STARTS_NUMBER in self.fields

    @property
    def attractors(self) -> np.ndarray | None:
        """The number of the attractor to which every point leads; 0 without a verdict. Attractors are numbered from 1,
        the one that most starts reach first. None if :attr:`has_attractors` is false."""
        return self._attractors[0]

    @property
    def shares(self) -> np.ndarray | None:
        """The share, from 0 to 1, of the starts (of the basin, or of the point's place) that lead to the attractor of
        the point; NaN if it has none. None if :attr:`has_attractors` is false."""
        return self._attractors[1]

    @property
    def share_errors(self) -> np.ndarray | None:
        """The standard errors of :attr:`shares` for random starts."""
        return self._attractors[2]

    @cached_property
    def options(self) -> dict:
        """Options of the computation: method, tolerances, revolutions, ..."""
        return ReadOnly(self._source.options(), "case.set('integrate.rtol', ...) sets an option of a case")

    def _field(self, name):
        if not isinstance(name, str):
            raise KeyError(f"a table has fields by their names, such as 'orbit/max_radius', and no {name!r}")
        if name in self.fields:
            return self.fields[name]
        from difflib import get_close_matches

        near = get_close_matches(name, self.fields, 1)
        raise KeyError(
            f"the table '{self.name}' has no field '{name}'" + (f", did you mean '{near[0]}'?" if near else "")
        )

    def __getitem__(self, name: str) -> np.ndarray:
        field = self._field(name)
        return self._source.numbers(list(self.fields).index(name), field)

    def __iter__(self) -> Iterator[str]:
        return iter(self.fields)

    def __len__(self) -> int:
        return len(self.fields)

    def __contains__(self, name: object) -> bool:
        return name in self.fields

    def keys(self) -> KeysView[str]:
        """Returns the names of the fields."""
        return self.fields.keys()

    def unit(self, name: str) -> str:
        """Returns the unit of a field's numbers: "length", "force", "1", "order", ..."""
        return self._field(name).unit

    def si(self, name: str) -> tuple[np.ndarray, str]:
        """Returns the numbers of a field in SI, and the name of the unit: ``radius, unit =
        table.si("orbit/max_radius")``.

        A column of orders among lengths (``spectrum/lines``) is unchanged.
        """
        field, numbers = self._field(name), self[name]
        factor = np.asarray(field.si_factor)
        if np.isnan(factor):
            factor = self._si_factors(field.unit).reshape(self.shape + (1,) * (numbers.ndim - len(self.shape)))
        if field.unit == "length" and "order" in field.column_names:
            factor = np.where(np.array(field.column_names) == "order", 1.0, factor)
        return numbers * factor, field.si_unit

    def _si_factors(self, unit):
        """Returns the factors to SI of every point, for units whose factor may differ."""
        if unit == "length":
            return self.length_scale
        return 2.0 * np.pi / self.clock if unit == "revolution" else self.clock / (2.0 * np.pi)

    def at(self, value: float | str) -> int:
        """Returns the index of the point whose parameter is nearest to a value: a number in SI, or a text with any unit
        of the parameter, "6000 rpm". A value that is beyond all points by more than the last step is BadInput."""
        return self._about.nearest(self.parameter, self.values.ravel(), value)

    def station(self, name: str | int) -> int:
        """Returns the index of a station, given by its name or its index."""
        names = [station.name for station in self._about.stations]
        if isinstance(name, (int, np.integer)) and 0 <= name < len(names):
            return int(name)
        if name in names:
            return names.index(name)
        raise errors.BadInput(f"there is no station '{name}', expected one of: {', '.join(names)}")

    def to_pandas(self) -> pandas.DataFrame:
        """Returns a DataFrame with a line for each point: the parameters, the verdict, and every field that has one
        row.

        Names are those of the CSV files without units ("orbit/max_radius disc", "orbit/mean disc x"). A parameter with
        the name of another column ("point", "branch", "verdict", ...) is "parameter point". ``frame.attrs["units"]``
        has the unit of every column, ``frame.attrs["meanings"]`` the meaning of every column of a field and how lengths
        are counted ("0-p").
        """
        import pandas as pd

        columns, units, meanings = {"point": self.point.ravel()}, {}, {}
        axes = ((self.parameter or "value", self.values), (self.second, self.second_values))
        for name, values in (*axes, (self.third, self.third_values)):
            if values is not None:
                columns[_apart(name)] = values.ravel()
        columns["branch"] = self.branch.ravel()
        if FIELD.REGIME_CODE in self.fields:
            columns["verdict"] = self.verdicts.ravel()
        if self.has_attractors:
            columns.update(attractor=self.attractors.ravel(), share=self.shares.ravel())
        for name, field in self.fields.items():
            if field.rows == 1 and not field.singles and name not in (FIELD.MAP_SECOND, FIELD.MAP_THIRD):
                own = self._columns(name, field)
                columns.update(own)
                units.update(dict.fromkeys(own, field.unit))
                meanings.update(dict.fromkeys(own, field.meaning))
        frame = pd.DataFrame(columns)
        frame.attrs["units"] = {
            **{_apart(n): self._about.parameter_unit(n) for n in (self.parameter, self.second, self.third) if n},
            **units,
        }
        frame.attrs["meanings"] = meanings
        return frame

    def _columns(self, name, field):
        """Yields the columns of a field with one row, one-dimensional."""
        numbers = self[name].reshape(int(np.prod(self.shape)), field.repeat, field.columns)
        owners = {"station": [s.name for s in self._about.stations], "contact": self._about.contacts, "point": [""]}
        parts = (
            field.column_names if field.columns > 1 and field.column_names else [str(i) for i in range(field.columns)]
        )
        found = {}
        for i in range(field.repeat):
            for k in range(field.columns):
                words = [name, owners[field.extent][i], parts[k] if field.columns > 1 else ""]
                title = " ".join(word for word in words if word)
                found[title] = numbers[:, i, k]
        return found

    def to_xarray(self) -> xarray.Dataset:
        """Returns a Dataset with the fields by their names, dimensions as in the file, units as attributes.

        If every value of the parameter occurs once, points can be chosen by it:
        ``data.sel(omega=3.3, method="nearest")``.

        With dask, fields of a file are read only when they are used.
        """
        import xarray as xr

        dims = ("z", "y", "x")[-len(self.shape) :] if len(self.shape) > 1 else ("point",)
        data, coords = {}, self._coordinates(dims)
        for name, field in self.fields.items():
            own = tuple(d if d in ("station", "contact") else f"{name} {d}" for d in field.dimensions)
            about = {
                "unit": field.unit,
                "SI_factor": field.si_factor,
                "SI_unit": field.si_unit,
                "meaning": field.meaning,
            }
            data[name] = (dims + own, self._lazy(name, field), about)
            if field.columns > 1 and field.column_names:
                coords[f"{name} column"] = field.column_names
        if FIELD.REGIME_CODE in self.fields:
            data["verdict"] = (dims, self._lazy_verdicts())
        if self.has_attractors:
            data["attractor"], data["share"] = (dims, self.attractors), (dims, self.shares)
        dataset = xr.Dataset(data, coords, {"title": self._about.title, "table": self.name, **self.options})
        along = _apart(self.parameter) if len(dims) == 1 else ""
        once = along in dataset.coords and len(np.unique(self.values)) == self.values.size
        return dataset.set_xindex(along) if once and hasattr(dataset, "set_xindex") else dataset

    def _coordinates(self, dims):
        names = [station.name for station in self._about.stations]
        coords = {"station": names, "contact": self._about.contacts}
        if len(dims) > 1:
            names = self.parameter, self.second, self.third
            values = self.values, self.second_values, self.third_values
            for along, axis in enumerate(reversed(dims)):
                own = np.moveaxis(values[along], -1 - along, 0).reshape(self.shape[-1 - along], -1)[:, 0]
                about = {"unit": self._about.parameter_unit(names[along]), "parameter": names[along]}
                coords[axis] = (axis, own, about)
        elif self.parameter:
            coords[_apart(self.parameter)] = (dims, self.values, {"unit": self._about.parameter_unit(self.parameter)})
        return coords

    def _lazy(self, name, field):
        dataset = getattr(self._source, "dataset", None)
        if dataset is None:
            return self[name]
        try:
            import dask.array as da
        except ImportError:
            return self[name]
        return field._shaped(da.from_array(dataset(field)), len(self.shape))

    def _lazy_verdicts(self):
        dataset = getattr(self._source, "verdict_dataset", None)
        try:
            import dask.array as da
        except ImportError:
            dataset = None
        if dataset is None:
            return self.verdicts
        words = da.from_array(dataset())
        return words.map_blocks(np.char.decode, "utf-8", dtype=f"U{words.dtype.itemsize}")

    def __repr__(self) -> str:
        size = " x ".join(map(str, self.shape))
        return (
            f"<whirl.Table '{self.name}': {size} points over {self.parameter or 'nothing'}, {len(self.fields)} fields>"
        )
