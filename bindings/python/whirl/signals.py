"""Measured signals: applies the analyses of computed motions to signals that were measured at a machine.

>>> time, a, b, keyphasor = numpy.loadtxt("measured.csv", delimiter=",", skiprows=1, unpack=True)
>>> record = whirl.signals.Record(time, a, b, keyphasor=keyphasor, angles=numpy.radians([45, 135]), unit="um")
>>> record.section()                          # [points][channels], a point for each pulse
>>> record.full_spectrum().lines              # order, x, y, forward, backward
>>> record.plot.full_spectrum()

libwhirl computes everything (``whirl/signals.h`` says how). Signals keep their unit, time may have any unit; angles are
in rad. Gaps, times that do not increase and signals that are too short raise :class:`whirl.BadInput` with one sentence;
samples, channels and pulses are counted from 0.
"""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any, Mapping, NamedTuple, Optional, Sequence

import numpy as np
from numpy.typing import ArrayLike

from ._library import check, ffi, lib
from .errors import BadInput

if TYPE_CHECKING:
    import os

    import pandas

    from ._signals_plot import Plots
    from .result import Result

__all__ = [
    "Spectrum",
    "FullSpectrum",
    "Recurrence",
    "Envelopes",
    "TrackedOrders",
    "Spectrogram",
    "Cascade",
    "RainFlow",
    "find_pulses",
    "bode",
    "vold_kalman",
    "vold_kalman_weight",
    "sweep_kept",
    "motion_size",
    "zero_one",
    "recurrence",
    "rain_flow",
    "damage",
    "check_pulses",
    "load",
    "Record",
]

_LINES, _COLUMNS = 16, 5  # WHIRL_SIGNALS_LINES, WHIRL_SIGNALS_COLUMNS


class Spectrum(NamedTuple):
    """Order spectra of all channels; amplitudes are zero to peak, in the unit of the signals."""

    orders: np.ndarray  #: [orders] multiples of the speed, 1/revolutions apart
    amplitude: np.ndarray  #: [channels][orders]
    lines: tuple  #: for each channel an array [lines][2] of order and amplitude of sinusoids, largest first
    synchronous: np.ndarray  #: [channels] amplitude once a revolution
    lag: np.ndarray  #: [channels] degrees by which its peak lags behind the pulse; NaN if the amplitude is 0


class FullSpectrum(NamedTuple):
    """The full spectrum of two probes: x, y and the circular motions forward (with the rotation) and backward."""

    orders: np.ndarray  #: [orders] multiples of the speed, 1/revolutions apart
    x: np.ndarray  #: [orders] amplitudes, zero to peak
    y: np.ndarray  #: [orders]
    forward: np.ndarray  #: [orders]
    backward: np.ndarray  #: [orders]
    lines: np.ndarray  #: [lines][5] order, x, y, forward, backward of sinusoids, largest first
    synchronous: np.ndarray  #: [4] amplitudes once a revolution of x, y, forward, backward
    lag: np.ndarray  #: [4] their lags behind the pulse, degrees, as ``spectrum/synchronous_lag`` of a result


class Recurrence(NamedTuple):
    """Recurrence of points."""

    #: the smallest number of steps, up to 64 (128 where there are three times as many points), after which all points
    #: return within the tolerance; else the number of steps with the nearest return
    period: int
    distance: float  #: largest distance of a point from the point ``period`` steps later, over the size of the motion
    rate: float  #: share of the pairs of points that are within the radius
    determinism: float  #: share of these pairs in diagonal lines; NaN without any
    laminarity: float  #: share of the near points in vertical lines
    longest: int  #: points of the longest diagonal line other than the main diagonal


class Envelopes(NamedTuple):
    """Amplitudes of orders at every sample, by a Vold-Kalman filter."""

    #: [channels][orders][count] complex, zero to peak: the part of an order is ``real(vectors * exp(1j * phase))``
    vectors: np.ndarray
    time: np.ndarray  #: [count] times of the samples
    #: [orders][count] True where values are less accurate: within 1/bandwidth of the ends, where samples are on one
    #: side only, and where the frequency of an order is below the bandwidth
    doubtful: np.ndarray

    @property
    def amplitude(self) -> np.ndarray:
        """[channels][orders][count] zero to peak, in the unit of the signals."""
        return np.abs(self.vectors)

    @property
    def lag(self) -> np.ndarray:
        """[channels][orders][count] 0 to 360 degrees by which a peak of the order lags behind phase 0 of the order."""
        return _lag(self.vectors)


class TrackedOrders(NamedTuple):
    """Orders over the turns of a record, with a row for every block of one or more turns. Amplitudes are zero to peak,
    in the unit of the signals; a peak lags behind the pulse by the ``lag`` in degrees."""

    orders: np.ndarray  #: [orders] multiples of the speed
    time: np.ndarray  #: [rows] time in the middle of the turns
    speed: np.ndarray  #: [rows] mean over the turns, rad per unit of time
    vectors: np.ndarray  #: [channels][orders][rows] complex amplitudes, with the slow roll subtracted
    mean: np.ndarray  #: [channels][rows] mean of the channels over the turns
    slow_roll: np.ndarray  #: [channels][orders] the vectors that were subtracted; 0 without a slow-roll speed
    forward: Optional[np.ndarray]  #: [orders][rows] complex amplitude of the circular motion with the rotation
    backward: Optional[np.ndarray]  #: [orders][rows] against it; both None if there is no pair of probes
    names: tuple  #: of the channels

    @property
    def amplitude(self) -> np.ndarray:
        """[channels][orders][rows] zero to peak."""
        return np.abs(self.vectors)

    @property
    def lag(self) -> np.ndarray:
        """[channels][orders][rows] degrees behind the pulse, 0 to 360."""
        return _lag(self.vectors)

    def to_pandas(self) -> "pandas.DataFrame":
        """Returns the rows with time, speed, and amplitude and lag of every channel and order: ``x 1X amplitude``."""
        from .findings import _pandas

        columns = {"time": self.time, "speed": self.speed}
        named = dict(zip(self.names, self.vectors))
        if self.forward is not None:
            named.update(forward=self.forward, backward=self.backward)
        for name, vectors in named.items():
            for order, vector in zip(self.orders, vectors):
                columns[f"{name} {order:g}X amplitude"] = np.abs(vector)
                columns[f"{name} {order:g}X lag"] = _lag(vector)
        return _pandas().DataFrame(columns)

    def columns(self, unit: str = "m", over: str = "speed") -> "dict[str, np.ndarray]":
        """Returns the rows as measured numbers for :func:`whirl.fit`: ``speed [rad/s]``, ``disc x 1X [um]``,
        ``disc x 1X lag [deg]``. The channels have names such as ``disc x``: a station and a direction.

        Parameters
        ----------
        unit : str
            Unit of the signals.
        over : str
            "speed" or, for runs that pass a speed twice, "time" from the beginning of the record; times are in s.
        """
        if over not in ("speed", "time"):
            raise BadInput(f"columns are over {over!r}, expected 'speed' or 'time'")
        columns = {"speed [rad/s]": self.speed} if over == "speed" else {"time [s]": self.time}
        for name, vectors in zip(self.names, self.vectors):
            for order, vector in zip(self.orders, vectors):
                columns[f"{name} {order:g}X [{unit}]"] = np.abs(vector)
                columns[f"{name} {order:g}X lag [deg]"] = _lag(vector)
        return columns


class Spectrogram(NamedTuple):
    """Spectra of windows over time. Amplitudes are zero to peak, in the unit of the signals."""

    time: np.ndarray  #: [rows] time in the middle of the windows
    speed: np.ndarray  #: [rows] mean over the window, rad per unit of time
    frequency: np.ndarray  #: [frequencies] cycles per unit of time
    x: np.ndarray  #: [rows][frequencies]
    y: Optional[np.ndarray]  #: [rows][frequencies]; None for a single channel, as are the next two
    forward: Optional[np.ndarray]  #: [rows][frequencies] circular motion with the rotation
    backward: Optional[np.ndarray]  #: [rows][frequencies] and against it
    window: float  #: duration of a window
    sweep: np.ndarray  #: [rows] change of the turns per unit of time within a window, times its duration
    #: [rows] share of the amplitude of 1X that is left in its line, because its frequency changes within the window
    kept: np.ndarray

    def kept_of(self, order: float) -> np.ndarray:
        """Returns the share [rows] of the amplitude of an order that is left in its line (:func:`sweep_kept`)."""
        return sweep_kept(float(order) * self.sweep)


class Cascade(NamedTuple):
    """Spectra of blocks of turns over the speed, with orders as their axis. Lines of orders stay sharp while the speed
    changes; lines of fixed frequencies do not. Amplitudes are zero to peak, in the unit of the signals."""

    time: np.ndarray  #: [rows] time in the middle of the turns
    speed: np.ndarray  #: [rows] mean over the turns, rad per unit of time
    orders: np.ndarray  #: [orders] multiples of the speed
    x: np.ndarray  #: [rows][orders]
    y: Optional[np.ndarray]  #: [rows][orders]; None for a single channel, as are the next two
    forward: Optional[np.ndarray]  #: [rows][orders] circular motion with the rotation
    backward: Optional[np.ndarray]  #: [rows][orders] and against it
    change: np.ndarray  #: [rows] change of the speed within the turns, over their mean speed


class RainFlow(NamedTuple):
    """Cycles of a load history, in the order in which they close."""

    range: np.ndarray  #: [rows] from the lower to the upper point, in the unit of the history: twice the amplitude
    mean: np.ndarray  #: [rows] halfway between the two points
    cycles: np.ndarray  #: [rows] 1, or 0.5 for half a cycle

    def counts(self) -> tuple:
        """Returns two arrays: the different ranges, from the least, and the cycles of each."""
        ranges, row = np.unique(self.range, return_inverse=True)
        return ranges, np.bincount(row, self.cycles, len(ranges))

    def to_pandas(self) -> "pandas.DataFrame":
        """Returns the rows with the columns range, mean, cycles."""
        from .findings import _pandas

        return _pandas().DataFrame(self._asdict())


def _lag(vectors: np.ndarray) -> np.ndarray:
    """Returns the degrees by which peaks of complex amplitudes lag, 0 to 360."""
    return np.degrees(-np.angle(vectors)) % 360.0


# ---------------------------------------------------------------- arrays


def _numbers(values: ArrayLike, what: str, dimensions: int = 1) -> np.ndarray:
    """Converts to contiguous doubles; masked values become gaps (NaN)."""
    kind = getattr(getattr(values, "dtype", None), "kind", None) or np.asarray(values, dtype=object).dtype.kind
    if kind in "mMc" or np.iscomplexobj(values):
        found = "complex numbers" if kind == "c" or np.iscomplexobj(values) else "dates or spans of time"
        raise BadInput(f"{what} has {found}, expected numbers")
    try:
        numbers = np.ma.filled(np.ma.asarray(values, dtype=float), np.nan)
    except (TypeError, ValueError) as failure:
        raise BadInput(f"{what}: {failure}, expected numbers") from None
    if numbers.ndim != dimensions:
        raise BadInput(f"{what} has the shape {numbers.shape}, expected {dimensions} dimension{'s'[: dimensions - 1]}")
    return np.ascontiguousarray(numbers)


def _at(numbers: np.ndarray):
    """Returns a pointer to an array, which the caller must keep alive."""
    return ffi.cast("double *", numbers.ctypes.data)


def _whole(value, what: str) -> int:
    """Converts a number to an int or a size for the library."""
    try:
        whole = int(value)
    except (TypeError, ValueError, OverflowError):
        whole = -1
    if not 0 <= whole < 1 << 31:
        raise BadInput(f"{what} is {value}, expected a whole number from 0 on")
    return whole


def _points(points: ArrayLike) -> np.ndarray:
    """Returns points [count][dimension]; a list of numbers has points of one coordinate."""
    points = np.asarray(points) if not np.ma.isMaskedArray(points) else points
    return _numbers(points if points.ndim > 1 else points.reshape(-1, 1), "the section", 2)


def _size_of(points: np.ndarray, size: Optional[float]) -> float:
    return motion_size(points.T) if size is None else float(size)


# ---------------------------------------------------------------- records as results


def load(path: "str | os.PathLike", columns: Optional[Mapping[str, str]] = None) -> "Result":
    """Reads a record of a run-up or coast-down as a result, with the fields and figures of the study ``runup``.

    >>> record = whirl.signals.load("coast-down.csv")
    >>> whirl.open("model.h5").figure("runup-de", other=record)    # both in one figure
    >>> names = {"time [s]": "t", "keyphasor": "key", "de x [um]": "X[:, 0]", "de y [um]": "X[:, 1]"}
    >>> record = whirl.signals.load("coast-down.mat", names)

    Parameters
    ----------
    path : path
        Comma-separated values, or an HDF5, MAT or universal file with such vectors, with the headings ``time [s]``,
        ``keyphasor`` or ``speed [rpm]``, and two probes for each station: ``de x [um]`` and ``de y
        [um]``, or with degrees from the x axis in the sense of rotation, ``de 45 [um]``.
    columns : dict, optional
        These headings, each with what it is called in the file, as for :func:`whirl.read_measured`; other columns of
        the file are not used.
    """
    from ._memory import MemorySource
    from .result import Result

    return Result(MemorySource.record(path, columns))


# ---------------------------------------------------------------- functions of arrays


def find_pulses(
    time: ArrayLike,
    voltage: ArrayLike,
    threshold: Optional[float] = None,
    hysteresis: Optional[float] = None,
    edge: str = "rising",
) -> np.ndarray:
    """Returns the instants of a keyphasor's pulses, interpolated between samples.

    Parameters
    ----------
    time, voltage : array_like
        [count] of the samples.
    threshold : float, optional
        Voltage that an edge passes; default: halfway between the least and the largest voltage.
    hysteresis : float, optional
        Voltage by which the signal must go back beyond the threshold before another pulse counts; default: a fifth of
        the range.
    edge : str
        "rising" or "falling".
    """
    time, voltage = _numbers(time, "time"), _numbers(voltage, "the keyphasor")
    if time.shape != voltage.shape:
        raise BadInput(f"the keyphasor has {voltage.size} samples, time has {time.size}")
    if edge not in ("rising", "falling"):
        raise BadInput(f"the edge is '{edge}', expected 'rising' or 'falling'")
    if threshold is None or hysteresis is None:
        levels = ffi.new("double[2]")
        check(lib.whirl_signals_threshold(_at(voltage), voltage.size, levels, levels + 1))
        threshold = levels[0] if threshold is None else threshold
        hysteresis = levels[1] if hysteresis is None else hysteresis
    instants, found = np.empty(time.size // 2 + 1), ffi.new("size_t *")
    levels = float(threshold), float(hysteresis)
    check(lib.whirl_signals_pulses(_at(time), _at(voltage), time.size, *levels, edge == "rising", _at(instants), found))
    return instants[: found[0]].copy()


def vold_kalman(
    values: ArrayLike,
    angle: Optional[ArrayLike] = None,
    orders: "float | Sequence[float]" = (1.0,),
    *,
    rate: float,
    bandwidth: "float | Sequence[float]",
    poles: int = 2,
    phases: Optional[ArrayLike] = None,
) -> Envelopes:
    """Tracks orders by a Vold-Kalman filter of the second generation (Vold and Leuridan 1993), all of them together.

    Orders that cross are separated if their distance is wider than the band in most of the record. Values are less
    accurate within 1/bandwidth of the ends, and wrong where the frequency of an order is below the bandwidth:
    ``doubtful`` marks both. A mean that is large compared with the amplitudes leaks into slow orders: subtract it
    before.

    Parameters
    ----------
    values : array_like
        [count] or [channels][count].
    angle : array_like, optional
        [count] rad that the shaft has turned at each sample, with its slow oscillations.
    orders : float or sequence of float
        Multiples of the angle to track.
    rate : float
        Samples per unit of time, constant.
    bandwidth : float or sequence of float
        Full width at -3 dB in the unit of the rate, one for all or one for each of orders and phases.
    poles : int
        1 or 2. Two poles are flatter within the band and steeper outside, and follow slopes.
    phases : array_like, optional
        [others][count] rad: phases of further components, such as ``2 * pi * 50 * time`` or an order of another shaft.
        They come after the orders in the result; messages number orders, then these, from 0.
    """
    values = np.asarray(values) if not np.ma.isMaskedArray(values) else values
    channels = _numbers(values if values.ndim > 1 else values.reshape(1, -1), "the signals", 2)
    count = channels.shape[1]
    if angle is None and phases is None:
        raise BadInput("there is nothing to track, expected an angle, or phases")
    tracked = np.empty((0, count))
    if angle is not None:
        angle = _numbers(angle, "the angle")
        if angle.size != count:
            raise BadInput(f"the angle has {angle.size} samples, the signals have {count}")
        orders = _numbers(np.atleast_1d(orders), "the orders")
        if not (np.all(orders > 0.0) and len(set(orders)) == len(orders) > 0):
            raise BadInput(f"the orders are {', '.join(f'{k:g}' for k in orders)}, expected different ones above 0")
        tracked = np.outer(orders, angle)
    if phases is not None:
        others = _numbers(np.atleast_2d(phases), "the phases", 2)
        if others.shape[1] != count:
            raise BadInput(f"the phases have {others.shape[1]} samples, the signals have {count}")
        tracked = np.vstack([tracked, others])
    tracked = np.ascontiguousarray(tracked)
    widths = _numbers(np.atleast_1d(bandwidth), "the bandwidths")
    if len(widths) not in (1, len(tracked)):
        raise BadInput(f"there are {len(widths)} bandwidths, expected one for all or one for each of {len(tracked)}")
    widths = np.ascontiguousarray(np.broadcast_to(widths, len(tracked)))
    poles, out = _whole(poles, "the number of poles"), np.empty((len(channels), len(tracked), count, 2))
    for channel, found in zip(channels, out):
        arrays = _at(tracked), len(tracked), _at(widths), poles, _at(found)
        check(lib.whirl_signals_vold_kalman(_at(channel), count, float(rate), *arrays))
    time = np.arange(count) / float(rate)
    near_end = np.minimum(time, time[-1] - time) < 1.0 / widths[:, None]
    slow = np.abs(np.gradient(tracked, axis=1)) * float(rate) < 2.0 * np.pi * widths[:, None]
    return Envelopes(out[..., 0] + 1j * out[..., 1], time, near_end | slow)


def vold_kalman_weight(bandwidth: float, rate: float, poles: int = 2) -> float:
    """Returns the weight r of a Vold-Kalman filter with a full width at -3 dB in the unit of the rate (Tuma 2005).

    The gain at a distance f from an order is 1/(1 + r^2 (2 sin(pi f/rate))^(2 poles)).
    """
    weight, poles = ffi.new("double *"), _whole(poles, "the number of poles")
    check(lib.whirl_signals_vold_kalman_weight(float(bandwidth), float(rate), poles, weight))
    return weight[0]


def sweep_kept(sweep: ArrayLike) -> "float | np.ndarray":
    """Returns the share of the amplitude of a sinusoid that its line keeps in a Hann window while its frequency
    changes.

    Parameters
    ----------
    sweep : array_like
        Change of the frequency within the window times the duration of the window: the rate in Hz/s times T^2. 0.25
        keeps 0.9995, 1 keeps 0.993, 4 keeps 0.894.
    """
    sweep, kept = np.asarray(sweep, dtype=float), ffi.new("double *")
    out = np.empty(sweep.size)
    for i, each in enumerate(sweep.ravel()):
        check(lib.whirl_signals_sweep(each, kept))
        out[i] = kept[0]
    return out.reshape(sweep.shape) if sweep.ndim > 0 else float(out[0])


def motion_size(channels: ArrayLike) -> float:
    """Returns the size of a motion, half the diagonal of the bounds of channels [channels][count], to compare distances
    with."""
    channels, size = _numbers(channels, "the channels", 2), ffi.new("double *")
    check(lib.whirl_signals_size(_at(channels), channels.shape[1], channels.shape[0], size))
    return size[0]


def zero_one(points: ArrayLike, size: Optional[float] = None) -> float:
    """Returns K of the 0-1 test for chaos (Gottwald and Melbourne 2009) of a section: near 1 for chaos, near 0 for
    regular motion.

    Parameters
    ----------
    points : array_like
        [count] or [count][dimension], at least 100 points, of which the last 4000 are used.
    size : float, optional
        Size of the motion (:func:`motion_size`); default: that of the points.

    Returns
    -------
    float
        NaN where the points spread by less than 1e-6 of the size.
    """
    points, k = _points(points), ffi.new("double *")
    check(lib.whirl_signals_zero_one(_at(points), *points.shape, _size_of(points, size), k))
    return k[0]


def recurrence(
    points: ArrayLike,
    size: Optional[float] = None,
    radius: float = 0.1,
    tolerance: float = 0.05,
    shortest: int = 2,
) -> Recurrence:
    """Finds how the points of a section return (Marwan, Romano, Thiel and Kurths 2007).

    Parameters
    ----------
    points : array_like
        [count] or [count][dimension], 5 to 20 000.
    size : float, optional
        Size of the motion (:func:`motion_size`); default: that of the points.
    radius : float
        Distance within which points are near each other, over the size.
    tolerance : float
        Distance within which points return after a period, over the size; it must be above the noise. For computed
        motions 1e-6 is used.
    shortest : int
        Least number of points of a line in the recurrence plot, at least 2.
    """
    points = _points(points)
    size, period, numbers = _size_of(points, size), ffi.new("int *"), ffi.new("double[4]")
    longest, shortest = ffi.new("size_t *"), _whole(shortest, "the shortest line")
    check(lib.whirl_signals_returns(_at(points), *points.shape, size, float(tolerance), period, numbers))
    radius = float(radius) * size
    lines = numbers + 1, numbers + 2, numbers + 3, longest
    check(lib.whirl_signals_recurrence(_at(points), *points.shape, radius, shortest, *lines))
    return Recurrence(period[0], *numbers, longest[0])


def _doubt_teeth(time: np.ndarray, channels: np.ndarray, pulses: np.ndarray) -> None:
    """Warns if a motion repeats once in many pulses, as with a keyphasor at a toothed wheel."""
    first = min(len(pulses), 1024)
    turned, samples = np.empty((len(channels), first - 1, 8)), 8
    arrays = _at(time), _at(channels), time.size, len(channels), _at(pulses), first
    if first < 64 or lib.whirl_signals_resample(*arrays, samples, 3, _at(turned)).code != 0:
        return  # too few pulses to decide; the analyses report their requirement
    lines = np.vstack([_spectrum(channel.ravel(), None, samples, 2.0)[1][:, :2] for channel in turned])
    order, most = lines[np.argmax(lines[:, 1])] if len(lines) > 0 else (1.0, 0.0)
    teeth = round(1.0 / order) if order > 0 else 0
    with_pulse = lines[np.abs(lines[:, 0] - 1.0) < 0.1, 1].max(initial=0.0)
    if teeth > 3 and abs(teeth * order - 1.0) < 0.02 and with_pulse < 0.05 * most:
        warnings.warn(
            f"the motion comes once in {teeth} pulses, and hardly with each of them: of {teeth} teeth per revolution "
            f"say per_revolution={teeth}",
            stacklevel=3,
        )


def _spectrum(x: np.ndarray, y: Optional[np.ndarray], samples: int, highest_order: float):
    """Returns the rows of orders and of lines, and the synchronous part [2][4], of signals [count] at equal angles."""
    count = lib.whirl_signals_orders(x.size, samples, highest_order)
    orders, lines, synchronous = np.empty((count, _COLUMNS)), np.empty((_LINES, _COLUMNS)), np.empty((2, 4))
    found, second = ffi.new("size_t *"), ffi.NULL if y is None else _at(y)
    arrays = _at(orders), _at(lines), found, _at(synchronous)
    check(lib.whirl_signals_spectrum(_at(x), second, x.size, samples, highest_order, *arrays))
    return orders, lines[: found[0]], synchronous


def _at_speed(speed: np.ndarray, vectors: np.ndarray, wanted: float) -> np.ndarray:
    """Returns vectors [...][rows] at a speed: the mean of linear interpolations between all rows that pass it."""
    low, high = np.minimum(speed[:-1], speed[1:]), np.maximum(speed[:-1], speed[1:])
    passed = np.flatnonzero((low <= wanted) & (wanted <= high))
    if len(passed) == 0:
        raise BadInput(
            f"the slow-roll speed is {wanted:g} rad per unit of time, expected a speed of the record, "
            f"{speed.min():.6g} to {speed.max():.6g}"
        )
    step = speed[passed + 1] - speed[passed]
    part = np.divide(wanted - speed[passed], step, out=np.full(len(passed), 0.5), where=step != 0.0)
    return np.mean(vectors[..., passed] * (1.0 - part) + vectors[..., passed + 1] * part, axis=-1)


_SLOW, _STILL, _RESPONDS = 1.1, 0.25, 0.5


def _check_slow_roll(speed: np.ndarray, once: np.ndarray, slow_roll: np.ndarray, wanted: float, names) -> None:
    """Raises :class:`whirl.BadInput` if the slow-roll speed is not below the resonances.

    Up to 1.1 times that speed, synchronous vectors ``once`` [channels][rows], with the slow roll subtracted, may reach
    a quarter of their largest amplitude. Channels whose largest amplitude is below half of the slow roll are not
    judged.
    """
    slow = speed <= _SLOW * wanted
    for name, channel, roll in zip(names, np.abs(once), np.abs(slow_roll)):
        changed = channel[slow].max(initial=0.0)
        if changed > _STILL * channel.max() and channel.max() > _RESPONDS * roll:
            raise BadInput(
                f"the slow-roll speed {wanted:g} rad per unit of time is not below the resonances: up to a tenth above "
                f"it 1X of '{name}' changes by {changed / channel.max():.0%} of its largest change"
            )


def rain_flow(values: ArrayLike) -> RainFlow:
    """Counts the cycles of a load history [count] by rain flow, three points (ASTM E1049-85, 5.4.4).

    Ranges that close no loop are half cycles.
    """
    values = _numbers(values, "the history")
    cycles, found = np.empty((values.size, 3)), ffi.new("size_t *")
    check(lib.whirl_signals_rain_flow(_at(values), values.size, _at(cycles), found))
    return RainFlow(*cycles[: found[0]].T.copy())


def damage(
    history: "RainFlow | ArrayLike",
    curve: ArrayLike,
    slope: Optional[float] = None,
    endurance: float = 0.0,
) -> float:
    """Damage of a load history: the sum of n/N over its cycles (Palmgren 1924, Miner 1945); failure is expected at 1.

    The mean of a cycle has no effect on its N.

    Parameters
    ----------
    history : RainFlow or array_like
        Cycles of :func:`rain_flow`, or the history [count] itself.
    curve : array_like
        S-N curve: points [points][2] of range and cycles to failure N. Ranges are twice the amplitudes. Between points
        the curve is straight over logarithms; the last line goes on to smaller ranges.
    slope : float, optional
        With a single point (range, N): m of N (range of the point/range)^m.
    endurance : float
        Range up to which cycles do no damage; 0: every cycle does damage.
    """
    counted = history if isinstance(history, RainFlow) else rain_flow(history)
    cycles = np.column_stack([_numbers(column, "the cycles") for column in counted])
    points = _numbers(np.atleast_2d(curve), "the S-N curve", 2)
    if points.shape[1] != 2:
        raise BadInput(f"the S-N curve has the shape {points.shape}, expected points of a range and a number of cycles")
    if (slope is None) != (len(points) > 1):
        raise BadInput(
            f"the S-N curve has {len(points)} point{'s'[: len(points) - 1]} and {'no' if slope is None else 'a'} "
            "slope, expected one point and a slope, or several points"
        )
    ranges, lives, out = points[:, 0].copy(), points[:, 1].copy(), ffi.new("double *")
    given = _at(ranges), _at(lives), len(points), 0.0 if slope is None else float(slope), float(endurance)
    check(lib.whirl_signals_damage(_at(cycles), len(cycles), *given, out))
    return out[0]


# ---------------------------------------------------------------- checks of pulses

_WINDOW, _UNLIKE, _STEADY = 3, 1.5, 0.1


def check_pulses(pulses: ArrayLike) -> None:
    """Raises :class:`whirl.BadInput` if a pulse was missed, or one is false.

    The time between two pulses is compared with the median of seven such times around it, which is the time itself
    while the speed only rises or falls. A ratio above 1.5 is an error, as no shaft changes its speed so much for one
    revolution. At the ends of a record, where fewer times are on one side, it is an error only if two thirds of the
    times are within a tenth of their median.
    """
    gaps = np.diff(_numbers(pulses, "pulses"))
    usual, inner = gaps.copy(), range(_WINDOW, len(gaps) - _WINDOW)
    if len(inner) > 0:
        windows = np.lib.stride_tricks.sliding_window_view(gaps, 2 * _WINDOW + 1)
        usual[_WINDOW:-_WINDOW] = np.median(windows, axis=1)
    for i in set(range(len(gaps))) - set(inner):
        first = max(0, i - 2 * _WINDOW)
        near = np.delete(gaps[first : i + 2 * _WINDOW + 1], i - first)
        alike = np.abs(near / np.median(near) - 1.0) < _STEADY if len(near) > 0 else np.zeros(1)
        usual[i] = np.median(near) if np.mean(alike) >= 2 / 3 else gaps[i]
    bad = np.flatnonzero((gaps > _UNLIKE * usual) | (_UNLIKE * gaps < usual))
    if len(bad) > 0:
        ratio, after = gaps[bad[0]] / usual[bad[0]], bad[0] + 1
        raise BadInput(
            f"pulse {after}, at {pulses[after]:.6g}, comes {ratio:.3g} of the usual revolution after the one before: "
            f"{'pulses were missed' if ratio > 1 else 'one of them is false'}, expected one a revolution: see "
            "threshold, hysteresis and edge, or say uneven=True where the shaft did turn so"
        )


# ---------------------------------------------------------------- a record


class Record:
    """Channels that were sampled at the same instants, and the pulses of the shaft.

    Parameters
    ----------
    time : float or array_like
        Samples per unit of time, the first one at 0; or the times [count] of the samples, which may be uneven.
    channels : array_like
        [count] each; for two probes of a plane x, then y.
    keyphasor : array_like, optional
        [count] voltage with a pulse per revolution; for ``threshold``, ``hysteresis`` and ``edge`` see
        :func:`find_pulses`.
    pulses : array_like, optional
        Times of the pulses, in the place of a keyphasor: one in each revolution, within the times of the samples.
    angles : array_like, optional
        [channels] angles of the probes, rad from the x axis in the sense of rotation; default: 0 and pi/2 in turn.
    per_revolution : int
        Pulses of the keyphasor in a revolution, such as the teeth of a wheel; only one pulse in each revolution is
        used.
    uneven : bool
        Whether the speed may change by half from one revolution to the next; otherwise such pulses are an error
        (:func:`check_pulses`).
    names : sequence of str, optional
        Names of the channels; default: those of Series, else "x", "y" and numbers, or the angles of the probes in
        degrees.
    unit : str
        Unit of the channels, for figures.
    time_unit : str
        Unit of time, for figures.
    """

    def __init__(
        self,
        time: "float | ArrayLike",
        *channels: ArrayLike,
        keyphasor: Optional[ArrayLike] = None,
        pulses: Optional[ArrayLike] = None,
        threshold: Optional[float] = None,
        hysteresis: Optional[float] = None,
        edge: str = "rising",
        angles: Optional[ArrayLike] = None,
        per_revolution: int = 1,
        uneven: bool = False,
        names: Optional[Sequence[str]] = None,
        unit: str = "",
        time_unit: str = "s",
    ) -> None:
        if not channels:
            raise BadInput("there is no channel, expected at least one")
        self.angles = None if angles is None else _numbers(angles, "angles")  #: [channels] rad, or None
        if self.angles is not None and len(self.angles) != len(channels):
            raise BadInput(f"there are {len(self.angles)} angles, expected one for each of {len(channels)} channels")
        for angle in () if self.angles is None else self.angles:
            if abs(angle) > 2 * np.pi:
                raise BadInput(
                    f"an angle is {angle:g}, expected rad, at most a turn of 2 pi: {angle:g} degrees are "
                    f"numpy.radians({angle:g})"
                )
        self.names = _names(channels, names, self.angles)
        self.channels = _stacked(channels, self.names)  #: [channels][count]
        self.time = _times(time, self.channels.shape[1])  #: [count]
        self.unit, self.time_unit = unit, time_unit
        if (keyphasor is None) == (pulses is None):
            raise BadInput("expected either a keyphasor or pulses")
        pulses = (
            _numbers(pulses, "pulses")
            if keyphasor is None
            else find_pulses(self.time, keyphasor, threshold, hysteresis, edge)
        )
        if _whole(per_revolution, "the pulses per revolution") < 1:
            raise BadInput("there are 0 pulses per revolution, expected 1 or more")
        every = self._speed_between(pulses)
        if not uneven:
            check_pulses(pulses)
        if per_revolution == 1:
            _doubt_teeth(self.time, self.channels, pulses)
        #: [pulses] instants of the pulses, one for each revolution
        self.pulses = pulses[:: int(per_revolution)].copy()
        #: [pulses - 1] mean between them, rad per unit of time
        self.speed = every if per_revolution == 1 else self._speed_between(self.pulses)

    def __setattr__(self, name: str, value) -> None:
        if name in self.__dict__ and name not in ("unit", "time_unit"):
            raise AttributeError(f"{name} of a record stays: make another one, Record(...), of other signals")
        super().__setattr__(name, value)

    @property
    def size(self) -> float:
        """Half the diagonal of the bounds of all channels, with which analyses of sections compare distances."""
        return motion_size(self.channels)

    @property
    def plot(self) -> "Plots":
        """Functions that draw figures, as ``result.plot`` does."""
        from ._signals_plot import Plots

        return Plots(self)

    def __repr__(self) -> str:
        return f"<{len(self.names)} channels of {self.time.size} samples, {len(self.speed)} revolutions>"

    def channel(self, name: "str | int") -> int:
        """Returns the index of a channel by its name or number."""
        if isinstance(name, str):
            if name not in self.names:
                raise BadInput(f"there is no channel '{name}', expected one of: {', '.join(self.names)}")
            return self.names.index(name)
        if not 0 <= name < len(self.names):
            raise BadInput(f"there is no channel {name}, expected 0 to {len(self.names) - 1}")
        return int(name)

    @staticmethod
    def _speed_between(pulses: np.ndarray) -> np.ndarray:
        speed = np.empty(max(0, len(pulses) - 1))
        check(lib.whirl_signals_speed(_at(pulses), len(pulses), _at(speed)))
        return speed

    def _sampled(self):
        """Returns the first arguments of all functions of the library."""
        count = self.channels.shape[1]
        return _at(self.time), _at(self.channels), count, len(self.names), _at(self.pulses), len(self.pulses)

    # ---------------------------------------------------------------- by the angle

    def section(self, phase: float = 0.0, order: int = 7) -> np.ndarray:
        """Returns the section [points][channels]: all channels at every pulse, or at an angle after it.

        Parameters
        ----------
        phase : float
            Angle after the pulse, 0 to 2 pi rad. Above 0, the last pulse has no point, as no other pulse follows.
        order : int
            Order of the polynomials between samples: 1 (straight lines), 3, 5, 7 or 9.
        """
        points, found = np.empty((len(self.pulses), len(self.names))), ffi.new("size_t *")
        check(lib.whirl_signals_section(*self._sampled(), float(phase), _whole(order, "the order"), _at(points), found))
        return points[: found[0]]

    def resample(self, samples: Optional[int] = None, order: int = 7) -> np.ndarray:
        """Returns the channels at equal angles [channels][revolutions][samples] (order tracking).

        Sample j is 2 pi (j + 1)/samples after the pulse of its revolution. ``resample().mean(axis=1)`` is the
        average over all revolutions.

        Parameters
        ----------
        samples : int, optional
            Samples of a revolution; default: enough to lose no sample of the record. With fewer, orders above samples/2
            appear as lower ones (aliases).
        order : int
            Order of the polynomials between samples: 1, 3, 5, 7 or 9.
        """
        time, values, count, channels, pulses, pulse_count = self._sampled()
        if samples is None:
            enough = ffi.new("size_t *")
            check(lib.whirl_signals_samples(time, count, pulses, pulse_count, enough))
            samples = enough[0]
        samples = _whole(samples, "samples")
        if channels * len(self.speed) * samples > 1_000_000_000:  # the library's limit, before memory is allocated
            raise BadInput(f"{samples} samples of {len(self.speed)} revolutions are too many")
        turned = np.empty((channels, len(self.speed), samples))
        check(lib.whirl_signals_resample(*self._sampled(), samples, _whole(order, "the order"), _at(turned)))
        return turned

    def displacements(self, x: "str | int" = 0, y: "str | int" = 1) -> np.ndarray:
        """Returns displacements [2][count] along x and y, from two probes of a plane at their angles."""
        pair = self.channels[[self.channel(x), self.channel(y)]]
        return pair if self.angles is None else self._turned(pair, x, y)

    def _turned(self, pair: np.ndarray, x, y) -> np.ndarray:
        first, second = (float(self.angles[self.channel(name)]) for name in (x, y))
        out = np.empty_like(pair)
        check(lib.whirl_signals_axes(_at(pair[0]), _at(pair[1]), pair[0].size, first, second, _at(out[0]), _at(out[1])))
        return out

    # ---------------------------------------------------------------- orders over time

    def vold_kalman(
        self,
        orders: "float | Sequence[float]" = (1.0,),
        *,
        bandwidth: "float | Sequence[float]",
        poles: int = 2,
        phases: Optional[ArrayLike] = None,
    ) -> Envelopes:
        """Tracks orders of all channels at every sample between the first and the last pulse (:func:`vold_kalman`).

        Means of the channels are subtracted. Samples must be equally far apart. ``phases`` are [others][count], at
        every sample of the record.
        """
        inside, step = self._even()
        time = self.time[inside]
        if phases is not None:
            phases = np.atleast_2d(phases)
            if phases.shape[1] != len(self.time):
                raise BadInput(f"the phases have {phases.shape[1]} samples, the record has {len(self.time)}")
            phases = phases[:, inside]
        given = dict(rate=1.0 / step, bandwidth=bandwidth, poles=poles, phases=phases)
        values = self.channels[:, inside]
        values = values - values.mean(axis=1, keepdims=True)
        return vold_kalman(values, self._angle(time), orders, **given)._replace(time=time)

    def track(
        self,
        orders: "float | Sequence[float]" = (1.0,),
        revolutions: int = 1,
        slow_roll: Optional[float] = None,
        x: "str | int" = 0,
        y: "str | int | None" = 1,
        samples: Optional[int] = None,
        order: int = 7,
    ) -> TrackedOrders:
        """Tracks orders over the turns, by exact integrals of samples at equal angles over blocks of one or more turns.

        Parameters
        ----------
        orders : float or sequence of float
            Multiples of 1/revolutions.
        revolutions : int
            Turns of a row. More turns resolve fractions of an order and average noise, but follow a change of speed
            less well.
        slow_roll : float, optional
            Speed, rad per unit of time. The vectors of every channel and order at this speed, which show what probes
            read of a shaft without vibration, are subtracted from those of all rows. It must be within the record and
            below the resonances.
        x, y : str or int
            Two probes for ``forward`` and ``backward``; none with ``y=None``, or if there is one channel.
        samples, order
            As in :meth:`resample`.
        """
        turned, revolutions = self.resample(samples, order), _whole(revolutions, "the number of revolutions")
        orders = _numbers(np.atleast_1d(orders), "the orders")
        channels, turns, samples = turned.shape
        tracked = np.ascontiguousarray(np.append(0.0, orders))
        rows = turns // max(1, revolutions)
        out = np.empty((channels, len(tracked), rows, 2))
        arrays = _at(tracked), len(tracked), revolutions, _at(out)
        check(lib.whirl_signals_track(_at(turned), channels, turns, samples, *arrays))
        vectors, mean = (out[..., 0] + 1j * out[..., 1])[:, 1:], out[:, 0, :, 0]
        ends = self.pulses[: rows * revolutions + 1 : revolutions]
        speed = 2.0 * np.pi * revolutions / np.diff(ends)

        rolled = np.zeros((channels, len(orders)), dtype=complex)
        if slow_roll is not None:
            rolled = _at_speed(speed, vectors, float(slow_roll))
            vectors = vectors - rolled[..., None]
            for once in np.flatnonzero(orders == 1.0):
                _check_slow_roll(speed, vectors[:, once], rolled[:, once], float(slow_roll), self.names)

        forward = backward = None
        if y is not None and channels > 1:
            pair = [self.channel(x), self.channel(y)]
            along = self._along(vectors[pair].reshape(2, -1), x, y).reshape(2, *vectors.shape[1:])
            forward, backward = 0.5 * (along[0] + 1j * along[1]), 0.5 * (along[0] - 1j * along[1])
        middle = 0.5 * (ends[1:] + ends[:-1])
        return TrackedOrders(orders, middle, speed, vectors, mean, rolled, forward, backward, tuple(self.names))

    def _along(self, pair: np.ndarray, x, y) -> np.ndarray:
        """Returns complex vectors of two probes [2][count] along x and y."""
        if self.angles is None:
            return pair
        parts = [self._turned(np.ascontiguousarray(part), x, y) for part in (pair.real, pair.imag)]
        return parts[0] + 1j * parts[1]

    def _even(self) -> tuple:
        """Returns the samples (a slice) from the first to the last pulse, and their time step, which must be
        constant."""
        first = int(np.searchsorted(self.time, self.pulses[0], side="left"))
        inside = slice(first, int(np.searchsorted(self.time, self.pulses[-1], side="right")))
        time = self.time[inside]
        if len(time) < 2:
            raise BadInput(f"there are {len(time)} samples between the pulses, expected more")
        step = (time[-1] - time[0]) / (len(time) - 1)
        uneven = np.flatnonzero(~(np.abs(np.diff(time) - step) <= 0.01 * step))
        if len(uneven) > 0:
            raise BadInput(
                f"samples {first + uneven[0]} and {first + uneven[0] + 1} are "
                f"{time[uneven[0] + 1] - time[uneven[0]]:.6g} apart, others {step:.6g}: expected a constant rate"
            )
        return inside, step

    def _angle(self, time: np.ndarray) -> np.ndarray:
        """Returns the angle of the shaft at times within the pulses, rad from the first pulse."""
        time, angle = np.ascontiguousarray(time), np.empty(len(time))
        check(lib.whirl_signals_angle(_at(self.pulses), len(self.pulses), _at(time), len(time), _at(angle)))
        return angle

    # ---------------------------------------------------------------- spectra

    def spectrum(self, highest_order: float = 10.0, samples: Optional[int] = None, order: int = 7) -> Spectrum:
        """Returns order spectra of all channels, with a Hann window over all revolutions and without means.

        ``samples`` and ``order`` as in :meth:`resample`. Needs 4 revolutions.
        """
        turned = self.resample(samples, order)
        made = [_spectrum(channel.ravel(), None, turned.shape[2], float(highest_order)) for channel in turned]
        rows, lines, synchronous = zip(*made)
        return Spectrum(
            rows[0][:, 0],
            np.stack([row[:, 1] for row in rows]),
            tuple(line[:, :2] for line in lines),
            np.array([part[0, 0] for part in synchronous]),
            np.array([part[1, 0] for part in synchronous]),
        )

    def full_spectrum(
        self,
        highest_order: float = 10.0,
        x: "str | int" = 0,
        y: "str | int" = 1,
        samples: Optional[int] = None,
        order: int = 7,
    ) -> FullSpectrum:
        """Returns the full spectrum of two probes of a plane, at their angles: forward and backward whirl.

        ``samples`` and ``order`` as in :meth:`resample`. Needs 4 revolutions.
        """
        turned = self.resample(samples, order)
        samples = turned.shape[2]
        pair = turned[[self.channel(x), self.channel(y)]].reshape(2, -1)
        pair = pair if self.angles is None else self._turned(pair, x, y)
        rows, lines, synchronous = _spectrum(pair[0], pair[1], samples, float(highest_order))
        return FullSpectrum(*rows.T, lines, *synchronous)

    def spectrogram(
        self, window: float, step: Optional[float] = None, x: "str | int" = 0, y: "str | int | None" = 1
    ) -> Spectrogram:
        """Returns spectra of windows over time, from the first to the last pulse, with a Hann window and without means.

        Longer windows separate nearer frequencies, but blur an order while the speed changes: ``kept`` is the share of
        1X that is left. Samples must be equally far apart.

        Parameters
        ----------
        window : float
            Duration, in the unit of time.
        step : float, optional
            Time from one window to the next; default: a quarter of the window.
        x, y : str or int
            Two probes of a plane, at their angles; one channel, x, with ``y=None`` or if there is only one.
        """
        inside, spacing = self._even()
        pair = self._pair(self.channels[:, inside], x, y)
        count = pair[0].size
        given = [float(window), 0.25 * float(window) if step is None else float(step)]
        if not (np.isfinite(given).all() and min(given) > 0.0):
            raise BadInput(f"windows last {given[0]:g} and are {given[1]:g} apart, expected times above 0")
        length, apart = min(round(given[0] / spacing), count + 1), max(1, min(round(given[1] / spacing), count))
        rows = max(0, count - length) // apart + 1
        bins = lib.whirl_signals_frequencies(length)
        if rows * bins * 4 > 1_000_000_000:  # the library's limit, before memory is allocated
            raise BadInput(f"{rows} windows of {bins} frequencies are too many: take fewer, step=...")
        out, second = np.empty((rows, bins, 4)), _at(pair[1]) if len(pair) > 1 else ffi.NULL
        check(lib.whirl_signals_spectrogram(_at(pair[0]), second, count, length, apart, _at(out)))

        # Compute the speed from the angle, and its change by parabolas through the angle at the ends and the middle of
        # windows.
        first, duration = self.time[inside][0] + apart * spacing * np.arange(rows), (length - 1) * spacing
        ends = [self._angle(np.minimum(first + part * duration, self.pulses[-1])) for part in (0.0, 0.5, 1.0)]
        speed = (ends[2] - ends[0]) / duration
        sweep = (ends[2] - 2.0 * ends[1] + ends[0]) * 4.0 / (2.0 * np.pi) * (length * spacing / duration) ** 2
        frequency, columns = np.arange(bins) / (length * spacing), _columns(out, len(pair))
        middle, whole = first + 0.5 * duration, length * spacing
        return Spectrogram(middle, speed, frequency, *columns, whole, sweep, sweep_kept(sweep))

    def cascade(
        self,
        revolutions: int = 16,
        step: Optional[int] = None,
        highest_order: float = 5.0,
        x: "str | int" = 0,
        y: "str | int | None" = 1,
        samples: Optional[int] = None,
        order: int = 7,
    ) -> Cascade:
        """Returns spectra of blocks of turns, over the speed: order spectra, and full spectra of two probes.

        Parameters
        ----------
        revolutions : int
            Turns of a block, at least 4; orders are 1/revolutions apart.
        step : int, optional
            Turns from one block to the next; default: a quarter of the block.
        highest_order : float
            Last order of the rows.
        x, y : str or int
            Two probes of a plane, at their angles; one channel, x, with ``y=None`` or if there is only one.
        samples, order
            As in :meth:`resample`.
        """
        turned = self.resample(samples, order)
        revolutions = _whole(revolutions, "the number of revolutions")
        apart = max(1, revolutions // 4) if step is None else _whole(step, "the step in revolutions")
        turns, samples = turned.shape[1:]
        if not (4 <= revolutions <= turns and apart > 0):
            raise BadInput(
                f"blocks have {revolutions} revolutions and are {apart} apart, expected blocks of 4 to {turns}, "
                "the record's, and a step of 1 or more"
            )
        pair = self._pair(turned.reshape(len(turned), -1), x, y)
        rows, first = [], np.arange(0, turns - revolutions + 1, apart)
        for begins in first * samples:
            parts = [np.ascontiguousarray(one[begins : begins + revolutions * samples]) for one in pair]
            rows.append(_spectrum(parts[0], parts[1] if len(parts) > 1 else None, samples, float(highest_order))[0])
        out = np.stack(rows)
        begins, ends = self.pulses[first], self.pulses[first + revolutions]
        speed = 2.0 * np.pi * revolutions / (ends - begins)
        change = (self.speed[first + revolutions - 1] - self.speed[first]) * revolutions / (revolutions - 1) / speed
        return Cascade(0.5 * (begins + ends), speed, out[0, :, 0], *_columns(out[..., 1:], len(pair)), change)

    def _pair(self, channels: np.ndarray, x, y) -> list:
        """Returns displacements along x and y of channels [channels][count]; one channel if there is no pair."""
        if y is None or len(self.names) == 1:
            return [np.ascontiguousarray(channels[self.channel(x)])]
        pair = np.ascontiguousarray(channels[[self.channel(x), self.channel(y)]])
        return list(pair if self.angles is None else self._turned(pair, x, y))

    # ---------------------------------------------------------------- sections

    def zero_one(self, phase: float = 0.0, order: int = 7) -> float:
        """Returns K of the 0-1 test for chaos of the section (:func:`zero_one`), which needs 100 revolutions.

        The section of a periodic motion varies only by noise, which the test takes for chaos: see first whether
        :meth:`recurrence` finds a period.
        """
        return zero_one(self.section(phase, order), self.size)

    def recurrence(
        self, radius: float = 0.1, tolerance: float = 0.05, shortest: int = 2, phase: float = 0.0, order: int = 7
    ) -> Recurrence:
        """Returns the recurrence of the section (:func:`recurrence`): period in revolutions, and recurrence
        quantification."""
        return recurrence(self.section(phase, order), self.size, radius, tolerance, shortest)


def bode(
    time: "float | ArrayLike",
    *channels: ArrayLike,
    orders: "float | Sequence[float]" = (1.0,),
    revolutions: int = 1,
    slow_roll: Optional[float] = None,
    y: "str | int | None" = 1,
    **record: Any,
) -> TrackedOrders:
    """Returns amplitude and lag of orders over the speed from raw signals, by :meth:`Record.track`.

    ``keyphasor`` (or ``pulses``), ``angles`` and further keywords are those of :class:`Record`. The first two channels
    are two probes of a plane; with ``y=None`` they are not.
    """
    return Record(time, *channels, **record).track(orders, revolutions, slow_roll, y=y)


def _columns(rows: np.ndarray, signals: int) -> list:
    """Returns the columns x, y, forward, backward of rows [...][4]; for one signal all but x are None."""
    return [rows[..., i].copy() if i == 0 or signals > 1 else None for i in range(4)]


def _names(channels, names, angles) -> list:
    if names is not None:
        names = [str(name) for name in names]
        if len(names) != len(channels) or len(set(names)) != len(names):
            raise BadInput(f"there are the names {', '.join(names)}, expected {len(channels)} different ones")
        return names
    usual = ["x", "y"] + [str(i) for i in range(2, len(channels))]
    if angles is not None:
        usual = [f"{degrees:.4g}°" for degrees in np.degrees(angles)]
    own = [str(getattr(channel, "name", None) or usual[i]) for i, channel in enumerate(channels)]
    return own if len(set(own)) == len(own) else [str(i) for i in range(len(channels))]


def _stacked(channels, names) -> np.ndarray:
    arrays = [_numbers(channel, f"channel '{name}'") for channel, name in zip(channels, names)]
    for array, name in zip(arrays, names):
        if array.size != arrays[0].size:
            raise BadInput(f"channel '{name}' has {array.size} samples, '{names[0]}' has {arrays[0].size}")
    return np.stack(arrays)


def _times(time, count: int) -> np.ndarray:
    if np.ndim(time) > 0:
        time = _numbers(time, "time")
        if time.size != count:
            raise BadInput(f"time has {time.size} samples, the channels have {count}")
        return time
    if not (float(time) > 0.0 and np.isfinite(float(time))):
        raise BadInput(f"the rate is {time}, expected samples a unit of time, above 0")
    return np.arange(count) / float(time)
