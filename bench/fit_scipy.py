#!/usr/bin/env python3
"""The peer SciPy at the fit of fit.yaml: least_squares with derivatives by differences.

    fit_scipy.py LIBRARY CASE write FOLDER    writes the case and its three tables of samples, and many.yaml: one step
                                              of the same fit to amplitudes at 180 speeds
    fit_scipy.py LIBRARY CASE whirl 2-point   orbits by whirl in C, by Newton's method from the orbit before
    fit_scipy.py LIBRARY CASE scipy 2-point   orbits by fsolve and solve_ivp (DOP853) over the right-hand side in C

The last two print how many orbits were computed, the seconds of processor time, and the largest error of the five
parameters, as a part of them.
"""
import ctypes
import pathlib
import shutil
import sys
import time

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import fsolve, least_squares

SPEEDS, SAMPLES, RTOL = (0.85, 1.0, 1.15), 64, 1e-11
TRUTH = np.array([0.9, 1.0, 10.0, 0.05, 0.2])
START = np.array([0.92, 0.99, 10.5, 0.06, 0.21])
# found by an independent program (tests/validation/test_fit.c)
FOUND = np.array([0.9000638546263, 0.9998612866208, 9.995958362655, 0.0500193183249, 0.2000210795785])
ANGLES = 2 * np.pi * np.arange(SAMPLES) / SAMPLES

library, case, orbits_by, what = ctypes.CDLL(sys.argv[1]), sys.argv[2], sys.argv[3], sys.argv[4]
DOUBLES = ctypes.POINTER(ctypes.c_double)
library.bench_fit_open.restype = ctypes.c_void_p
library.bench_fit_orbit.restype = ctypes.c_bool
library.bench_fit_orbit.argtypes = (ctypes.c_void_p, DOUBLES, ctypes.c_double, ctypes.c_int, ctypes.c_double, DOUBLES,
                                    DOUBLES)
library.bench_fit_slope.argtypes = (DOUBLES, ctypes.c_double, ctypes.c_double, DOUBLES, DOUBLES)
library.bench_fit_slope.restype = None


def doubles(array):
    return array.ctypes.data_as(DOUBLES)


class Whirl:
    def __init__(self):
        self.study = library.bench_fit_open(case.encode())

    def orbit(self, values, omega, x, revolutions=0, rtol=RTOL):
        values, x, samples = np.array(values, float), x.copy(), np.empty((SAMPLES, 2))
        if not library.bench_fit_orbit(self.study, doubles(values), omega, revolutions, rtol, doubles(x),
                                       doubles(samples)):
            sys.exit("bench: whirl finds no orbit")
        return x, samples


class Scipy:
    def orbit(self, values, omega, x, revolutions=0):
        values, slope, period = np.array(values, float), np.empty(4), 2 * np.pi / omega
        own, out = doubles(values), doubles(slope)

        def right_hand_side(t, state):
            library.bench_fit_slope(own, omega, t, doubles(state), out)
            return slope.copy()

        def carry(x, **more):
            return solve_ivp(right_hand_side, (0.0, period), x, "DOP853", rtol=RTOL, atol=1e-13, **more).y

        for _ in range(revolutions):
            x = carry(x)[:, -1]
        x = fsolve(lambda x: carry(x)[:, -1] - x, x, xtol=1e-11)
        return x, carry(x, t_eval=ANGLES / omega)[:2].T


def disturbed(samples, omega):
    k = np.arange(SAMPLES)
    return samples + 0.002 * np.column_stack((np.sin(7 * k + 1 + 3 * omega), np.cos(11 * k + 2 + 5 * omega)))


def write_many(folder):
    machine, x, rows = Whirl(), begin, []
    for omega in np.linspace(0.8, 0.95, 180):
        x, samples = machine.orbit(TRUTH, omega, x, 30)
        amplitudes = 2 / SAMPLES * abs(np.exp(-1j * ANGLES) @ samples)
        rows.append((omega, *amplitudes))
    np.savetxt(folder / "many.csv", rows, "%.17g", ",", comments="", header="omega [rad/s], disc x [m], disc y [m]")
    text = pathlib.Path(case).read_text().partition("    data:")[0] + "    data: many.csv\n    steps: 1\n"
    (folder / "many.yaml").write_text(text)


begin = np.array([0.7, 0.0, 0.0, 0.7])
measured = [disturbed(Whirl().orbit(TRUTH, omega, begin, 100, 1e-13)[1], omega) for omega in SPEEDS]
if orbits_by == "write":
    for number, samples in enumerate(measured, 1):
        rows = np.column_stack((np.degrees(ANGLES), samples))
        np.savetxt(pathlib.Path(what, f"orbit-{number}.csv"), rows, "%.17g", ",", comments="",
                   header="angle [deg], disc x [m], disc y [m]")
    shutil.copy(case, pathlib.Path(what, "fit.yaml"))
    write_many(pathlib.Path(what))
    sys.exit()

maker = {"whirl": Whirl, "scipy": Scipy}[orbits_by]()
count, kept, clock = 0, [], time.process_time()


def residuals(values):
    global count
    count += len(SPEEDS)
    found = [maker.orbit(values, omega, x) for omega, x in zip(SPEEDS, kept)]
    return np.concatenate([(samples - data).ravel() for (_, samples), data in zip(found, measured)])


for omega in SPEEDS:
    kept.append(maker.orbit(START, omega, begin, 30)[0])
fit = least_squares(residuals, START, what, x_scale="jac", xtol=1e-8, ftol=1e-14, gtol=1e-14)
print(f"{count}\t{time.process_time() - clock:.6g}\t{np.max(np.abs(fit.x / FOUND - 1)):.3g}")
