"""Draws panels of the figures of reports in Matplotlib, chosen by what they show.

Every function takes the axes to draw into, or makes a figure of the panel; it returns the axes. Further keywords go to
the lines and marks (``color="red"``), ``yscale="log"`` to the axes. Numbers, units, colours and labels are those of
:meth:`whirl.Result.figure`, which draws all panels of a figure. What these functions add: one panel in axes of yours,
and points by their value (``at="31.5 rpm"``).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .errors import BadInput
from .fields import FIELD
from .result import value_text

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .result import Result
    from .table import Table

__all__ = ["ATTRACTORS", "REGIMES", "Plots", "attractor_colour", "classes"]

# Colours of the report and the explorer, which readers with any colour vision can distinguish.
REGIMES = {
    "P-1": "#366EFB",
    "P-2": "#1FBADD",
    "P-4": "#1D7257",
    "other P-k": "#664406",
    "quasi-periodic": "#CC0892",
    "chaotic": "#000000",
    "undetermined": "#9A9F95",
    "diverged": "#FB8D41",
}
# Colours of attractors, repeated after the last: those of Okabe and Ito, in an order in which neighbours also differ in
# lightness.
ATTRACTORS = ("#0072B2", "#E69F00", "#56B4E9", "#009E73", "#CC79A7", "#D55E00", "#F0E442", "#000000")
_NO_ATTRACTOR = "#9A9F95"
_UNDETERMINED, _PERIODIC, _QUASI_PERIODIC, _CHAOTIC, _DIVERGED = range(5)

_FIELDS = {
    "bifurcation": FIELD.POINCARE_SECTION,
    "waterfall": FIELD.SPECTRUM_LINES,
    "branch": FIELD.TRACE_HIGH,
    "campbell": FIELD.MODES_FREQUENCY,
    "unbalance": FIELD.UNBALANCE_AMPLITUDE,
}
_MAX_PLANES = 12  # largest number of planes in the figure of a map over three parameters (figure_map.c)


def classes(table: Table) -> np.ndarray:
    """Returns the class of every point's verdict, as an index into :data:`REGIMES`."""
    code, period = (np.nan_to_num(table[name]).astype(int) for name in (FIELD.REGIME_CODE, FIELD.REGIME_PERIOD))
    found = np.full(code.shape, 6)
    found[code == _QUASI_PERIODIC], found[code == _CHAOTIC], found[code == _DIVERGED] = 4, 5, 7
    periodic = code == _PERIODIC
    found[periodic] = 3
    for index, k in enumerate((1, 2, 4)):
        found[periodic & (period == k)] = index
    return found


def attractor_colour(number: int) -> str:
    """Returns the colour of an attractor by its number, from 1; of 0 the colour of points without an attractor."""
    return ATTRACTORS[(number - 1) % len(ATTRACTORS)] if number > 0 else _NO_ATTRACTOR


class Plots:
    """Figures of a result: ``result.plot.bifurcation()``."""

    def __init__(self, result: Result):
        self._result = result

    # ---------------------------------------------------------------- names of figures, tables and points

    def _name(self, kind, table=None, station=None):
        """Returns the name of a figure; without a table or station of the first table with its field and the first
        station."""
        if self._named(table) is None:
            first = self._first(_FIELDS[kind], True)
            table = None if first is None else first.name
        name = kind if kind == "campbell" else f"{kind}-{self._station(0 if station is None else station)}"
        return name if table is None else f"{table}/{name}"

    def _named(self, table):
        """Returns the name of an existing table, or None."""
        if table is not None and table not in self._result:
            raise BadInput(f"the result has no table '{table}', expected one of: {', '.join(self._result)}")
        return table

    def _first(self, field, every):
        """Returns the first table that has a field, or None; ``every`` includes details."""
        for table in self._result.values():
            if field in table and (every or table.name != "detail"):
                return table
        return None

    def _station(self, which):
        return _chosen(which, [station.name for station in self._result.stations], "station")

    def _table(self, table, needs, every=False):
        """Returns the table of a name, or the first table that has the field ``needs``."""
        advice = f"add {needs.split('/')[0]} to what the case analyses"
        if needs == FIELD.SPECTRUM_AMPLITUDE:
            advice = "'study: {detail: {at: ...}}' in a case keeps whole spectra"
        if self._named(table) is not None:
            if needs not in self._result[table]:
                raise BadInput(f"the table '{table}' has no '{needs}': {advice}")
            return self._result[table]
        found = self._first(needs, every)
        if found is None:
            raise BadInput(f"no table of the result has '{needs}': {advice}")
        return found

    def _document(self, name, panel, style, titled=False):
        """Returns the document of a figure with one panel (None: the first), and with the scales of axes in the
        style."""
        log = "".join(axis for axis in "xy" if style.get(f"{axis}scale") == "log")
        document = self._result.figure_data(name, panel, log or None)
        del document["panels"][1:]
        only = document["panels"][0]
        only.update(letter="", title=document["title"] if titled else "")
        for axis in log:
            if not only[axis]["log"]:
                raise BadInput(
                    f"the {axis} axis goes down to {only[axis]['low']:.3g}, expected numbers above 0 for log"
                )
        return document

    def _draw(self, name, panel, ax, style, titled=False):
        """Draws a panel of a figure; titled: with the figure's title."""
        return self._put(self._document(name, panel, style, titled), ax, style)

    @staticmethod
    def _put(document, ax, style):
        """Draws a document into axes, or as a new figure."""
        from .figure import close, draw, new_axes

        scales = {axis: style.pop(f"{axis}scale") for axis in "xy" if f"{axis}scale" in style}
        drawn = new_axes(ax)
        try:
            draw(document, drawn, style)
        except BadInput:
            if ax is None:
                close(drawn)
            raise
        for axis, scale in scales.items():
            if scale != "log":
                getattr(drawn, f"set_{axis}scale")(scale)
        return drawn

    # ---------------------------------------------------------------- along a parameter

    def bifurcation(
        self,
        table: str | None = None,
        station: str | int | None = None,
        coordinate: str = "x",
        ax: Axes | None = None,
        **style,
    ) -> Axes:
        """Draws sections over the parameter, a mark for each revolution, in the colours of their regimes; if points
        have several starts, every attractor once, in a colour of its own.

        Parameters
        ----------
        table : str, optional
            "sweep", ...; default: the first that has such a figure.
        station : str or int, optional
            Name or index of the station; default: the first.
        coordinate : str
            "x" or "y".
        ax : matplotlib.axes.Axes, optional
            Axes to draw into.
        style
            Keywords of Matplotlib: ``markersize=5``.
        """
        return self._draw(self._name("bifurcation", table, station), _axis(coordinate), ax, style)

    def shares(self, table: str | None = None, ax: Axes | None = None, **style) -> Axes:
        """Draws the share of the starts that leads to each attractor, with its standard error; open circles mark shares
        of 0, of attractors that were found only from a neighbouring point."""
        tables = self._result.tables.values() if self._named(table) is None else [self._result[table]]
        if not any(candidate.has_attractors for candidate in tables):
            raise BadInput(
                "no points have several starts: 'study: {starts: {count: ..., within: ...}}' in a case gives them"
            )
        return self._draw(self._name("bifurcation", table), "share", ax, style)

    def lyapunov(self, table: str | None = None, ax: Axes | None = None, **style) -> Axes:
        """Draws the largest Lyapunov exponent over the parameter with its standard error, in the colours of the
        regimes; without the error if the table has no sections."""
        found = self._table(table, FIELD.LYAPUNOV_LARGEST)
        if FIELD.POINCARE_SECTION not in found:
            return self._draw(f"{found.name}/{FIELD.LYAPUNOV_LARGEST}", "value", ax, style)
        return self._draw(self._name("bifurcation", found.name), "exponent", ax, style)

    # ---------------------------------------------------------------- branches

    def branches(
        self,
        table: str | None = None,
        station: str | int | None = None,
        coordinate: str = "x",
        ax: Axes | None = None,
        **style,
    ) -> Axes:
        """Draws branches of orbits over the parameter, at one angle of each revolution: stable solid, unstable dashed,
        special points by their kinds, with tori that begin along them and the sections of a sweep."""
        return self._draw(self._name("branch", table, station), _axis(coordinate), ax, style)

    def curves(self, ax: Axes | None = None, **style) -> Axes:
        """Draws curves of special points over two parameters, by their kinds."""
        if "curves" in self._result.tables and self._result["curves"].values.size == 0:
            raise BadInput("the table 'curves' has no point: no special point was found to begin a curve")
        return self._draw("curves", "curves", ax, style)

    # ---------------------------------------------------------------- machines at rest

    def campbell(self, table: str | None = None, ax: Axes | None = None, **style) -> Axes:
        """Draws natural frequencies over the parameter, in the unit of the speed or in Hz, with critical speeds and
        thresholds of stability; the dashed line is once a revolution."""
        return self._draw(self._name("campbell", table), "frequency", ax, style)

    def bode(
        self, table: str | None = None, station: str | int | None = None, ax: tuple[Axes, Axes] | None = None, **style
    ) -> tuple[Axes, Axes]:
        """Draws the response to unbalance over the parameter as both probes of a station see it: amplitude and lag.

        ``ax`` is a pair of axes for the two; such a pair is returned.
        """
        name = self._name("unbalance", table, station)
        documents = [self._document(name, panel, style) for panel in ("amplitude", "lag")]
        if ax is None:
            import matplotlib.pyplot as plt

            ax = plt.subplots(2, sharex=True, figsize=(7.0, 5.6), layout="constrained")[1]
        return tuple(self._put(document, own, dict(style)) for document, own in zip(documents, ax))

    # ---------------------------------------------------------------- one point

    def poincare(
        self,
        point: int | str | None = None,
        table: str | None = None,
        station: str | int | None = None,
        ax: Axes | None = None,
        *,
        at: float | str | None = None,
        **style,
    ) -> Axes:
        """Draws the section of a point: the position of a station once a revolution.

        ``point`` is an index from 0. In its place, ``at`` is a value of the parameter, to which the nearest point is
        taken: a number in SI, or a text with any unit, "6000 rpm". A value beyond those of the table is BadInput.
        """
        return self._of_point(self._table(table, FIELD.POINCARE_SECTION), point, at, station, "section", ax, style)

    def orbit(
        self,
        point: int | str | None = None,
        table: str | None = None,
        station: str | int | None = None,
        ax: Axes | None = None,
        *,
        at: float | str | None = None,
        **style,
    ) -> Axes:
        """Draws the path of a station at a point, with a mark at every revolution if sections were taken; ``point`` and
        ``at`` as for :meth:`poincare`."""
        return self._of_point(self._table(table, FIELD.WAVEFORM_SAMPLES, True), point, at, station, "orbit", ax, style)

    def spectrum(
        self,
        point: int | str | None = None,
        table: str | None = None,
        station: str | int | None = None,
        full: bool = True,
        ax: Axes | None = None,
        *,
        at: float | str | None = None,
        **style,
    ) -> Axes:
        """Draws a point's spectrum over the order: forward and backward whirl. ``full=False`` draws the spectra of x
        and y, which a result has if the case keeps whole spectra, as for points in detail. ``point`` and ``at`` as for
        :meth:`poincare`."""
        needs, panel = (FIELD.SPECTRUM_LINES, "full-spectrum") if full else (FIELD.SPECTRUM_AMPLITUDE, "spectrum")
        return self._of_point(self._table(table, needs, True), point, at, station, panel, ax, style)

    def _of_point(self, table, point, at, station, panel, ax, style):
        place = f"{table.name}/@{_point(table, point, at)}:{self._station(0 if station is None else station)}"
        return self._draw(place, panel, ax, style, titled=True)

    def waterfall(
        self,
        table: str | None = None,
        station: str | int | None = None,
        highest_order: float | None = None,
        ax: Axes | None = None,
        **style,
    ) -> Axes:
        """Draws the lines of all spectra over order and parameter by colour, down to a thousandth of the largest;
        backward whirl is below order 0. Of a sweep in both directions it shows only the way up."""
        drawn = self._draw(self._name("waterfall", table, station), None, ax, style)
        if highest_order is not None:
            drawn.set_xlim(-highest_order, highest_order)
        return drawn

    # ---------------------------------------------------------------- planes

    def map(
        self,
        field: str | None = None,
        table: str | None = None,
        which: int | str = 0,
        column: int | str = 0,
        plane: int = 0,
        ax: Axes | None = None,
        **style,
    ) -> Axes:
        """Draws regimes over two parameters, paler where confidence is low, or a field's numbers; of a basin the
        attractors to which its starts lead. If points have several starts, a cell shows the motion to which most starts
        lead.

        Parameters
        ----------
        field : str, optional
            "orbit/max_radius", "lyapunov/largest", ...; default: regimes.
        table : str, optional
            "map" or "basin"; default: the first with two parameters.
        which : int or str
            Station or contact of the field, by name or index.
        column : int or str
            Column of a field that has several: "y" of "orbit/mean".
        plane : int
            Plane of a map over three parameters, from 0 in the order of the third parameter's values; of more than 12
            planes only those of the figure can be drawn.
        """
        table = self._plane(table)
        if not 0 <= plane < table.planes:
            raise BadInput(f"the table '{table.name}' has {table.planes} planes, from 0, and no plane {plane}")
        if field is not None:
            name = self._field_name(table, field, which, column)
        elif table.role == "basin":
            name = "basins"
        elif FIELD.REGIME_CODE in table:
            name = "map-regime"
        else:
            raise BadInput(f"the table '{table.name}' has no verdicts: add regime to what the case analyses")
        count = min(table.planes, _MAX_PLANES)
        shown = [k * (table.planes - 1) // max(1, count - 1) for k in range(count)]
        if plane not in shown:
            raise BadInput(f"of {table.planes} planes these are drawn: {', '.join(map(str, shown))}")
        panel = f"plane-{shown.index(plane) + 1}" if count > 1 else "map"
        return self._draw(f"{table.name}/{name}", panel, ax, style)

    def _plane(self, table):
        for candidate in self._result.tables.values() if self._named(table) is None else [self._result[table]]:
            if candidate.role in ("map", "basin"):
                return candidate
        raise BadInput("the result has no map: 'study: {map: {x: ..., y: ...}}' in a case computes one")

    def _field_name(self, table, field, which, column):
        """Returns the name of the figure of a field, "orbit/mean:disc:y"."""
        about, words = table._field(field), [field]
        if about.extent == "station":
            words.append(self._station(which))
        elif about.extent == "contact":
            words.append(_chosen(which, self._result.contacts, "contact"))
        if about.columns > 1:
            words.append(_chosen(column, about.column_names, f"column of '{field}'"))
        return ":".join(words)


def _axis(coordinate):
    if coordinate not in ("x", "y"):
        raise BadInput(f"the coordinate is {coordinate!r}, expected 'x' or 'y'")
    return coordinate


def _chosen(which, names, what):
    """Returns an existing name, given by itself or by its index."""
    if isinstance(which, str) and which in names:
        return which
    if isinstance(which, (int, np.integer)) and 0 <= which < len(names):
        return names[which]
    raise BadInput(f"there is no {what} {which!r}, expected one of: {', '.join(names) or 'none'}")


def _point(table, point, at):
    """Returns the name of a point in names of figures: "#3" by its index, "6000 rpm" by a value."""
    if isinstance(point, str) and at is None:
        point, at = None, point
    if (point is None) == (at is None):
        raise BadInput("a point is chosen by its index, or by a value of the parameter, at='6000 rpm': one of both")
    if at is not None:
        return value_text(at)
    count = int(np.prod(table.shape))
    if isinstance(point, (float, np.floating)):
        raise BadInput(f"the point is {point!r}, expected an index; a value of the parameter is at={float(point)!r}")
    if isinstance(point, (int, np.integer)) and not isinstance(point, bool) and 0 <= point < count:
        return f"#{int(point)}"
    raise BadInput(f"the table '{table.name}' has no point {point!r}, expected 0 to {count - 1}")
