#!/usr/bin/python3
"""Compares all numbers that two builds of whirl give of the shipped cases:

    scripts/compare-results.py OLD/whirl NEW/whirl [CASE.yaml ...] [--points N] [--keep FOLDER]

Each case runs with at most N points a parameter (5) and short records, by both programs, each in a folder of its own.
It compares the summary (`show`), the JSON of the result (`show --json`), statements and sheets (`table`, where both
have it), and the pages of the report. Texts are compared line by line without their numbers, and numbers to 1e-9. It
writes a line for every difference, with the file, the words before it and both numbers. A sheet, key or line that only
one program gives is a difference, too. The exit status is 1 if there is any difference.
"""
import argparse
import html
import json
import math
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
NUMBER = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
# What differs between builds, or from run to run, without being a number of the case.
NOISE = re.compile(
    r"wall_time|cpu|seconds|version|commit|compiler|host|threads|build|checksum|isa\b|facts/|"
    r"^(started|finished|revision|sources|command line) ",
    re.IGNORECASE,
)


def shortened(text, points):
    """A case of few points with short records, of the same machine."""
    text = re.sub(r"points: (\d+)", lambda m: f"points: {min(int(m[1]), points)}", text)
    text = re.sub(r"transient: (\d+)", lambda m: f"transient: {min(int(m[1]), 20)}", text)
    text = re.sub(r"(record|waveform): (\d+)", lambda m: f"{m[1]}: {min(int(m[2]), 16)}", text)
    text = re.sub(r"watch: (\d+)", lambda m: f"watch: {min(int(m[1]), 36)}", text)
    return re.sub(r"(starts: \{count: )(\d+)", lambda m: f"{m[1]}{min(int(m[2]), 2)}", text)


def plain(page):
    """The lines of a page as its reader sees them: rows of tables, items, paragraphs."""
    page = re.sub(r"<(style|script|svg|pre)\b.*?</\1>", "", page, flags=re.S)
    page = re.sub(r"</(tr|p|li|h\d|figcaption|dd)>", "\n", page)
    return html.unescape(re.sub(r"<[^>]+>", " ", page))


def flat(value, path=""):
    """Paths and values of a JSON document; cells of sheets by the keys of their columns."""
    if isinstance(value, dict) and {"columns", "rows"} <= value.keys():
        keys = [column["key"] for column in value["columns"]]
        value = {**value, "columns": dict(zip(keys, value["columns"]))}
        for part in ("rows", "shown"):
            value[part] = [dict(zip(keys, row)) for row in value.get(part, [])]
    if isinstance(value, dict):
        for key, one in value.items():
            yield from flat(one, f"{path}/{key}")
    elif isinstance(value, list):
        times = {}
        for index, one in enumerate(value):
            name = str(index)
            if isinstance(one, dict) and "table" in one:  # named, so that added ones shift no others
                name = f"{one['table']}:{one.get('name') or one.get('what')}"
                times[name] = times.get(name, -1) + 1
                name += f":{times[name]}"
            yield from flat(one, f"{path}/{name}")
    else:
        yield path, value


def outputs(program, case, folder):
    """Texts by name of all that a program gives of a case; `json` as a dict."""
    env = {**os.environ, "PATH": f"{program.parent}:{os.environ['PATH']}"}

    def call(*words):
        done = subprocess.run([program, *map(str, words)], cwd=folder, env=env, capture_output=True, text=True)
        return done.returncode, done.stdout, done.stderr

    status, _, complaint = call("run", case.name, "-q", "--force", "-o", "r.h5")
    found = {"run": f"status {status}\n" + ("" if status == 0 else complaint)}
    if not (folder / "r.h5").exists():
        return found
    found["show"] = call("show", "r.h5")[1]
    found["json"] = call("show", "r.h5", "--json")[1]
    status, text, _ = call("table", "r.h5")
    if status == 0:
        found["table"] = text
    call("report", "r.h5", "-o", "report", "--lateral", "--gnuplot", "/bin/true", "--weasyprint", "/bin/true")
    for page in sorted((folder / "report").glob("*.html")):
        if page.name != "explorer.html":
            found[page.name] = plain(page.read_text(encoding="utf-8"))
    return found


def same(one, other):
    return one == other or (math.isfinite(one) and math.isfinite(other)
                            and abs(one - other) <= 1e-9 * max(abs(one), abs(other)))


def lines(text):
    joined = (" ".join(line.split()) for line in text.splitlines())
    return [line for line in joined if line and not NOISE.search(line)]


def compare_texts(name, old, new):
    """Differences of texts. Lines are matched by their words; lines of the same words in their order."""
    words = lambda line: NUMBER.sub("#", line)  # noqa: E731
    both = []
    for text in (old, new):
        by_words = {}
        for line in lines(text):
            by_words.setdefault(words(line), []).append([float(n) for n in NUMBER.findall(line)])
        both.append(by_words)
    for key in dict.fromkeys([*both[0], *both[1]]):
        one, other = both[0].get(key, []), both[1].get(key, [])
        if len(one) != len(other):
            yield f"{name}: {len(one)} lines before, {len(other)} after: {key[:150]}"
        for a, b in zip(one, other):
            if any(not same(x, y) for x, y in zip(a, b)):
                pairs = ", ".join(f"{x:.10g} -> {y:.10g}" for x, y in zip(a, b) if not same(x, y))
                yield f"{name}: {key[:100]}: {pairs}"


def compare_json(name, old, new):
    try:
        one, other = (dict(flat(json.loads(text))) for text in (old, new))
    except json.JSONDecodeError:
        yield from compare_texts(name, old, new)
        return
    missing, more = {}, {}
    for path in dict.fromkeys([*one, *other]):
        key = re.sub(r"/\d+", "/#", path)
        if NOISE.search(path):
            continue
        if path not in other:
            missing[key] = missing.get(key, 0) + 1
        elif path not in one:
            more[key] = more.get(key, 0) + 1
        else:
            a, b = one[path], other[path]
            numbers = all(isinstance(v, (int, float)) and not isinstance(v, bool) for v in (a, b))
            if not (same(a, b) if numbers else a == b or (isinstance(a, str) and NOISE.search(a))):
                yield f"{name}: {path}: {str(a)[:80]} -> {str(b)[:80]}"
    for word, keys in (("only before", missing), ("only after", more)):
        for key, count in keys.items():
            yield f"{name}: {word}: {key} ({count})"


def compare(case, programs, points, keep):
    found = []
    for which, program in zip(("old", "new"), programs):
        folder = Path(keep) / which / case.stem
        folder.mkdir(parents=True, exist_ok=True)
        copy = folder / case.name
        copy.write_text(shortened(case.read_text(encoding="utf-8"), points), encoding="utf-8")
        found.append(outputs(program, copy, folder))
    for which, one in zip(("old", "new"), found):
        if "show" not in one:
            yield f"the {which} program gives no result: {one['run'].strip()[:300]}"
    for name in dict.fromkeys([*found[0], *found[1]]):
        if name not in found[0] or name not in found[1]:
            yield f"{name}: {'only after' if name in found[1] else 'only before'}"
        else:
            yield from (compare_json if name == "json" else compare_texts)(name, found[0][name], found[1][name])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old", type=Path)
    parser.add_argument("new", type=Path)
    parser.add_argument("cases", type=Path, nargs="*")
    parser.add_argument("--points", type=int, default=5, help="at most so many points a parameter")
    parser.add_argument("--keep", help="folder in which results and reports stay")
    given = parser.parse_args()
    cases = given.cases or [c for c in sorted((ROOT / "cases").glob("*.yaml")) if "claims" not in c.name]
    differences = 0
    with tempfile.TemporaryDirectory() as folder:
        for case in cases:
            count = 0
            for line in compare(case.resolve(), [given.old.resolve(), given.new.resolve()], given.points,
                                given.keep or folder):
                print(f"{case.name}: {line}")
                count += 1
            print(f"{case.name}: {count} differences", flush=True)
            differences += count
    return differences > 0


if __name__ == "__main__":
    sys.exit(main())
