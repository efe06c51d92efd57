"""Draws figures described by the library (docs/figures.md) in Matplotlib by panels, axes and series."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import numpy as np

from . import errors
from ._library import check, ffi, lib, taken, word_bytes

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_MARKS = {
    "disc": ("o", True),
    "ring": ("o", False),
    "square": ("s", True),
    "frame": ("s", False),
    "up": ("^", True),
    "down": ("v", True),
    "diamond": ("D", True),
    "cross": ("x", True),
}
_CM = 1.0 / 2.54
_DASHES = (0, (4, 2.5))
_LOW_PANEL = 0.7  # cm; upright labels do not fit next to panels that are lower than this


def _word(value):
    return ffi.NULL if value is None else word_bytes(value)


def names_of(handle) -> dict[str, str]:
    """Returns names and titles of the figures of a result."""
    out = ffi.new("char **")
    check(lib.whirl_result_figures(handle, ffi.NULL, out))
    return dict(line.split("\t", 1) for line in taken(out).splitlines())


def describe(handle, name, units, panels, log, other=None) -> dict[str, Any]:
    """Returns the document of a figure; `other`: the handle of a result that is drawn into it."""
    out = ffi.new("char **")
    chosen = ",".join(panels) if isinstance(panels, (list, tuple)) else panels
    words = _word(name), _word(units), _word(chosen), _word(log)
    check(lib.whirl_result_figure_with(handle, ffi.NULL if other is None else other, *words, out))
    return json.loads(taken(out))


# ---------------------------------------------------------------- series


def _numbers(series, key):
    return np.array([np.nan if value is None else value for value in series.get(key, [])], dtype=float)


def _dots(ax, series, x, y, own):
    marker, filled = _MARKS[series["mark"]]
    face = {} if filled else {"markerfacecolor": "none"}
    width = 0.6 if series["size"] > 2.0 else 0.2
    return ax.plot(
        x, y, linestyle="none", marker=marker, markersize=series["size"], markeredgewidth=width, **face, **own
    )


def _boxes(ax, series, x, y, own, scale):
    from matplotlib.collections import PolyCollection

    to, up = _numbers(series, "x_to"), _numbers(series, "y_to")
    corners = np.stack([np.stack([x, y], -1), np.stack([to, y], -1), np.stack([to, up], -1), np.stack([x, up], -1)], 1)
    drawn = PolyCollection(corners, linewidths=0.2, zorder=1)
    if "values" in series and scale:
        colours, norm = _scale(scale)
        drawn.set(array=_numbers(series, "values"), cmap=colours, norm=norm, edgecolor="face")
    else:
        drawn.set(facecolor=own["color"], edgecolor=own["color"], alpha=own["alpha"])
    return [ax.add_collection(drawn)]


def _texts(ax, series, x, y, font):
    places = {
        "above": {"xytext": (0, 2), "ha": "center", "va": "bottom"},
        "below": {"xytext": (0, -2), "ha": "center", "va": "top"},
        "left": {"xytext": (-3, 2), "ha": "right", "va": "bottom"},
        "right": {"xytext": (3, -2), "ha": "left", "va": "top"},
        "slanted": {"xytext": (1, 2), "ha": "left", "va": "bottom", "rotation": 60, "rotation_mode": "anchor"},
        "beside": {"xytext": (3, 0), "ha": "left", "va": "center"},
    }
    look = {"textcoords": "offset points", "fontsize": 0.9 * font, "color": series["colour"], **places[series["side"]]}
    return [ax.annotate(words, at, **look) for words, at in zip(series["texts"], zip(x, y))]


def _draw(ax, series, scale, font):
    x, y = _numbers(series, "x"), _numbers(series, "y")
    shape, own = series["shape"], {"color": series["colour"], "alpha": series["opacity"]}
    if x.size == 0:
        return []
    if shape == "dots":
        return _dots(ax, series, x, y, {**own, "rasterized": x.size > 20000})
    if shape == "line":
        return ax.plot(x, y, linewidth=series["size"], linestyle=_DASHES if series["dashed"] else "-", **own)
    if shape == "area":
        return [ax.fill_between(x, y, _numbers(series, "y_to"), linewidth=0.0, **own)]
    if shape == "bars":
        return [ax.vlines(x, y, _numbers(series, "y_to"), linewidth=series["size"], **own)]
    if shape == "boxes":
        return _boxes(ax, series, x, y, own, scale)
    return _texts(ax, series, x, y, font)


def _scale(scale):
    from matplotlib.colors import LinearSegmentedColormap, LogNorm, Normalize

    colours = LinearSegmentedColormap.from_list("whirl", scale["colours"])
    return colours, (LogNorm if scale["log"] else Normalize)(scale["low"], scale["high"])


# ---------------------------------------------------------------- axes and legends


def _entry(series):
    """Returns the legend entry of a series, with enlarged dots."""
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    colour, name = series["colour"], series["name"]
    if series["shape"] in ("boxes", "area"):
        return Patch(color=colour, alpha=series["opacity"], linewidth=0.0, label=name)
    if series["shape"] == "dots":
        marker, filled = _MARKS[series["mark"]]
        face = {} if filled else {"markerfacecolor": "none"}
        return Line2D([], [], linestyle="none", marker=marker, markersize=max(3.0, series["size"]), color=colour,
                      label=name, **face)  # fmt: skip
    line = _DASHES if series.get("dashed") else "-"
    return Line2D([], [], color=colour, linewidth=max(0.8, series["size"]), linestyle=line, label=name)


def entries(panels):
    """Returns the named series of panels, each name once."""
    found: dict[str, dict] = {}
    for panel in panels:
        for series in panel["series"]:
            if series["name"]:
                found.setdefault(series["name"], series)
    return list(found.values())


def _set_axis(ax, axis, which, font):
    own, near = getattr(ax, f"{which}axis"), 0.9 * font
    if axis["log"]:
        getattr(ax, f"set_{which}scale")("log")
    getattr(ax, f"set_{which}lim")(axis["low"], axis["high"])
    own.set_ticks(
        axis.get("ticks", []), axis.get("tick_texts", []) if axis["shown"] else [""] * len(axis.get("ticks", []))
    )
    if axis["log"]:
        own.set_minor_formatter(lambda *_: "")
    own.set_tick_params(which="both", labelsize=near, length=2.5, width=0.5, direction="out")
    if axis["shown"]:
        own.set_label_text(axis["label"], fontsize=font)
    for side in ax.spines.values():
        side.set_linewidth(0.5)


def _shared(ax):
    """Returns two values: whether other axes share the x axis, and whether others share the y axis."""
    return [len(axes.get_siblings(ax)) > 1 for axes in (ax.get_shared_x_axes(), ax.get_shared_y_axes())]


def _set_style(artists, style):
    """Sets keywords of Matplotlib, each on all artists that take it; a label only on the first, so that the legend has
    it once."""
    for key, value in style.items():
        takers = [artist for artist in artists if hasattr(artist, f"set_{key}")]
        if not takers:
            raise errors.BadInput(f"nothing of what is drawn takes '{key}'")
        for artist in takers[:1] if key == "label" else takers:
            artist.set(**{key: value})


def _limits_before(ax):
    """Returns the limits of axes with contents (also those of axes that share them); None for empty axes."""
    groups = {"x": ax.get_shared_x_axes(), "y": ax.get_shared_y_axes()}
    return {
        which: getattr(ax, f"get_{which}lim")() if any(each.has_data() for each in group.get_siblings(ax)) else None
        for which, group in groups.items()
    }


def _widen(ax, which, axis, before):
    """Sets limits that show the new contents; if earlier contents need wider ones, those, with Matplotlib's ticks."""
    low, high = axis["low"], axis["high"]
    if before is not None and (min(before) < low or max(before) > high):
        low, high = min(low, *before), max(high, *before)
        getattr(ax, f"set_{which}scale")("log" if axis["log"] else "linear")  # sets the ticks too
    getattr(ax, f"set_{which}lim")(low, high)


def draw_panel(ax: Axes, panel: dict[str, Any], document: dict[str, Any], style: dict[str, Any] | None = None) -> Axes:
    """Draws a panel into axes, with its title and its own legend."""
    font, before = document["font_pt"], _limits_before(ax)
    for axis in "xy":
        _set_axis(ax, panel[axis], axis, font)
    drawn = [_draw(ax, series, document.get("scale"), font) for series in panel["series"]]
    _set_style([artist for artists in drawn for artist in artists], style or {})
    for axis in "xy":  # earlier contents do not widen the limits
        _widen(ax, axis, panel[axis], before[axis])
    low = (panel["box"][3] - panel["box"][2]) * document["height_cm"] < _LOW_PANEL
    if low and panel["y"]["shown"]:
        ax.set_ylabel(panel["y"]["label"], fontsize=font, rotation=0, ha="right", va="center")
    if panel["equal"]:
        ax.set_aspect("equal", adjustable="box" if all(_shared(ax)) else "datalim")
    if panel["title"]:
        ax.set_title(panel["title"], fontsize=0.9 * font)
    if panel["letter"]:
        ax.set_title(f"({panel['letter']})", fontsize=font, loc="left")
    if panel["legend_inside"]:
        handles = [_entry(series) for series in entries([panel])]
        ax.legend(handles=handles, loc="upper right", ncols=len(handles), fontsize=0.9 * font, frameon=False)
    return ax


def new_axes(ax: Axes | None) -> Axes:
    """Returns the given axes, or the axes of a new figure."""
    if ax is not None:
        if not hasattr(ax, "get_shared_x_axes"):
            raise errors.BadInput(f"ax is {ax!r}, expected axes of Matplotlib")
        return ax
    import matplotlib.pyplot as plt

    return plt.subplots(figsize=(7.0, 4.2), layout="constrained")[1]


def close(ax: Axes) -> None:
    """Closes the figure of axes."""
    import matplotlib.pyplot as plt

    plt.close(ax.figure)


def _draw_into(ax, document, style):
    """Draws a single panel into given axes, with the title, legend and colour scale of its figure."""
    if len(document["panels"]) != 1:
        names = ", ".join(panel["name"] for panel in document["panels"])
        raise errors.BadInput(f"the figure has the panels {names}, expected one of them for the axes: panels=...")
    from matplotlib import rcParams

    panel, font = document["panels"][0], rcParams["font.size"]
    for series in panel["series"]:  # marks and lines scaled as letters
        series["size"] *= font / document["font_pt"]
    draw_panel(ax, panel, {**document, "font_pt": font}, style)
    place, (x, y) = ax.get_subplotspec(), _shared(ax)
    if x and place and not place.is_last_row():
        ax.set_xlabel("")  # the panels below have the label
    if y and place and not place.is_first_col():
        ax.set_ylabel("")
    own = bool({"color", "label"} & set(style or {}))  # the names have other colours
    if not panel["legend_inside"] and entries([panel]) and not own:
        boxes = any(series["shape"] == "boxes" and series["name"] for series in panel["series"])
        place = {"loc": "center left", "bbox_to_anchor": (1.01, 0.5)} if boxes else {"loc": "best"}
        ax.legend(handles=[_entry(series) for series in entries([panel])], fontsize=0.9 * font, frameon=False, **place)
    if "scale" in document:
        _fill_scale({**document, "font_pt": font}, ax=ax)


def draw(document: dict[str, Any], ax: Axes | None = None, style: dict[str, Any] | None = None) -> Figure:
    """Draws a figure, or its only panel into given axes; ``style`` applies to all series."""
    import matplotlib.pyplot as plt

    if ax is not None:
        _draw_into(ax, document, style)
        return ax.figure
    figure = plt.figure(figsize=(document["width_cm"] * _CM, document["height_cm"] * _CM))
    for panel in document["panels"]:
        left, right, bottom, top = panel["box"]
        draw_panel(figure.add_axes((left, bottom, right - left, top - bottom)), panel, document, style)
    outside = [_entry(series) for series in entries([p for p in document["panels"] if not p["legend_inside"]])]
    if outside:
        columns = max(1, min(len(outside), int(document["width_cm"] / 2.1)))
        figure.legend(
            handles=outside, loc="upper center", ncols=columns, fontsize=0.9 * document["font_pt"], frameon=False
        )
    figure.align_ylabels([ax for ax, panel in zip(figure.axes, document["panels"]) if panel["box"][0] < 0.3])
    if "scale" in document:
        boxes = [panel["box"] for panel in document["panels"]]
        low, high = min(box[2] for box in boxes), max(box[3] for box in boxes)
        place = (1.0 - 1.85 / document["width_cm"], low, 0.35 / document["width_cm"], high - low)
        _fill_scale(document, cax=figure.add_axes(place))
    return figure


def _fill_scale(document, **place):
    """Draws the colour scale into its own axes (``cax``) or next to others (``ax``)."""
    from matplotlib.cm import ScalarMappable

    colours, norm = _scale(document["scale"])
    bar = next(iter(place.values())).figure.colorbar(ScalarMappable(norm, colours), **place)
    bar.set_ticks(document["scale"].get("ticks", []), labels=document["scale"].get("tick_texts", []))
    bar.minorticks_off()
    bar.set_label(document["scale"]["label"], fontsize=document["font_pt"])
    bar.ax.tick_params(labelsize=0.9 * document["font_pt"])
