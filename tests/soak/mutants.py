#!/usr/bin/python3
"""Mutants of cases, checked and run:  mutants.py WHIRL COUNT CASE.yaml...

Of each case the COUNT mildest mutants: one number of it, in the order of the file and by turns, times a factor, the nearest
to 1 first. `whirl check` and a short `whirl run` must end by themselves, in time and with an exit status of their own; what is
refused is refused with a sentence. Meant for a program with sanitizers, whose reports fail here.
"""

import itertools
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

FACTORS = [1.001, 1.1, 0.9, 1.5, 2, 0.5, 10, 0.1, 1e3, 1e-3, -1, 0, 1e12, 1e-12]
NUMBER = re.compile(r"(?<![\w.#-])-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?(?![\w.])")
# Fewer revolutions: the machine is mutated, not how long it is watched.
SHORT = ["--set", "integrate.transient=2", "--set", "integrate.record=3", "--max-time=5 s", "--threads=1", "-q", "--force"]
SECONDS = 120
REPORTS = ("runtime error", "Sanitizer", "(null)", " nan ", "assertion")


def places(text):
    """Numbers of a case but for its first key, comments and words in quotes."""
    found = []
    at = 0
    for line in text.splitlines(keepends=True):
        code = line.split(" #")[0]
        if not line.startswith(("whirl:", "title:", "#")):
            found += [(at + number.start(), at + number.end()) for number in NUMBER.finditer(code)]
        at += len(line)
    return found


def mutants(text):
    """The change, in words, and the mutated text."""
    numbers = places(text)
    for factor, (begin, end) in itertools.product(FACTORS, numbers):
        old = text[begin:end]
        value = float(old) * factor
        new = str(round(value)) if "." not in old and value == round(value) else f"{value:.12g}"
        if new != old:
            yield f"line {text.count(chr(10), 0, begin) + 1}: {old} becomes {new}", text[:begin] + new + text[end:]


def complaint(command, folder):
    """The fault in how a command ends, or nothing."""
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, errors="replace", timeout=SECONDS)
    except subprocess.TimeoutExpired:
        return f"does not end in {SECONDS} s", 1
    said = done.stderr + done.stdout
    for report in REPORTS:
        if report in said:
            return f"says '{report}': {said[:2000]}", 1
    if done.returncode not in (0, 1, 2, 3):
        return f"exit status {done.returncode}: {said[-2000:]}", 1
    if done.returncode in (1, 2) and "whirl: " not in done.stderr and ".yaml:" not in done.stderr:
        return f"exit status {done.returncode} without a sentence: {said[-500:]}", 1
    return None, done.returncode


def try_mutant(whirl, folder, name):
    wrong, status = complaint([whirl, "check", name], folder)
    if wrong or status:
        return wrong and f"check {wrong}"
    wrong, _ = complaint([whirl, "run", name, *SHORT, "-o", "r.h5"], folder)
    return wrong and f"run {wrong}"


def main():
    whirl, count = str(Path(sys.argv[1]).resolve()), int(sys.argv[2])
    failures = tried = 0
    os.environ.setdefault("UBSAN_OPTIONS", "print_stacktrace=1")
    for path in map(Path, sys.argv[3:]):
        text = path.read_text()
        # From all over the file: every so many of those of one factor.
        every = max(1, len(places(text)) // 10)
        with tempfile.TemporaryDirectory() as folder:
            for what, mutant in itertools.islice(mutants(text), 0, every * count, every):
                (Path(folder) / path.name).write_text(mutant)
                wrong = try_mutant(whirl, folder, path.name)
                tried += 1
                if wrong:
                    failures += 1
                    print(f"FAILED: {path.name}, {what}: {wrong}", flush=True)
    print(f"{tried} mutants, {failures} failures")
    sys.exit(failures > 0)


if __name__ == "__main__":
    main()
