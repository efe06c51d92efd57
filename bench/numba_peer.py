"""The peer Numba: the straightforward loops in Python, compiled; one machine."""
import math
import sys
import time

import numpy as np
from numba import njit

STEPS = 1024
R_K, W, R_M, XI1, XI2 = 0.6, 0.2, 8.4, 0.0157509, 0.286154
RHO, G, S_F = 0.08, 0.115976, 0.0045
R_DELTA, R_CK, F = 1.2, 10.0, 0.1
K1, K2, PUSH = 1 / (2 * R_M * W * W), 1 / (4 * W * W), R_CK / (R_M * W * W)


@njit(fastmath=True, error_model="numpy")
def slope(t, z, dz):
    a, b = R_K + 1, R_K - 1
    c, s, c2, s2 = math.cos(t), math.sin(t), math.cos(2 * t), math.sin(2 * t)
    x1, y1, x2, y2, u1, v1, u2, v2 = z
    dx, dy = x1 - x2, y1 - y2
    sx = (a + b * c2) * dx + b * s2 * dy
    sy = (a + b * c2) * dy + b * s2 * dx
    fx = fy = 0.0
    radius = math.sqrt(x1 * x1 + y1 * y1)
    if radius >= R_DELTA:
        push = (1 - R_DELTA / radius) * PUSH
        fx, fy = -push * (x1 - F * y1), -push * (F * x1 + y1)
    A, B = x2 - 2 * v2, y2 + 2 * u2
    q = 1 - x2 * x2 - y2 * y2
    C, root = math.sqrt(A * A + B * B), math.sqrt(q)
    P, U = x2 * B - y2 * A, x2 * A + y2 * B
    g = (math.pi + 2 * math.atan(P / (C * root))) / root
    S2 = -2 * U * C / (q * C * C + P * P)
    CV3 = 3 * (2 * C + P * g) / q
    px, py = -(x2 * CV3 + B * g + A * S2) / q, -(y2 * CV3 - A * g + B * S2) / q
    dz[0], dz[1], dz[2], dz[3] = u1, v1, u2, v2
    dz[4] = -XI1 * u1 - K1 * sx + RHO * c + fx
    dz[5] = -XI1 * v1 - K1 * sy + RHO * s + fy - G
    dz[6] = -0.5 * XI2 * u2 + K2 * sx + S_F * px
    dz[7] = -0.5 * XI2 * v2 + K2 * sy + S_F * py - G


@njit(fastmath=True, error_model="numpy")
def revolve(z, revolutions):
    h = 2 * math.pi / STEPS
    k1, k2, k3, k4, y = np.empty(8), np.empty(8), np.empty(8), np.empty(8), np.empty(8)
    for n in range(revolutions * STEPS):
        t = (n % STEPS) * h
        slope(t, z, k1)
        for i in range(8):
            y[i] = z[i] + 0.5 * h * k1[i]
        slope(t + 0.5 * h, y, k2)
        for i in range(8):
            y[i] = z[i] + 0.5 * h * k2[i]
        slope(t + 0.5 * h, y, k3)
        for i in range(8):
            y[i] = z[i] + h * k3[i]
        slope(t + h, y, k4)
        for i in range(8):
            z[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i])


def main():
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 0.3
    z = np.array([0, -0.1, 0, -0.1, 0, 0, 0, 0.0])
    revolve(z, 20)  # compiles, too
    x1, chunk, done, spent, start = z[0], 20, 0, 0.0, time.process_time()
    while spent < seconds:
        revolve(z, chunk)
        done += chunk
        spent = time.process_time() - start
    print(f"Numba\t{done * STEPS / spent:.6g}\t{x1:.13f}")


main()
