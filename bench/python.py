#!/usr/bin/python3
"""The cost of the Python package compared with the command, and the time of its import.

    bench/python.py BUILD [--rounds N]

Prints a table: import, the paper's sweep of 512 points by both (processor time, alternating, the best round of each),
and a result of a million points opened.
"""

import argparse
import os
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).parents[1]
MILLION = """
whirl: 1
parameters: {omega: 1.5 rad/s}
rotor:
  speed: = omega
  length_scale: 1 m
  stations:
    disc: {mass: 1 kg, damping: 0.2 N.s/m, eccentricity: 0.9 m}
  elements:
    - shaft: {between: [disc, ground], k1: 1 N/m}
study:
  sweep: {parameter: omega, from: 1.0, to: 4.0, points: 1000000, start: rest}
  integrate: {method: rk4, steps_per_revolution: 64, transient: 1, record: 8}
  analyze: [poincare, orbit]
"""
OPEN = """
import sys, time
begun = time.perf_counter()
import whirl
table = whirl.open(sys.argv[1])["sweep"]
opened = time.perf_counter()
radius = table["orbit/max_radius"]
print(opened - begun, time.perf_counter() - opened, radius.shape[0])
"""


def spent(words, environment):
    """Processor time and seconds of a program."""
    before, begun = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    subprocess.run(words, env=environment, check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, time.perf_counter() - begun


def best(rounds, programs, environment):
    """The best round of each program, which take turns."""
    programs = list(programs)
    found = [(float("inf"), float("inf"))] * len(programs)
    for _ in range(rounds):
        for i, words in enumerate(programs):
            found[i] = tuple(map(min, found[i], spent(words, environment)))
    return found


def python(code, *arguments):
    return [sys.executable, "-c", code, *map(str, arguments)]


def import_times(rounds, environment):
    programs = ("pass", "import whirl", "import whirl; whirl.library_version(); whirl.Case; whirl.open; whirl.run")
    nothing, bare, ready = (times[1] for times in best(rounds, map(python, programs), environment))
    print(f"import whirl: {bare - nothing:.3f} s; with the library, NumPy and h5py in use: {ready - nothing:.3f} s")


def sweep_overhead(rounds, command, folder, environment):
    case = (ROOT / "cases/paper.yaml").read_text().split("\n")
    (folder / "sweep.yaml").write_text("\n".join(line for line in case if not line.startswith("  detail:")))
    run = "import sys, whirl; whirl.run(sys.argv[1], threads=1, progress=False).save(sys.argv[2])"
    programs = (
        [command, "run", folder / "sweep.yaml", "-o", folder / "a.h5", "--force", "--quiet", "--threads=1"],
        python(run, folder / "sweep.yaml", folder / "b.h5"),
    )
    own, theirs = (times[0] for times in best(rounds, programs, environment))
    share = 100.0 * (theirs / own - 1.0)
    print(f"512 points, processor time: command {own:.2f} s, Python {theirs:.2f} s: {share:+.2f} %")


def opening_times(rounds, command, folder, environment):
    (folder / "million.yaml").write_text(MILLION)
    file = folder / "million.h5"
    subprocess.run([command, "run", folder / "million.yaml", "-o", file, "--quiet"], check=True)
    answers = [subprocess.check_output(python(OPEN, file), env=environment, text=True).split() for _ in range(rounds)]
    opened, read = (min(float(words[i]) for words in answers) for i in (0, 1))
    size = file.stat().st_size / 1e9
    print(f"a million points ({size:.2f} GB): import and open {opened:.3f} s, a number of each read in {read:.3f} s")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--rounds", type=int, default=3)
    options = parser.parse_args()
    command = options.build.resolve() / "whirl"
    with tempfile.TemporaryDirectory() as folder:
        environment = {
            **os.environ,
            "WHIRL_LIBRARY": str(command.with_name("libwhirl.so.1")),
            "PYTHONPATH": str(ROOT / "bindings/python"),
            "PYTHONPYCACHEPREFIX": f"{folder}/compiled",  # kept, as those of an installed package are
        }
        environment.pop("PYTHONDONTWRITEBYTECODE", None)
        import_times(5 * options.rounds, environment)
        sweep_overhead(options.rounds, command, pathlib.Path(folder), environment)
        opening_times(options.rounds, command, pathlib.Path(folder), environment)


if __name__ == "__main__":
    main()
