"""Figures in Matplotlib as the report draws them, fit for a paper.

Every function takes the axes to draw into, or makes a figure; it returns the axes, and passes further keywords on to
Matplotlib, ``yscale="log"`` to the axes. Lengths, amplitudes and parameters are in the units of reports: those of the
case, or of :meth:`whirl.Result.show_in`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ._kinds import ATTRACTORS, REGIMES, attractor_colour, classes, kinds_of, points_once
from ._marks import broken, keep_span, label_values, legend, mark_size, new_axes, runs, scaled
from ._planes import axis_of, cover_of, spread
from .errors import BadInput
from .fields import FIELD

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .result import Result

__all__ = ["ATTRACTORS", "REGIMES", "Plots", "attractor_colour", "classes"]

_SPECIAL = {
    1: ("fold", "s"),
    2: ("crossing", "D"),
    3: ("period doubling", "^"),
    4: ("Neimark-Sacker", "o"),
    5: ("Hopf", "v"),
    6: ("grazing", "x"),
}
_ADVICE = {
    FIELD.TRACE_HIGH: "'study: {branch: ...}' in a case follows branches",
    FIELD.TRACE_SECOND: "'study: {branch: ..., curves: ...}' in a case follows them",
    FIELD.MODES_FREQUENCY: "add modes to what the case analyses",
    FIELD.UNBALANCE_AMPLITUDE: "add unbalance to what the case analyses",
}
_DIRECTIONS = (("forward", "#0072B2", "^"), ("backward", "#D55E00", "v"), ("neither", "#606060", "o"))


@scaled
class Plots:
    """Figures of a result: ``result.plot.bifurcation()``."""

    def __init__(self, result: Result):
        self._result = result

    # ---------------------------------------------------------------- what is drawn, and its units

    def _table(self, table, needs, every=False):
        """The table of that name, or the first that has a field."""
        advice = _ADVICE.get(needs, f"add {needs.split('/')[0]} to what the case analyses")
        if table is not None:
            chosen = self._result[table]
            if needs not in chosen:
                raise BadInput(f"the table '{table}' has no '{needs}': {advice}")
            return chosen
        for candidate in self._result.tables.values():
            if needs in candidate and (every or candidate.name != "detail"):
                return candidate
        raise BadInput(f"no table of the result has '{needs}': {advice}")

    def _lengths(self, table):
        """What lengths of every point of the table are multiplied by."""
        return self._result._shown.lengths(table, self._result.length_scale)

    def _amplitudes(self, table):
        """What amplitudes of every point of the table are multiplied by."""
        return self._lengths(table) * self._result._shown.counting()[1]

    def _parameter(self, table, second=False):
        """Values of the parameter in its unit, and a label."""
        shown, name = self._result._shown, table.second if second else table.parameter
        values = table.second_values if second else table.values
        return values / shown.size(name), shown.parameter_label(name)

    def _displacement(self, what):
        return self._result._shown.length_label(what)

    def _amplitude(self, station):
        shown = self._result._shown
        return shown.length_label(f"amplitude of {station}", shown.counting()[0])

    def _station(self, table, station):
        """Its index and its name; the first one where none is named."""
        index = table.station(station if station is not None else 0)
        return index, self._result.stations[index].name

    # ---------------------------------------------------------------- along a parameter

    def bifurcation(
        self,
        table: str | None = None,
        station: str | int | None = None,
        coordinate: str = "x",
        ax: Axes | None = None,
        **style,
    ) -> Axes:
        """Sections over the parameter, a point a revolution, in the colours of their regimes; where points have several
        starts, every attractor once, in a colour of its own. Points that were carried down have crosses.

        Parameters
        ----------
        table : str, optional
            "sweep", ...; the first that has sections.
        station : str or int, optional
            Whose; the first one.
        coordinate : str
            "x" or "y".
        ax : matplotlib.axes.Axes, optional
            Where to draw.
        style
            For ``Axes.plot``.
        """
        table = self._table(table, FIELD.POINCARE_SECTION)
        index, name = self._station(table, station)
        factors = self._lengths(table)
        sizes = _flat(table, FIELD.POINCARE_SECTION)[:, index, :, _axis(coordinate)] * factors[:, None]
        values, label = self._parameter(table)
        places = np.broadcast_to(values.ravel()[:, None], sizes.shape)
        chosen, kinds, ax = points_once(table), kinds_of(table), new_axes(ax)
        size = mark_size(len(chosen) * sizes.shape[1])
        look = {"marker": ".", "markersize": size, "markeredgewidth": 0, "linestyle": "none", "rasterized": True}
        if kinds is None or "color" in style:
            ax.plot(places[chosen].ravel(), sizes[chosen].ravel(), **{"color": "black", **look, **style})
        else:
            for kind, colour, title in kinds.shown:
                of = chosen[kinds.of[chosen] == kind]
                down = table.branch.ravel()[of] < 0 if not table.has_attractors else np.zeros(len(of), bool)
                if not down.all():
                    own = {"color": colour, "label": title, **look, **style}
                    ax.plot(places[of[~down]].ravel(), sizes[of[~down]].ravel(), **own)
                if down.any():
                    own = {**look, "color": colour, "marker": "x", "markeredgewidth": 0.4, "markersize": 1.5 * size}
                    ax.plot(places[of[down]].ravel(), sizes[of[down]].ravel(), **{**own, **style})
            if (table.branch < 0).any() and not table.has_attractors:
                ax.plot([], [], linestyle="none", marker="x", color="0.4", markersize=4, label="carried down")
            legend(ax, title=kinds.title)
        keep_span(ax, sizes)
        ax.set(xlabel=label, ylabel=self._displacement(f"{coordinate} of {name}"))
        return ax

    def shares(self, table: str | None = None, ax: Axes | None = None, **style) -> Axes:
        """Of several starts a point, the share that leads to each attractor, with its standard error; open circles
        where it is 0: an attractor that was found from a neighbour alone."""
        table = self._starts(table)
        values, label = self._parameter(table)
        at, number, ax = points_once(table), table.attractors.ravel(), new_axes(ax)
        share, error = 100.0 * table.shares.ravel(), 100.0 * table.share_errors.ravel()
        for kind in np.unique(number[at]):
            of = at[(number[at] == kind) & np.isfinite(share[at])]
            if kind == 0 or len(of) == 0:
                continue
            own = {"color": attractor_colour(kind), "linestyle": "none", "marker": "o", "markersize": 3, **style}
            held, found = of[share[of] > 0], of[share[of] == 0]
            ax.errorbar(values.ravel()[held], share[held], error[held], label=str(kind), elinewidth=0.6, **own)
            ax.plot(values.ravel()[found], share[found], **{**own, "markerfacecolor": "none"})
        ax.set(xlabel=label, ylabel="share of the starts (%)")
        legend(ax, title="attractor")
        return ax

    def _starts(self, table):
        """The table of that name, or the first, that has several starts a place."""
        tables = self._result.tables if table is None else {table: self._result[table]}
        for candidate in tables.values():
            if candidate.has_attractors and candidate.name != "basin":
                return candidate
        raise BadInput(
            "no points have several starts: 'study: {starts: {count: ..., within: ...}}' in a case gives them"
        )

    def lyapunov(self, table: str | None = None, ax: Axes | None = None, **style) -> Axes:
        """The largest Lyapunov exponent over the parameter with its standard error, in the colours of the regimes."""
        table = self._table(table, FIELD.LYAPUNOV_LARGEST)
        values, label = self._parameter(table)
        size, error = table[FIELD.LYAPUNOV_LARGEST].ravel(), table[FIELD.LYAPUNOV_ERROR].ravel()
        chosen, kinds, ax = points_once(table), kinds_of(table), new_axes(ax)
        look = {"linestyle": "none", "marker": ".", "markersize": mark_size(len(chosen)), "elinewidth": 0.5}
        plain = kinds is None or "color" in style
        for kind, colour, title in [(None, "black", None)] if plain else kinds.shown:
            of = chosen if plain else chosen[kinds.of[chosen] == kind]
            own = {"color": colour, "label": title, **look, **style}
            ax.errorbar(values.ravel()[of], size[of], error[of], **own)
        if not plain:
            legend(ax, title=kinds.title)
        ax.axhline(0.0, color="0.6", linewidth=0.6, zorder=0)
        ax.set(xlabel=label, ylabel="largest exponent (1/revolution)")
        return ax

    # ---------------------------------------------------------------- branches

    def branches(
        self,
        table: str | None = None,
        station: str | int | None = None,
        coordinate: str = "x",
        ax: Axes | None = None,
        **style,
    ) -> Axes:
        """Branches of orbits: the largest displacement, stable solid, unstable dashed, special points by their kinds.

        Tori that begin along them are broad green lines.
        """
        table = self._table(table, FIELD.TRACE_HIGH)
        index, name = self._station(table, station)
        axis = _axis(coordinate)
        values, label = self._parameter(table)
        highs = table[FIELD.TRACE_HIGH][:, index, axis] * self._lengths(table)
        number, stable, ax = table[FIELD.TRACE_NUMBER].astype(int), table[FIELD.TRACE_UNSTABLE] == 0, new_axes(ax)
        for branch in np.unique(number):
            own = np.flatnonzero(number == branch)
            for first, last in runs(stable[own]):
                piece = own[first : last + 2]  # up to the point where stability has changed
                line = "-" if stable[own[first]] else "--"
                look = {"linestyle": line, "color": f"C{(branch - 1) % 10}", **style}
                ax.plot(values[piece], highs[piece], **look)
        self._tori(ax, index, axis)
        self._special(ax, table, values, highs)
        ax.set(xlabel=label, ylabel=self._displacement(f"largest {coordinate} of {name}"))
        return ax

    def _tori(self, ax, index, axis):
        """The largest displacement on tori, solid where they are stable."""
        tori = self._result.tables.get("tori")
        if tori is None or FIELD.TORUS_HIGH not in tori:
            return
        values, highs = self._parameter(tori)[0], tori[FIELD.TORUS_HIGH][:, index, axis] * self._lengths(tori)
        number, unstable = tori[FIELD.TORUS_NUMBER].astype(int), tori[FIELD.TORUS_UNSTABLE] > 0
        for torus in np.unique(number):
            own = np.flatnonzero(number == torus)
            own = own[np.argsort(values[own], kind="stable")]
            look = {"color": "#009E73", "linewidth": 2.5, "alpha": 0.6, "marker": "." if len(own) == 1 else ""}
            title = "torus" if torus == number.min() else None
            ax.plot(values[own], highs[own], "--" if unstable[own].any() else "-", label=title, **look)

    @staticmethod
    def _special(ax, table, values, highs):
        """Marks of special points with their values, and what the marks mean."""
        special = table[FIELD.TRACE_SPECIAL]
        for kind, (title, marker) in _SPECIAL.items():
            chosen = np.flatnonzero(special == kind)
            if len(chosen):
                look = {"color": "black"} if marker == "x" else {"facecolor": "white", "edgecolor": "black"}
                ax.scatter(values[chosen], highs[chosen], marker=marker, s=28, zorder=3, label=title, **look)
        chosen = np.flatnonzero(special > 0)
        label_values(ax, values[chosen], highs[chosen], [f"{value:.6g}" for value in values[chosen]])
        if len(chosen):
            legend(ax)

    def curves(self, ax: Axes | None = None, **style) -> Axes:
        """Curves of special points over two parameters, by their kinds."""
        if "curves" not in self._result.tables:
            raise BadInput(f"the result has no curves: {_ADVICE['trace/second']}")
        table = self._result["curves"]
        if table.values.size == 0:
            raise BadInput("the table 'curves' has no point: no special point was found to begin a curve")
        (x, xlabel), (y, ylabel) = self._parameter(table), self._parameter(table, second=True)
        number, special, ax = table[FIELD.TRACE_NUMBER].astype(int), table[FIELD.TRACE_SPECIAL], new_axes(ax)
        kinds = {}
        for curve in np.unique(number):
            own = np.flatnonzero(number == curve)
            kind = int(special[own][special[own] > 0][0]) if (special[own] > 0).any() else 0
            title, _ = _SPECIAL.get(kind, ("other", ""))
            look = {"color": f"C{kind % 10}", "linewidth": 1.0, "label": None if kind in kinds else title, **style}
            kinds[kind] = ax.plot(x[own], y[own], **look)
        ax.set(xlabel=xlabel, ylabel=ylabel)
        legend(ax)
        return ax

    # ---------------------------------------------------------------- machines at rest

    def _frequency(self, table):
        """The unit of frequencies: that of the parameter where it is the speed of the shaft, else Hz; and its size."""
        speed = table[FIELD.MODES_SPEED]
        if not np.allclose(speed, table.values, rtol=1e-9, atol=0.0, equal_nan=True):
            return "Hz", 2.0 * np.pi
        return self._result._shown.unit(table.parameter) or "rad/s", self._result._shown.size(table.parameter)

    def campbell(self, table: str | None = None, ax: Axes | None = None, **style) -> Axes:
        """Natural frequencies over the parameter, in the unit of the speed, or in Hz: forward blue, backward vermilion.

        Critical speeds (circles) and thresholds of stability (crosses) have their values beside them; the dashed line
        is once a revolution.
        """
        table = self._table(table, FIELD.MODES_FREQUENCY)
        values, label = self._parameter(table)
        unit, size = self._frequency(table)
        frequency, direction, ax = table[FIELD.MODES_FREQUENCY] / size, table[FIELD.MODES_DIRECTION], new_axes(ax)
        places = np.broadcast_to(values[:, None], frequency.shape)
        sides = direction > 0.05, direction < -0.05, np.abs(direction) <= 0.05
        for (title, colour, marker), side in zip(_DIRECTIONS, sides):
            of = side & np.isfinite(frequency)
            if of.any():
                own = {"linestyle": "none", "marker": marker, "markersize": 3, "color": colour, "label": title, **style}
                ax.plot(places[of], frequency[of], **own)
        ax.plot(
            values, table[FIELD.MODES_SPEED] / size, color="0.6", linewidth=0.8, linestyle="--", label="1X", zorder=0
        )
        # Modes far above all speeds would press the others together.
        once = 2.0 * np.nanmax(table[FIELD.MODES_SPEED]) / size
        ax.set_ylim(0.0, min(ax.get_ylim()[1], once) if once > 0.0 else None)
        self._critical(ax, table, size)
        ax.set(xlabel=label, ylabel=f"damped frequency ({unit})")
        legend(ax)
        return ax

    def _critical(self, ax, table, size):
        """Marks of critical speeds and thresholds, with their values."""
        own = self._result._shown.size(table.parameter)
        rows = table[FIELD.MODES_CRITICAL].reshape(-1, 6)
        rows = rows[np.isfinite(rows[:, 1]) & (rows[:, 0] > 0)]
        at, height = rows[:, 1] / own, rows[:, 3] / size
        for title, marker, of in (("critical speed", "o", rows[:, 0] == 1), ("threshold", "x", rows[:, 0] > 1)):
            if of.any():
                look = {"facecolor": "none", "edgecolor": "black"} if marker == "o" else {"color": "#CC0000"}
                ax.scatter(at[of], height[of], marker=marker, s=36, zorder=3, label=title, **look)
        label_values(ax, at, height, [f"{value:.5g}" for value in at], offset=(5, -8))

    def bode(
        self, table: str | None = None, station: str | int | None = None, ax: tuple[Axes, Axes] | None = None, **style
    ) -> tuple[Axes, Axes]:
        """The response to unbalance: amplitude along x and y over the parameter, and its lag below.

        ``ax`` is a pair of axes; the pair is returned.
        """
        table = self._table(table, FIELD.UNBALANCE_AMPLITUDE)
        index, name = self._station(table, station)
        factors = self._amplitudes(table)
        values, label = self._parameter(table)
        if ax is None:
            import matplotlib.pyplot as plt

            ax = plt.subplots(2, sharex=True, figsize=(7.0, 5.6), layout="constrained")[1]
        above, below = ax
        for axis, colour in enumerate(("#0072B2", "#D55E00")):
            own = {"color": colour, "linewidth": 1.0, "label": "xy"[axis], **style}
            above.plot(values, table[FIELD.UNBALANCE_AMPLITUDE][:, index, axis] * factors, **own)
            lag, jumps = broken(table[FIELD.UNBALANCE_LAG][:, index, axis])
            below.plot(np.insert(values, jumps, np.nan), lag, **own)
        above.set(ylabel=self._amplitude(name))
        above.set_ylim(bottom=0.0)
        legend(above)
        below.set(xlabel=label, ylabel="lag (degrees)")
        below.yaxis.set_major_locator(_degrees())
        return above, below

    # ---------------------------------------------------------------- one point

    def poincare(
        self,
        point: int | float,
        table: str | None = None,
        station: str | int | None = None,
        ax: Axes | None = None,
        **style,
    ) -> Axes:
        """The section of a point: where the station is once a revolution.

        ``point`` is an index, or the value of the parameter in SI, of which the nearest point is taken.
        """
        table = self._table(table, FIELD.POINCARE_SECTION)
        index, at = self._station(table, station)[0], _index(table, point)
        section = _flat(table, FIELD.POINCARE_SECTION)[at, index] * self._lengths(table)[at]
        ax = new_axes(ax)
        ax.plot(section[:, 0], section[:, 1], **{"marker": ".", "ls": "none", "c": "k", **style})
        return self._plane_of_motion(ax, table, index, at)

    def orbit(
        self,
        point: int | float,
        table: str | None = None,
        station: str | int | None = None,
        ax: Axes | None = None,
        **style,
    ) -> Axes:
        """The path of a station at a point, with a mark at every revolution where sections were taken."""
        table = self._table(table, FIELD.WAVEFORM_SAMPLES, every=True)
        index, at = self._station(table, station)[0], _index(table, point)
        factor = self._lengths(table)[at]
        path, ax = _flat(table, FIELD.WAVEFORM_SAMPLES)[at, index] * factor, new_axes(ax)
        ax.plot(path[:, 0], path[:, 1], **{"color": "black", "linewidth": 0.8, **style})
        if FIELD.POINCARE_SECTION in table:
            revolutions = max(1, len(path) // int(table.options["samples_per_revolution"]))
            marks = _flat(table, FIELD.POINCARE_SECTION)[at, index, -revolutions:, :2] * factor
            look = {"linestyle": "none", "marker": "o", "markersize": 3, "color": REGIMES["quasi-periodic"]}
            ax.plot(marks[:, 0], marks[:, 1], **look)
        return self._plane_of_motion(ax, table, index, at)

    def _plane_of_motion(self, ax, table, index, at):
        """Labels of the plane in which a station moves."""
        x, y = (self._displacement(f"{axis} of {self._result.stations[index].name}") for axis in "xy")
        ax.set(xlabel=x, ylabel=y, aspect="equal")
        ax.set_title(self._title(table, at), fontsize="medium")
        return ax

    def spectrum(
        self,
        point: int | float,
        table: str | None = None,
        station: str | int | None = None,
        full: bool = True,
        ax: Axes | None = None,
        **style,
    ) -> Axes:
        """The lines of a point's spectrum over the order: forward and backward whirl, or x alone (``full=False``)."""
        table = self._table(table, FIELD.SPECTRUM_LINES)
        index, name = self._station(table, station)
        at, ax = _index(table, point), new_axes(ax)
        lines = _flat(table, FIELD.SPECTRUM_LINES)[at, index]
        lines = lines[np.isfinite(lines[:, 0])]
        order, (x, _, forward, backward) = lines[:, 0], lines[:, 1:].T * self._amplitudes(table)[at]
        style = {"color": "black", "linewidth": 1.2, **style}
        if full:
            ax.vlines(order, 0.0, forward, **style)
            ax.vlines(-order, 0.0, backward, **style)
            ax.axvline(0.0, color="0.6", linewidth=0.6, zorder=0)
        else:
            ax.vlines(order, 0.0, x, **style)
        ax.set(xlabel="order, backward below 0" if full else "order", ylabel=self._amplitude(name))
        ax.set_ylim(bottom=0.0)
        ax.set_title(self._title(table, at), fontsize="medium")
        return ax

    def waterfall(
        self,
        table: str | None = None,
        station: str | int | None = None,
        full: bool = True,
        highest_order: float | None = None,
        ax: Axes | None = None,
        **style,
    ) -> Axes:
        """The lines of all spectra over order and parameter: the darker, the larger, to a thousandth of the largest."""
        table = self._table(table, FIELD.SPECTRUM_LINES)
        index, name = self._station(table, station)
        values, label = self._parameter(table)
        order, x, _, forward, backward = np.moveaxis(_flat(table, FIELD.SPECTRUM_LINES)[:, index], -1, 0)
        sides = ((order, forward), (-order, backward)) if full else ((order, x),)
        places = np.broadcast_to(values.ravel()[:, None], order.shape)
        at = np.concatenate([side[0].ravel() for side in sides])
        height = np.concatenate([places.ravel()] * len(sides))
        size = np.concatenate([(side[1] * self._amplitudes(table)[:, None]).ravel() for side in sides])
        keep = np.isfinite(at) & (size > 0.0)
        keep &= size > 1e-3 * np.max(size[keep], initial=0.0)
        if highest_order is not None:
            keep &= np.abs(at) <= highest_order
        first, ax = np.argsort(size[keep], kind="stable"), new_axes(ax)  # the largest above all others
        at, height, size = (each[keep][first] for each in (at, height, size))
        flat = size.size == 0 or size[0] > 0.999 * size[-1]  # a scale of equal numbers would have equal labels
        look = {"s": 6, "norm": "linear" if flat else "log", "cmap": "viridis_r", "linewidths": 0, "rasterized": True}
        if flat:
            look.update(vmin=0.0, vmax=1.1 * np.max(size, initial=1e-300))
        drawn = ax.scatter(at, height, c=size, **{**look, **style})
        ax.figure.colorbar(drawn, ax=ax, label=self._amplitude(name))
        ax.set(xlabel="order, backward below 0" if full else "order", ylabel=label)
        return ax

    def _title(self, table, at):
        value = table.values.ravel()[at]
        where = self._result._shown.value(table.parameter, value) if table.parameter else table.name
        verdict = table.verdicts.ravel()[at] if FIELD.REGIME_CODE in table else ""
        return f"{where}: {verdict}" if verdict else where

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
        """Regimes over two parameters, paler where confidence is low; or a field's numbers. Of a basin the attractors
        that its starts lead to. Where points have several starts, what most of them lead to.

        Parameters
        ----------
        field : str, optional
            "orbit/max_radius", "lyapunov/largest", ...; regimes without it.
        table : str, optional
            "map" or "basin"; the first that has two parameters.
        which : int or str
            Station or contact of the field.
        column : int or str
            Of a field with several columns: "y" of "orbit/mean".
        plane : int
            Of a map over three parameters, from 0 in the order of the third one's values.
        """
        table = self._plane(table)
        if not 0 <= plane < table.planes:
            raise BadInput(f"the table '{table.name}' has {table.planes} planes, from 0, and no plane {plane}")
        kinds = kinds_of(table, attractors=table.name == "basin") if field is None else None
        if kinds is None and field is None:
            raise BadInput(f"the table '{table.name}' has no verdicts: add regime to what the case analyses")
        numbers, name = (None, None) if field is None else self._numbers(table, field, which, column)
        cover = cover_of(table, plane)
        if not (cover >= 0).any():
            raise BadInput(f"the table '{table.name}' has no point that is done")
        (x, xlabel), (y, ylabel) = self._parameter(table), self._parameter(table, second=True)
        x, y, ax = axis_of(x, cover, 0), axis_of(y, cover, 1), new_axes(ax)
        if field is None:
            self._regimes(ax, x, y, kinds, cover, style)
        else:
            mesh = ax.pcolormesh(x, y, spread(numbers, cover), **{"rasterized": True, "shading": "nearest", **style})
            ax.figure.colorbar(mesh, ax=ax, label=name)
        ax.set(xlabel=xlabel, ylabel=ylabel)
        if table.third:
            there = table.third_values.ravel()[cover[cover >= 0][:1]]
            ax.set_title(" ".join(self._result._shown.value(table.third, value) for value in there))
        return ax

    def _plane(self, table):
        for candidate in self._result.tables.values() if table is None else [self._result[table]]:
            if candidate.name in ("map", "basin"):
                return candidate
        raise BadInput("the result has no map: 'study: {map: {x: ..., y: ...}}' in a case computes one")

    def _numbers(self, table, field, which, column):
        """A number of every point, in the unit that is shown, and what it is called."""
        about, numbers = table._field(field), table[field]
        if about.rows != 1:
            raise BadInput(f"'{field}' has {about.rows} rows at every point, expected a field with one")
        owner, name = 0, ""
        if about.extent == "station":
            owner, name = self._station(table, which)
        elif about.extent == "contact":
            owner = _chosen(which, self._result.contacts, "contact")
            name = self._result.contacts[owner]
        columns = about.column_names or [str(i) for i in range(about.columns)]
        column = _chosen(column, columns, f"column of '{field}'")
        numbers = numbers.reshape(int(np.prod(table.shape)), about.repeat, about.columns)[:, owner, column]
        what = columns[column] if about.columns > 1 else about.meaning.split(" (")[0]
        title = " ".join([what, *(["of", name] if name else [])])
        if about.unit == "length" and what != "order":
            counted, factor = self._result._shown.counting(about.meaning)
            return numbers * self._lengths(table) * factor, self._result._shown.length_label(title, counted)
        if about.unit == "force":
            return numbers * self._result.force_scale, f"{title} (N)"
        return numbers, title if about.unit in ("1", "length") else f"{title} ({about.unit})"

    @staticmethod
    def _regimes(ax, x, y, kinds, cover, style):
        from matplotlib.colors import to_rgba_array
        from matplotlib.patches import Patch

        colours = to_rgba_array([colour for _, colour, _ in kinds.shown])
        rank = {kind: i for i, (kind, _, _) in enumerate(kinds.shown)}
        cells = colours[[rank[kind] for kind in kinds.of]]
        cells[:, 3] = kinds.opacity
        cells = np.where((cover >= 0)[..., None], cells[cover], 0.0)
        mesh = ax.pcolormesh(x, y, cover, **{"rasterized": True, "shading": "nearest", **style})
        mesh.set_array(None)  # colours of their own for the cells; Matplotlib before 3.7 takes none in pcolormesh
        mesh.set_facecolor(cells.reshape(-1, 4))
        there = np.unique(kinds.of[cover[cover >= 0]])
        shown = [Patch(color=colour, label=title) for kind, colour, title in kinds.shown if kind in there]
        look = {"loc": "center left", "bbox_to_anchor": (1.01, 0.5), "frameon": False, "fontsize": "small"}
        ax.legend(handles=shown, title=kinds.title, **look)


def _axis(coordinate):
    if coordinate not in ("x", "y"):
        raise BadInput(f"the coordinate is {coordinate!r}, expected 'x' or 'y'")
    return "xy".index(coordinate)


def _chosen(which, names, what):
    """The index of a name, or an index that there is."""
    if isinstance(which, str) and which in names:
        return names.index(which)
    if isinstance(which, (int, np.integer)) and 0 <= which < len(names):
        return int(which)
    raise BadInput(f"there is no {what} {which!r}, expected one of: {', '.join(names) or 'none'}")


def _degrees():
    from matplotlib.ticker import MaxNLocator

    return MaxNLocator(steps=[1, 1.5, 3, 4.5, 9, 10])


def _index(table, point):
    """The index of a point; a float is a value of the parameter in SI."""
    count = int(np.prod(table.shape))
    if isinstance(point, (float, np.floating)):
        return table.at(point)
    if isinstance(point, (int, np.integer)) and 0 <= point < count:
        return int(point)
    raise BadInput(f"the table '{table.name}' has no point {point}, expected 0 to {count - 1}")


def _flat(table, field):
    """A field with its points in one list, also of a map."""
    numbers = table[field]
    return numbers.reshape((-1,) + numbers.shape[len(table.shape) :])
