#!/usr/bin/env python3
"""The peers SciPy and Newmark at the run-up of runup.yaml, over the equations in C.

    runup_scipy.py LIBRARY scipy RTOL     solve_ivp (DOP853)
    runup_scipy.py LIBRARY newmark STEPS  Newmark's method in C, with so many steps of equal length

Prints the seconds of processor time, x and y at the end, m, and the speed there, rad/s.
"""
import ctypes
import sys
import time

import numpy as np
from scipy.integrate import solve_ivp

DURATION = 40.0
DOUBLES = ctypes.POINTER(ctypes.c_double)
library, method, number = ctypes.CDLL(sys.argv[1]), sys.argv[2], float(sys.argv[3])
library.bench_runup_slope.argtypes = (DOUBLES, DOUBLES)
library.bench_runup_newmark.argtypes = (DOUBLES, ctypes.c_double, ctypes.c_long)
library.bench_runup_slope.restype = library.bench_runup_newmark.restype = None


def doubles(array):
    return array.ctypes.data_as(DOUBLES)


def slope(t, z):
    out = np.empty(6)
    library.bench_runup_slope(doubles(np.ascontiguousarray(z)), doubles(out))
    return out


z = np.zeros(6)
start = time.process_time()
if method == "scipy":
    z = solve_ivp(slope, (0.0, DURATION), z, method="DOP853", rtol=number, atol=1e-6 * number).y[:, -1]
else:
    library.bench_runup_newmark(doubles(z), DURATION / number, int(number))
print(time.process_time() - start, *(f"{value:.17g}" for value in (z[0], z[1], z[5])))
