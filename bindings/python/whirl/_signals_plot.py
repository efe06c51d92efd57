"""Figures of measured signals, in the manner of whirl.plot."""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING, Any, Sequence

import numpy as np

from .errors import BadInput
from .figure import new_axes
from .plot import REGIMES

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .signals import Record

__all__ = ["Plots"]


def _scaled(figures):
    """Decorates a class: its figures take ``xscale`` and ``yscale`` ("log", ...) for the axes that they return."""

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
        """Draws the speed between pulses over time, in rpm if time is in seconds."""
        record, ax = self._record, new_axes(ax)
        middles = 0.5 * (record.pulses[1:] + record.pulses[:-1])
        speed, unit = self._speeds(record.speed)
        ax.plot(middles, speed, **{"color": "black", "linewidth": 0.8, **style})
        ax.set(xlabel=f"time ({record.time_unit})", ylabel=f"speed ({unit})")
        return ax

    def bode(
        self,
        channel: str | int = 0,
        orders: float | Sequence[float] = (1.0,),
        revolutions: int = 1,
        slow_roll: float | None = None,
        ax: tuple[Axes, Axes] | None = None,
        **style: Any,
    ) -> tuple[Axes, Axes]:
        """Draws amplitude and lag of orders of a channel over the speed (:meth:`whirl.signals.Record.track`).

        ``ax`` is a pair of axes for the two; such a pair is returned.
        """
        record = self._record
        index = record.channel(channel)
        tracked = record.track(orders, revolutions, slow_roll, y=None)
        if ax is None:
            import matplotlib.pyplot as plt

            ax = plt.subplots(2, sharex=True, figsize=(7.0, 5.6), layout="constrained")[1]
        speed, unit = self._speeds(tracked.speed)
        style = {"linewidth": 0.8, **({"color": "black"} if len(tracked.orders) == 1 else {}), **style}
        for order, amplitude, lag in zip(tracked.orders, tracked.amplitude[index], tracked.lag[index]):
            ax[0].plot(speed, amplitude, label=f"{order:g}X", **style)
            jumps = np.flatnonzero(np.abs(np.diff(lag)) > 180.0) + 1  # from 360 to 0 degrees
            ax[1].plot(np.insert(speed, jumps, np.nan), np.insert(lag, jumps, np.nan), **style)
        ax[0].set(ylabel=self._label(f"amplitude of {record.names[index]}"))
        ax[0].set_ylim(bottom=0.0)
        ax[1].set(xlabel=f"speed ({unit})", ylabel="lag (degrees)", ylim=(360.0, 0.0), yticks=range(0, 361, 90))
        if len(tracked.orders) > 1:
            ax[0].legend()
        return tuple(ax)

    def polar(
        self,
        channel: str | int = 0,
        order: float = 1.0,
        revolutions: int = 1,
        slow_roll: float | None = None,
        ax: Axes | None = None,
        **style: Any,
    ) -> Axes:
        """Draws a polar plot of an order of a channel: the lag grows from the probe against the rotation, marks name
        speeds."""
        record = self._record
        index = record.channel(channel)
        tracked = record.track(order, revolutions, slow_roll, y=None)
        if ax is None:
            import matplotlib.pyplot as plt

            ax = plt.subplots(figsize=(5.0, 5.0), layout="constrained", subplot_kw={"projection": "polar"})[1]
        elif not hasattr(ax, "set_theta_offset"):
            raise BadInput('the axes are not polar, expected those of plt.subplots(subplot_kw={"projection": "polar"})')
        ax.set_theta_direction(-1)
        ax.set_theta_offset(0.0 if record.angles is None else record.angles[index])
        lag, amplitude = -np.angle(tracked.vectors[index, 0]), tracked.amplitude[index, 0]
        ax.plot(lag, amplitude, **{"color": "black", "linewidth": 0.8, **style})
        speed, unit = self._speeds(tracked.speed)
        # Place marks at equal parts of the path, which is long where the shaft passes a resonance.
        path = np.append(0.0, np.cumsum(np.abs(np.diff(tracked.vectors[index, 0]))))
        for row in np.unique(np.searchsorted(path, path[-1] * np.linspace(0.0, 1.0, 9)).clip(max=len(path) - 1)):
            ax.plot(lag[row], amplitude[row], marker="o", markersize=3, color=REGIMES["quasi-periodic"])
            ax.annotate(f"{speed[row]:.4g}", (lag[row], amplitude[row]), fontsize="x-small")
        ax.set_title(self._label(f"{order:g}X of {record.names[index]}") + f", marks: {unit}")
        return ax

    def _speeds(self, speed):
        """Returns speeds in the unit of figures, and its name."""
        seconds = self._record.time_unit == "s"
        return speed * (30.0 / np.pi if seconds else 1.0), "rpm" if seconds else f"rad/{self._record.time_unit}"

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
        """Draws the full spectrum of two probes: forward whirl at orders above 0, backward whirl below."""
        spectrum, ax = self._record.full_spectrum(highest_order, x, y), new_axes(ax)
        style = {"color": "black", "linewidth": 0.8, **style}
        ax.plot(spectrum.orders, spectrum.forward, **style)
        ax.plot(-spectrum.orders, spectrum.backward, **style)
        ax.axvline(0.0, color="0.6", linewidth=0.6, zorder=0)
        ax.set(xlabel="order, backward below 0", ylabel=self._label("amplitude"))
        ax.set_xlim(-spectrum.orders[-1], spectrum.orders[-1])
        ax.set_ylim(bottom=0.0)
        return ax

    # ---------------------------------------------------------------- over time and speed

    def spectrogram(
        self,
        window: float,
        channel: str | int = 0,
        highest: float | None = None,
        step: float | None = None,
        ax: Axes | None = None,
        **style: Any,
    ) -> Axes:
        """Draws amplitudes of a channel over time and frequency by colour, down to 0.001 of the largest; 1X as a line.

        The title states the share of 1X that a window leaves where its frequency changes most
        (:meth:`whirl.signals.Record.spectrogram`).
        """
        from matplotlib.colors import LogNorm

        record, ax = self._record, new_axes(ax)
        found = record.spectrogram(window, step, channel, None)
        largest = found.x[:, 1:].max()
        norm = LogNorm(1e-3 * largest, largest, clip=True) if largest > 0.0 else None
        style = {"cmap": "viridis", "norm": norm, "shading": "nearest", "rasterized": True, **style}
        mesh = ax.pcolormesh(found.time, found.frequency, found.x.T, **style)
        ax.figure.colorbar(mesh, ax=ax, label=self._label(f"amplitude of {record.names[record.channel(channel)]}"))
        ax.plot(found.time, found.speed / (2.0 * np.pi), color="white", linewidth=0.6, linestyle="--")
        ax.set(xlabel=f"time ({record.time_unit})", ylabel=f"frequency ({self._frequency_unit()})")
        ax.set_ylim(0.0, found.frequency[-1] if highest is None else highest)
        ax.set_title(self._kept(found), fontsize="small")
        return ax

    def waterfall(
        self,
        window: float,
        channel: str | int = 0,
        highest: float | None = None,
        step: float | None = None,
        ax: Axes | None = None,
        **style: Any,
    ) -> Axes:
        """Draws spectra of a channel over frequency, one above the other at their times; the title is as in
        ``spectrogram``."""
        record = self._record
        found = record.spectrogram(window, step, channel, None)
        ax = self._stack(ax, found.frequency, found.x, found.time, style)
        ax.set(xlabel=f"frequency ({self._frequency_unit()})", ylabel=f"time ({record.time_unit})")
        ax.set_xlim(0.0, found.frequency[-1] if highest is None else highest)
        ax.set_title(f"{record.names[record.channel(channel)]}: {self._kept(found)}", fontsize="small")
        return ax

    def cascade(
        self,
        revolutions: int = 16,
        highest_order: float = 5.0,
        step: int | None = None,
        x: str | int = 0,
        y: str | int | None = 1,
        ax: Axes | None = None,
        **style: Any,
    ) -> Axes:
        """Draws order spectra one above the other at their speeds; of two probes full spectra, backward whirl below
        0."""
        record = self._record
        found = record.cascade(revolutions, step, highest_order, x, y)
        if found.forward is None:
            orders, rows, label = found.orders, found.x, "order"
        else:
            orders = np.concatenate([-found.orders[:0:-1], found.orders])
            rows = np.hstack([found.backward[:, :0:-1], found.forward])
            label = "order, backward below 0"
        speed, unit = self._speeds(found.speed)
        ax = self._stack(ax, orders, rows, speed, style)
        ax.set(xlabel=label, ylabel=f"speed ({unit})", xlim=(orders[0], orders[-1]))
        return ax

    def _stack(self, ax, along, rows, heights, style):
        """Draws rows at heights; the largest amplitude is a fifth of the range of heights and has a label."""
        ax, largest = new_axes(ax), rows[:, 1:].max()
        span = np.ptp(heights) or 1.0
        scale = 0.2 * span / largest if largest > 0.0 else 0.0
        style = {"color": "black", "linewidth": 0.5, **style}
        for row, height in zip(rows, heights):
            ax.plot(along, height + scale * row, **style)
        unit = self._label("largest amplitude").partition("(")[2].rstrip(")")
        ax.annotate(
            f"largest {largest:.3g} {unit}".rstrip(), (0.99, 0.98), xycoords="axes fraction", ha="right", va="top"
        )
        return ax

    def _frequency_unit(self):
        return "Hz" if self._record.time_unit == "s" else f"1/{self._record.time_unit}"

    def _kept(self, found):
        windows = f"windows of {found.window:.4g} {self._record.time_unit}"
        return f"{windows} leave {100.0 * found.kept.min():.4g} % of 1X where its frequency changes most"
