#!/usr/bin/python3
"""The coefficients of films of finite length:

    scripts/film-table.py | clang-format --assume-filename=x.h >src/rotor/elements/films/film_table.h

The force of a closed film of finite length without negative pressures (Guembel's condition) is that of the short film
times a complex ratio R, a function of p = e cos a and beta = atan(e sin a/sqrt(1 - e^2)), with the eccentricity ratio e
and the direction a of (A, B) against the journal's, and of L/D (docs/theory.md). This finds R from Reynolds' equation
and fits to it by least squares (N(p, b) + i M(p, b))/(1 + d_p p^2 + d_b b^2), b = 2 beta/pi, at Chebyshev places of
s = r/(SHIFT + r), r = L/D, over which d_p, d_b and the polynomials' coefficients times 1 + r^2 are then polynomials. The
denominator saves three degrees of the polynomials. It is found together with them by repeated fits, each weighted by
the denominator of the fit before (Sanathanan, Koerner 1963). The slope of R by the direction a is fitted, too, at a = 0:
stiffness and damping at rest depend on it. Takes half a minute.
"""

import numpy as np
from numpy.polynomial import chebyshev, legendre
from scipy.linalg import eigh, solveh_banded

MIN_RATIO, MAX_RATIO, SHIFT, PLACES = 0.1, 2.0, 0.6, 11  # of L/D
IN_P, IN_B = 15, 13  # degrees: of p^i b^j those with i/IN_P + j/IN_B <= 1
DENOMINATOR, DENOMINATOR_TERMS = [(2, 0), (0, 2)], 6  # powers of p and b; terms over s, few, for smoothness
AT_REST, STEP = 0.3, 1e-3  # weight of slopes by the direction at rest; directions at which they are differenced
# Weights of relative errors at eccentricity ratios, by straight lines of their logarithms over sqrt(1 - e^2).
WEIGHTS = {0.0: 1.0, 0.9: 1.0, 0.95: 0.3, 0.97: 0.03, 0.987: 0.003}


def axial_modes(count, points):
    """Shapes of the pressure along z = -1 to 1 that separate Reynolds' equation: eigenvalues, loads, values."""
    z, weight = legendre.leggauss(points)
    series = np.zeros((count, 2 * count + 1))
    for n in range(count):
        series[n, 2 * n], series[n, 2 * n + 2] = -1.0, 1.0
    shape, slope = legendre.legval(z, series.T), legendre.legval(z, legendre.legder(series.T))
    value, vector = eigh((slope * weight) @ slope.T, (shape * weight) @ shape.T)
    half = points // 2  # the other half is its mirror image
    return value, vector.T @ (shape @ weight), (vector.T @ shape)[:, half:], 2.0 * weight[half:]


def pressures(e, length, modes, terms):
    """Fourier coefficients [z, n] of the pressure by A, sines, and by B, cosines, of a journal at (e, 0):
    (h^3 P')' + (1/length)^2 h^3 P'' = A sin t - B cos t, h = 1 - e cos t, by Galerkin's method."""
    value, load, shape, _ = modes
    n = np.arange(terms + 1)
    cube = np.array([1.0 + 1.5 * e**2, -1.5 * e - 0.375 * e**3, 0.75 * e**2, -0.125 * e**3])  # of exp(i n t)
    sines, cosines = (np.zeros((shape.shape[1], terms + 1)) for _ in range(2))
    for k in range(len(value)):
        for by, parity in ((sines, -1.0), (cosines, 1.0)):
            bands = np.zeros((4, terms + 1))
            for d in range(4):
                a, b = n[d:], n[: terms + 1 - d]
                both = np.where(a + b < 4, cube[np.minimum(a + b, 3)], 0.0)
                bands[d, : terms + 1 - d] = (
                    a * b * (cube[d] - parity * both) + value[k] / length**2 * (cube[d] + parity * both)
                )
            first = 1 if parity < 0.0 else 0
            right = np.zeros(terms + 1 - first)
            right[1 - first] = parity * load[k]
            by[:, first:] += np.outer(shape[k], solveh_banded(bands[:, first:], right, lower=True))
    return sines, cosines


def finite_force(e, length, angles, axial=10):
    """f_x + i f_y of a journal at (e, 0) for (A, B) = (cos a, sin a), in mu omega R L (R/c)^2. At every z the
    positive part of the pressure counts; its Fourier series is integrated between its zeros."""
    modes = axial_modes(axial, 2 * axial)
    terms = int(max(48, 30.0 / np.sqrt(1.0 - e**2)))
    sines, cosines = pressures(e, length, modes, terms)
    n, grid = np.arange(terms + 1), 4 * terms
    spectrum = np.zeros((2, len(sines), grid // 2 + 1), complex)
    spectrum[0, :, : terms + 1], spectrum[1, :, : terms + 1] = -0.5j * grid * sines, 0.5 * grid * cosines
    spectrum[1, :, 0] *= 2.0
    by_a, by_b = np.fft.irfft(spectrum, n=grid, axis=2)
    A, B = np.cos(angles), np.sin(angles)
    pressure = A[:, None, None] * by_a + B[:, None, None] * by_b
    above = pressure > 0.0
    i, z, j = np.nonzero(above != np.roll(above, -1, axis=2))
    left, right = pressure[i, z, j], pressure[i, z, (j + 1) % grid]
    t = 2.0 * np.pi / grid * (j + left / (left - right))
    half = 0.5 * (B[i, None] * cosines[z] - 1j * A[i, None] * sines[z])  # of exp(i n t), with its conjugate
    for _ in range(3):
        wave = half * np.exp(1j * np.outer(t, n))
        t -= wave.real.sum(1) / (1j * n * wave).real.sum(1)
    once, wave = np.exp(1j * t)[:, None], np.exp(1j * np.outer(t, n))
    down = np.where(n == 1, 0.0, 1j * (1 - n) + (n == 1))
    integral = (half * wave * once / (1j * (n + 1))).sum(1) + t * np.conj(half[:, 1])
    integral += (np.conj(half[:, n != 1]) * (np.conj(wave) * once)[:, n != 1] / down[n != 1]).sum(1)
    total = np.zeros(len(angles), complex)
    np.add.at(total, i, np.where(left > 0.0, 1.0, -1.0) * integral * modes[3][z])
    around = 0.5 * (B[:, None] * cosines[None, :, 1] + 1j * A[:, None] * sines[None, :, 1])
    return -3.0 * (total + (above[:, :, 0] * 2.0 * np.pi * around * modes[3]).sum(1))


def short_force(e, angles):
    """f_x + i f_y of the short film, in (L/D)^2 times the unit of finite_force (Capone 1991;
    src/rotor/elements/films/film_kernel.h)."""
    A, B, q = np.cos(angles), np.sin(angles), 1.0 - e**2
    P, U, W = e * B, e * A, np.sqrt(q)
    angle, E = 0.5 * np.pi + np.arctan2(P, W), U * W / (W**2 + P**2)
    M = 3.0 * (W + P * angle) / q
    return -2.0 / q**1.5 * (e * M + B * angle - A * E - 1j * (A * angle + B * E))


def powers(parity):
    """(i, j) of p^i b^j, for even (0) or odd (1) i, in the order of the table."""
    return [(i, j) for i in range(parity, IN_P + 1, 2) for j in range(IN_B * (IN_P - i) // IN_P + 1)]


def polynomials(p, b, parity):
    in_p, in_b = chebyshev.chebvander(p, IN_P), chebyshev.chebvander(b, IN_B)
    return np.array([in_p[:, i] * in_b[:, j] for i, j in powers(parity)]).T


def monomials(parity, coefficients):
    """Converts coefficients of T_i(p) T_j(b) to those of p^i b^j."""
    square = np.zeros((IN_P + 1, IN_B + 1, coefficients.shape[1]))
    for (i, j), row in zip(powers(parity), coefficients):
        p, b = chebyshev.cheb2poly(np.eye(i + 1)[i]), chebyshev.cheb2poly(np.eye(j + 1)[j])
        square[: i + 1, : j + 1] += p[:, None, None] * b[None, :, None] * row
    return np.array([square[i, j] for i, j in powers(parity)])


def denominator(by, p, b):
    return 1.0 + sum(c * p**i * b**j for c, (i, j) in zip(by, DENOMINATOR))


def best_denominator(p, b, ratio, weight):
    """Coefficients of the denominator for one L/D."""
    even, odd = (polynomials(p, b, parity) for parity in (0, 1))
    free = np.array([p**i * b**j for i, j in DENOMINATOR]).T
    found = np.zeros(free.shape[1])
    for _ in range(12):
        own = weight / np.abs(ratio) / np.abs(denominator(found, p, b))
        sums = [
            np.hstack([even * own[:, None], np.zeros(odd.shape), -free * (ratio.real * own)[:, None]]),
            np.hstack([np.zeros(even.shape), odd * own[:, None], -free * (ratio.imag * own)[:, None]]),
        ]
        sides = np.concatenate([ratio.real * own, ratio.imag * own])
        found = np.linalg.lstsq(np.vstack(sums), sides, rcond=1e-13)[0][-free.shape[1] :]
    return found


def place_of(r):
    """The variable of the Chebyshev series over s, -1 to 1, at L/D = r."""
    ends = [one / (SHIFT + one) for one in (MIN_RATIO, MAX_RATIO)]
    return (2.0 * r / (SHIFT + r) - ends[0] - ends[1]) / (ends[1] - ends[0])


def coordinates(e, a):
    return e * np.cos(a), np.arctan(e * np.sin(a) / np.sqrt(1.0 - e**2)) * 2.0 / np.pi


def slope_of(values):
    """The slope by the direction, from values at -STEP and STEP."""
    return (values[1] - values[0]) / (2.0 * STEP)


def fit():
    """Coefficients [coefficient, Chebyshev term over s] of the real part, the imaginary part and the denominator."""
    end = list(WEIGHTS)[-1]
    radii = end * np.sin(0.5 * np.pi * (np.arange(34) + 0.5) / 34)
    angles = np.pi * ((np.arange(32) + 0.5) / 32 - 0.5)  # the other half is its mirror image
    e, a = (m.ravel() for m in np.meshgrid(radii, angles, indexing="ij"))
    knots = [np.sqrt(1.0 - np.array(list(WEIGHTS)[::-1]) ** 2), np.log(list(WEIGHTS.values())[::-1])]
    weight, weight_at_rest = (np.exp(np.interp(np.sqrt(1.0 - one**2), *knots)) for one in (e, radii))
    place, near = coordinates(e, a), [coordinates(radii, side) for side in (-STEP, STEP)]
    ends = [r / (SHIFT + r) for r in (MIN_RATIO, MAX_RATIO)]
    x = np.cos(np.pi * (np.arange(PLACES) + 0.5) / PLACES)
    s = 0.5 * (ends[0] + ends[1]) + 0.5 * (ends[1] - ends[0]) * x
    lengths, at = SHIFT * s / (1.0 - s), np.append(angles, [-STEP, STEP])
    ratios = [np.array([finite_force(one, r, at) / short_force(one, at) for one in radii]) / r**2 for r in lengths]
    below = [best_denominator(*place, ratio[:, :-2].ravel(), weight) for ratio in ratios]
    below = chebyshev.chebfit(x, np.array(below), DENOMINATOR_TERMS - 1).T
    if chebyshev.chebval(np.linspace(-1.0, 1.0, 999), below.T).min() <= -1.0:
        raise SystemExit("the denominator vanishes within p^2 + b^2 < 1")
    found = [[], []]
    for r, ratio in zip(lengths, ratios):
        own = chebyshev.chebval(place_of(r), below.T)
        scale = np.append(
            weight / np.abs(ratio[:, :-2].ravel()), AT_REST * weight_at_rest / np.abs(ratio[:, -2:]).mean(1)
        )
        for parity, part in ((0, ratio.real), (1, ratio.imag)):
            over = [polynomials(*pb, parity) / denominator(own, *pb)[:, None] for pb in (place, *near)]
            basis = np.vstack([over[0], slope_of(over[1:])]) * scale[:, None]
            wanted = np.append(part[:, :-2].ravel(), slope_of(part[:, -2:].T)) * scale
            found[parity].append(np.linalg.lstsq(basis, wanted, rcond=1e-12)[0] * (1.0 + r**2))
    terms = np.linalg.inv(chebyshev.chebvander(x, PLACES - 1))
    return [monomials(parity, (terms @ np.array(found[parity])).T) for parity in (0, 1)] + [below]


def ratio_of(table, e, r, angles):
    """The complex ratio of the table, as the program computes it."""
    p, b = coordinates(e, angles)
    sums = []
    for parity in (0, 1):
        at_r = chebyshev.chebval(place_of(r), table[parity].T) / (1.0 + r**2)
        sums.append(sum(c * p**i * b**j for c, (i, j) in zip(at_r, powers(parity))))
    return (sums[0] + 1j * sums[1]) / denominator(chebyshev.chebval(place_of(r), table[2].T), p, b)


def errors(table, r):
    """Largest relative errors of the force, up to e = .9 and from there to .95."""
    angles, worst = np.pi * (np.arange(49) / 48 - 0.5), []
    for places in (np.linspace(0.05, 0.9, 18), np.linspace(0.91, 0.95, 5)):
        exact = [finite_force(e, r, angles, 12) / short_force(e, angles) / r**2 for e in places]
        worst.append(max(np.max(np.abs(ratio_of(table, e, r, angles) / at - 1.0)) for e, at in zip(places, exact)))
    return worst


def rows(table):
    return "\n".join("    {" + ", ".join(f"{value:.12g}" for value in row) + "}," for row in table)


def main():
    parts = fit()
    found = [[r, *errors(parts, r)] for r in np.geomspace(MIN_RATIO, MAX_RATIO, 27)]
    count = len(parts[0]) + len(parts[1])
    print(
        f"""/// Coefficients of the ratio of finite to short films (film_ratio.h), written by scripts/film-table.py.
#ifndef ROTOR_FILM_TABLE_H
#define ROTOR_FILM_TABLE_H

/// Range of L/D of the table. The coefficients are Chebyshev series in s = r/(FILM_SHIFT + r), r = L/D.
#define FILM_SHORTEST {MIN_RATIO}
#define FILM_LONGEST {MAX_RATIO}
#define FILM_SHIFT {SHIFT}

/// Degrees in p and b; number of coefficients; terms of their series over s.
enum {{ FILM_IN_P = {IN_P}, FILM_IN_B = {IN_B}, FILM_COEFFICIENTS = {count}, FILM_TERMS = {PLACES} }};

/// Coefficients of p^2 and b^2 in the denominator.
enum {{ FILM_DENOMINATOR = {len(parts[2])}, FILM_DENOMINATOR_TERMS = {DENOMINATOR_TERMS} }};
static const double film_denominator[FILM_DENOMINATOR][FILM_DENOMINATOR_TERMS] = {{
{rows(parts[2])}
}};

/// A row for each p^i b^j with i/FILM_IN_P + j/FILM_IN_B <= 1, first even i (of R), then odd i (of I), j fastest: the
/// Chebyshev series of its coefficient times 1 + r^2.
static const double film_table[FILM_COEFFICIENTS][FILM_TERMS] = {{
{rows(np.concatenate(parts[:2]))}
}};

/// A row for each L/D tried: L/D, and the largest relative error of the force over 1127 states, up to an eccentricity
/// ratio of .9 and from .9 to .95.
enum {{ FILM_TRIED = {len(found)} }};
static const double film_errors[FILM_TRIED][3] = {{"""
    )
    for row in found:
        print("    {%.4g, %.1e, %.1e}," % tuple(row))
    print("};\n\n#endif")


if __name__ == "__main__":
    main()
