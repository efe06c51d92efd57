"""An independent finite element program, with which tests compare whirl: rotors of Timoshenko beams, rigid discs and
bearings over the speed.

It shares nothing with whirl but the equations: Nelson (1980), A finite rotating shaft element using Timoshenko beam
theory; Friswell, Penny, Garvey, Lees (2010), Dynamics of Rotating Machines, ch. 5 and 6. Matrices of an element are
integrals of its shape functions; every node keeps its displacement and the slope of its section in both planes, and
nothing is reduced. Lengths in m, speeds in rad/s.
"""

import tomllib

import numpy as np
from scipy.interpolate import PchipInterpolator
from scipy.optimize import brentq, minimize_scalar

KINDS = ("kxx", "kxy", "kyx", "kyy", "cxx", "cxy", "cyx", "cyy")


def cowper(outer, inner, poisson):
    """Returns the shear factor of a hollow circle (Cowper 1966)."""
    ratio = (inner / outer) ** 2
    both = (1 + ratio) ** 2
    return 6 * (1 + poisson) * both / ((7 + 6 * poisson) * both + (20 + 12 * poisson) * ratio)


def element(length, outer, inner, modulus, shear_modulus, density):
    """Returns stiffness, mass and polar inertia [4, 4] of displacement and slope at both ends, in a plane."""
    area, second = np.pi / 4 * (outer**2 - inner**2), np.pi / 64 * (outer**4 - inner**4)
    bending = modulus * second
    shear = cowper(outer, inner, modulus / (2 * shear_modulus) - 1) * shear_modulus * area
    phi = 12 * bending / (shear * length**2)
    points, weights = np.polynomial.legendre.leggauss(4)  # exact for the integrands, polynomials up to degree 6
    s = (points + 1) / 2
    displacement = np.array(
        [
            1 - 3 * s**2 + 2 * s**3 + phi * (1 - s),
            length * (s - 2 * s**2 + s**3 + phi * (s - s**2) / 2),
            3 * s**2 - 2 * s**3 + phi * s,
            length * (s**3 - s**2 - phi * (s - s**2) / 2),
        ]
    )
    turn = np.array(
        [
            6 * (s**2 - s) / length,
            1 - 4 * s + 3 * s**2 + phi * (1 - s),
            6 * (s - s**2) / length,
            3 * s**2 - 2 * s + phi * s,
        ]
    )
    curvature = np.array([(12 * s - 6) / length, 6 * s - 4 - phi, (6 - 12 * s) / length, 6 * s - 2 + phi]) / length
    sliding = phi * np.array([-1 / length, -0.5, 1 / length, -0.5])[:, None] * np.ones(len(s))
    by = [f / (1 + phi) for f in (displacement, turn, curvature, sliding)]

    def integral(function):
        return length / 2 * (function * weights) @ function.T

    tilting = density * second * integral(by[1])
    return (
        bending * integral(by[2]) + shear * integral(by[3]),
        density * area * integral(by[0]) + tilting,
        2 * tilting,
    )


class Rotor:
    """A rotor: nodes at `position`; pieces (left node, length, outer, inner, E, G, rho); discs (node, m, I_d, I_p);
    bearings (node, coefficients by name, each a function of the speed)."""

    def __init__(self, position, pieces, discs, bearings):
        self.position, self.pieces, self.discs, self.bearings = np.asarray(position), pieces, discs, bearings
        size = 2 * len(position)
        self.stiffness, self.mass, self.polar = (np.zeros((size, size)) for _ in range(3))
        for node, *piece in pieces:
            at = slice(2 * node, 2 * node + 4)
            for whole, part in zip((self.stiffness, self.mass, self.polar), element(*piece)):
                whole[at, at] += part
        for node, mass, diametral, polar in discs:
            self.mass[2 * node, 2 * node] += mass
            self.mass[2 * node + 1, 2 * node + 1] += diametral
            self.polar[2 * node + 1, 2 * node + 1] += polar
        zero = np.zeros((size, size))
        self._planes = [np.block([[own, zero], [zero, own]]) for own in (self.mass, self.stiffness)]
        self._gyroscopic = np.block([[zero, self.polar], [-self.polar, zero]])

    @classmethod
    def of_ross(cls, path, seals=True):
        """Makes a rotor from a file of ROSS; its tables are interpolated by monotone cubics (Fritsch, Butland 1984)."""
        with open(path, "rb") as file:
            sections = tomllib.load(file)
        of = {
            kind: [content for name, content in sections.items() if name.startswith(kind + "Element_")]
            for kind in ("Shaft", "Disk", "Bearing", "Seal")
        }
        length, pieces = {}, []
        for own in of["Shaft"]:
            assert own["idl"] == own["idr"] and own["odl"] == own["odr"], "cones are not for this program"
            material = own["material"]
            length[own["n"]] = own["L"]
            size = [own[key] for key in ("n", "L", "odl", "idl")]
            pieces.append(size + [material[key] for key in ("E", "G_s", "rho")])
        position = np.concatenate(([0], np.cumsum([length[n] for n in sorted(length)])))
        bearings = [
            (own["n"], {kind: PchipInterpolator(own["frequency"], own[kind], extrapolate=False) for kind in KINDS})
            for own in of["Bearing"] + (of["Seal"] if seals else [])
        ]
        return cls(position, pieces, [[d[key] for key in ("n", "m", "Id", "Ip")] for d in of["Disk"]], bearings)

    def mass_before(self, node):
        """Returns the mass of pieces and discs nearer to the left end, kg."""
        shaft = sum(
            np.pi / 4 * (d**2 - i**2) * length * rho for n, length, d, i, _, _, rho in self.pieces if n < node
        )
        return shaft + sum(mass for n, mass, _, _ in self.discs if n < node)

    # ---------------------------------------------------------------- small motions

    def system(self, speed):
        """Returns M, C, K over the x coordinates (displacement and slope of each node), followed by the y
        coordinates."""
        size, (mass, stiffness) = len(self.mass), self._planes
        stiffness, damping = stiffness.copy(), speed * self._gyroscopic
        for node, of in self.bearings:
            x, y = 2 * node, size + 2 * node
            for a, i in (("x", x), ("y", y)):
                for b, j in (("x", x), ("y", y)):
                    stiffness[i, j] += of["k" + a + b](speed)
                    damping[i, j] += of["c" + a + b](speed)
        return mass, damping, stiffness

    def modes(self, speed):
        """Returns the eigenvalues of oscillating modes, the lowest frequency first, and their whirl: 1 with the
        rotation, -1 against it."""
        mass, damping, stiffness = self.system(speed)
        size = len(mass)
        flow = np.block(
            [
                [np.zeros((size, size)), np.eye(size)],
                [-np.linalg.solve(mass, stiffness), -np.linalg.solve(mass, damping)],
            ]
        )
        values, vectors = np.linalg.eig(flow)
        keep = np.argsort(abs(values.imag))
        keep = keep[values[keep].imag > 1e-6 * abs(values[keep])]
        x, y = vectors[: size // 2 : 2, keep], vectors[size // 2 : size : 2, keep]
        return values[keep], 2 * (x * y.conj()).imag.sum(0) / (abs(x) ** 2 + abs(y) ** 2).sum(0)

    def critical(self, near, forward=True):
        """Returns the damped critical speed near a speed, and its eigenvalue."""

        def mode(speed):
            values, whirl = self.modes(speed)
            values = values[(whirl > 0) == forward]
            light = values[-values.real < 0.5 * abs(values)]
            return light[np.argmin(abs(light.imag - near))]

        speed = brentq(lambda s: mode(s).imag - s, 0.95 * near, 1.05 * near, xtol=1e-7)
        return speed, mode(speed)

    def undamped(self, stiffness, nodes, forward=True):
        """Returns critical speeds, rising, and their shapes [node, speed], with springs at nodes in place of
        bearings."""
        held = self.stiffness.copy()
        for node in nodes:
            held[2 * node, 2 * node] += stiffness
        values, vectors = np.linalg.eig(np.linalg.solve(held, self.mass - (1 if forward else -1) * self.polar))
        keep = values.real > 1e-14 * abs(values).max()
        speeds = 1 / np.sqrt(values[keep].real)
        order = np.argsort(speeds)
        return speeds[order], vectors[::2, keep][:, order].real

    def response(self, speed, unbalances):
        """Returns x and y [node] of the motion Re(X exp(i speed t)) by unbalances (node, kg m, angle)."""
        mass, damping, stiffness = self.system(speed)
        size = len(self.mass)
        force = np.zeros(2 * size, complex)
        for node, moment, angle in unbalances:
            force[2 * node] += moment * speed**2 * np.exp(1j * angle)
            force[size + 2 * node] += -1j * moment * speed**2 * np.exp(1j * angle)
        all = np.linalg.solve(stiffness - speed**2 * mass + 1j * speed * damping, force)
        return all[:size:2], all[size::2]

    # ---------------------------------------------------------------- weight

    def loads(self, nodes, gravity=9.80665):
        """Returns the loads of rigid bearings at nodes, N, and the displacements, m."""
        size, held = len(self.mass), [2 * node for node in nodes]
        system = np.zeros((size + len(held), size + len(held)))
        system[:size, :size] = self.stiffness
        for row, at in enumerate(held):
            system[size + row, at], system[at, size + row] = 1, -1
        weight = np.zeros(size)
        weight[::2] = gravity
        all = np.linalg.solve(system, np.concatenate((-self.mass @ weight, np.zeros(len(held)))))
        return all[size:], all[:size:2]


# -------------------------------------------------------------------- critical speeds as peaks


def peak(amplitude, low, high):
    """Returns the speed of the largest amplitude between two speeds, this amplitude, and the amplification factor by
    half power."""
    found = minimize_scalar(lambda s: -amplitude(s), bounds=(low, high), method="bounded", options={"xatol": 1e-5})
    top, half = found.x, -found.fun / np.sqrt(2)
    left, right = (brentq(lambda s: amplitude(s) - half, *ends, xtol=1e-6) for ends in ((low, top), (top, high)))
    return top, -found.fun, top / (right - left)


def margin_asked(amplification, below):
    """Returns the separation margin in percent that API 617 requires of a peak below or above the running speeds."""
    if amplification < 2.5:
        return 0.0
    return 17 * (1 - 1 / (amplification - 1.5)) + (0 if below else 10)
