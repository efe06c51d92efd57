#!/usr/bin/python3
"""Writes measured.csv: what two proximity probes and a keyphasor see of a rotor that rubs every other revolution.

    examples/measured.py [FILE]

Whirl computes the motion of a disc of 10 kg that touches its stator at 7000 rpm, beyond twice its critical speed: P-2.
Then it is measured: the speed hunts by 1 %, the probes stand at 45 and 135 degrees, a recorder takes 10 000 samples a
second to the nearest 0.1 um with some noise, and the keyphasor gives -10 V but for a notch in the shaft.
"""

import sys

import numpy as np

import whirl

CASE = """
whirl: 1
parameters: {speed: 7000 rpm, gap: 0.2 mm}
rotor:
  speed: = speed
  length_scale: = gap
  stations:
    disc: {mass: 10 kg, damping: 400 N.s/m, eccentricity: 0.04 mm}
  elements:
    - shaft:   {between: [disc, ground], k1: 1 MN/m, k2: 1 MN/m}
    - rub:     {at: disc, gap: = gap, stiffness: 20 MN/m, friction: 0.1}
    - gravity: 9.81 m/s2
study:
  sweep: {parameter: speed, values: [7000 rpm]}
  integrate: {method: rk4, steps_per_revolution: 1024, transient: 600, record: 256}
  keep: {waveform: 256, samples: 512}
  analyze: [poincare, regime, spectrum, waveform]
"""
RATE, SECONDS, HUNTING, PERIOD = 10_000, 2.0, 0.01, 1.3  # Hz, s, share of the speed, s


def turns_at(time):
    """Turns of the shaft, whose speed is 7000/60 (1 + HUNTING sin(2 pi time/PERIOD)) Hz."""
    return 7000 / 60 * (time + HUNTING * PERIOD / (2 * np.pi) * (1 - np.cos(2 * np.pi * time / PERIOD)))


def measure(result):
    """Columns of the record: time in s, two probes in um, the keyphasor in V."""
    table = result["sweep"]
    motion = table["waveform/samples"][0, 0] * table.length_scale[0] * 1e6  # um; sample j at (j + 1)/512 turns
    noise = np.random.default_rng(7)
    time = np.arange(int(RATE * SECONDS)) / RATE
    turns = turns_at(time)
    x, y = (np.interp(turns, np.arange(1, len(motion) + 1) / 512, coordinate) for coordinate in motion.T)
    probes = [x * np.cos(angle) + y * np.sin(angle) for angle in np.radians([45, 135])]
    probes = [np.round(probe + noise.normal(0, 0.2, time.size), 1) for probe in probes]
    after = np.remainder(turns + 0.5, 1) - 0.5  # turns after the nearest whole turn, at which the notch's edge passes
    notch = np.clip(0.5 + np.minimum(after, 0.1 - after) / 0.03, 0, 1)
    return time, *probes, np.round(-10 + 8 * notch + noise.normal(0, 0.05, time.size), 2)


if __name__ == "__main__":
    path = sys.argv[1] if len(sys.argv) > 1 else "measured.csv"
    columns = np.column_stack(measure(whirl.run(whirl.Case(text=CASE), progress=False)))
    header = "time / s,probe at 45 deg / um,probe at 135 deg / um,keyphasor / V"
    np.savetxt(path, columns, delimiter=",", header=header, comments="", fmt=["%.4f", "%.1f", "%.1f", "%.2f"])
