"""What all figures need of Matplotlib: axes, marks that few and many points can be seen by, labels that stay apart."""

import functools

import numpy as np


def new_axes(ax):
    """Those that were given, or those of a new figure."""
    if ax is not None:
        return ax
    import matplotlib.pyplot as plt

    return plt.subplots(figsize=(7.0, 4.2), layout="constrained")[1]


def mark_size(count):
    """Of a point, where there are so many: a hundred are seen as dots, a hundred thousand as a cloud of pixels."""
    return float(np.interp(np.log10(max(count, 1)), [2.0, 4.5], [4.0, 1.2]))


def legend(ax, **more):
    """A legend whose marks are large enough to be told apart, whatever those of the figure are."""
    look = {"loc": "best", "frameon": False, "fontsize": "small", "numpoints": 1, **more}
    made = ax.legend(**look)
    for handle in getattr(made, "legend_handles", None) or made.legendHandles:  # its name up to Matplotlib 3.6
        if getattr(handle, "get_marker", lambda: "")() == ".":
            handle.set_marker("o")
            handle.set_markersize(4)


def label_values(ax, x, y, texts, offset=(4, 4)):
    """Texts beside points, without those that would lie on one that is there already."""
    ax.autoscale_view()
    across, up = 44, 10  # pixels at 100 dots an inch that a number of six digits takes
    placed = []
    for at in np.argsort(x, kind="stable"):
        here = ax.transData.transform((x[at], y[at])) * 100.0 / ax.figure.dpi
        if any(abs(here[0] - other[0]) < across and abs(here[1] - other[1]) < up for other in placed):
            continue
        placed.append(here)
        ax.annotate(texts[at], (x[at], y[at]), xytext=offset, textcoords="offset points", fontsize="x-small")


def keep_span(ax, sizes):
    """Shows what varies by rounding alone as the constant that it is."""
    sizes = np.asarray(sizes)[np.isfinite(sizes)]
    if sizes.size and np.ptp(sizes) <= 1e-7 * np.abs(sizes).max():
        middle = 0.5 * (sizes.min() + sizes.max())
        half = 0.1 * abs(middle) or 1.0
        ax.set_ylim(middle - half, middle + half)


def runs(flags):
    """First and last index of every run of equal flags."""
    if len(flags) == 0:
        return []
    ends = np.flatnonzero(np.diff(np.asarray(flags).astype(int)))
    return list(zip(np.concatenate(([0], ends + 1)), np.concatenate((ends, [len(flags) - 1]))))


def broken(angles):
    """Degrees with NaN put in where they jump by half a turn or more; and where the points of these go."""
    angles = np.asarray(angles, dtype=float)
    jumps = np.flatnonzero(np.abs(np.diff(angles)) >= 180.0) + 1
    return np.insert(angles, jumps, np.nan), jumps


def scaled(figures):
    """A class whose figures take ``xscale`` and ``yscale`` ("log", ...) for the axes that they return."""

    def with_scales(draw):
        @functools.wraps(draw)
        def figure(*given, **style):
            scales = {axis: style.pop(f"{axis}scale") for axis in "xy" if f"{axis}scale" in style}
            drawn = draw(*given, **style)
            for ax in drawn if isinstance(drawn, tuple) else (drawn,):
                for axis, scale in scales.items():
                    getattr(ax, f"set_{axis}scale")(scale)
                if scales.get("y") == "log" and ax.dataLim.minposy > 0:
                    ax.set_ylim(bottom=0.5 * ax.dataLim.minposy)
            return drawn

        return figure

    for name, draw in list(vars(figures).items()):
        if callable(draw) and not name.startswith("_"):
            setattr(figures, name, with_scales(draw))
    return figures
