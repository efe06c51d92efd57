"""Figures of measured signals, in the manner of whirl.plot."""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING, Any

import numpy as np

from .figure import new_axes
from .plot import REGIMES

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .signals import Record

__all__ = ["Plots"]


def _scaled(figures):
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


@_scaled
class Plots:
    """Figures of a record: ``record.plot.orbit()``.

    Every function takes the axes to draw into, or makes a figure; it returns the axes, and passes further keywords on
    to Matplotlib, ``yscale="log"`` to the axes.
    """

    def __init__(self, record: Record) -> None:
        self._record = record

    def _label(self, what):
        unit = {"um": "µm", "1": ""}.get(self._record.unit, self._record.unit)
        return f"{what} ({unit})" if unit else what

    def speed(self, ax: Axes | None = None, **style: Any) -> Axes:
        """The speed between pulses over time: in rpm where time is in seconds."""
        record, ax = self._record, new_axes(ax)
        seconds = record.time_unit == "s"
        middles = 0.5 * (record.pulses[1:] + record.pulses[:-1])
        speed = record.speed * (30.0 / np.pi if seconds else 1.0)
        ax.plot(middles, speed, **{"color": "black", "linewidth": 0.8, **style})
        unit = "rpm" if seconds else f"rad/{record.time_unit}"
        ax.set(xlabel=f"time ({record.time_unit})", ylabel=f"speed ({unit})")
        return ax

    def orbit(
        self, revolutions: int = 4, x: str | int = 0, y: str | int = 1, ax: Axes | None = None, **style: Any
    ) -> Axes:
        """Draws the path of the last revolutions, with a mark at every pulse."""
        record, ax = self._record, new_axes(ax)
        path = record.displacements(x, y)
        inside = (record.time >= record.pulses[-1 - min(revolutions, len(record.speed))]) & (
            record.time <= record.pulses[-1]
        )
        ax.plot(*path[:, inside], **{"color": "black", "linewidth": 0.8, **style})
        marks = self._marks(x, y)[-revolutions - 1 :]
        ax.plot(*marks.T, linestyle="none", marker="o", markersize=4, color=REGIMES["quasi-periodic"])
        ax.set(xlabel=self._label("x"), ylabel=self._label("y"), aspect="equal")
        return ax

    def _marks(self, x, y, phase=0.0):
        """Returns the section of two probes along x and y."""
        record = self._record
        section = np.ascontiguousarray(record.section(phase)[:, [record.channel(x), record.channel(y)]].T)
        return (section if record.angles is None else record._turned(section, x, y)).T

    def section(
        self, phase: float = 0.0, x: str | int = 0, y: str | int = 1, ax: Axes | None = None, **style: Any
    ) -> Axes:
        """Draws the section of two probes: the shaft's positions once a revolution."""
        ax = new_axes(ax)
        ax.plot(*self._marks(x, y, phase).T, **{"marker": ".", "ls": "none", "c": "k", **style})
        ax.set(xlabel=self._label("x"), ylabel=self._label("y"), aspect="equal")
        return ax

    def spectrum(
        self, channel: str | int = 0, highest_order: float = 10.0, ax: Axes | None = None, **style: Any
    ) -> Axes:
        """Draws the order spectrum of a channel."""
        record, ax = self._record, new_axes(ax)
        index = record.channel(channel)
        spectrum = record.spectrum(highest_order)
        ax.plot(spectrum.orders, spectrum.amplitude[index], **{"color": "black", "linewidth": 0.8, **style})
        ax.set(xlabel="order", ylabel=self._label(f"amplitude of {record.names[index]}"))
        ax.set_xlim(0.0, spectrum.orders[-1])
        ax.set_ylim(bottom=0.0)
        return ax

    def full_spectrum(
        self, highest_order: float = 5.0, x: str | int = 0, y: str | int = 1, ax: Axes | None = None, **style: Any
    ) -> Axes:
        """The full spectrum of two probes: forward whirl at orders above 0, backward whirl below."""
        spectrum, ax = self._record.full_spectrum(highest_order, x, y), new_axes(ax)
        style = {"color": "black", "linewidth": 0.8, **style}
        ax.plot(spectrum.orders, spectrum.forward, **style)
        ax.plot(-spectrum.orders, spectrum.backward, **style)
        ax.axvline(0.0, color="0.6", linewidth=0.6, zorder=0)
        ax.set(xlabel="order, backward below 0", ylabel=self._label("amplitude"))
        ax.set_xlim(-spectrum.orders[-1], spectrum.orders[-1])
        ax.set_ylim(bottom=0.0)
        return ax
