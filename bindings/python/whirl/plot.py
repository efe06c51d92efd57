"""Figures in Matplotlib as the report draws them, fit for a paper.

Every function takes the axes to draw into, or makes a figure; it returns the axes, and passes further keywords on to
Matplotlib. Lengths, amplitudes and parameters are in the units of reports: those of the case, or of
:meth:`whirl.Result.show_in`.
"""

import numpy as np

from ._kinds import ATTRACTORS, REGIMES, attractor_colour, classes, kinds_of, points_once  # noqa: F401 (public here)
from ._planes import axis_of, cover_of, spread
from .errors import BadInput

_SPECIAL = {
    1: ("fold", "s"),
    2: ("crossing", "D"),
    3: ("period doubling", "^"),
    4: ("Neimark-Sacker", "o"),
    5: ("Hopf", "v"),
    6: ("grazing", "x"),
}


def _axes(ax):
    if ax is not None:
        return ax
    import matplotlib.pyplot as plt

    return plt.subplots(figsize=(7.0, 4.2), layout="constrained")[1]


def _degrees():
    from matplotlib.ticker import MaxNLocator

    return MaxNLocator(steps=[1, 1.5, 3, 4.5, 9, 10])


class Plots:
    """Figures of a result: ``result.plot.bifurcation()``."""

    def __init__(self, result):
        self._result = result

    # ---------------------------------------------------------------- what is drawn, and its units

    def _table(self, table, needs, analysis, every=False):
        """The table of that name, or the first that has a field."""
        tables = self._result.tables
        if table is not None:
            chosen = self._result[table]
            if needs not in chosen:
                raise BadInput(f"the table '{table}' has no '{needs}': add {analysis} to what the case analyses")
            return chosen
        for candidate in tables.values():
            if needs in candidate and (every or candidate.name != "detail"):
                return candidate
        raise BadInput(f"no table of the result has '{needs}': add {analysis} to what the case analyses")

    def _lengths(self, table):
        """What lengths of every point of the table are multiplied by."""
        return self._result._shown.lengths(table, self._result.length_scale)

    def _parameter(self, table, second=False):
        """Values of the parameter in its unit, and a label."""
        shown, name = self._result._shown, table.second if second else table.parameter
        values = table.second_values if second else table.values
        return values / shown.size(name), shown.parameter_label(name)

    def _displacement(self, what):
        return self._result._shown.length_label(what)

    def _amplitude(self, station):
        return self._result._shown.amplitude_label(f"amplitude of {station}")

    def _amplitudes(self, table):
        """What amplitudes of every point of the table are multiplied by."""
        return self._lengths(table) * self._result._shown.amplitude

    def _station(self, table, station):
        """Its index and its name; the first one where none is named."""
        index = table.station(station if station is not None else 0)
        return index, self._result.stations[index].name

    # ---------------------------------------------------------------- along a parameter

    def bifurcation(self, table=None, station=None, coordinate="x", ax=None, **style):
        """Sections over the parameter, a point a revolution, in the colours of their regimes; where points have several
        starts, every attractor once, in a colour of its own.

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
        table, ax = self._table(table, "poincare/section", "poincare"), _axes(ax)
        index, name = self._station(table, station)
        factors = self._lengths(table)
        section = _flat(table, "poincare/section")
        sizes = section[:, index, :, {"x": 0, "y": 1}[coordinate]] * factors[:, None]
        values, label = self._parameter(table)
        places = np.broadcast_to(values.ravel()[:, None], sizes.shape)
        style = {
            "marker": ".",
            "markersize": 1.2,
            "markeredgewidth": 0,
            "linestyle": "none",
            "rasterized": True,
            **style,
        }
        chosen = points_once(table)
        kinds = kinds_of(table)
        if kinds is None or "color" in style:
            ax.plot(places[chosen].ravel(), sizes[chosen].ravel(), **{"color": "black", **style})
        else:
            for kind, colour, title in kinds.shown:
                of = chosen[kinds.of[chosen] == kind]
                ax.plot(places[of].ravel(), sizes[of].ravel(), **{"color": colour, "label": title, **style})
            ax.legend(loc="best", frameon=False, fontsize="small", title=kinds.title, **_large_markers())
        ax.set(xlabel=label, ylabel=self._displacement(f"{coordinate} of {name}"))
        return ax

    def shares(self, table=None, ax=None, **style):
        """Of several starts a point, the share that leads to each attractor, with its standard error; open circles where
        it is 0: an attractor that was found from a neighbour alone."""
        table, ax = self._starts(table), _axes(ax)
        values, label = self._parameter(table)
        at, number = points_once(table), table.attractors.ravel()
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
        ax.legend(loc="best", frameon=False, fontsize="small", title="attractor")
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

    def lyapunov(self, table=None, ax=None, **style):
        """The largest Lyapunov exponent over the parameter, with its error as a band."""
        table, ax = self._table(table, "lyapunov/largest", "lyapunov"), _axes(ax)
        values, label = self._parameter(table)
        order = np.argsort(values.ravel(), kind="stable")
        at, size = values.ravel()[order], table["lyapunov/largest"].ravel()[order]
        error = table["lyapunov/error"].ravel()[order]
        (line,) = ax.plot(at, size, **{"color": "black", "linewidth": 0.8, **style})
        ax.fill_between(at, size - error, size + error, color=line.get_color(), alpha=0.2, linewidth=0)
        ax.axhline(0.0, color="0.6", linewidth=0.6, zorder=0)
        ax.set(xlabel=label, ylabel="largest exponent (1/revolution)")
        return ax

    def branches(self, table="branch", station=None, coordinate="x", ax=None, **style):
        """Branches of orbits: the largest displacement, stable solid, unstable dashed, special points by their kinds."""
        table, ax = self._table(table, "trace/high", "branch"), _axes(ax)
        index, name = self._station(table, station)
        factors = self._lengths(table)
        values, label = self._parameter(table)
        highs = table["trace/high"][:, index, {"x": 0, "y": 1}[coordinate]] * factors
        number, stable = table["trace/number"], table["trace/unstable"] == 0
        colours = [f"C{i % 10}" for i in range(int(number.max()))] if len(number) else []
        for branch in np.unique(number).astype(int):
            own = np.flatnonzero(number == branch)
            for first, last in _runs(stable[own]):
                piece = own[first : last + 2]  # up to the point where stability has changed
                line = "-" if stable[own[first]] else "--"
                ax.plot(values[piece], highs[piece], **{"linestyle": line, "color": colours[branch - 1], **style})
        self._special(ax, table, values, highs)
        ax.set(xlabel=label, ylabel=self._displacement(f"largest {coordinate} of {name}"))
        return ax

    @staticmethod
    def _special(ax, table, values, highs):
        """Marks of special points with their values, and what the marks mean."""
        special = table["trace/special"]
        for kind, (title, marker) in _SPECIAL.items():
            chosen = np.flatnonzero(special == kind)
            if len(chosen) == 0:
                continue
            look = {"color": "black"} if marker == "x" else {"facecolor": "white", "edgecolor": "black"}
            ax.scatter(values[chosen], highs[chosen], marker=marker, s=28, zorder=3, label=title, **look)
            for point in chosen:
                place = (values[point], highs[point])
                text = f"{values[point]:.6g}"
                ax.annotate(text, place, xytext=(4, 4), textcoords="offset points", fontsize="x-small")
        if (special > 0).any():
            ax.legend(loc="best", frameon=False, fontsize="small")

    # ---------------------------------------------------------------- machines at rest

    def _frequency(self, table):
        """The unit of frequencies: that of the parameter where it is the speed of the shaft, else Hz; and its size."""
        speed = table["modes/speed"]
        if not np.allclose(speed, table.values, rtol=1e-9, atol=0.0, equal_nan=True):
            return "Hz", 2.0 * np.pi
        return self._result._shown.unit(table.parameter) or "rad/s", self._result._shown.size(table.parameter)

    def campbell(self, table=None, ax=None, **style):
        """Natural frequencies over the parameter, in the unit of the speed, or in Hz: forward blue, backward vermilion.

        Critical speeds (circles) and thresholds of stability (crosses) have their values beside them; the dashed line
        is once a revolution.
        """
        table, ax = self._table(table, "modes/frequency", "modes"), _axes(ax)
        values, label = self._parameter(table)
        unit, size = self._frequency(table)
        frequency, direction = table["modes/frequency"] / size, table["modes/direction"]
        places = np.broadcast_to(values[:, None], frequency.shape)
        for title, colour, marker, of in (
            ("forward", "#0072B2", "^", direction > 0.05),
            ("backward", "#D55E00", "v", direction < -0.05),
            ("neither", "#606060", "o", np.abs(direction) <= 0.05),
        ):
            of = of & np.isfinite(frequency)
            if of.any():
                own = {"linestyle": "none", "marker": marker, "markersize": 3, "color": colour, "label": title, **style}
                ax.plot(places[of], frequency[of], **own)
        ax.plot(values, table["modes/speed"] / size, color="0.6", linewidth=0.8, linestyle="--", label="1X", zorder=0)
        self._critical(ax, table, size)
        ax.set(xlabel=label, ylabel=f"damped frequency ({unit})")
        # Modes far above all speeds would press the others together.
        once = 2.0 * np.nanmax(table["modes/speed"]) / size
        ax.set_ylim(0.0, min(ax.get_ylim()[1], once) if once > 0.0 else None)
        ax.legend(loc="best", frameon=False, fontsize="small")
        return ax

    def _critical(self, ax, table, size):
        """Marks of critical speeds and thresholds, with their values."""
        own = self._result._shown.size(table.parameter)
        rows = table["modes/critical"].reshape(-1, 6)
        rows = rows[np.isfinite(rows[:, 1]) & (rows[:, 0] > 0)]
        for title, marker, chosen in (("critical speed", "o", rows[:, 0] == 1), ("threshold", "x", rows[:, 0] > 1)):
            at, height = rows[chosen, 1] / own, rows[chosen, 3] / size
            if len(at) == 0:
                continue
            look = {"facecolor": "none", "edgecolor": "black"} if marker == "o" else {"color": "#CC0000"}
            ax.scatter(at, height, marker=marker, s=36, zorder=3, label=title, **look)
            for place in zip(at, height):
                text = f"{place[0]:.5g}"
                ax.annotate(text, place, xytext=(5, -8), textcoords="offset points", fontsize="x-small")

    def bode(self, table=None, station=None, ax=None, **style):
        """The response to unbalance: amplitude along x and y over the parameter, and its lag below.

        ``ax`` is a pair of axes; the pair is returned.
        """
        table = self._table(table, "unbalance/amplitude", "unbalance")
        if ax is None:
            import matplotlib.pyplot as plt

            ax = plt.subplots(2, sharex=True, figsize=(7.0, 5.6), layout="constrained")[1]
        above, below = ax
        index, name = self._station(table, station)
        factors = self._amplitudes(table)
        values, label = self._parameter(table)
        for axis, colour in enumerate(("#0072B2", "#D55E00")):
            own = {"color": colour, "linewidth": 1.0, "label": "xy"[axis], **style}
            above.plot(values, table["unbalance/amplitude"][:, index, axis] * factors, **own)
            below.plot(values, table["unbalance/lag"][:, index, axis], **own)
        above.set(ylabel=self._amplitude(name))
        above.set_ylim(bottom=0.0)
        above.legend(loc="best", frameon=False, fontsize="small")
        below.set(xlabel=label, ylabel="lag (degrees)")
        below.yaxis.set_major_locator(_degrees())
        return above, below

    # ---------------------------------------------------------------- one point

    def poincare(self, point, table=None, station=None, ax=None, **style):
        """The section of a point: where the station is once a revolution.

        ``point`` is an index, or the value of the parameter in SI, of which the nearest point is taken.
        """
        table, ax = self._table(table, "poincare/section", "poincare"), _axes(ax)
        index, name = self._station(table, station)
        at = _index(table, point)
        factors = self._lengths(table)
        section = _flat(table, "poincare/section")[at, index]
        ax.plot(
            section[:, 0] * factors[at], section[:, 1] * factors[at], **{"marker": ".", "ls": "none", "c": "k", **style}
        )
        ax.set(xlabel=self._displacement(f"x of {name}"), ylabel=self._displacement(f"y of {name}"), aspect="equal")
        ax.set_title(self._title(table, at), fontsize="medium")
        return ax

    def orbit(self, point, table=None, station=None, ax=None, **style):
        """The path of a station at a point, with a mark at every revolution where sections were taken."""
        table, ax = self._table(table, "waveform/samples", "waveform", every=True), _axes(ax)
        index, name = self._station(table, station)
        at = _index(table, point)
        factors = self._lengths(table)
        path = _flat(table, "waveform/samples")[at, index] * factors[at]
        ax.plot(path[:, 0], path[:, 1], **{"color": "black", "linewidth": 0.8, **style})
        if "poincare/section" in table:
            revolutions = max(1, len(path) // int(table.options["samples_per_revolution"]))
            marks = _flat(table, "poincare/section")[at, index, -revolutions:, :2] * factors[at]
            ax.plot(
                marks[:, 0], marks[:, 1], linestyle="none", marker="o", markersize=3, color=REGIMES["quasi-periodic"]
            )
        ax.set(xlabel=self._displacement(f"x of {name}"), ylabel=self._displacement(f"y of {name}"), aspect="equal")
        ax.set_title(self._title(table, at), fontsize="medium")
        return ax

    def spectrum(self, point, table=None, station=None, full=True, ax=None, **style):
        """The lines of a point's spectrum over the order: forward and backward whirl, or x alone (``full=False``)."""
        table, ax = self._table(table, "spectrum/lines", "spectrum"), _axes(ax)
        index, name = self._station(table, station)
        at = _index(table, point)
        factors = self._amplitudes(table)
        lines = _flat(table, "spectrum/lines")[at, index]
        lines = lines[np.isfinite(lines[:, 0])]
        order, amplitudes = lines[:, 0], lines[:, 1:] * factors[at]
        style = {"color": "black", "linewidth": 1.2, **style}
        if full:
            ax.vlines(order, 0.0, amplitudes[:, 2], **style)
            ax.vlines(-order, 0.0, amplitudes[:, 3], **style)
            ax.axvline(0.0, color="0.6", linewidth=0.6, zorder=0)
        else:
            ax.vlines(order, 0.0, amplitudes[:, 0], **style)
        ax.set(xlabel="order, backward below 0" if full else "order", ylabel=self._amplitude(name))
        ax.set_ylim(bottom=0.0)
        ax.set_title(self._title(table, at), fontsize="medium")
        return ax

    def waterfall(self, table=None, station=None, full=True, highest_order=None, ax=None, **style):
        """The lines of all spectra over order and parameter: the darker, the larger, to a thousandth of the largest."""
        table, ax = self._table(table, "spectrum/lines", "spectrum"), _axes(ax)
        index, name = self._station(table, station)
        factors = self._amplitudes(table)
        values, label = self._parameter(table)
        lines = _flat(table, "spectrum/lines")[:, index]
        order = lines[:, :, 0]
        sides = ((order, lines[:, :, 3]), (-order, lines[:, :, 4])) if full else ((order, lines[:, :, 1]),)
        places = np.broadcast_to(values.ravel()[:, None], order.shape)
        at = np.concatenate([side[0].ravel() for side in sides])
        height = np.concatenate([places.ravel()] * len(sides))
        size = np.concatenate([(side[1] * factors[:, None]).ravel() for side in sides])
        keep = np.isfinite(at) & (size > 1e-3 * np.nanmax(size))
        if highest_order is not None:
            keep &= np.abs(at) <= highest_order
        first = np.argsort(size[keep], kind="stable")  # the largest above all others
        drawn = ax.scatter(
            at[keep][first],
            height[keep][first],
            c=size[keep][first],
            **{"s": 6, "norm": "log", "cmap": "viridis_r", "linewidths": 0, "rasterized": True, **style},
        )
        ax.figure.colorbar(drawn, ax=ax, label=self._amplitude(name))
        ax.set(xlabel="order, backward below 0" if full else "order", ylabel=label)
        return ax

    def _title(self, table, at):
        value = table.values.ravel()[at]
        where = self._result._shown.value(table.parameter, value) if table.parameter else table.name
        verdict = table.verdicts.ravel()[at] if "regime/code" in table else ""
        return f"{where}: {verdict}" if verdict else where

    # ---------------------------------------------------------------- planes

    def map(self, field=None, table=None, which=0, plane=0, ax=None, **style):
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
        plane : int
            Of a map over three parameters, from 0 in the order of the third one's values.
        """
        table = self._plane(table)
        if not 0 <= plane < table.planes:
            raise BadInput(f"the table '{table.name}' has {table.planes} planes, from 0, and no plane {plane}")
        kinds = kinds_of(table, attractors=table.name == "basin") if field is None else None
        if kinds is None and field is None:
            raise BadInput(f"the table '{table.name}' has no verdicts: add regime to what the case analyses")
        ax, cover = _axes(ax), cover_of(table, plane)
        (x, xlabel), (y, ylabel) = self._parameter(table), self._parameter(table, second=True)
        x, y = axis_of(x, cover, 0), axis_of(y, cover, 1)
        if field is None:
            self._regimes(ax, x, y, kinds, cover, style)
        else:
            numbers, name = self._numbers(table, field, which)
            mesh = ax.pcolormesh(x, y, spread(numbers, cover), **{"rasterized": True, "shading": "nearest", **style})
            ax.figure.colorbar(mesh, ax=ax, label=name)
        ax.set(xlabel=xlabel, ylabel=ylabel)
        if table.third:
            there = table.third_values.ravel()[cover[cover >= 0][:1]]
            ax.set_title(" ".join(self._result._shown.value(table.third, value) for value in there))
        return ax

    def _plane(self, table):
        if table is not None:
            return self._result[table]
        for candidate in self._result.tables.values():
            if candidate.name in ("map", "basin"):
                return candidate
        raise BadInput("the result has no map: 'study: {map: {x: ..., y: ...}}' in a case computes one")

    def _numbers(self, table, field, which):
        about, numbers = table.fields.get(field), table[field]
        if about.extent == "station":
            index, name = self._station(table, which)
        else:
            index = self._result.contacts.index(which) if isinstance(which, str) else which
            name = self._result.contacts[index] if about.extent == "contact" else ""
        numbers = numbers.reshape(int(np.prod(table.shape)), -1)[:, index if about.extent != "point" else 0]
        title = about.meaning.split(" (")[0] + (f" of {name}" if name else "")
        if about.unit == "length":
            return numbers * self._lengths(table), self._displacement(title)
        return numbers, title if about.unit == "1" else f"{title} ({about.unit})"

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


def _large_markers():
    """Pixels of a diagram are too small for a legend."""
    from matplotlib.legend_handler import HandlerLine2D

    class Larger(HandlerLine2D):
        def create_artists(self, *arguments):
            artists = super().create_artists(*arguments)
            for artist in artists:
                artist.set_marker("o")
                artist.set_markersize(4)
            return artists

    from matplotlib.lines import Line2D

    return {"handler_map": {Line2D: Larger(numpoints=1)}}


def _index(table, point):
    """The index of a point; a float is a value of the parameter in SI."""
    at = table.at(point) if isinstance(point, (float, np.floating)) else int(point)
    if not 0 <= at < int(np.prod(table.shape)):
        raise BadInput(f"the table '{table.name}' has no point {at}, expected 0 to {int(np.prod(table.shape)) - 1}")
    return at


def _flat(table, field):
    """A field with its points in one list, also of a map."""
    numbers = table[field]
    return numbers.reshape((-1,) + numbers.shape[len(table.shape) :])


def _runs(flags):
    """First and last index of every run of equal flags."""
    if len(flags) == 0:
        return []
    ends = np.flatnonzero(np.diff(flags.astype(int)))
    return list(zip(np.concatenate(([0], ends + 1)), np.concatenate((ends, [len(flags) - 1]))))
