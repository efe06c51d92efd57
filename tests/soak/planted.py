#!/usr/bin/python3
"""Faults planted one by one, and the tests that find them:  planted.py CLONE [LAYER...]

CLONE is a clean clone in which `make ci` has passed. A fault, one line in one layer, is written there, what depends on it is
built, and the phase of `make ci` that should see it runs until something fails: tests that run every time, whatever quarter
it is, tests under the sanitizers, or studies under the thread sanitizer. Then the line is put back. The status is 1 if a fault
stays unseen. Everything takes about half an hour on two cores.
"""

import re
import subprocess
import sys
import time
from pathlib import Path

TESTS, SANITIZED, THREADS = "tests", "sanitized tests", "studies of threads"

# Layer, what is wrong, file, line as it is, line with the fault, phase.
FAULTS = [
    ("rotor", "friction of a rub along y has the other sign", "src/rotor/elements/contacts/rub_kernel.h",
     "a[j] = v_fnma(p.push, v_fma(f, p.x, p.y), a[j]);", "a[j] = v_fnma(p.push, v_fnma(f, p.x, p.y), a[j]);", TESTS),
    ("integrate", "a digit of dop853", "src/integrate/methods/dop853_tableau.h",
     "{0.02958758547680685, 0, 0.08876275643042054}", "{0.02958758547680685, 0, 0.08876275642042054}", TESTS),
    ("linear", "whirl has the other direction", "src/linear/modes.c",
     "(x[1] * y[0] - x[0] * y[1])", "(x[0] * y[1] - x[1] * y[0])", TESTS),
    ("orbit", "period doublings are looked for where folds are", "src/orbit/branch/vanishing.c",
     "return product_about(orbit, -1.0);", "return product_about(orbit, 1.0);", TESTS),
    ("analyze", "locks are lost that returns approach slowly", "src/analyze/sections/locks.c",
     "const double whole_turns = 3.0;", "const double whole_turns = 0.5;", TESTS),
    ("study, threads", "points are taken without their lock", "src/study/run/passes.c",
     "#pragma omp critical(whirl_points)\n    {\n        const size_t left", "    {\n        const size_t left", THREADS),
    ("study, units", "exponents by the second lack a factor of two pi", "src/study/result/units.c",
     'return (whirl_unit){"1/s", clock / two_pi};', 'return (whirl_unit){"1/s", clock};', TESTS),
    ("case", "centipoises are taken for Pa s", "src/case/values/quantity.c",
     'add_unit("cP", "mPa.s");', 'add_unit("cP", "Pa.s");', TESTS),
    ("store", "damaged points of a journal are taken", "src/store/journal/journal.c",
     "frame_checksum(frame + length - JOURNAL_TAIL) == crc32c(0, frame, length - JOURNAL_TAIL);",
     "frame_checksum(frame + length - JOURNAL_TAIL) != 0;", TESTS),
    ("report", "sections are drawn in other units than the axis says", "src/report/figures/figure_bifurcation.c",
     "length * section.at[4 * dots[k].row + column]", "section.at[4 * dots[k].row + column]", TESTS),
    ("import", "the mean of unequal masses of a seal is their sum", "src/import/ross_bearing.c",
     "mean[i] = 0.5 * (one + other);", "mean[i] = one + other;", TESTS),
    ("command", "a result is not freed", "cli/export.c",
     "whirl_result_export_csv(result, arguments->csv);\n    whirl_result_free(result);",
     "whirl_result_export_csv(result, arguments->csv);", SANITIZED),
    ("explorer", "orbits are drawn upside down", "explorer/src/view/orbit.ts",
     "y: (value) => height / 2 - (value - view.y) * scale,", "y: (value) => height / 2 + (value - view.y) * scale,", TESTS),
    ("Python", "numbers in SI lack the factor of their own speed", "bindings/python/whirl/table.py",
     "if np.isnan(factor):", "if False:", TESTS),
]  # fmt: skip

CTEST = "ctest --test-dir {tree} -j 2 --stop-on-failure --no-tests=error -LE quarter- "
STEPS = {
    TESTS: [
        "cmake --build build --parallel 2",
        CTEST.format(tree="build") + "-L 'unit|cli|python'",
        CTEST.format(tree="build"),
    ],
    SANITIZED: [
        "cmake --build build/sanitize --parallel 2",
        CTEST.format(tree="build/sanitize") + "-L 'unit|cli'",
    ],
    THREADS: [
        "cmake --build build/threads --parallel 2 --target whirl",
        "scripts/thread-check.sh build/threads",
    ],
}


def finder(clone, phase, explorer):
    """The first test that fails, or nothing."""
    steps = list(STEPS[phase])
    if explorer:
        steps[1:2] = ["scripts/explorer.sh build/explorer", CTEST.format(tree="build") + "-L 'browser|explorer'"]
    for step in steps:
        done = subprocess.run(step, shell=True, cwd=clone, capture_output=True, text=True, errors="replace")
        if done.returncode != 0:
            failed = re.findall(r"^\s*\d+ - (\S+) \(", done.stdout, re.M)
            if not failed and "thread-check" not in step:
                sys.exit(f"'{step}' failed, and no test of it:\n{(done.stdout + done.stderr)[-2000:]}")
            return ", ".join(failed) or "thread-check"
    return None


def main(clone, layers):
    """Plants the requested faults, all by default."""
    unseen = 0
    known = {fault[0] for fault in FAULTS}
    if set(layers) - known:
        sys.exit(f"there is no layer {', '.join(set(layers) - known)}, expected some of: {', '.join(sorted(known))}")
    for layer, what, name, good, bad, phase in FAULTS:
        if layers and layer not in layers:
            continue
        path = Path(clone) / name
        text = path.read_text(encoding="utf-8")
        if text.count(good) != 1:
            sys.exit(f"{name} has no longer one line of this kind, mend this program: {good}")
        begun = time.monotonic()
        try:
            path.write_text(text.replace(good, bad), encoding="utf-8")
            found = finder(clone, phase, name.startswith("explorer"))
        finally:
            path.write_text(text, encoding="utf-8")
        unseen += found is None
        seconds = time.monotonic() - begun
        print(f"{layer}: {what}: {'found by ' + found if found else 'NOT FOUND'}, after {seconds:.0f} s", flush=True)
    print(f"{unseen} unseen")
    return int(unseen > 0)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], sys.argv[2:]))
