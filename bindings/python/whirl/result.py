"""Results of a study, in memory or in a file, with one interface."""

from __future__ import annotations

import html
import os
import shutil
import tempfile
from collections.abc import ItemsView, Iterator, KeysView, ValuesView
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import errors
from ._readonly import ReadOnly
from .fields import FIELD
from .table import Table

if TYPE_CHECKING:
    from .case import Case
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from .findings import Sheet, Statements
    from .plot import Plots

__all__ = ["Parameter", "Station", "Result", "open", "read"]


@dataclass(frozen=True)
class Parameter:
    """A named parameter of the case with the value that the run used."""

    name: str
    value: float  #: in SI
    unit: str  #: SI unit, "1" for a plain number
    text: str  #: text in the case

    def __float__(self) -> float:
        return self.value


@dataclass(frozen=True)
class Station:
    """A place of the machine whose motion is recorded."""

    name: str
    clearance: float  #: clearance of the bearing, in length scales; 0 without a bearing
    gap: float  #: radius at which the station touches a stator, in length scales; 0 without a stator
    x: int  #: index of the coordinate along x in the state
    y: int  #: index of the coordinate along y
    vx: int  #: index of the velocity along x
    vy: int  #: index of the velocity along y
    shaft: int = 0  #: number of its shaft of finite elements, from 1; 0 for none
    position: float = 0.0  #: position along that shaft, m
    along_y: int = 0  #: 1 if the station moves along y only; then `x` is the index of that coordinate too
    twists: int = 0  #: 1 where the station only turns about the shaft's axis: displacements in m are rad
    clockwise: int = 0  #: 1 if the rotor turns clockwise, from y to x


def value_text(value: float | str) -> str:
    """Returns a parameter value as a text for the library, from a number in SI or a text with a unit."""
    if isinstance(value, str):
        return value
    try:
        return repr(float(value))
    except (TypeError, ValueError):
        raise errors.BadInput(
            f"the value of a parameter is {value!r}, expected a number in SI or a text such as '6000 rpm'"
        ) from None


class _About:
    """The part of a result that its tables need. They do not hold the result itself, so that its memory is freed when
    the user no longer has it."""

    def __init__(self, source: Any) -> None:
        self._source = source

    title = property(lambda self: self._source.title)

    @cached_property
    def parameters(self) -> dict[str, Parameter]:
        named = {name: Parameter(name, *rest) for name, *rest in self._source.parameters()}
        return ReadOnly(named, "case.set(name, value) sets a parameter of a case")

    @cached_property
    def stations(self) -> list[Station]:
        return [Station(**about) for about in self._source.stations()]

    @cached_property
    def contacts(self) -> list[str]:
        return self._source.contacts()

    @cached_property
    def facts(self) -> dict[str, str]:
        return ReadOnly(self._source.facts(), "facts are what a result says of its run")

    @property
    def clock(self) -> float:
        """Rate of the phase that counts revolutions, rad/s, for the case without parameter changes."""
        try:
            rate = float(self.facts.get("keyphasor rate", "").split(" ")[0])
        except ValueError:
            rate = 0.0
        return rate if 0.0 < rate < np.inf else self._source.speed

    def parameter_unit(self, name: str) -> str:
        return self.parameters[name].unit if name in self.parameters else "1"

    def nearest(self, parameter: str, values: np.ndarray, value: float | str) -> int:
        from ._library import check, ffi, lib, word_bytes

        if not parameter:
            raise errors.BadInput("nothing varies in the table: its points are chosen by their index")
        index, values = ffi.new("size_t *"), np.ascontiguousarray(values, dtype=float)
        check(
            lib.whirl_nearest_value(
                self._source.outline_result(),
                word_bytes(parameter),
                ffi.cast("double *", values.ctypes.data),
                len(values),
                word_bytes(value_text(value)),
                index,
            )
        )
        return index[0]


class Result:
    """Results of a run, with its case and its options."""

    def __init__(self, source: Any) -> None:
        self._source, self._about = source, _About(source)
        self._units = None  # units of figures; "": those of the case
        self._whole = None  # whole result in memory, once a result in a file was needed for figures

    @property
    def title(self) -> str:
        """The title of the case."""
        return self._source.title

    @property
    def case_name(self) -> str:
        """The name of the case file."""
        return self._source.case_name

    @property
    def case_text(self) -> str:
        """The case file, byte for byte."""
        return self._source.case_text

    @property
    def speed(self) -> float:
        """Speed of the shaft in rad/s, for the case without parameter changes."""
        return self._source.speed

    @property
    def length_scale(self) -> float:
        """Length scale: m per unit of length."""
        return self._source.length_scale

    @property
    def force_scale(self) -> float:
        """Force scale: N per unit of force."""
        return self._source.force_scale

    @property
    def partial(self) -> bool:
        """True if the run was stopped before its end."""
        return self._source.partial

    def _rows_of(self, field):
        """Yields tables that have points and the field: name, and numbers [points][numbers of a point]."""
        for name, table in self.tables.items():
            if field in table and len(table.values) > 0:
                yield name, np.asarray(table[field]).reshape(len(table.values), -1)

    @property
    def warnings(self) -> list[str]:
        """Warnings of the library, which ``whirl check`` and ``whirl run`` also print: values of the case outside the
        range of a law or unlike any machine, and empty ranges; in the units of statements. :func:`whirl.run` also shows
        them as ``UserWarning``."""
        if "warning 1" not in self.facts:
            return []
        from ._library import check, ffi, lib, taken

        out = ffi.new("char **")
        check(lib.whirl_result_warnings(self._figured(), ffi.NULL, out))
        return taken(out).splitlines()

    @property
    def beyond(self) -> list[str]:
        """Validity ranges of laws that points of tables have left, and the values that they reached. The field
        "ranges/left" of a table has the number of ranges that a point has left, "ranges/reached" the value reached and
        the end of each range."""
        lines = []
        for name, every in self._rows_of(FIELD.RANGES_REACHED):
            for i in range(every.shape[1] // 2):
                reached, most = every[:, 2 * i : 2 * i + 2].T
                left = reached > most * (1 + 1e-9)
                if left.any():
                    worst = np.nanmax(reached[left])
                    lines.append(
                        f"{name}: {self.facts[f'range {i + 1}']}; reached {worst:.4g} "
                        f"({left.sum()} of {len(left)} points)"
                    )
        return lines

    @property
    def held(self) -> list[str]:
        """Contacts that are closed in the equilibria of machines at rest, and stay closed in small motions. The field
        "ranges/held" of a table is the normal force of every contact at every point, 0 for an open one."""
        lines = []
        for name, every in self._rows_of(FIELD.RANGES_HELD):
            for contact, force in zip(self.contacts, self.force_scale * every.T):
                count = (force > 0).sum()
                if count:
                    most = np.nanmax(force)
                    lines.append(f"{name}: {contact} with {most:.4g} N ({count} of {len(force)} points)")
        return lines

    @property
    def unfound(self) -> list[str]:
        """Tables of machines at rest that have points without a place of rest; the numbers of these points are NaN. The
        field "ranges/rest" of a table is the share of the static load up to which an equilibrium could be followed, 1
        if one was found."""
        lines = []
        for name, share in self._rows_of(FIELD.RANGES_REST):
            missing = ~(share >= 1)
            if missing.any():
                lines.append(f"{name}: no place of rest was found ({missing.sum()} of {share.size} points)")
        return lines

    @property
    def elsewhere(self) -> list[str]:
        """A text for each table of a machine at rest in which points have a second place of rest. It was found from the
        place of rest at the value before or after. The field "ranges/elsewhere" of a table has the distance of each
        station between both places, "ranges/elsewhere_growth" the largest real part of the eigenvalues at the second
        place, 1/s: stable below 0."""
        lines = []
        for name, apart in self._rows_of(FIELD.RANGES_ELSEWHERE):
            found = np.isfinite(apart).any(axis=tuple(range(1, apart.ndim)))
            if found.any():
                lines.append(f"{name}: there is another place of rest ({found.sum()} of {found.size} points)")
        return lines

    @property
    def parameters(self) -> dict[str, Parameter]:
        """The parameters of the case by their names."""
        return self._about.parameters

    @property
    def stations(self) -> list[Station]:
        """The stations, in the order of the station dimension of fields."""
        return self._about.stations

    @property
    def contacts(self) -> list[str]:
        """Names of the contacts, in the order of the contact dimension of fields."""
        return self._about.contacts

    @property
    def facts(self) -> dict[str, str]:
        """Facts about the computation: method, machine, versions."""
        return self._about.facts

    @cached_property
    def tables(self) -> dict[str, Table]:
        """Tables of points by name, such as "sweep", "map", "branch". Tables as documents show them are
        :meth:`sheets`."""
        tables = {name: Table(self._about, table) for name, table in self._source.tables().items()}
        return ReadOnly(tables, "the tables of a result cannot be replaced")

    @property
    def case(self) -> Case:
        """The case, to be run again or changed."""
        from .case import Case

        return Case(text=self.case_text, name=self.case_name)

    def show_in(self, units: str) -> Result:
        """Chooses the units of figures, statements and sheets, as ``whirl report --units`` does; default: those of the
        case.

        Parameters
        ----------
        units : str
            At most one word, in any order, of a length (scale, m, mm, um, in, mil), a speed (rad/s, rpm), and a way to
            count amplitudes (0-p, p-p, rms): "um, rpm, p-p". Frequencies (order, Hz, cpm) are accepted without an
            effect, since spectra here are over orders. "" restores the default. A result in memory is saved with its
            choice; an opened file does not change.

        Returns
        -------
        Result
            The same object: ``result.show_in("mil, rpm").plot.bode()``.
        """
        if not isinstance(units, str):
            raise errors.BadInput(f"the units are {units!r}, expected words such as 'um, rpm, p-p'")
        for source in (self._source, self._whole):
            if source:
                source.show_in(units)
        self._units = units
        self._about.__dict__.pop("facts", None)  # facts contain the units of a result in memory
        return self

    def parameter_unit(self, name: str) -> str:
        """Returns the SI unit of a parameter; "1" for other names."""
        return self._about.parameter_unit(name)

    def __getitem__(self, name: str) -> Table:
        if name in self.tables:
            return self.tables[name]
        raise KeyError(f"the result has no table '{name}', expected one of: {', '.join(self.tables)}")

    def __contains__(self, name: object) -> bool:
        return name in self.tables

    def __iter__(self) -> Iterator[str]:
        return iter(self.tables)

    def __len__(self) -> int:
        return len(self.tables)

    def __bool__(self) -> bool:
        return True

    def keys(self) -> KeysView[str]:
        """Returns the names of the tables."""
        return self.tables.keys()

    def values(self) -> ValuesView[Table]:
        """The tables."""
        return self.tables.values()

    def items(self) -> ItemsView[str, Table]:
        """Returns names and tables: ``for name, table in result.items(): ...``"""
        return self.tables.items()

    def get(self, name: str, default: Table | None = None) -> Table | None:
        """Returns a table, or ``default`` if the result has no table of the name."""
        return self.tables.get(name, default)

    @property
    def plot(self) -> Plots:
        """Functions that draw figures of reports in Matplotlib, such as ``result.plot.bifurcation()``."""
        from .plot import Plots

        return Plots(self)

    def figures(self) -> dict[str, str]:
        """Returns names and titles of the figures of reports, which :meth:`figure` draws."""
        from .figure import names_of

        return names_of(self._figured())

    def figure_data(
        self,
        name: str | None = None,
        panels: str | list[str] | None = None,
        log: str | None = None,
        units: str | None = None,
        other: "Result | None" = None,
    ) -> dict[str, Any]:
        """Returns a figure as data, the document of docs/figures.md: panels with axes and series, in the units shown.

        Parameters
        ----------
        name : str, optional
            One of :meth:`figures`; default: the first.
        panels : str or list of str, optional
            Names of the panels to include: "x,exponent".
        log : str, optional
            "x", "y" or "xy": axes that shall be logarithmic.
        units : str, optional
            "um, rpm, Hz, p-p"; default: those of the result.
        other : Result, optional
            A result whose figure of the same name is drawn into this one, dashed: a measured record
            (:func:`whirl.signals.load`) over a model.
        """
        from .figure import describe

        return describe(self._figured(), name, units, panels, log, None if other is None else other._figured())

    def figure(
        self,
        name: str | None = None,
        panels: str | list[str] | None = None,
        log: str | None = None,
        units: str | None = None,
        ax: Axes | None = None,
        other: "Result | None" = None,
    ) -> Figure:
        """Draws a figure of reports in Matplotlib, or one of its panels into given axes.

        ``result.figure("bifurcation-disc", panels="x,exponent").savefig("figure-3.pdf")``; parameters as of
        :meth:`figure_data`. The figure is returned.
        """
        from .figure import draw

        return draw(self.figure_data(name, panels, log, units, other), ax)

    def statements(self, units: str | None = None) -> Statements:
        """Returns findings on machines at rest, branches, tori and spectra: a list of :class:`whirl.Statement`.

        Parameters
        ----------
        units : str, optional
            Units of the numbers in texts, "um, rpm, Hz, p-p" or "US"; default: those of the result.
        """
        from .findings import statements_of

        return statements_of(self._figured(), units)

    def sheets(self, units: str | None = None) -> dict[str, Sheet]:
        """Returns findings as tables of documents, by their names: "peaks", or "TABLE/peaks" if several tables have
        such a sheet. ``units`` as in :meth:`statements`."""
        from .findings import sheets_of

        return ReadOnly(sheets_of(self._figured(), units), "sheets are what was found")

    def sheet(self, name: str, units: str | None = None) -> Sheet:
        """Returns one of :meth:`sheets`; "TABLE/peaks" is a valid name of any sheet. An unknown name is BadInput."""
        from .findings import sheet_of

        return sheet_of(self._figured(), name, units)

    def spread(
        self,
        field: str,
        *,
        column: str = "",
        row: int = 1,
        at: str = "",
        above: float | None = None,
        below: float | None = None,
        what: str = "spread",
        table: str = "",
        units: str | None = None,
    ) -> Sheet:
        """Returns statistics of a number of the points of a study of tolerances, over the parameter: mean, deviation
        and quantiles with their errors. ``to_pandas()`` of the sheet makes a DataFrame.

        Parameters
        ----------
        field : str
            Name of the field, such as "orbit/max_radius".
        column, row, at : optional
            Column of the field by its name, row from 1 (the number of a mode), and station or contact.
        above, below : float, optional
            Limits in SI.
        what : str
            "spread"; "indices", the parts of the variance that parameters cause; or "probabilities" of the limits.
        table : str, optional
            Table of samples, if the result has several.
        """
        from .findings import sheet_of

        words = [f"{table}/{what}:{field}" if table else f"{what}:{field}"]
        words += [f"column {column}"] if column else []
        words += [f"row {row}"] if row != 1 else []
        words += [f"{key} {float(limit)!r}" for key, limit in (("above", above), ("below", below)) if limit is not None]
        words += [f"at {at}"] if at else []
        return sheet_of(self._figured(), " ".join(words), units)

    def sheet_text(self, name: str | None = None, format: str = "text", units: str | None = None) -> str:
        """Returns a sheet as ``whirl table`` writes it: "text", "csv", "latex" (a table with rules of booktabs),
        "markdown" or "json"; without a name all statements and sheets, as "text" or "json"."""
        from .findings import text_of

        return text_of(self._figured(), name, units, format)

    def _figured(self):
        """Returns the library's result; a result in a file is read completely."""
        from ._memory import MemorySource

        source = self._source
        if hasattr(source, "handle"):
            return source.handle
        if not self._whole:
            self._whole = MemorySource.read(source.path)
            if self._units is not None:
                self._whole.show_in(self._units)
        return self._whole.handle

    def save(self, path: str | os.PathLike, *, overwrite: bool = False) -> None:
        """Writes the result as the file that `whirl run` writes, to a temporary name that is renamed at the end, so
        that no file is ever incomplete.

        Unless ``overwrite`` is True, an existing file stays and FileFailure is raised (also a FileExistsError). A name
        with the ending of another kind of file, "a.csv", is BadInput.
        """
        from ._library import keep_file, lib, path_bytes

        if not lib.whirl_result_name_fits(path_bytes(path)):
            raise errors.BadInput(
                f"'{os.fspath(path)}' has the ending of another kind of file, expected the name of a result, such as "
                "result.h5"
            )
        keep_file(path, overwrite)
        self._source.write(path)

    def __reduce__(self):
        raise TypeError("a result cannot be pickled: save() writes it to a file, and whirl.open() reads that")

    def close(self) -> None:
        """Closes the file of an opened result, which then cannot be read."""
        getattr(self._source, "close", lambda: None)()

    def __enter__(self) -> Result:
        return self

    def __exit__(self, *_exception: object) -> None:
        self.close()

    def explorer(
        self,
        path: str | os.PathLike | None = None,
        template: str | os.PathLike | None = None,
        *,
        overwrite: bool = False,
    ) -> str | None:
        """Makes the explorer: a page that shows the result and computes further motions in the browser.

        Parameters
        ----------
        path : path, optional
            File of the page; without it, the text of the page is returned.
        template : path, optional
            The explorer's template; default: that of the package or of the system.
        overwrite : bool
            Whether an existing page is replaced; otherwise it is a FileFailure (also a FileExistsError).
        """
        from ._library import check, ffi, keep_file, lib, path_bytes

        if path is not None:
            keep_file(path, overwrite)
        template = template or find_template()
        if template is None:
            raise errors.BadInput(
                "the explorer's template was not found: 'make explorer' builds it, WHIRL_EXPLORER may say where it is"
            )
        handle, name = self._source.library_result(), ffi.new("char[]", Path(self.case_name or "result").stem.encode())
        with tempfile.TemporaryDirectory() as folder:
            check(
                lib.whirl_explorer_write(
                    path_bytes(template),
                    ffi.new("whirl_result *[]", [handle]),
                    ffi.new("char *[]", [name]),
                    1,
                    path_bytes(folder),
                )
            )
            page = Path(folder) / "explorer.html"
            if path is None:
                return page.read_text(encoding="utf-8")
            shutil.copyfile(page, path)

    def _repr_html_(self) -> str:
        """Shows the explorer in a notebook, if its template exists and the page is not too large; else a table."""
        if find_template() is not None and self._source.bytes() <= _LARGEST_SHOWN:
            return (
                f'<iframe srcdoc="{html.escape(self.explorer())}" width="100%" height="720" style="border: 0" '
                f'title="{html.escape(self.title)}"></iframe>'
            )
        lines = (
            f"<tr><td>{html.escape(table.name)}</td><td>{' x '.join(map(str, table.shape))}</td>"
            f"<td>{html.escape(table.parameter)}</td></tr>"
            for table in self.tables.values()
        )
        return (
            f"<p><b>{html.escape(self.title or self.case_name)}</b>{' (partial)' if self.partial else ''}</p>"
            f"{''.join(f'<p>Warning: {html.escape(words)}</p>' for words in self.warnings)}"
            f"{'' if find_template() else _NO_EXPLORER}"
            f"<table><tr><th>table</th><th>points</th><th>over</th></tr>{''.join(lines)}</table>"
        )

    def __str__(self) -> str:
        """Returns the summary: warnings, and findings on each table."""
        lines = [self.title or self.case_name or "A result"]
        lines += [f"warning: {words}" for words in self.warnings]
        statements = self.statements()
        for table in self.tables.values():
            over = f" over {table.parameter}" if table.parameter else ""
            size = " x ".join(map(str, table.shape))
            lines.append(f"{table.name}: {size} point{'' if size == '1' else 's'}{over}")
            lines += [f"  {own}" for own in statements if own.table == table.name]
        lines += [str(own) for own in statements if own.table not in self.tables]
        return "\n".join(lines + (["partial: not all points are there"] if self.partial else []))

    def __repr__(self) -> str:
        tables = ", ".join(f"{t.name} ({' x '.join(map(str, t.shape))})" for t in self.tables.values())
        count = len(self.warnings)
        warned = f", {count} warning{'s' if count > 1 else ''}" if count else ""
        return f"<whirl.Result {self.title!r}: {tables}{', partial' if self.partial else ''}{warned}>"


_NO_EXPLORER = (
    "<p>The explorer would stand here, and its page is not installed: <code>make explorer</code> in a checkout of "
    "whirl builds it, <code>make install</code> or pip then install it.</p>"
)
_LARGEST_SHOWN = 64 << 20  # bytes of a result: notebooks keep the page in their file


def find_template() -> str | os.PathLike | None:
    """Returns the explorer's template: that of WHIRL_EXPLORER, in the package, next to the command ``whirl``, in the
    system's folders, or built in the checkout of this package; None if there is none."""
    command, own = shutil.which("whirl"), Path(__file__).resolve().parent
    folder = Path(command).resolve().parent if command else own
    places = (
        os.environ.get("WHIRL_EXPLORER"),
        own / "_native" / "explorer.html",
        folder.parent / "share" / "whirl" / "explorer.html",
        folder / "explorer" / "template.html",
        "/usr/local/share/whirl/explorer.html",
        "/usr/share/whirl/explorer.html",
        own.parents[2] / "build" / "explorer" / "template.html",
    )
    return next((place for place in places if place and os.path.exists(place)), None)


def open(path: str | os.PathLike) -> Result:  # noqa: A001 (whirl.open shall have this name)
    """Opens a result file of any size. Only its outline is read at once, other parts when they are used.

    The file is read by h5py without checks. For files from untrusted sources use :func:`read`, with which libwhirl
    first checks every part.
    """
    from ._file import FileSource

    return Result(FileSource(os.fspath(path)))


def read(path: str | os.PathLike) -> Result:
    """Reads a whole result file into memory; the library checks it first."""
    from ._memory import MemorySource

    return Result(MemorySource.read(path))
