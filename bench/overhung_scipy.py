"""The peer SciPy on the overhung rotor: its stiff solvers BDF and Radau, over 20 revolutions.

    overhung_scipy.py MATRICES
"""
import sys
import time

import numpy as np
from scipy.integrate import solve_ivp

N, PORTS = 22, 6
SPEED, CLEARANCE, VISCOSITY, GAP = 628.0, 80e-6, 0.02, 150e-6 / 80e-6
PUSH, DAMPING, FRICTION = 20e6 / SPEED**2, 500.0 / SPEED, 0.1
RADIUS, LENGTH = np.array([0.02, 0.025]), np.array([0.025, 0.03])
FILM = VISCOSITY * RADIUS * LENGTH**3 / (4 * CLEARANCE**3 * SPEED)

rows = np.loadtxt(sys.argv[1])
K, G, P = rows[:N], rows[N:2 * N], rows[2 * N:2 * N + PORTS].T
g, u, w = rows[2 * N + PORTS:]
LINEAR = np.block([[np.zeros((N, N)), np.eye(N)], [-K, -G]])


def films(x, y, vx, vy):
    A, B = x - 2 * vy, y + 2 * vx
    q, CC = 1 - x * x - y * y, A * A + B * B
    C, root = np.sqrt(CC), np.sqrt(q)
    P, U = x * B - y * A, x * A + y * B
    angle = (np.pi + 2 * np.arctan(P / (C * root))) / root
    S2, CV3 = -2 * U * C / (q * CC + P * P), 3 * (2 * C + P * angle) / q
    return -FILM / q * (x * CV3 + B * angle + A * S2), -FILM / q * (y * CV3 - A * angle + B * S2)


def slope(t, z):
    F = np.zeros(PORTS)
    F[0:4:2], F[1:4:2] = films(z[0:4:2], z[1:4:2], z[N:N + 4:2], z[N + 1:N + 4:2])
    x, y = z[4:6]
    r = np.hypot(x, y)
    if r > GAP:
        push = max(PUSH * (r - GAP) + DAMPING * (x * z[N + 4] + y * z[N + 5]) / r, 0.0) / r
        F[4:] = -push * (x - FRICTION * y), -push * (y + FRICTION * x)
    dz = LINEAR @ z
    dz[N:] += P @ F + np.cos(t) * u + np.sin(t) * w - g
    return dz


for method in ("BDF", "Radau"):
    z = np.zeros(2 * N)
    z[1:PORTS:2] = -0.3, -0.6, -0.8
    revolutions, start = 20, time.process_time()
    end = 2 * np.pi * revolutions
    z = solve_ivp(slope, (0.0, end), z, method, t_eval=[end], rtol=1e-6, atol=1e-9).y[:, -1]
    print(f"SciPy {method}\t{revolutions / (time.process_time() - start):.6g}\t{z[1]:.13f}")
