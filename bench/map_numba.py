"""The peer Numba over a map: dopri5 with step control in compiled loops, point after point (map_equations.h).

    map_numba.py TRANSIENT RECORD STRIDE
"""
import math
import sys
import time

import numpy as np
from numba import njit

R_M, XI1, XI2, W = 8.4, 0.0157509, 0.286154, 0.2
G, S_F, R_DELTA, R_CK, F = 0.115976, 0.0045, 1.2, 10.0, 0.1
K1, K2, PUSH = 1 / (2 * R_M * W * W), 1 / (4 * W * W), R_CK / (R_M * W * W)
RTOL, ATOL, PERTURBATION, SIDE = 1e-6, 1e-9, 1e-8, 16
TIMES = np.array([0, 1 / 5, 3 / 10, 4 / 5, 8 / 9, 1, 1])
STAGES = np.array([[0, 0, 0, 0, 0, 0], [1 / 5, 0, 0, 0, 0, 0], [3 / 40, 9 / 40, 0, 0, 0, 0],
                   [44 / 45, -56 / 15, 32 / 9, 0, 0, 0], [19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729, 0, 0],
                   [9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656, 0],
                   [35 / 384, 0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84]])
ERRORS = np.array([71 / 57600, 0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40])


@njit(fastmath=True, error_model="numpy")
def slope(r_k, rho, t, z, dz):
    a, b = r_k + 1, r_k - 1
    c, s = math.cos(t), math.sin(t)
    c2, s2 = 1 - 2 * s * s, 2 * s * c
    dx, dy = z[0] - z[2], z[1] - z[3]
    sx = (a + b * c2) * dx + b * s2 * dy
    sy = (a + b * c2) * dy + b * s2 * dx
    push = PUSH * min(R_DELTA / math.sqrt(z[0] * z[0] + z[1] * z[1]) - 1, 0.0)
    x2, y2, u2, v2 = z[2], z[3], z[6], z[7]
    A, B = x2 - 2 * v2, y2 + 2 * u2
    q = 1 - x2 * x2 - y2 * y2
    C, root = math.sqrt(A * A + B * B), math.sqrt(q)
    P, U = x2 * B - y2 * A, x2 * A + y2 * B
    g = (math.pi + 2 * math.atan(P / (C * root))) / root
    S2 = -2 * U * C / (q * C * C + P * P)
    CV3 = 3 * (2 * C + P * g) / q
    dz[0], dz[1], dz[2], dz[3] = z[4], z[5], z[6], z[7]
    dz[4] = -XI1 * z[4] - K1 * sx + rho * c + push * (z[0] - F * z[1])
    dz[5] = -XI1 * z[5] - K1 * sy + rho * s + push * (z[1] + F * z[0]) - G
    dz[6] = -0.5 * XI2 * u2 + K2 * sx - S_F * (x2 * CV3 + B * g + A * S2) / q
    dz[7] = -0.5 * XI2 * v2 + K2 * sy - S_F * (y2 * CV3 - A * g + B * S2) / q - G


@njit(fastmath=True, error_model="numpy")
def revolve(r_k, rho, z, h, k, y):
    """Carries the rotor over one revolution. Returns the last step and the largest radius of the disc."""
    t, largest, end = 0.0, 0.0, 2 * math.pi
    slope(r_k, rho, t, z, k[0])
    while t < end:
        step = min(h, end - t)
        for i in range(1, 7):
            for n in range(8):
                rise = 0.0
                for j in range(i):
                    rise += STAGES[i, j] * k[j, n]
                y[n] = z[n] + step * rise
            slope(r_k, rho, t + TIMES[i] * step, y, k[i])
        error = 0.0
        for n in range(8):
            off = 0.0
            for i in range(7):
                off += ERRORS[i] * k[i, n]
            error = max(error, abs(step * off) / (ATOL + RTOL * max(abs(z[n]), abs(y[n]))))
        if error <= 1:
            t = end if step == end - t else t + step
            for n in range(8):
                z[n] = y[n]
                k[0, n] = k[6, n]
            largest = max(largest, z[0] * z[0] + z[1] * z[1])
        factor = min(5.0, max(0.2, 0.9 * (error + 1e-12) ** -0.2))
        if step == h or factor < 1:
            h = step * factor
    return h, largest


@njit(fastmath=True, error_model="numpy")
def follow(r_k, rho, transient, record):
    z, twin = np.zeros(8), np.zeros(8)
    k, y = np.empty((7, 8)), np.empty(8)
    z[1] = z[3] = -0.1
    h = other = 1e-3
    largest, growth, section = 0.0, 0.0, 0.0
    watched = transient - transient // 2
    for n in range(transient + record):
        if n == watched:
            twin[:] = z
            twin[0] += PERTURBATION
        h, radius = revolve(r_k, rho, z, h, k, y)
        if n >= watched:
            other, _ = revolve(r_k, rho, twin, other, k, y)
            distance = math.sqrt(np.sum((twin - z) ** 2))
            growth += math.log(distance / PERTURBATION)
            twin[:] = z + (twin - z) * (PERTURBATION / distance)
        if n >= transient:
            largest = max(largest, radius)
            section += z[0]
    return section, growth, largest


def main():
    transient, record, stride = (int(word) for word in sys.argv[1:4])
    follow(1.0, 0.08, 1, 1)  # compiles
    start, section, points = time.process_time(), 0.0, 0
    for point in range(0, SIDE * SIDE, stride):
        r_k, rho = 1.0 - 0.9 * (point % SIDE) / (SIDE - 1), 0.04 + 0.08 * (point // SIDE) / (SIDE - 1)
        section += follow(r_k, rho, transient, record)[0]
        points += 1
    print(f"Numba dopri5\t{(time.process_time() - start) / points:.6g}\t{section / (points * record):.9f}")


main()
