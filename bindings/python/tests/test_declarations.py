"""Tests that the declarations for cffi are those of the headers."""

import os
import pathlib
import shutil
import subprocess

import pytest
from conftest import ROOT

import whirl._library


def compile_with(folder, declarations):
    (folder / "both.c").write_text('#include "whirl/engine.h"\n' + declarations)
    built = pathlib.Path(os.environ.get("WHIRL_BUILD", ROOT / "build")) / "include"
    words = ["cc", "-std=c17", "-fsyntax-only", f"-I{ROOT}/include", f"-I{built}", folder / "both.c"]
    return subprocess.run(words, capture_output=True, text=True)


@pytest.mark.skipif(not shutil.which("cc"), reason="there is no C compiler")
def test_declarations_are_those_of_the_headers(tmp_path):
    own = pathlib.Path(whirl._library.__file__).with_name("_library.h").read_text()
    good = compile_with(tmp_path, own)
    assert good.returncode == 0, good.stderr
    assert compile_with(tmp_path, own.replace("double seconds);", "float seconds);")).returncode != 0
