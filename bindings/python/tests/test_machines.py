"""Tests rotors with published results: the rotors of ROSS's tests, and the overhung fan of a textbook.

The expected numbers are those that ross/tests asserts (github.com/petrobras/ross, commit 631a249); they are met to
ROSS's tolerances or better. All rotors are steel shafts with a diameter of 50 mm and elements of 0.25 m, with steel
discs. They are examples of Friswell, Penny, Garvey, Lees (2010), Dynamics of Rotating Machines, section 5.9, and
variations of these by ROSS.
"""

import numpy as np
import pytest

import whirl

RPM = np.pi / 30
STEEL = 7810  # kg/m3
GRAVITY = 9.8065  # m/s2, ROSS's


def disc(outer, width=0.07, inner=0.05):
    """Returns mass and moments of inertia of a ring of steel."""
    mass = STEEL * np.pi / 4 * (outer**2 - inner**2) * width
    return mass, mass / 48 * (3 * (outer**2 + inner**2) + 4 * width**2), mass / 8 * (outer**2 + inner**2)


def case(study, count=6, discs=(), bearings=(), unbalances=()):
    """Makes a case of discs (node, diameter), bearings (node, kxx, kyy, c), unbalances (node, kg m)."""
    bodies = dict(discs)
    stations = []
    for node in range(count + 1):
        of = {"position": f"{0.25 * node} m"}
        if node in bodies:
            of |= {key: repr(float(value)) for key, value in zip(("mass", "diametral", "polar"), disc(bodies[node]))}
        stations.append(f"    n{node}: {{" + ", ".join(f"{key}: {value}" for key, value in of.items()) + "}")
    elements = ["    - segment: {length: 0.25 m, outer: 50 mm}"] * count
    elements += [f"    - bearing: {{at: n{n}, kxx: {kxx!r}, kyy: {kyy!r}, cxx: {c!r}}}" for n, kxx, kyy, c in bearings]
    elements += [f"    - unbalance: {{at: n{node}, moment: {moment!r}}}" for node, moment in unbalances]
    elements.append(f"    - gravity: {GRAVITY} m/s2")
    lines = ["whirl: 1", "parameters: {omega: 100 rad/s, k: 1 MN/m}", "rotor:", "  speed: = omega"]
    lines += ["  length_scale: 1 mm", "  shafts: {shaft: {reduce: no}}", "  stations:", *stations]
    return "\n".join([*lines, "  elements:", *elements, "study:", f"  {study}\n"])


def run(*args, **more):
    return whirl.run(whirl.Case(text=case(*args, **more)), progress=False)


TWO_DISCS = {"discs": ((2, 0.28), (4, 0.35))}
ISOTROPIC = {**TWO_DISCS, "bearings": ((0, 1e6, 1e6, 0.0), (6, 1e6, 1e6, 0.0))}
ANISOTROPIC = {**TWO_DISCS, "bearings": ((0, 1e6, 0.8e6, 0.0), (6, 1e6, 0.8e6, 0.0))}
BEYOND = {"count": 10, "discs": ((5, 0.28), (10, 0.35)), "bearings": ((2, 1e6, 1e6, 0.0), (8, 1e6, 1e6, 0.0))}
FAN = {"discs": ((6, 0.35),), "bearings": ((0, 1e7, 1e7, 0.0), (4, 1e7, 1e7, 0.0))}


def frequencies(count, speeds, **machine):
    values = ", ".join(f"{speed!r} rad/s" for speed in speeds)
    return run(f"modes: {{parameter: omega, values: [{values}]}}", **machine)["modes"]["modes/frequency"][:, :count]


def test_fan():
    """Friswell et al., example 5.9.9: a wheel of 0.35 m, 0.5 m beyond the front bearing, at rest and at 4000 rpm.

    The book's natural frequencies in rad/s as test_examples.py has them, of six elements; ROSS allows 1e-3."""
    found = frequencies(6, (0.0, 4000 * RPM), **FAN)
    assert found[0] == pytest.approx([90.14, 90.14, 630.73, 630.73, 830.43, 830.43], abs=0.005)
    assert found[1] == pytest.approx([76.19, 103.91, 565.99, 634.23, 647.75, 1174.2], abs=0.005)


def test_modes_over_the_speed():
    """test_campbell: damped frequencies in rad/s, to ROSS's 1e-7, without torsion, 650.407866 at every speed."""
    expected = (
        (82.65303734, 86.65811435, 254.52047828, 274.31285391, 679.48903239),
        (82.60929602, 86.68625235, 251.70037114, 276.87787937, 652.85679897),
        (82.48132723, 86.76734307, 245.49092844, 282.33294699, 614.05536277),
    )
    assert frequencies(5, (0.0, 150.0, 300.0), **ANISOTROPIC) == pytest.approx(np.array(expected), rel=1e-7)


def test_critical_speeds_of_an_overhung_rotor():
    """test_run_critical_speed of rotors 5 and 6: to 5e-5 rad/s, ROSS's four decimals."""
    between = {**BEYOND, "discs": ((4, 0.28), (6, 0.35))}
    for machine, expected in (
        (BEYOND, (61.52110644, 63.72862198, 117.49491374, 118.55829416, 233.83724523, 236.40346235)),
        (between, (86.10505193, 86.60492546, 198.93259257, 207.97165539, 244.95609413, 250.53522782)),
    ):
        found = run("critical_speeds: {}", **machine)["critical_speeds"]["critical_speeds/speed"][0]
        assert found[:6] == pytest.approx(expected, abs=5e-5)


def test_critical_speed_map():
    """test_ucs_calc: every fifth of 20 stiffnesses from 1e6 to 1e11 N/m, forward, to 1e-7."""
    stiffness = ", ".join(f"{k:.17g} N/m" for k in np.logspace(6, 11, 20)[::5])
    table = run(f"critical_speeds: {{parameter: k, values: [{stiffness}], bearings: yes}}", **ISOTROPIC)[
        "critical_speeds"
    ]
    speeds, direction = (table["critical_speeds/" + field] for field in ("speed", "direction"))
    expected = (
        (86.90424993, 288.61681387, 925.78185127, 1115.3680757),
        (110.26337332, 436.40207642, 2636.00694936, 2763.19618667),
        (111.9023347, 448.46406291, 3610.85969749, 3828.3605264),
        (111.98332019, 449.0621522, 3669.03626945, 3893.39070372),
    )
    for own, whirling, of in zip(speeds, direction, expected):
        assert own[whirling > 0][:4] == pytest.approx(of, rel=1e-7)


def test_responses_to_unbalance():
    """test_freq_response_w_force, to 1e-7: |x| and |y| of the left end, of one and of two unbalances of 1 kg mm."""
    study = "unbalance: {parameter: omega, values: [150 rad/s, 300 rad/s, 450 rad/s]}"
    x = {
        (2,): (1.14259057e-06, 1.88932819e-04, 4.50376020e-05),
        (2, 3): (4.80337594e-06, 2.31170438e-04, 6.90062268e-05),
    }
    y = {
        (2,): (3.02252319e-06, 1.50551126e-04, 4.98323245e-05),
        (2, 3): (3.15307288e-06, 1.87793923e-04, 8.08531462e-05),
    }
    for nodes in x:
        found = run(study, **ANISOTROPIC, unbalances=[(node, 1e-3) for node in nodes])["unbalance"]
        ends = 1e-3 * found["unbalance/amplitude"][:, 0]
        assert ends == pytest.approx(np.transpose([x[nodes], y[nodes]]), rel=1e-7)


def test_readings_of_a_probe():
    """test_unbalance, to 1e-4: 1 kg m at the left end, a probe there at 45 degrees, and the major axis."""
    study = "unbalance: {parameter: omega, values: [50 rad/s, 100 rad/s], probe: 45 degree}"
    found = run(study, **ANISOTROPIC, unbalances=((0, 1.0),))["unbalance"]
    assert 1e-3 * found["unbalance/probe"][:, 0, 0] == pytest.approx(
        (0.003158927232913641, 0.004620055491206476), rel=1e-4
    )
    assert np.radians(found["unbalance/probe_lag"][:, 0, 0]) == pytest.approx((0.90962393, 1.00571182), rel=1e-4)
    assert 1e-3 * found["unbalance/axes"][:, 0, 0] == pytest.approx(
        (0.0035259958428500164, 0.005518031001232163), rel=1e-4
    )


def test_weight():
    """test_static_analysis of rotors 3 and 6: sag to 1e-7 of it, shears and moments to half of ROSS's last digit."""
    found = run("statics: {}", **ISOTROPIC)["statics"]
    sag = (0.0, -4.512491e-04, -7.884209e-04, -9.181142e-04, -8.085602e-04, -4.687889e-04, 0.0)
    assert 1e-3 * found["statics/deflection"][0] == pytest.approx(np.array(sag), abs=1e-9)
    assert found["statics/load"][0, 0] == pytest.approx(494.274533, abs=1e-6)
    found = run("statics: {}", **BEYOND)["statics"]
    moments = (0, 4.6994, 18.7977, -2.5415, -14.4818, -17.0232, 69.732, 165.886, 271.439, 131.0201, 0)
    assert np.abs(found["statics/moment"][0]) == pytest.approx(np.abs(moments), abs=1e-3)


def plain_seal(speed, pressure, radius=0.1, length=0.04, clearance=0.25e-3, density=1000.0, viscosity=1e-3, inlet=0.5):
    """Returns stiffness, damping, mass of a short turbulent annular seal (Black 1969; friction after Yamada 1962)."""
    through, turning = 10.0, density * radius * speed * clearance / viscosity
    for _ in range(200):
        axial = 2 * density * through * clearance / viscosity
        friction = 0.079 * axial**-0.25 * (1 + (7 * turning / (8 * axial)) ** 2) ** 0.375
        sigma = friction * length / clearance
        through = np.sqrt(2 * pressure / density / (1 + inlet + 2 * sigma))
    a, force, time = 1 + inlet + 2 * sigma, np.pi * radius * pressure / friction, length / through
    loss = (1 + inlet) / 2
    mu = (
        (1 + inlet) * sigma**2 / a**2,
        2 * sigma / a * (loss * ((1 + sigma) / a - sigma / a**2) + sigma / 6),
        2 * sigma / a * (loss * (1 / (2 * a) - (1 + sigma) / a**2 + sigma / a**3) + 1 / 12),
    )
    return [own * force * time**power for power, own in enumerate(mu)]


def test_plain_seal():
    """Tests the closed form at a state at which the equations of the flow were integrated with 30 digits."""
    found = plain_seal(100 * np.pi, 1e6, radius=0.05, length=0.05, clearance=2e-4)
    assert found == pytest.approx((3685982.251, 26317.55976, 8.437355202), rel=5e-10)


def test_pump():
    """Tests an impeller of 60 kg between two wear rings whose pressure rises with the square of the speed (Lomakin
    1958): its modes are the roots of (m + 2M) s^2 + 2 (C - i W M) s + k + 2 (K - M W^2/4 - i C W/2) = 0, W the
    speed."""
    mass, stiffness = 60.0, 15e6
    speeds = np.linspace(1000, 8000, 8) * RPM
    rings = [plain_seal(speed, 1e6 * (speed / (3000 * RPM)) ** 2) for speed in speeds]
    terms = {key: [] for key in ("kxx", "kxy", "kyx", "cxx", "cxy", "cyx", "mxx")}
    expected = []
    for speed, (k, c, m) in zip(speeds, rings):
        for key, value in zip(
            terms, (k - m * speed**2 / 4, c * speed / 2, -c * speed / 2, c, m * speed, -m * speed, m)
        ):
            terms[key].append(2 * value)
        roots = np.roots(
            (mass + 2 * m, 2 * (c - 1j * speed * m), stiffness + 2 * (k - m * speed**2 / 4 - 1j * c * speed / 2))
        )
        expected.append(sorted((root.real + 1j * abs(root.imag) for root in roots), key=lambda root: root.imag))
    table = ", ".join(f"{key}: [{', '.join(f'{value:.17g}' for value in values)}]" for key, values in terms.items())
    listed = ", ".join(f"{speed:.17g}" for speed in speeds)
    text = f"""
whirl: 1
parameters: {{omega: {speeds[0]:.17g}}}
rotor:
  speed: = omega
  length_scale: 1 mm
  stations: {{impeller: {{mass: {mass}}}}}
  elements:
    - shaft: {{between: [impeller, ground], k1: {stiffness}, k2: {stiffness}}}
    - bearing: {{at: impeller, role: seal, speeds: [{listed}], {table}}}
study:
  modes: {{parameter: omega, values: [{listed}]}}
"""
    found = whirl.run(whirl.Case(text=text), progress=False)["modes"]
    own = found["modes/growth"] + 1j * found["modes/frequency"]
    assert own[:, :2] == pytest.approx(np.array(expected), rel=1e-9)
    assert (own[4:, :2].imag > np.sqrt(stiffness / mass)).all()  # above the dry critical speed, 4775 rpm
