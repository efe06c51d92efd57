#!/usr/bin/env python3
"""Runs whirl's kernels and their peers side by side on one core, then the whole diagram through the command; writes the
table and the picture of docs/benchmarks.md.

    bench/run.py BUILD [--docs FOLDER] [--rounds N] [--seconds S] [--core N] [--no-study]
    bench/run.py BUILD --adaptive | --overhung | --branches | --map | --elements | --fit | --runup

Every round runs every program once, in turn, so that a noisy computer is noisy for all; the best round of each counts.
Speeds are by the processor time of the program; of the whole diagram the clock is printed, too. A program that is not
there is left out with a line that says so; one that ends in another state fails the run.
"""
import argparse
import csv
import functools
import json
import math
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import textwrap
import time

HERE = pathlib.Path(__file__).resolve().parent
INSTRUCTION_SETS = ["avx512", "avx2", "simd128", "fma", "scalar"]
X1 = 0.3457490150754  # of RK4 in 1024 steps after 20 revolutions: what all programs must find, to 1e-6
BASE = "C -O3 -march=native -ffast-math"
STEPS_OF_STUDY = 512 * 1200 * 1024
CHAINS = {"ten": 10, "fifty": 50}


def say(text):
    print(text, flush=True)


def first_line(*command):
    try:
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()[0].strip()
    except (OSError, subprocess.CalledProcessError, IndexError):
        return "unknown"


# ---------------------------------------------------------------- what there is to run


class Program:
    def __init__(self, title, command, isa=None, once=False):
        self.title, self.command, self.isa, self.once = title, command, isa, once


def python_with(module):
    """A Python that has the module: the one that runs this, or Debian's."""
    for python in (sys.executable, "/usr/bin/python3"):
        if python and subprocess.run([python, "-c", f"import {module}"], capture_output=True).returncode == 0:
            return python
    return None


def adder(build, found):
    def add(title, name, *arguments, isa=None):
        program = build / "bench" / name
        if program.exists():
            found.append(Program(title, [str(program), "SECONDS", *arguments], isa))
        else:
            say(f"left out: {title} ({name} was not built: its library or compiler is not installed)")
    return add


def loops(build):
    """RK4 in loops that the compiler vectorised."""
    found = []
    add = adder(build, found)
    add("C vectorised", "bench_c_vectorised")
    add("C vectorised, own arctangent", "bench_c_vectorised_own")
    return found


def adaptive_programs(build):
    found = []
    add = adder(build, found)
    for isa in INSTRUCTION_SETS:
        add(f"whirl {isa}, contacts located", "bench_whirl_adaptive", isa=isa)
    add("whirl integrator dop853", "bench_whirl_adaptive", "alone")
    add("GSL rk8pd", "bench_adaptive_gsl")
    add("SUNDIALS, adaptive", "bench_adaptive_sundials")
    add("Boost.odeint dopri5", "bench_adaptive_odeint")
    return found + loops(build)


def overhung_programs(build, matrices):
    found = []
    add = adder(build, found)
    for isa in INSTRUCTION_SETS:
        add(f"whirl {isa}, overhung", "bench_whirl_overhung", isa=isa)
    add("C -O3, overhung", "bench_overhung_c", matrices)
    add(f"{BASE}, overhung", "bench_overhung_c_fast", matrices)
    for machines in (8, 16, 32):
        for step in (1, 2):
            add("C vectorised, overhung", f"bench_overhung_vectorised_{step}_{machines}", matrices)
    add("SUNDIALS CVODE, overhung", "bench_overhung_cvode", matrices)
    python, octave = python_with("scipy"), shutil.which("octave-cli")
    if python:
        found.append(Program("SciPy", [python, str(HERE / "overhung_scipy.py"), matrices], once=True))
    else:
        say("left out: SciPy (no Python here can import it)")
    if octave:
        found.append(Program("Octave", [octave, "--norc", "--no-history", "--quiet", str(HERE / "overhung_octave.m"),
                                        matrices], once=True))
    return found


def programs(build):
    found = []
    add = adder(build, found)
    for isa in INSTRUCTION_SETS:
        add(f"whirl {isa}", "bench_whirl_kernels", "bare", "watched", "ten", "fifty", isa=isa)
    add("whirl integrator", "bench_whirl_kernels", "integrator")
    add("C -O3", "bench_c")
    add(BASE, "bench_c_fast")
    found += loops(build)
    add("GSL", "bench_gsl")
    add("SUNDIALS ARKODE", "bench_arkode")
    add("Boost.odeint", "bench_odeint")
    python, octave = python_with("numba"), shutil.which("octave-cli")
    if python:
        found.append(Program("Numba", [python, str(HERE / "numba_peer.py"), "SECONDS"]))
    else:
        say("left out: Numba (no Python here can import it)")
    if octave:
        for script in ("octave_vectorised.m", "octave_script.m"):
            found.append(Program(script, [octave, "--norc", "--no-history", "--quiet", str(HERE / script)], once=True))
    else:
        say("left out: Octave (octave-cli is not installed)")
    return found


# ---------------------------------------------------------------- measurements


def on_cores(cores, command):
    return ["taskset", "-c", cores, *command] if shutil.which("taskset") else command


def run_program(program, seconds, core):
    """Lines (name, steps a second, x1) of one program; None where the processor lacks the instruction set."""
    command = [str(seconds) if word == "SECONDS" else word for word in program.command]
    environment = dict(os.environ, **({"WHIRL_ISA": program.isa} if program.isa else {}))
    done = subprocess.run(on_cores(core, command), capture_output=True, text=True, env=environment)
    if done.returncode == 77 or (done.returncode != 0 and "WHIRL_ISA" in done.stderr):
        return None
    if done.returncode != 0:
        sys.exit(f"bench: {program.title} failed: {done.stderr.strip()}")
    rows = [line.split("\t") for line in done.stdout.splitlines() if line.count("\t") == 2]
    return [(name, float(rate), float(x1)) for name, rate, x1 in rows]


def measure_rounds(found, options):
    """Best rate of every name, and the proofs that the programs printed: all of them in turn, in several rounds."""
    best, ends, absent = {}, {}, set()
    for number in range(options.rounds):
        say(f"round {number + 1} of {options.rounds}, load {os.getloadavg()[0]:.2f}")
        for program in found:
            if program.title in absent or (program.once and number > 0):
                continue
            rows = run_program(program, options.seconds, options.core)
            if rows is None:
                say(f"left out: {program.title} (not on this processor, or not installed)")
                absent.add(program.title)
                continue
            for name, rate, x1 in rows:
                best[name], ends[name] = max(rate, best.get(name, 0.0)), x1
    return best, ends


def measure(found, options):
    """Best steps a second of every name."""
    best, ends = measure_rounds(found, options)
    strangers = [n for n in ends if n.split()[-1] not in CHAINS and not abs(ends[n] - X1) < 1e-6]
    for name in strangers:
        say(f"bench: {name} ends at x1 = {ends[name]:.13f} after 20 revolutions, expected {X1}")
    if strangers:
        sys.exit(1)
    return best


def processor_seconds_of_children():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run_timed(options, case, result, threads=1):
    """Runs a case. Returns the seconds by the clock, and of the processor."""
    command = [str(options.build / "whirl"), "run", str(case), "-q", f"--threads={threads}", "--force", "-o", str(result)]
    cores = options.core if threads == 1 else ",".join(str(c) for c in sorted(os.sched_getaffinity(0)))
    start, used = time.monotonic(), processor_seconds_of_children()
    subprocess.run(on_cores(cores, command), check=True)
    return time.monotonic() - start, processor_seconds_of_children() - used


def shown_points(options, result, how="--json"):
    """The points of a result as `whirl show` gives them."""
    out = subprocess.run([options.build / "whirl", "show", how, result], capture_output=True, text=True, check=True)
    return json.loads(out.stdout)["points"]


def scipy_python(what):
    """A Python that can import SciPy; None, with a line that says what is left out."""
    python = python_with("scipy")
    if not python:
        say(f"left out: {what} (no Python here can import SciPy)")
    return python


def study(options, case, threads):
    """Seconds of `whirl run` by the clock, and of the processor."""
    with tempfile.TemporaryDirectory() as folder:
        return run_timed(options, case, os.path.join(folder, "t1.h5"), threads)


def measure_studies(options):
    """Least seconds (clock, processor) of the whole diagram, by the options of the command."""
    case = HERE / "t1.yaml"
    kinds = {"all analyses, 1 thread": (True, 1), "without exponents and verdicts, 1 thread": (False, 1)}
    if len(os.sched_getaffinity(0)) > 1:
        kinds["all analyses, 2 threads"] = (True, 2)
    best = {}
    with tempfile.NamedTemporaryFile("w", suffix=".yaml") as plain:
        plain.write(re.sub(r"analyze:.*", "analyze: [poincare, spectrum, orbit, rub]", case.read_text()))
        plain.flush()
        for number in range(options.study_rounds):
            say(f"the whole diagram, round {number + 1} of {options.study_rounds}, load {os.getloadavg()[0]:.2f}")
            for kind, (full, threads) in kinds.items():
                spent = study(options, case if full else plain.name, threads)
                best[kind] = tuple(map(min, spent, best.get(kind, spent)))
    return best


# ---------------------------------------------------------------- what is said of it


def computer():
    text = subprocess.run(["lscpu"], capture_output=True, text=True, env=dict(os.environ, LC_ALL="C")).stdout
    field = dict(re.findall(r"^([^:]+):\s+(.*)$", text, re.M))
    lines = [f"{field.get('Model name', 'unknown processor')} (family {field.get('CPU family', '?')}, "
             f"model {field.get('Model', '?')}), {os.cpu_count()} cores"]
    if "Hypervisor vendor" in field:
        lines[0] += f", a virtual machine under {field['Hypervisor vendor']}"
    return lines[0]


def compilers(build):
    """Compilers as CMake found them, "GNU 12.2.0"; those of C and C++ are mostly the same."""
    found = []
    for language in ("C", "CXX"):
        for path in build.glob(f"CMakeFiles/*/CMake{language}Compiler.cmake"):
            text = path.read_text()
            found.append(" ".join(re.search(rf'CMAKE_{language}_COMPILER_{what} "(.*)"', text)[1]
                                  for what in ("ID", "VERSION")))
    return list(dict.fromkeys(found))


def versions():
    """Versions of the peers' libraries, where pkg-config or the program knows them."""
    found = [f"glibc {os.confstr('CS_GNU_LIBC_VERSION').split()[-1]}"]
    for name, module in (("GSL", "gsl"),):
        version = first_line("pkg-config", "--modversion", module)
        if version != "unknown":
            found.append(f"{name} {version}")
    for package, name in (("libsundials-dev", "SUNDIALS"), ("libboost-dev", "Boost"), ("python3-numba", "Numba"),
                          ("python3-scipy", "SciPy"), ("octave", "Octave")):
        version = first_line("dpkg-query", "-W", "-f", "${Version}\\n", package)
        if version != "unknown":
            found.append(f"{name} {version.split('+')[0].split('-')[0]}")
    return ", ".join(found)


def short(value):
    """A number with three digits: 4.93e7, 13,800, 1.18."""
    if 1000 <= value < 1e5:
        return f"{float(f'{value:.3g}'):,.0f}"
    return f"{value:.3g}".replace("e+0", "e").replace("e+", "e")


def ratio(a, b):
    return short(a / b) if b else "-"


def speed_table(best):
    base, plain = best.get(BASE), best.get("C -O3")
    lines = ["| program | steps/s a core | of C, -O3 -march=native -ffast-math | of C, -O3 | whole diagram |",
             "|---|---:|---:|---:|---:|"]
    for name, rate in sorted(best.items(), key=lambda item: -item[1]):
        if name.split()[-1] in CHAINS:
            continue
        whole = STEPS_OF_STUDY / rate
        whole = (f"{whole:.3g} s" if whole < 600 else f"{whole / 60:.3g} min" if whole < 36000 else
                 f"{whole / 3600:.3g} h")
        lines.append(f"| {name} | {short(rate)} | {ratio(rate, base)} | {ratio(rate, plain)} | {whole} |")
    return lines


def station_table(best):
    lines = ["| kernel | 2 stations, steps/s | 10 stations, steps/s x stations | 50 stations, steps/s x stations |",
             "|---|---:|---:|---:|"]
    for isa in INSTRUCTION_SETS:
        two = best.get(f"whirl {isa} bare")
        if not two:
            continue
        cells = [f"{short(best[f'whirl {isa} {kind}'] * n)} ({best[f'whirl {isa} {kind}'] * n / (2 * two):.2f})"
                 for kind, n in CHAINS.items()]
        lines.append(f"| {isa} | {short(two)} | {' | '.join(cells)} |")
    return lines


def study_table(best, studies):
    widest = next(best[f"whirl {isa} bare"] for isa in INSTRUCTION_SETS if f"whirl {isa} bare" in best)
    bare = STEPS_OF_STUDY / widest
    lines = ["| the whole diagram, 629 million steps | seconds by the clock | of the processor | of the bare kernel |",
             "|---|---:|---:|---:|", f"| the bare kernel, from its speed above | | {bare:.3g} | 1 |"]
    lines += [f"| `whirl run`, {kind} | {clock:.3g} | {used:.3g} | {used / bare:.2f} |"
              for kind, (clock, used) in studies.items()]
    one, two = studies.get("all analyses, 1 thread"), studies.get("all analyses, 2 threads")
    if two:
        lines += ["", f"Two threads are {one[0] / two[0]:.2f} times as fast as one by the clock, which is valid on an "
                  f"idle computer only (see the load above). Their processor time differs from that of one thread by "
                  f"{100 * (two[1] / one[1] - 1):.1f} percent."]
    return lines


def key_ratios(best):
    """Sentences with the ratios that the tables show."""
    widest = next(isa for isa in INSTRUCTION_SETS if f"whirl {isa} bare" in best)
    bare, watched = best[f"whirl {widest} bare"], best[f"whirl {widest} watched"]
    vectorised = best_loop(best)
    rows = [("straightforward C (-O3 -march=native -ffast-math)", best.get(BASE)),
            ("straightforward C (the faster of both builds)", max(best.get(BASE, 0), best.get("C -O3", 0)) or None),
            ("the best loop that the compiler vectorised", vectorised),
            ("the Octave script", best.get("Octave script"))]
    lines = [f"The {widest} kernel alone (*bare*) takes {short(bare)} steps a second. While it also records the motion (*watched*: "
             f"bounds, contacts, 64 samples per revolution) it takes {short(watched)}: recording costs "
             f"{100 * (bare / watched - 1):.0f} percent. Its rate divided by that of:",
             ""]
    lines += [f"- {name}: {short(bare / rate)} bare, {short(watched / rate)} watched" for name, rate in rows if rate]
    return lines


TEXT = """# Benchmarks

This page compares the speed of whirl's kernels with other programs for the same task: the rotor of the paper of 2015
([theory](theory.md), section 7), a disc and a journal, with the signs of the shaft's stiffness as printed there
(`signs: paper`), film coefficient Sf = 0.0045 and gravity G = 0.115976. It starts at rest at y = -0.1 and is computed
in double precision by RK4 in 1024 steps per revolution. A *step* is one step of one machine. `make bench` repeats the
measurements and writes this page.

All programs ran in one session on one core, in {rounds} alternating rounds of {seconds:g} s. The best round counts, by
processor time. A check before the rounds proves that every program computes the same: x1 after 20 revolutions at r_k
= 0.6 agrees to 1e-6 with 0.3457490150754.

- Processor: {computer}
- Compilers: {compilers}
- Libraries: {versions}
- Load average, before and after: {before:.2f}, {after:.2f}

![Steps a second](images/benchmarks.png)

{ratios}

{speed}

- *whirl ISA bare*: `whirl_ensemble_revolve`, the kernel alone; *watched*: with bounds, contact statistics and waveform
  samples, as the command does while it records. The rotor comes from a list of elements at run time.
  `scalar`, `fma`: one lane; `simd128`: two, with no fused multiply-add; `avx2`: four; `avx512`: eight.
- *whirl integrator*: `whirl_integrator_revolve`, a single machine through the general right-hand side.
- *C*: the equations as the paper prints them (`bench/straightforward.c`), one machine, two sets of flags. The
  vectorised loop (`bench/vectorised.c`) has no branch, one arctangent, tabulated cosines, 64 machines side by side and
  RK4 in Nystrom's form; 512-bit vectors where the processor has them; also -march=native -ffast-math.
- *GSL, ARKODE, Boost.odeint, Numba*: one machine; the forces of the film are computed by one arctangent, without the
  angle alpha of the paper. GSL's rk4 takes every step whole and as two halves; its halves are counted. ARKODE's table
  has a fifth stage (see `bench/arkode.c`). *simd* is Boost.odeint over `std::experimental::simd`.
- *Octave*: 20 revolutions of one machine, and of 512 side by side; the whole diagram by extrapolation.

## More stations

The rotors are chains of equal discs with a film at both ends and one rub in the middle; every shaft, disc and film is
an element of the list. Brackets give the ratio to the rate of two stations, 2 x steps/s.

{stations}
"""

STUDY = """
## The whole diagram

`bench/t1.yaml`: 512 values of r_k, 1100 revolutions of transient and 100 recorded, from case file to result file; the
best of {rounds} rounds. With exponents, a perturbation runs over 650 of the 1200 revolutions in a lane of its own: 1.54
times the steps.

{study}
"""


ADAPTIVE = """
## Adaptive, contacts located

The same rotor at r_k = 0.6 by adaptive methods at rtol 1e-9 and atol 1e-12 (unless the name says otherwise), in
revolutions a second of one core. The error is the largest of all coordinates after 20 revolutions with six crossings of
the gap, against a reference in extended precision. All ran in one session, in alternating rounds as above.

{table}

- *whirl ISA*: machines in lanes, r_k from 0.55 to 0.65, the first 0.6, contacts located; also at a tighter tolerance,
  and RK4 in 1024 steps with and without located contacts.
- *GSL, ARKODE, Boost.odeint*: one machine; they do not locate contacts, and shorten their steps there. *CVODE* finds
  contacts as roots.

heyoka 7 is not in Debian. It was measured together with two peers on a Zen 5 core: heyoka does {heyoka} revolutions a
second in batches of 8 (AVX-512, events, error {heyoka_error:.1e}), GSL rk8pd {gsl}, and the loop that the compiler
vectorised {there} steps of RK4 a second. Either peer can convert heyoka's rate to this processor. GSL is scalar code,
heyoka's batches are vectors of 512 bits, and processors differ in the number of such vectors per cycle, so both
conversions are given. The loop does {loop} steps a second here.

{sentences}
"""

# heyoka 7 (batch of 8 with AVX-512, events) on a Zen 5 core, revolutions a second, and what peers did on the same core:
# GSL rk8pd, revolutions a second, and the loop that the compiler vectorised, steps of RK4 a second (6.4e7 to 6.9e7).
HEYOKA, HEYOKA_ERROR = 4.5e4, 1.1e-11
GSL_THERE, LOOP_THERE = 8.6e3, 6.4e7


LOOP = "C vectorised"


def best_loop(best):
    """Steps a second of the best loop that the compiler vectorised; None where there is none."""
    return max((rate for name, rate in best.items() if name.startswith(LOOP)), default=None)


def adaptive_table(best, errors):
    gsl = best.get("GSL odeiv2 rk8pd")
    lines = ["| program | revolutions/s a core | of GSL rk8pd | error |", "|---|---:|---:|---:|"]
    lines += [f"| {name} | {short(rate)} | {ratio(rate, gsl)} | {errors[name]:.1e} |"
              for name, rate in sorted(best.items(), key=lambda item: -item[1])]
    return lines


def adaptive_sentences(best, errors, loop):
    """Sentences that compare with GSL, and with heyoka through peers that ran on both computers."""
    gsl = best.get("GSL odeiv2 rk8pd")
    if not gsl:
        return ["GSL was not there to compare with."]
    lines = []
    for tolerance in ("1e-09", "4e-11"):
        name = next((f"whirl {isa} dop853, rtol {tolerance}" for isa in INSTRUCTION_SETS
                     if f"whirl {isa} dop853, rtol {tolerance}" in best), None)
        if not name:
            continue
        line = (f"- {name}: {best[name] / gsl:.1f} times GSL rk8pd, error {errors[name]:.1e}; "
                f"{best[name] / (HEYOKA * gsl / GSL_THERE):.1f} times heyoka by the scale of GSL")
        if loop:
            line += f", {best[name] / (HEYOKA * loop / LOOP_THERE):.1f} times by that of the vectorised loop"
        lines.append(line + ".")
    return lines


def measure_adaptive(options):
    best, errors = measure_rounds(adaptive_programs(options.build), options)
    loop = best_loop(best)
    best = {name: rate for name, rate in best.items() if not name.startswith(LOOP)}
    return ADAPTIVE.format(table="\n".join(adaptive_table(best, errors)),
                           sentences="\n".join(adaptive_sentences(best, errors, loop)),
                           loop=short(loop) if loop else "not measured", there=short(LOOP_THERE),
                           heyoka=short(HEYOKA), heyoka_error=HEYOKA_ERROR, gsl=short(GSL_THERE))


BRANCHES = """
## Orbits along a branch

Periodic orbits of the paper's rotor without its stator, with multipliers and special points, at a hundred values of r_k
from 0.6 to 0.37, in points a second of one core. AUTO-07p has the equations compiled, with exact derivatives
(`tests/peers/auto`). The names give its intervals, points and tolerances; 1e-7 is the tolerance of its demonstrations,
with 1e-5 for special points. whirl reads a case, and computes eight segments per revolution side by side. Errors are
the largest of all points: of a coordinate at tau = 0 and of a multiplier, against orbits found at rtol 1e-13; and that
of the Neimark-Sacker point at {torus:.12f}. Load before {before:.1f}, after {after:.1f}.

{table}

{sentence}
"""
# By AUTO-07p with 100, 200 and 400 intervals of 7 points, and by whirl.
TORUS = 0.392506766046
AUTO = HERE.parent / "tests" / "peers" / "auto"
# Settings of AUTO, as options of follow.py; the first one is about as accurate as whirl at rtol 1e-8.
AUTO_SETTINGS = (["--ntst=50", "--ncol=4", "--loose"], ["--ntst=50", "--ncol=4"], ["--ntst=100", "--ncol=7"])


def branch_programs(build):
    found = []
    add = adder(build, found)
    add("whirl, branch", "bench_whirl_branch", str(AUTO / "rotor.yaml"))
    for settings in AUTO_SETTINGS:
        found.append(Program("AUTO-07p", [sys.executable, str(AUTO / "follow.py"), "--bench", *settings]))
    return found


def branch_errors(build, command):
    """The largest errors (of a coordinate, of a multiplier) of the points that a command prints."""
    program = [str(build / "bench" / "bench_whirl_branch"), "--errors", str(AUTO / "rotor.yaml")]
    points = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    done = subprocess.run(program, input=points, capture_output=True, text=True, check=True)
    return [float(word) for word in done.stdout.split()]


def points_command(build, name):
    """The command that prints the points of a row of the table."""
    if name.startswith("whirl"):
        return [str(build / "bench" / "bench_whirl_branch"), "--points", name.split()[-1], str(AUTO / "rotor.yaml")]
    intervals, count = (word.rstrip(",") for word in name.split() if word.rstrip(",").isdigit())
    loose = ["--loose"] if name.endswith("1e-7") else []
    return [sys.executable, str(AUTO / "follow.py"), f"--ntst={intervals}", f"--ncol={count}", *loose, "--points=100",
            "--to=0.37"]


def branch_sentence(best, errors):
    """How much faster whirl is than AUTO with the tolerances of its demonstrations: where none of its errors is larger,
    and at its fastest."""
    peers = [name for name in best if name.startswith("AUTO") and name.endswith("1e-7")]
    if not peers:
        return "AUTO-07p was not measured."
    peer = peers[0]
    own = sorted((name for name in best if name.startswith("whirl")), key=lambda name: -best[name])
    as_exact = [name for name in own if all(a <= b for a, b in zip(errors[name], errors[peer]))]
    sentences = [f"{best[name] / best[peer]:.1f} times as fast at {name[7:]}" + why for names, why in
            ((as_exact, ", where no error is larger"), (own, "")) for name in names[:1]]
    return f"Against {peer}, whirl's points come " + ", and ".join(dict.fromkeys(sentences)) + "."


def measure_branches(options):
    before = os.getloadavg()[0]
    best, ends = measure_rounds(branch_programs(options.build), options)
    strangers = [name for name in ends if not abs(ends[name] - TORUS) < 1e-4]
    for name in strangers:
        say(f"bench: {name} finds a Neimark-Sacker point at {ends[name]:.10f}, expected {TORUS}")
    if strangers:
        sys.exit(1)
    after = os.getloadavg()[0]
    errors = {name: [*branch_errors(options.build, points_command(options.build, name)), abs(ends[name] - TORUS)]
              for name in best}
    lines = ["| program | points/s a core | ms a point | error of a coordinate | of a multiplier | of r_k |",
             "|---|---:|---:|---:|---:|---:|"]
    for name, rate in sorted(best.items(), key=lambda item: -item[1]):
        columns = [f"{error:.0e}" if error >= 1e-12 else "< 1e-12" for error in errors[name]]
        lines.append(" | ".join([f"| {name}", short(rate), f"{1e3 / rate:.2g}", *columns]) + " |")
    return BRANCHES.format(torus=TORUS, table="\n".join(lines), before=before, after=after,
                           sentence=branch_sentence(best, errors))


MAP = """
## A map

`bench/map.yaml`: 16 x 16 points over the ratio of stiffness and the unbalance. Each point has 220 revolutions of
transient and 20 recorded ones, with sections and bounds of the disc; over 130 of them a second motion gives the largest
exponent. That is 370 revolutions a point, by adaptive methods at rtol 1e-6. Processor time of one core, the best of
{rounds} alternating rounds; load average {before:.2f} before, {after:.2f} after. A check before the rounds proves that
every program computes the same: the mean of x1 over the first five sections of four points agrees to 1e-5.

{table}

- *whirl run*: the command, from case file to result file. It also computes verdicts, contact statistics and 64 samples
  a revolution.
- *Boost.odeint, Numba*: compiled loops over one machine after the other; *Octave*: `lsode`, 4 of the points over 10
  revolutions, scaled.
"""

MAP_REVOLUTIONS, MAP_POINTS, MAP_FOUR = 370, 256, 85
MAP_OCTAVE = (8, 2, 16)  # transient, record, and revolutions with those of the second motion


def run_map(options, case, folder):
    """Processor seconds of `whirl run` over a map."""
    used = processor_seconds_of_children()
    subprocess.run(on_cores(options.core, [str(options.build / "whirl"), "run", str(case), "-q", "--force",
                                           "--threads=1", "-o", os.path.join(folder, "map.h5")]), check=True)
    return processor_seconds_of_children() - used


def map_proof(options, folder):
    """Mean of x1 over the first five sections of four points, by whirl."""
    case = pathlib.Path(folder) / "proof.yaml"
    case.write_text((HERE / "map.yaml").read_text().replace("transient: 220, record: 20", "transient: 0, record: 5"))
    run_map(options, case, folder)
    subprocess.run([str(options.build / "whirl"), "export", os.path.join(folder, "map.h5"), "--csv", folder],
                   check=True, capture_output=True)
    with open(os.path.join(folder, "map-poincare-section.csv"), newline="", encoding="utf-8") as file:
        found = [float(line["x [0.2 mm]"]) for line in csv.DictReader(file)
                 if line["station"] == "disc" and (int(line["point"]) - 1) % MAP_FOUR == 0]
    return sum(found) / len(found)


def map_peers(options):
    """Commands of the peers that are there."""
    found = {}
    odeint, python = options.build / "bench" / "bench_map_odeint", python_with("numba")
    octave = shutil.which("octave-cli")
    if odeint.exists():
        found["Boost.odeint dopri5"] = [str(odeint)]
    if python:
        found["Numba dopri5"] = [python, str(HERE / "map_numba.py")]
    if octave:
        found["Octave lsode"] = [octave, "--norc", "--no-history", "--quiet", str(HERE / "map_octave.m")]
    return found


def map_seconds(options, command, transient, record, stride):
    """Seconds a point, and the mean of x1 over the recorded sections."""
    words = [*command, str(transient), str(record), str(stride)]
    done = subprocess.run(on_cores(options.core, words), capture_output=True, text=True, check=True)
    return tuple(float(word) for word in done.stdout.split("\t")[1:3])


def measure_map(options):
    before, best = os.getloadavg()[0], {}
    peers = map_peers(options)
    with tempfile.TemporaryDirectory() as folder:
        proof = map_proof(options, folder)
        for name, command in peers.items():
            mean = map_seconds(options, command, 0, 5, MAP_FOUR)[1]
            if not abs(mean - proof) < 1e-5:
                sys.exit(f"bench: {name} has a mean of {mean:.9f}, whirl {proof:.9f}")
        for number in range(options.study_rounds):
            say(f"the map, round {number + 1} of {options.study_rounds}, load {os.getloadavg()[0]:.2f}")
            spent = {"whirl run": run_map(options, HERE / "map.yaml", folder) / MAP_POINTS}
            for name, command in peers.items():
                if name == "Octave lsode":
                    transient, record, revolutions = MAP_OCTAVE
                    scale = MAP_REVOLUTIONS / revolutions
                    spent[name] = scale * map_seconds(options, command, transient, record, MAP_FOUR)[0]
                else:
                    spent[name] = map_seconds(options, command, 220, 20, 1)[0]
            best = {name: min(seconds, best.get(name, seconds)) for name, seconds in spent.items()}
    lines = ["| program | ms a point | revolutions/s a core | of whirl's time |", "|---|---:|---:|---:|"]
    for name, seconds in sorted(best.items(), key=lambda item: item[1]):
        lines.append(f"| {name} | {short(1e3 * seconds)} | {short(MAP_REVOLUTIONS / seconds)} | "
                     f"{short(seconds / best['whirl run'])} |")
    return MAP.format(rounds=options.study_rounds, before=before, after=os.getloadavg()[0], table="\n".join(lines))


ELEMENTS = """
## Elements

Kernels of elements in lanes compared with C functions of the same laws (`bench/element_laws.c`, -O3 -march=native): one
sine and cosine for all balls or blades, branches for open contacts, accelerations added up as kernels do. Both compute
the same random states of machines with four copies of the element. All contacts touch; balls and blades touch if the
displacements reach them. Times are nanoseconds for one element of one machine on one core. All numbers agree with C to
1e-12.

{table}

Aim: five times. Contacts that do not touch are not in the table: there C returns at once, and lanes are some three
times as fast. C runs along with every instruction set, so its best time is from more rounds.
"""


def element_programs(build):
    found = []
    add = adder(build, found)
    for isa in INSTRUCTION_SETS:
        add(f"elements, {isa}", "bench_elements", isa=isa)
    return found


def measure_elements(options):
    best, apart = measure_rounds(element_programs(options.build), options)
    strangers = [name for name in apart if not apart[name] < 1e-12]
    if strangers:
        sys.exit(f"bench: {', '.join(strangers)}: kernel and law in C differ")
    split = {tuple(name.split(", ", 1)): 1e9 / rate for name, rate in best.items()}
    sets = [isa for isa in INSTRUCTION_SETS if any(who == isa for who, _ in split)]
    lines = ["| element | " + " | ".join([*sets, "C", f"C/{sets[0]}"]) + " |", "|---|" + "---:|" * (len(sets) + 2)]
    for name in dict.fromkeys(name for _, name in split):
        times = [split[who, name] for who in (*sets, "C")]
        lines.append(f"| {name} | " + " | ".join(f"{time:.3g}" for time in times) +
                     f" | {times[-1] / times[0]:.1f} |")
    return ELEMENTS.format(table="\n".join(lines))


OVERHUNG = """
## A rotor of finite elements

An overhung rotor of 20 elements (84 coordinates), reduced to its three stations and 8 modes a plane (22 coordinates),
in two films, with gravity, unbalance and a rub at the disc (`bench/overhung.h`). RK4 takes {steps} steps per
revolution, which resolve its highest mode. A single machine turns at 628 rad/s, machines in lanes at 628 to 1000 rad/s.
The peers read the same reduced matrices. Checks before the rounds: y of the left journal after 20 revolutions, the last ones with contact, agrees to
1e-6 with {end:.10f} of RK4 for fixed steps. Adaptive methods, at rtol 1e-6 and atol 1e-9, agree to 1e-4 with
{converged:.7f} of rodas5p at rtol 1e-10.

{table}

{sentences}

- *C*: `bench/overhung_straightforward.c`, one machine, dense matrices. *Vectorised* (`bench/overhung_vectorised.c`): 8,
  16 or 32 machines side by side, four rows of a matrix at a time, RK4 in Nystrom's form. *dense* uses whole matrices.
  *by planes* leaves out the half that is zero, because stiffness acts in a plane and gyroscopic moments across. The
  table has the best number of machines of each.
- *rodas5p*: whirl's stiff method in lanes, contacts located. *CVODE, SciPy, Octave*: one machine, dense Jacobians by
  differences.

`whirl check bench/overhung.yaml` takes {check:.2g} s by the clock (aim: 0.2 s), and `modes` of that rotor over 200
speeds, from case file to result file on one thread, {modes:.2g} s (aim: 1 s).
"""

# y of the left journal after 20 revolutions: by RK4, and by rodas5p at rtol 1e-10, which rtol 1e-8 does not change.
OVERHUNG_STEPS, OVERHUNG_END, OVERHUNG_CONVERGED = 512, 0.2857630092477, 0.3939028
OVERHUNG_STIFF = ("rodas5p", "SUNDIALS", "SciPy", "Octave")
OVERHUNG_FORMS = ("dense", "by planes")
OVERHUNG_MODES = "study:\n  modes: {parameter: omega, from: 105 rad/s, to: 1257 rad/s, points: 200}\n"


def is_stiff(name):
    return any(word in name for word in OVERHUNG_STIFF)


def check_overhung(ends):
    strangers = [name for name, y in ends.items()
                 if not abs(y - (OVERHUNG_CONVERGED if is_stiff(name) else OVERHUNG_END)) <
                 (1e-4 if is_stiff(name) else 1e-6)]
    for name in strangers:
        say(f"bench: {name} ends at y = {ends[name]:.10f} after 20 revolutions, which is not what is expected")
    if strangers:
        sys.exit(1)


def overhung_rates(best):
    """Revolutions a second of the rows of the table: of the vectorised loops, the best of each form."""
    rates = {name: rate / (1 if is_stiff(name) and not name.startswith("whirl") else OVERHUNG_STEPS)
             for name, rate in best.items()}
    loops_of = {form: [name for name in rates if name.startswith(LOOP) and f", {form}," in name]
                for form in OVERHUNG_FORMS}
    kept = [max(names, key=rates.get) for names in loops_of.values() if names]
    return {name: rate for name, rate in rates.items() if not name.startswith(LOOP) or name in kept}


def overhung_table(rates):
    base, plain = rates.get(BASE), rates.get("C -O3")
    lines = ["| program | revolutions/s a core | steps of RK4/s | of C, -O3 -march=native -ffast-math | of C, -O3 |",
             "|---|---:|---:|---:|---:|"]
    lines += [f"| {name} | {short(rate)} | {'' if is_stiff(name) else short(rate * OVERHUNG_STEPS)} | "
              f"{ratio(rate, base)} | {ratio(rate, plain)} |"
              for name, rate in sorted(rates.items(), key=lambda item: -item[1])]
    return lines


def overhung_sentences(rates):
    widest = next(isa for isa in INSTRUCTION_SETS if f"whirl {isa} bare" in rates)
    bare, watched = rates[f"whirl {widest} bare"], rates[f"whirl {widest} watched"]
    rows = [("straightforward C (-O3)", rates.get("C -O3")), (f"straightforward {BASE}", rates.get(BASE))]
    rows += [(f"the best loop that the compiler vectorised, {form}",
              next((rate for name, rate in rates.items() if name.startswith(LOOP) and form in name), None))
             for form in OVERHUNG_FORMS]
    lines = [f"Rate of the {widest} kernel divided by that of the following (aims: 10 for straightforward C, 2 for vectorised "
             "loops):", ""]
    return lines + [f"- {name}: {short(bare / rate)} bare, {short(watched / rate)} watched" for name, rate in rows
                    if rate]


def seconds_of(core, *command):
    """Seconds of a command by the clock, the best of five runs."""
    best = float("inf")
    for _ in range(5):
        start = time.monotonic()
        subprocess.run(on_cores(core, [str(word) for word in command]), capture_output=True, check=True)
        best = min(best, time.monotonic() - start)
    return best


def measure_overhung(options):
    whirl, case = options.build / "whirl", HERE / "overhung.yaml"
    with tempfile.TemporaryDirectory() as folder:
        matrices, modes = os.path.join(folder, "matrices.txt"), pathlib.Path(folder, "modes.yaml")
        subprocess.run([str(options.build / "bench" / "bench_overhung_matrices"), matrices], check=True)
        modes.write_text(case.read_text().partition("study:")[0] + OVERHUNG_MODES)
        best, ends = measure_rounds(overhung_programs(options.build, matrices), options)
        check_overhung(ends)
        check = seconds_of(options.core, whirl, "check", case)
        run = seconds_of(options.core, whirl, "run", modes, "-q", "--threads=1", "--force", "-o",
                         os.path.join(folder, "modes.h5"))
    rates = overhung_rates(best)
    return OVERHUNG.format(steps=OVERHUNG_STEPS, end=OVERHUNG_END, converged=OVERHUNG_CONVERGED,
                           table="\n".join(overhung_table(rates)), sentences="\n".join(overhung_sentences(rates)),
                           check=check, modes=run)


PADS = """
## Bearings of pads

Four journals, each by itself in a bearing (`bench/pads.h`), RK4 in 1024 steps per revolution. The bearings have five
tilting pads with inertia, whose films are tables, in whirl and in straightforward C; x of a journal after 20
revolutions agrees to 1e-9. By processor time of one core, the best of {rounds} alternating rounds; load average
{before:.2f} before, {after:.2f} after.

{table}

{sentences}

- *C*: `bench/pads_straightforward.c`, one machine, the same numbers of the table, read from a file.
- *none* has no bearing: its time is subtracted for the cost of a film.

`bench/pads.yaml`, a rotor with two bearings of five tilting pads and a rub, 256 speeds and 300 revolutions by dop853 at
rtol 1e-6, takes `whirl run` {study:.3g} s of processor time: {half:.3g} s on two cores (aim: 30 s).
"""


def pads_programs(build, table):
    found = []
    add = adder(build, found)
    for isa in INSTRUCTION_SETS:
        add(f"whirl {isa}, pads", "bench_whirl_pads", isa=isa)
    add("C -O3, pads", "bench_pads_c", table)
    add(f"{BASE}, pads", "bench_pads_c_fast", table)
    return found


PADS_TILTING = "five tilting pads"
PADS_FILMS = {"short film": 4, "finite film": 4, "five fixed pads": 20, PADS_TILTING: 20,
              "five tilting pads without inertia": 20}


def pads_costs(rates, isa):
    """Nanoseconds per film, machine and computed force (four a step), by the kind of bearing."""
    seconds = {kind: 1 / rates[f"whirl {isa}, {kind}"] for kind in ["none", *PADS_FILMS]}
    return {kind: 1e9 * (seconds[kind] - seconds["none"]) / (4 * films) for kind, films in PADS_FILMS.items()}


def pads_sentences(rates):
    widest = next(isa for isa in INSTRUCTION_SETS if f"whirl {isa}, {PADS_TILTING}" in rates)
    costs, own = pads_costs(rates, widest), rates[f"whirl {widest}, {PADS_TILTING}"]
    films = ", ".join(f"{kind} {short(cost)} ({cost / costs['short film']:.1f})" for kind, cost in costs.items())
    return [f"- Cost of a film, or of one pad of a bearing, for one machine of the {widest} kernel in ns, with the ratio to the short "
            f"film: {films}. The aims are ratios, 2.2 for a finite film and 5 for a pad. When they were set a short film took "
            "2.9 ns, so that they stood for 6.4 and 14.5 ns.",
            f"- Five tilting pads, rate divided by that of straightforward C (aim: 10): {own / rates['C -O3']:.1f} with -O3, "
            f"{own / rates[BASE]:.1f} with -O3 -march=native -ffast-math."]


def measure_pads(options):
    before = os.getloadavg()[0]
    with tempfile.TemporaryDirectory() as folder:
        table, out = os.path.join(folder, "table"), os.path.join(folder, "pads.h5")
        subprocess.run([str(options.build / "bench" / "bench_pads_table"), table], check=True)
        best, ends = measure_rounds(pads_programs(options.build, table), options)
        used = []
        for _ in range(options.study_rounds):
            start = processor_seconds_of_children()
            subprocess.run([str(options.build / "whirl"), "run", str(HERE / "pads.yaml"), "-q", "--threads=2", "--force",
                            "-o", out], check=True)
            used.append(processor_seconds_of_children() - start)
    rates = {name.removeprefix("pads: "): rate for name, rate in best.items()}
    same = [end for name, end in ends.items() if name.endswith(PADS_TILTING) or "C -O3" in name]
    if max(same) - min(same) > 1e-9:
        sys.exit(f"bench: bearings of pads end apart: {same}")
    lines = ["| program | steps of RK4/s | of C, -O3 -march=native -ffast-math | of C, -O3 |", "|---|---:|---:|---:|"]
    for name, rate in sorted(rates.items(), key=lambda item: -item[1]):
        peer = name.endswith(PADS_TILTING) or "C -O3" in name
        ratios = f"{ratio(rate, rates[BASE])} | {ratio(rate, rates['C -O3'])}" if peer else " | "
        lines.append(f"| {name} | {short(rate)} | {ratios} |")
    return PADS.format(rounds=options.rounds, before=before, after=os.getloadavg()[0], table="\n".join(lines),
                       sentences="\n".join(pads_sentences(rates)), study=min(used), half=min(used) / 2)


FIT = """
## A fit

Five parameters of a rotor that rubs, fitted to three orbits of 64 samples (`bench/fit.yaml`). *Orbits* is the
number of computed orbits; *error* is the largest relative error of the five parameters against an independent program.
Times are processor time of one core.

{table}

- *whirl run*: the command, from case file to result file, with exact derivatives.
- *least_squares, orbits by whirl*: SciPy with derivatives by differences of two or three points; each orbit by whirl's
  Newton method in C, from the one before (`bench/fit_orbits.c`).
- *least_squares, fsolve, solve_ivp*: all by SciPy but the right-hand side, which is C.

Two evaluations of 180 orbits with derivatives by five parameters, transients included, take `whirl run` {many:.3g} s of
processor time. A single evaluation takes a quarter of that by the clock if two cores share it: {half:.2g} s (aim: 1 s).
"""


FIT_FOUND = (0.9000638546263, 0.9998612866208, 9.995958362655, 0.0500193183249, 0.2000210795785)


def fit_outcome(point):
    """Evaluations of all motions, and the largest error of a parameter."""
    found = point["fit"]
    errors = [abs(row[2] / value - 1) for row, value in zip(found["unknown"], FIT_FOUND)]
    return int(found["outcome"][2]), max(errors)


def measure_fit(options):
    python, library = scipy_python("fits"), options.build / "bench" / "libbench_fit_orbits.so"
    if not python:
        return ""
    with tempfile.TemporaryDirectory() as folder:
        call = [python, HERE / "fit_scipy.py", library, HERE / "fit.yaml"]
        subprocess.run([*call, "write", folder], check=True)
        spent = {}
        for case in ("fit", "many"):
            for _ in range(options.rounds):
                seconds = run_timed(options, f"{folder}/{case}.yaml", f"{folder}/{case}.h5")[1]
                spent[case] = min(seconds, spent.get(case, seconds))
        steps, error = fit_outcome(shown_points(options, f"{folder}/fit.h5")[0])
        lines = ["| program | orbits | s | of whirl's time | error |", "|---|---:|---:|---:|---:|",
                 f"| whirl run | {3 * (steps + 1)} | {short(spent['fit'])} | 1 | {error:.0e} |"]
        for orbits_by, differences, name in (("whirl", "2-point", "least_squares, orbits by whirl, two points"),
                                             ("whirl", "3-point", "least_squares, orbits by whirl, three points"),
                                             ("scipy", "2-point", "least_squares, fsolve, solve_ivp, two points")):
            best = None
            for _ in range(1 if orbits_by == "scipy" else options.rounds):
                row = subprocess.run(on_cores(options.core, [*map(str, call), orbits_by, differences]),
                                     capture_output=True, text=True, check=True).stdout.split()
                count, seconds, off = int(row[0]), float(row[1]), float(row[2])
                best = seconds if best is None else min(best, seconds)
            lines.append(f"| {name} | {count} | {short(best)} | {short(best / spent['fit'])} | {off:.0e} |")
    return FIT.format(table="\n".join(lines), many=spent["many"], half=spent["many"] / 4)


RUNUP = """
## A run-up

An unbalanced disc on a spring passes its critical speed in 40 s, 596 turns (`bench/runup.yaml`). Every program takes the
loosest tolerance, a power of ten, or the fewest steps, a power of two, at which the disc's place at the end is exact to
2e-6 of its radius there. *Error* is the distance from SciPy's result at rtol 1e-13, as a part of that radius. Processor
time of one core.

{table}

- *whirl run*: the command, from case file to result file, with 128 samples of each turn, their orders and the largest
  motion.
- *Newmark*: mean acceleration with steps of equal length, each repeated until it has settled, in C
  (`bench/runup_peers.c`).
- *SciPy*: `solve_ivp` (DOP853) over the same equations in C; *Octave*: `ode45`.

A study of 64 such runs, with torques from 2.5 to 4 N m, takes {one:.3g} s of processor time on one thread, and
{two:.3g} s by the clock on two.

The runs of a study share vector lanes. 64 run-ups of the paper's rotor (`bench/t1.yaml`) from 300 to 650 rad/s in 3.5 s
are {turns:.0f} turns and take {fan:.3g} s of processor time of one core, from case file to result file: {ups:.3g}
million steps a second, {steps:.0f} steps a turn at rtol 1e-8. At constant speed as many turns of the rotor by the same
method take {constant:.3g} s: {still:.3g} million steps a second, {constant_steps:.0f} steps a turn. So run-ups keep
{kept:.2f} of the steps (aim: 0.75).

The three-disc compressor (`cases/compressor.yaml`) runs from 1500 to 6000 rpm in 200 s of the machine, through the range
in which the journals of its squeeze film dampers come close to the walls. By `rodas5p` at `rtol` 1e-4 and `atol` 1e-5
this takes {compressor:.3g} s of processor time (aim: 20). Its largest motions differ by {off:.0e} of the largest from
those at 1e-6 and 1e-7, which take {fine:.3g} s. An orbit of the gear pair
(`cases/gear-rattle.yaml`) with its multipliers takes {orbit:.2g} ms, on a branch through contact loss and a fold.
"""

RUNUP_ERROR = 2e-6

# Steps of dop853 in a turn of the paper's rotor at rtol 1e-8, counted once: in the run-ups of measure_lanes, and at
# constant speed.
STEPS_RUNNING, STEPS_STILL = 63.2, 56.8


def study_of(case, text):
    """The machine of a case with another study."""
    return case.read_text().split("\nstudy:")[0] + f"\nstudy:\n{text}"


def runup_by_whirl(options, folder, rtol):
    """Seconds of the run of runup.yaml, and where the disc is at its end."""
    case, result = pathlib.Path(folder, "runup.yaml"), pathlib.Path(folder, "runup.h5")
    case.write_text((HERE / "runup.yaml").read_text().replace("40 s}", f"40 s, rtol: {rtol:g}}}"))
    seconds = run_timed(options, case, result)[1]
    (point,) = shown_points(options, result, "--json=full")
    return seconds, [1e-3 * value for value in point["runup"]["stations"]["disc"]["place"]]


def runup_by_peer(options, command):
    out = subprocess.run(on_cores(options.core, [str(word) for word in command]), capture_output=True, text=True,
                         check=True).stdout.split()
    return float(out[0]), [float(value) for value in out[1:3]]


def measure_fan(options, folder):
    case, result = pathlib.Path(folder, "fan.yaml"), pathlib.Path(folder, "fan.h5")
    case.write_text(study_of(HERE / "runup.yaml", "  runup: {parameter: torque, from: 2.5 N.m, to: 4 N.m, points: 64, "
                                                  "duration: 40 s}\n"))
    return [min(run_timed(options, case, result, threads)[which] for _ in range(options.study_rounds))
            for threads, which in ((1, 1), (2, 0))]


def measure_lanes(options, folder):
    """Turns of 64 run-ups of the paper's rotor, and seconds of processor time of them and of as many turns at constant
    speed."""
    case, result = pathlib.Path(folder, "lanes.yaml"), pathlib.Path(folder, "lanes.h5")
    axis = "{parameter: r_k, from: 1.0, to: 0.7, points: 64"
    start = "  initial:\n    disc:    {y: -0.1}\n    journal: {y: -0.1}\n"
    runs = (f"  runup: {axis}, rate: 100 rad/s2, speed_from: 300 rad/s, speed_to: 650 rad/s, sensitivity: no}}\n",
            f"  sweep: {axis}, start: state}}\n  integrate: {{method: dop853, rtol: 1e-8, atol: 1e-11, "
            "steps_per_revolution: 128, transient: 0, record: 265, settle: no}\n  analyze: [poincare, spectrum, orbit]\n")
    seconds = []
    for text in runs:
        case.write_text(study_of(HERE / "t1.yaml", text + start))
        seconds.append(min(run_timed(options, case, result)[1] for _ in range(options.study_rounds)))
        if len(seconds) == 1:
            turns = sum(point["runup"]["end_turns"] for point in shown_points(options, result, "--json=full"))
    return turns, seconds[0], seconds[1] * turns / (64 * 265)


def measure_compressor(options, folder):
    """Seconds of processor time for 200 s of the machine at usual and at fine tolerances, and the largest difference of
    its peaks as a part of the largest."""
    seconds, peaks = [], []
    case, result = pathlib.Path(folder, "compressor.yaml"), pathlib.Path(folder, "compressor.h5")
    for rtol in (1e-4, 1e-6):
        case.write_text(study_of(HERE.parent / "cases" / "compressor.yaml", "  runup: {rate: 2.36 rad/s2, "
                                 f"speed_from: 1500 rpm, speed_to: 6000 rpm, method: rodas5p, rtol: {rtol:g}, "
                                 f"atol: {rtol / 10.0:g}}}\n"))
        seconds.append(run_timed(options, case, result)[1])
        (point,) = shown_points(options, result, "--json=full")
        peaks.append([station["peak"] for station in point["runup"]["stations"].values()])
    return seconds[0], seconds[1], max(abs(a - b) for a, b in zip(*peaks)) / max(peaks[1])


def measure_gears(options, folder):
    """Milliseconds of processor time for an orbit of a branch."""
    case, result = pathlib.Path(folder, "gears.yaml"), pathlib.Path(folder, "gears.h5")
    case.write_text(study_of(HERE.parent / "cases" / "gear-rattle.yaml", "  branch: {parameter: W, from: 0.6, to: 1.2, "
                             "step: 0.002, switches: 0}\n  initial: {wheel: {x: 1.1}}\n"))
    seconds = min(run_timed(options, case, result)[1] for _ in range(options.study_rounds))
    return 1e3 * seconds / len(shown_points(options, result))


def measure_runups(options):
    python, library = scipy_python("run-ups"), options.build / "bench" / "libbench_runup_peers.so"
    if not python:
        return ""
    with tempfile.TemporaryDirectory() as folder:
        call = [python, HERE / "runup_scipy.py", library]
        tolerances, steps = [10.0 ** -n for n in range(3, 13)], [2 ** n for n in range(16, 28)]
        runs = {"whirl run": [functools.partial(runup_by_whirl, options, folder, rtol) for rtol in tolerances],
                "Newmark": [functools.partial(runup_by_peer, options, [*call, "newmark", count]) for count in steps],
                "SciPy": [functools.partial(runup_by_peer, options, [*call, "scipy", rtol]) for rtol in tolerances]}
        if shutil.which("octave-cli"):
            script = ["octave-cli", "--quiet", "--no-init-file", HERE / "runup_octave.m"]
            runs["Octave"] = [functools.partial(runup_by_peer, options, [*script, rtol]) for rtol in tolerances[3:]]
        _, truth = runup_by_peer(options, [*call, "scipy", 1e-13])
        best = {}
        for name, tries in runs.items():
            for run in tries:
                seconds, place = run()
                error = math.dist(place, truth) / math.hypot(*truth)
                if error < RUNUP_ERROR:
                    again = options.rounds - 1 if seconds < 5.0 else 0
                    best[name] = min([seconds, *(run()[0] for _ in range(again))]), error
                    break
        own = best["whirl run"][0]
        lines = ["| program | s | of whirl's time | error |", "|---|---:|---:|---:|"]
        lines += [f"| {name} | {short(seconds)} | {short(seconds / own)} | {error:.0e} |"
                  for name, (seconds, error) in best.items()]
        one, two = measure_fan(options, folder)
        turns, fan, constant = measure_lanes(options, folder)
        compressor, fine, off = measure_compressor(options, folder)
        ups, still = 1e-6 * STEPS_RUNNING * turns / fan, 1e-6 * STEPS_STILL * turns / constant
        return RUNUP.format(table="\n".join(lines), one=one, two=two, turns=turns, fan=fan, constant=constant, ups=ups,
                            still=still, steps=STEPS_RUNNING, constant_steps=STEPS_STILL, kept=ups / still,
                            compressor=compressor, fine=fine, off=off, orbit=measure_gears(options, folder))


RECORDS = """
## Data sets

Records of the paper's rotor (`bench/records.yaml`): 100 revolutions to settle, 100 of 64 samples from four sensors,
verdicts, float32 in HDF5, written as they come; processor time of two threads.

| records | processor, s | of a record, ms | file, MB | memory, MB |
|---:|---:|---:|---:|---:|
{table}

Each further record takes {each:.3g} ms, and 100,000 records {minutes:.3g} minutes of two idle cores (aim: 10). A record
of a run-up (`cases/run-up-records.yaml`, 8.2 s through the critical speed) takes {runs:.3g} ms.
"""


def run_records(options, case, folder, machines):
    """Runs a data set of so many machines by two threads. Returns the number of records, the seconds of the processor,
    the bytes of the file, and those of memory."""
    result = pathlib.Path(folder, "records.h5")
    command = [str(options.build / "whirl"), "run", str(case), "-q", "--threads=2", "--force", "-o", str(result), "--set",
               f"dataset.machines={machines}"]
    child = subprocess.Popen(command)
    _, status, used = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    assert child.returncode == 0, command
    with open(result.with_name("records-records.csv"), "rb") as table:
        count = sum(1 for _ in table) - 1
    return count, used.ru_utime + used.ru_stime, result.stat().st_size, 1024 * used.ru_maxrss


def measure_records(options):
    lines, spent = [], []
    with tempfile.TemporaryDirectory() as folder:
        for machines in (500, 2500):
            runs = [run_records(options, HERE / "records.yaml", folder, machines) for _ in range(options.study_rounds)]
            count, seconds, size, memory = min(runs, key=lambda run: run[1])
            lines.append(f"| {count:,} | {short(seconds)} | {short(1e3 * seconds / count)} | {size / 1e6:.0f} | "
                         f"{memory / 1e6:.0f} |")
            spent.append((count, seconds))
        (few, first), (many, last) = spent
        count, seconds, _, _ = min((run_records(options, HERE.parent / "cases" / "run-up-records.yaml", folder, 40)
                                    for _ in range(options.study_rounds)), key=lambda run: run[1])
    each = (last - first) / (many - few)
    return RECORDS.format(table="\n".join(lines), each=1e3 * each, minutes=1e5 * each / 2.0 / 60.0,
                          runs=1e3 * seconds / count)


def wrapped(page):
    """The page with paragraphs and items in lines of at most 120 columns; tables, headings and pictures stay."""
    def filled(item):
        return textwrap.fill(" ".join(item.split()), 120, break_long_words=False, break_on_hyphens=False,
                             subsequent_indent="  " if item.startswith("- ") else "")

    blocks = [block if block.startswith(("|", "#", "!")) else "\n".join(map(filled, re.split(r"\n(?=- )", block)))
              for block in page.strip().split("\n\n")]
    return "\n\n".join(blocks) + "\n"


def picture(best, path):
    """Horizontal bars by gnuplot, fastest on top."""
    rows = sorted((rate, name) for name, rate in best.items() if name.split()[-1] not in CHAINS)
    data = "\n".join(f'"{name}" {rate:.6g} {i} {1 if name.startswith("whirl") else 2} "{short(rate)}"'
                     for i, (rate, name) in enumerate(rows))
    script = f"""
set terminal pngcairo size 1000,{120 + 26 * len(rows)} font "sans,11"
set output "{path}"
$rows << EOD
{data}
EOD
set logscale x
set format x "10^{{%T}}"
set xrange [1e3:3e8]
set yrange [-0.7:{len(rows) - 0.3}]
set xlabel "steps of RK4 a second, one core"
set title "The rotor of the 2015 paper, 1024 steps per revolution"
set grid x
set style fill solid
unset key
plot $rows using (1e3):3:(1e3):2:($3-0.35):($3+0.35):($4==1 ? 0x2b6cb0 : 0xa0aec0):ytic(1) \\
     with boxxyerror lc rgb variable, \\
     $rows using 2:3:(" ".strcol(5)) with labels left font "sans,9"
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


def arguments():
    parser = argparse.ArgumentParser(description="whirl's kernels and their peers, side by side")
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--docs", type=pathlib.Path, help="write benchmarks.md and images/benchmarks.png there")
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--study-rounds", type=int, default=2)
    parser.add_argument("--seconds", type=float, default=0.3, help="of every measurement")
    parser.add_argument("--core", default=str(max(os.sched_getaffinity(0))))
    parser.add_argument("--no-study", action="store_true", help="leave out the whole diagram")
    parser.add_argument("--adaptive", action="store_true", help="measure the adaptive methods only, and print")
    parser.add_argument("--overhung", action="store_true", help="measure the rotor of finite elements only, and print")
    parser.add_argument("--branches", action="store_true", help="measure continuation of orbits only, and print")
    parser.add_argument("--elements", action="store_true", help="measure kernels of elements only, and print")
    parser.add_argument("--pads", action="store_true", help="measure bearings of pads only, and print")
    parser.add_argument("--fit", action="store_true", help="measure a fit only, and print")
    parser.add_argument("--runup", action="store_true", help="measure run-ups only, and print")
    parser.add_argument("--records", action="store_true", help="measure data sets only, and print")
    parser.add_argument("--map", action="store_true", help="measure a map only, and print")
    return parser.parse_args()


def main():
    options = arguments()
    options.build = options.build.resolve()
    say(f"{computer()}; {'; '.join(compilers(options.build))}")
    if options.adaptive:
        say(measure_adaptive(options))
        return
    if options.branches:
        say(wrapped(measure_branches(options)))
        return
    if options.overhung:
        say(wrapped(measure_overhung(options)))
        return
    if options.elements:
        say(wrapped(measure_elements(options)))
        return
    if options.pads:
        say(wrapped(measure_pads(options)))
        return
    if options.map:
        say(wrapped(measure_map(options)))
        return
    if options.fit:
        say(wrapped(measure_fit(options)))
        return
    if options.runup:
        say(wrapped(measure_runups(options)))
        return
    if options.records:
        say(wrapped(measure_records(options)))
        return
    before = os.getloadavg()[0]
    best = measure(programs(options.build), options)
    studies = {} if options.no_study else measure_studies(options)
    page = TEXT.format(rounds=options.rounds, seconds=options.seconds, computer=computer(), versions=versions(),
                       compilers=", ".join(compilers(options.build)), before=before, after=os.getloadavg()[0],
                       ratios="\n".join(key_ratios(best)), speed="\n".join(speed_table(best)),
                       stations="\n".join(station_table(best)))
    page += measure_adaptive(options) + measure_overhung(options) + measure_branches(options) + measure_map(options)
    page += measure_elements(options)
    page += measure_pads(options)
    page += measure_fit(options)
    page += measure_runups(options)
    page += measure_records(options)
    if studies:
        page += STUDY.format(rounds=options.study_rounds, study="\n".join(study_table(best, studies)))
    page = wrapped(page)
    say(page)
    if options.docs:
        (options.docs / "images").mkdir(parents=True, exist_ok=True)
        (options.docs / "benchmarks.md").write_text(page)
        if shutil.which("gnuplot"):
            picture(best, options.docs / "images" / "benchmarks.png")
        else:
            say("left out: the picture (gnuplot is not installed)")


main()
