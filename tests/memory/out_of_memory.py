#!/usr/bin/python3
"""The command when allocations fail:  out_of_memory.py WHIRL FAILING_MALLOC GOOD.yaml UNITS.xml SAMPLES [COMMAND...]

Every command below, or those named, is run again and again, and each time another one of its allocations fails, alone or with all that follow:
SAMPLES allocations of a command, spread over all of them; 0: every one. Whatever fails, the exit status is 0 or 1, what ends with 1
says so in a sentence, what ends with 0 has done as much as ever, and nothing is left half written.
"""
import collections
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

whirl, library, good, units = map(os.path.realpath, sys.argv[1:5])
samples = int(sys.argv[5])
COMMANDS = {
    "check": ["check", "case.yaml"],
    "run": ["run", "case.yaml", "--threads", "1", "-q", "-o", "made.h5"],
    "json": ["run", "case.yaml", "--threads", "1", "-q", "--json"],
    "import": ["import", "supports.toml", "-o", "imported.yaml"],
    "import JSON": ["import", "layers.json", "-o", "imported.yaml"],
    "show": ["show", "starts.h5"],
    "table": ["table", "modes.h5", "-o", "made.txt"],
    "table JSON": ["table", "modes.h5", "--format", "json"],
    "modes": ["run", "modes.yaml", "--threads", "1", "-q", "-o", "made.h5"],
    "pads": ["run", "pads.yaml", "--threads", "1", "-q", "--json"],
    "pads at rest": ["run", "rest.yaml", "--threads", "1", "-q", "--json"],
    "export": ["export", "there.h5", "--csv", "tables"],
    "export MAT": ["export", "there.h5", "--mat", "made.mat"],
    "report": ["report", "there.h5", "-o", "report", "--gnuplot", "true", "--claims", "claims.yaml"],
}
PADS = """whirl: 1
parameters: {omega: 3000 rpm}
rotor:
  speed: = omega
  length_scale: 0.1 mm
  stations:
    j: {mass: 40 kg, eccentricity: 10 um}
  elements:
    - pad_bearing: {at: j, shape: elliptical, preload: 0.5, clearance: 0.1 mm, viscosity: 20 mPa.s, radius: 45 mm,
                    length: 20 mm, cavitation: gumbel}
    - gravity
study:
"""
MOTIONS = """  sweep: {parameter: omega, from: 4000 rpm, to: 6000 rpm, points: 2}
  integrate: {transient: 3, record: 3}
"""
REST = """  modes: {parameter: omega, from: 2000 rpm, to: 4000 rpm, points: 3}
"""
CLAIMS = """claims: 1
parameter: omega
station: disc
items:
  - {where: text, from: 1, to: 4, says: it is periodic, regime: P-1}
"""
QUIET = {**os.environ, "UDUNITS2_XML_PATH": units}


def execute(arguments, folder, **environment):
    return subprocess.run([whirl, *arguments], cwd=folder, env={**QUIET, **environment}, capture_output=True,
                          stdin=subprocess.DEVNULL, timeout=120, check=False)


def half_written(folder):
    return [path.name for path in folder.rglob("*") if ".tmp-" in path.name or path.name.endswith(".part")]


def files(folder):
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file())


def attempt(name, template, whole, call, all_later):
    """The exit status, and the fault found ("": none)."""
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place) / "work"
        shutil.copytree(template, folder)
        done = execute(COMMANDS[name], folder, LD_PRELOAD=library, WHIRL_FAIL_AT=str(call), WHIRL_FAIL_ALL=str(all_later))
        said = done.stderr.decode(errors="replace")
        if done.returncode not in (0, 1):
            return done.returncode, f"exit status {done.returncode}: {said[:300]}"
        if done.returncode == 1 and not any(line.startswith("whirl") for line in said.splitlines()):
            return 1, f"no sentence: {said[:300]}"
        if half_written(folder):
            return done.returncode, f"half written: {half_written(folder)}"
        if done.returncode == 0 and (done.stdout, files(folder)) != whole:
            return 0, "done, but not the same"
        for path in folder.rglob("*.h5"):
            shown = execute(["show", path.name], folder)
            if shown.returncode != 0:
                return done.returncode, f"{path.name} cannot be read: {shown.stderr.decode()}"
        # A journal without points does not prevent the next run; one with points is continued.
        if done.returncode == 1 and "made.h5" in COMMANDS[name]:
            again = execute(COMMANDS[name], folder)
            if again.returncode != 0:
                again = execute([word for word in COMMANDS[name] if word != "-q"] + ["--resume"], folder)
                if again.returncode != 0 or not re.search("[1-9][0-9]* of", again.stderr.decode()):
                    return 1, f"in the way of the next run: {said[:200]} {again.stderr.decode()[:300]}"
        return done.returncode, ""


def calls_of(count, most):
    step = max(1, count // most) if most else 1
    # Vary the place within calls that repeat.
    return [1 + (call + 7 * index) % count for index, call in enumerate(range(0, count, step))]


def main():
    failures = 0
    with tempfile.TemporaryDirectory() as place, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        template = pathlib.Path(place) / "template"
        template.mkdir()
        (template / "case.yaml").write_text(pathlib.Path(good).read_text().replace("points: 5", "points: 2"))
        (template / "claims.yaml").write_text(CLAIMS)
        (template / "pads.yaml").write_text(PADS + MOTIONS)
        (template / "rest.yaml").write_text(PADS + REST)
        QUIET["XDG_CACHE_HOME"] = place  # tables of films are read where they are not what fails
        for rotor in ("supports.toml", "layers.json"):
            shutil.copy(pathlib.Path(__file__).parent.parent / "rotors" / rotor, template)
        assert execute(["run", "case.yaml", "-q", "-o", "there.h5"], template).returncode == 0
        shutil.copy(pathlib.Path(good).parent / "modes.yaml", template)
        assert execute(["run", "modes.yaml", "-q", "-o", "modes.h5"], template).returncode == 0
        starts = "study:\n  starts: {count: 3, within: {disc: {x: [-1, 1]}}}"
        (template / "starts.yaml").write_text((template / "case.yaml").read_text().replace("study:", starts))
        assert execute(["run", "starts.yaml", "-q", "-o", "starts.h5"], template).returncode == 0
        for name in sys.argv[6:] or COMMANDS:
            arguments = COMMANDS[name]
            folder = pathlib.Path(place) / name
            shutil.copytree(template, folder)
            number = pathlib.Path(place) / "count"
            done = execute(arguments, folder, LD_PRELOAD=library, WHIRL_COUNT=str(number))
            assert done.returncode == 0, done.stderr
            whole = done.stdout, files(folder)
            count = int(number.read_text())
            jobs = [(call, later) for call in calls_of(count, samples) for later in (0, 1)]
            outcomes = collections.Counter()
            for job, (status, wrong) in zip(jobs, pool.map(lambda job: attempt(name, template, whole, *job), jobs)):
                outcomes[status] += 1
                if wrong:
                    failures += 1
                    print(f"FAILED: {name}, allocation {job[0]}{' and all later ones' if job[1] else ''}: {wrong}")
            print(f"{name}: {len(jobs)} runs, of {count} allocations each:", dict(sorted(outcomes.items())), flush=True)
    return failures > 0


sys.exit(main())
