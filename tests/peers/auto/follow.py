#!/usr/bin/env python3
"""Follows the rotor's orbit from r_k = 0.6 downwards with AUTO-07p and prints its points.

    follow.py [--ntst N] [--ncol N] [--loose] [--values R,R,...] [--to R] [--points N] [--bench] [--keep FOLDER]

A line a point, separated by tabs: kind, r_k, the state at tau = 0 (x1, y1, x2, y2 and their derivatives), the eight
multipliers of the rotor as real and imaginary parts, largest modulus first. The kind is NS (Neimark-Sacker), PD (period
doubling), LP (fold), BP, UZ (a value that was asked for), EP (the end) or MX (AUTO did not converge). With --points
every point is printed, "-" where it is none of these, in steps that put N of them between the ends. --bench prints
instead a line for bench/run.py: what it is, points a second of AUTO's processor time, r_k of the last Neimark-Sacker
point.

--loose takes the tolerances of AUTO's demonstrations; else they are as tight as doubles allow. Exit status 77 where
AUTO-07p or a Fortran compiler (which AUTO needs) is not installed.
"""
import argparse
import math
import os
import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
AUTO = pathlib.Path(os.environ.get("AUTO_DIR", "/usr/lib/auto-07p"))
KINDS = {0: "-", 1: "BP", 5: "LP", 6: "BP", 7: "PD", 8: "NS", 9: "EP", -4: "UZ", -9: "MX"}
TIGHT = {"EPSL": 1e-12, "EPSU": 1e-12, "EPSS": 1e-11, "ITMX": 20}
LOOSE = {"EPSL": 1e-7, "EPSU": 1e-7, "EPSS": 1e-5, "ITMX": 8}
STATES, ALL = 8, 10

CONSTANTS = """\
NDIM = 10, IPS = 2, IRS = 0, ILP = 1, ICP = [1, 11], JAC = 1
NTST = {ntst}, NCOL = {ncol}, IAD = 3, ISP = 2, ISW = 1, IPLT = 0, NBC = 0, NINT = 0
NMX = {most}, NPR = 0, MXBF = 0, IID = 2, ITMX = {ITMX}, ITNW = 9, NWTN = 3
EPSL = {EPSL}, EPSU = {EPSU}, EPSS = {EPSS}
DS = -{step}, DSMIN = 1e-7, DSMAX = {step}, IADS = {adapted}
UZR = {{1: {values}}}
UZSTOP = {{1: [{to}, 0.7]}}
THL = {{11: 0}}
"""
# Steps of equal length in r_k.
EVEN = "THU = {" + ", ".join(f"{i + 1}: 0" for i in range(ALL)) + "}\n"


def build(folder):
    """AUTO's program with the rotor's equations."""
    flags = ["-O3", "-march=native"]
    subprocess.run([os.environ.get("CC", "gcc"), *flags, "-c", HERE / "rotor.c", "-o", folder / "rotor.o"], check=True)
    subprocess.run(["gfortran", "-fopenmp", folder / "rotor.o", "-o", folder / "rotor", *sorted(AUTO.glob("lib/*.o")),
                    AUTO / "lib" / "libauto_c.a"], check=True)


def follow(folder, options):
    """Runs AUTO once; its processor time."""
    # Small enough that two multipliers never cross the unit circle in one step, of which AUTO would see one.
    step = 0.004 if options.points is None else (0.6 - options.to) / options.points
    constants = CONSTANTS.format(ntst=options.ntst, ncol=options.ncol, most=10000, step=step,
                                 adapted=1 if options.points is None else 0, values=options.values, to=options.to,
                                 **(LOOSE if options.loose else TIGHT))
    (folder / "fort.2").write_text(constants + (EVEN if options.points else ""))
    (folder / "fort.3").write_text("")
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([folder / "rotor"], cwd=folder, capture_output=True, text=True,
                          env=dict(os.environ, OMP_NUM_THREADS="1"))
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        sys.exit(f"follow.py: AUTO failed: {done.stdout[-2000:]}{done.stderr[-2000:]}")
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def without_clock(multipliers):
    """The rotor's own: without 1 and exp(-4 pi), those of the two states that make cosine and sine; pairs together."""
    for known in (1.0, math.exp(-4.0 * math.pi)):
        multipliers.remove(min(multipliers, key=lambda m: abs(m - known)))
    upper = sorted((m for m in multipliers if m.imag >= 0.0), key=lambda m: -abs(m))
    return [one for m in upper for one in ([m, m.conjugate()] if m.imag > 0.0 else [m])]


def points(folder):
    """(kind, r_k, state, multipliers) of every point that AUTO wrote. It writes a point after it has printed it more
    than once, the last time with the multipliers that belong to it."""
    printed = [[float(word) for word in line.split()] for line in (folder / "points.txt").read_text().splitlines()]
    for line in (folder / "fort.7").read_text().splitlines():
        words = line.split()
        if words[0] == "0" or abs(int(words[1])) == 1:  # the first one is where AUTO began: it does not correct it
            continue
        kind, r_k = int(words[2]), float(words[4])
        row = [row for row in printed if abs(row[0] - r_k) < 1e-10][-1]
        pairs = row[2 + STATES:]
        multipliers = [complex(*pairs[2 * i:2 * i + 2]) for i in range(ALL)]
        yield KINDS.get(kind, str(kind)), row[0], row[2:2 + STATES], without_clock(multipliers)


def arguments():
    parser = argparse.ArgumentParser(description="the rotor's orbits by AUTO-07p")
    parser.add_argument("--ntst", type=int, default=100, help="mesh intervals")
    parser.add_argument("--ncol", type=int, default=7, help="collocation points in each, 2 to 7")
    parser.add_argument("--loose", action="store_true", help="tolerances of AUTO's demonstrations")
    parser.add_argument("--values", type=lambda text: [float(word) for word in text.split(",")], default=[])
    parser.add_argument("--to", type=float, default=0.355, help="last value of r_k")
    parser.add_argument("--points", type=int, help="print all points, about so many")
    parser.add_argument("--bench", action="store_true", help="measure 100 points")
    parser.add_argument("--keep", type=pathlib.Path, help="leave AUTO's files there")
    options = parser.parse_args()
    if options.bench:
        options.points, options.to = 100, 0.37
    return options


def main():
    options = arguments()
    if not shutil.which("gfortran") or not (AUTO / "lib" / "main.o").exists():
        print("follow.py: left out: AUTO-07p (Debian's auto-07p and gfortran are not installed)", file=sys.stderr)
        sys.exit(77)
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.keep.resolve() if options.keep else pathlib.Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        build(folder)
        seconds = follow(folder, options)
        found = list(points(folder))
    if options.bench:
        torus = [r_k for kind, r_k, *_ in found if kind == "NS"][-1]
        name = f"AUTO-07p, {options.ntst} intervals of {options.ncol}, {'1e-7' if options.loose else '1e-12'}"
        print(name, f"{len(found) / seconds:.6g}", f"{torus:.13f}", sep="\t")
        return
    for kind, r_k, state, multipliers in found:
        if options.points is None and kind == "-":
            continue
        numbers = [r_k, *state, *(part for m in multipliers for part in (m.real, m.imag))]
        print(kind, *(f"{number:.15g}" for number in numbers), sep="\t")



main()
