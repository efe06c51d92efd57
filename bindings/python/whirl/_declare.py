"""Declares the functions of libwhirl to cffi. As a program it writes them as a module for packages: _declare.py
MODULE."""

import sys
from pathlib import Path

from cffi import FFI

_BASICS = """
typedef int whirl_code;
typedef int whirl_list;
typedef struct whirl_status { whirl_code code; const char *message; } whirl_status;
"""


def declared():
    """Returns the FFI with the functions of _library.h."""
    ffi = FFI()
    ffi.cdef(_BASICS + (Path(__file__).parent / "_library.h").read_text())
    return ffi


def write(path):
    """Writes a Python module with the same `ffi`, which loads faster."""
    ffi = declared()
    ffi.set_source("_declarations", None)
    ffi.emit_python_code(str(path))


if __name__ == "__main__":
    write(sys.argv[1])
