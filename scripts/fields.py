#!/usr/bin/python3
"""The names of the fields of results in all languages:  scripts/fields.py [--check]

include/whirl/engine/fields.h defines them; this writes the files for Python, Octave and the explorer. With --check it
writes nothing: it fails if a file is out of date, and for every literal name of a field anywhere else.
"""

import io
import re
import subprocess
import sys
import tokenize
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
HEADER = ROOT / "include/whirl/engine/fields.h"
NAMES = dict(re.findall(r'^#define WHIRL_FIELD_(\w+)\s+\\?\s*"([^"]+)"', HEADER.read_text(), re.MULTILINE))
WRITTEN = "written by scripts/fields.py from include/whirl/engine/fields.h"

PYTHON = f'''"""Names of the fields of results; {WRITTEN}."""


class FIELD:
{"".join(f"    {name} = {chr(34)}{field}{chr(34)}{chr(10)}" for name, field in NAMES.items())}'''
OCTAVE = f"""function names = field_names()
% FIELD_NAMES  Names of the fields of results; {WRITTEN}.
{"".join(f"names.{name.lower()} = '{field}';{chr(10)}" for name, field in NAMES.items())}end
"""
TYPESCRIPT = f"""// Names of the fields of results; {WRITTEN}.
export const FIELD = {{
{"".join(f"  {name}: '{field}',{chr(10)}" for name, field in NAMES.items())}}} as const;
"""
FILES = {
    "bindings/python/whirl/fields.py": PYTHON,
    "bindings/octave/private/field_names.m": OCTAVE,
    "explorer/src/data/fields.ts": TYPESCRIPT,
}
PRODUCT = ["src", "cli", "include", "bindings/*/whirl*", "bindings/octave/private", "explorer/src", "explorer/core"]
CODE = {".m", ".ts", ".c", ".h", ".cc", ".inc"}


def literals(path):
    """Lines with a quoted field's name in code, and the name."""
    text = path.read_text()
    if path.suffix == ".py":
        for token in tokenize.generate_tokens(io.StringIO(text).readline):
            if token.type == tokenize.STRING and token.string.strip("'\"") in NAMES.values():
                yield token.start[0], token.string
    elif path.suffix in CODE:
        comment = "%.*" if path.suffix == ".m" else "//.*"
        for number, line in enumerate(text.splitlines(), 1):
            for literal in re.findall(r"[\"'`]([a-z]+/\w+)[\"'`]", re.sub(comment, "", line)):
                if literal in NAMES.values():
                    yield number, literal


def check():
    wrong = [f"{name} is not what scripts/fields.py writes" for name, text in FILES.items()
             if not (ROOT / name).exists() or (ROOT / name).read_text() != text]
    listed = subprocess.run(["git", "ls-files", *PRODUCT], cwd=ROOT, check=True, capture_output=True, text=True).stdout
    for name in listed.split():
        if name not in FILES and name != "include/whirl/engine/fields.h":
            wrong += [f"{name}:{line}: {literal} has a name in include/whirl/engine/fields.h" for line, literal in literals(ROOT / name)]
    return wrong


if __name__ == "__main__":
    if sys.argv[1:] == ["--check"]:
        complaints = check()
        print("\n".join(complaints) or f"{len(NAMES)} fields, each said once")
        sys.exit(1 if complaints else 0)
    for name, text in FILES.items():
        (ROOT / name).write_text(text)
