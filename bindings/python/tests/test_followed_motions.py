"""Tests motions over time with events: closed forms of bouncing balls, switches, and the reasons why motions end."""

import numpy as np
import pytest

import whirl
from whirl.systems import Event, System

G = 9.81


def fall(t, x, p):
    return x[1], -G


def floor(**more):
    return Event(lambda t, x, p: x[0], -1, lambda t, x, p: [x[0], -p.e * x[1]], name="floor", **more)


@pytest.mark.parametrize("e", [0.3, 0.7, 0.95])
def test_a_ball_bounces_until_no_time_is_left(e):
    """Tests a bouncing ball: bounce n is at t1 (1 + 2 sum of e^k, k < n) with the speed e^(n-1) g t1, and the bounces
    accumulate at t1 (1 + e)/(1 - e)."""
    first = np.sqrt(2 / G)
    last = first * (1 + e) / (1 - e)
    system = System(fall, [1, 0], {"e": e})
    motion = system.follow([0, 0.5 * (first + last), 2 * last], floor(), rtol=1e-12)
    n = np.arange(len(motion.events))
    assert motion.end == "accumulated" and "floor" in motion.reason and len(n) > 10
    expected = first * (1 + 2 * (e - e ** (n + 1)) / (1 - e))
    assert np.abs(np.array([each.time for each in motion.events]) - expected).max() < 1e-10 * last
    assert np.abs([each.before[1] + e**k * G * first for k, each in zip(n, motion.events)]).max() < 1e-8
    assert abs(motion.time - last) < 1e-9 * last and len(motion.times) == 2
    # The second instant is between two bounces: the height follows from the flight since the last bounce.
    passed = motion.times[1] - expected[expected <= motion.times[1]][-1]
    k = (expected <= motion.times[1]).sum()
    height = e**k * G * first * passed - 0.5 * G * passed**2
    assert abs(motion.states[1, 0] - height) < 1e-9


def test_a_ball_that_does_not_bounce_stays():
    motion = System(fall, [1, 0], {"e": 0.0}).follow([0, 10], floor())
    assert motion.end == "accumulated" and motion.reason == "after event 'floor' the motion stays where it happens"
    assert len(motion.events) == 1 and abs(motion.time - np.sqrt(2 / G)) < 1e-12


def test_perfect_bounces_go_on():
    first = np.sqrt(2 / G)
    motion = System(fall, [1, 0], {"e": 1.0}).follow(np.linspace(0, 1000.2 * 2 * first, 5), floor(), rtol=1e-12)
    assert motion.end == "done" and len(motion.events) == 1000
    n = np.arange(len(motion.events))
    assert np.abs(np.array([each.time for each in motion.events]) - first * (1 + 2 * n)).max() < 1e-8


def test_switches_without_a_reset_and_ends():
    """Tests an oscillator with events that have no reset, that end the motion, or that switch a coordinate. The system
    has no period."""
    system = System(lambda t, x, p: (x[1], -x[0]), [0, 1])
    both = system.follow([0, 20], Event(lambda t, x, p: x[0] - 0.5), rtol=1e-12)
    times = [np.pi / 6, 5 * np.pi / 6, 13 * np.pi / 6, 17 * np.pi / 6, 25 * np.pi / 6, 29 * np.pi / 6, 37 * np.pi / 6]
    assert np.abs(np.array([each.time for each in both.events]) - times).max() < 1e-10
    falling = system.follow([0, 20], Event(lambda t, x, p: x[0], -1, ends=True, name="top"), rtol=1e-12)
    assert falling.end == "event" and falling.reason == "event 'top'" and abs(falling.time - np.pi) < 1e-11
    toggled = System(lambda t, x, p: (x[1], -x[0], 0), [0, 1, 1]).follow(
        [0, 20], Event(lambda t, x, p: x[0], 0, lambda t, x, p: [x[0], x[1], -x[2]]), rtol=1e-12
    )
    assert toggled.end == "done" and len(toggled.events) == 6 and toggled.states[-1, 2] == 1


def test_scales_and_lanes():
    """Tests a coordinate of 3e5 with scales, by which tolerances are relative to its size, and slopes in lanes."""
    lanes = System(lambda t, x, p: np.array([x[1], -4e6 * x[0]]), [3e5, 0], lanes=True, scales={0: 3e5, 1: 6e8})
    motion = lanes.follow([0, 0.01], rtol=1e-11)
    assert abs(motion.states[-1, 0] - 3e5 * np.cos(20)) < 3e5 * 1e-8


NO_EVENTS = (
    (
        Event(lambda t, x, p: x[0], -1, lambda t, x, p: [1.0]),
        r"the reset of .* a state of shape \(1,\), expected \(2,\)",
    ),
    (Event(lambda t, x, p: x[0], -1, lambda t, x, p: None), "the reset of event 'event 0' gave None, expected real"),
    (
        Event(lambda t, x, p: x[0], -1, [1.0, 0.0]),
        r"the reset of event 'event 0' is \[1.0, 0.0\], expected a Python fun",
    ),
    (
        Event(lambda t, x, p: x, name="all"),
        r"the value of event 'all' gave numbers of shape \(2,\), expected one number",
    ),
    (Event(lambda t, x, p: None), "the value of event 'event 0' gave None, expected real numbers"),
    (Event(lambda t, x, p: 1j), "the value of event 'event 0' gave 1j, expected real numbers"),
    (Event("x"), "the value of event 'event 0' is 'x', expected a Python function of t, x, p"),
    (Event(lambda t, x, p: x[0], "up"), "event 'event 0' has passing 'up', expected 1 for rising"),
    (Event(lambda t, x, p: x[0], 2), "event 'event 0' has passing 2, expected 1 for rising"),
    (lambda t, x, p: x[0], r"event 0 is <function .*, expected whirl.systems.Event\(value"),
)


def test_systems_that_cannot_be_followed_are_refused():
    system = System(fall, [1, 0], {"e": 0.5})
    with pytest.raises(whirl.BadInput, match="instant 1 of the motion is 0, expected instants that rise"):
        system.follow([1, 0])
    with pytest.raises(whirl.BadInput, match="has a reset, expected one of both"):
        system.follow([0, 1], floor(ends=True))
    with pytest.raises(whirl.BadInput, match="give one of both"):
        system.response()
    with pytest.raises(ZeroDivisionError):
        system.follow([0, 1], Event(lambda t, x, p: 1 / 0))
    with pytest.raises(whirl.NumericalFailure, match="function of event 'odd' is no number at t = 0"):
        system.follow([0, 1], Event(lambda t, x, p: float("nan"), name="odd"))
    for event, words in NO_EVENTS:
        with pytest.raises(whirl.BadInput, match=words):
            system.follow([0, 1], [event])
    burst = System(lambda t, x, p: (x[0] ** 2,), [1.0]).follow([0, 0.5, 2])
    assert burst.end in ("diverged", "stuck") and abs(burst.time - 1) < 1e-2 and abs(burst.states[1, 0] - 2) < 1e-6
