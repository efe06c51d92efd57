"""Finds and opens libwhirl by cffi, and turns its failures into exceptions."""

import errno
import os
from pathlib import Path

from . import errors

try:
    from ._declarations import ffi  # written when the package was built; saves a tenth of a second
except ImportError:
    from ._declare import declared

    ffi = declared()

# Values of enumerations of the stable interface, which do not change.
PARAMETERS, STATIONS, CONTACTS, FACTS, TABLES = range(5)
OK, BAD_INPUT, NO_MEMORY, IO_ERROR, NUMERICAL_FAILURE, STOPPED, MISSING_PROGRAM = range(7)

_EXCEPTIONS = {
    BAD_INPUT: errors.BadInput,
    NO_MEMORY: errors.OutOfMemory,
    IO_ERROR: errors.FileFailure,
    NUMERICAL_FAILURE: errors.NumericalFailure,
    STOPPED: errors.Stopped,
    MISSING_PROGRAM: errors.MissingProgram,
}
SONAME = "libwhirl.so.1"
_OLDEST = (0, 2, 0)


def _places():
    """Returns the places to look for the library: that of WHIRL_LIBRARY, else in the package, else in the system's
    folders."""
    given = os.environ.get("WHIRL_LIBRARY")
    if given:
        return [given]
    own = Path(__file__).parent / "_native" / SONAME
    return [str(own)] if own.exists() else [SONAME]


def _open():
    # RTLD_NODELETE keeps the library loaded. At exit Python frees this module before the last cases, whose finalizers
    # still call the library.
    kept = ffi.RTLD_NOW | getattr(ffi, "RTLD_NODELETE", 0)
    for place in _places():
        try:
            library = ffi.dlopen(place, kept)
        except OSError as failure:
            raise ImportError(
                f"{failure}; whirl needs libwhirl, version {'.'.join(map(str, _OLDEST))} or later: install the package "
                f"with 'pip install .', or say in WHIRL_LIBRARY where {SONAME} lies"
            ) from None
    return library


lib = _open()
_forbidden: list[str] = []


def forbid(why):
    """Forbids further use of the library in this process; later calls raise the reason."""
    _forbidden.append(why)


def ensure_allowed():
    """Raises an error if the library is forbidden."""
    if _forbidden:
        raise errors.Error(_forbidden[0])


def text(pointer):
    """Returns the text at a ``const char *``; None for NULL."""
    return None if pointer == ffi.NULL else ffi.string(pointer).decode("utf-8", "replace")


def taken(pointer):
    """Returns the text at a ``char **`` of the library, and frees it."""
    try:
        return text(pointer[0]) or ""
    finally:
        lib.whirl_text_free(pointer[0])


def check(status):
    """Raises the exception of a status, unless it is a success."""
    if status.code != OK:
        raise _EXCEPTIONS.get(status.code, errors.Error)(text(status.message))


def word_bytes(word):
    """Encodes a text for the library, where it ends at the first NUL: a NUL within it is an error."""
    if not isinstance(word, str):
        raise errors.BadInput(f"{word!r} is no text, where one is expected")
    try:
        data = word.encode()
    except UnicodeEncodeError:
        raise errors.BadInput(f"{word!r} is no text that UTF-8 could hold") from None
    if b"\0" in data:
        raise errors.BadInput(f"{word!r} has a NUL in it, which no text of the library may have")
    return data


def path_bytes(path):
    """Encodes the name of a file for the library; a NUL in it is an error."""
    data = os.fsencode(os.fspath(path))
    if b"\0" in data:
        raise errors.BadInput(f"the name of a file has a NUL in it: {path!r}")
    return data


def keep_file(path, overwrite):
    """Raises an error for an existing file, unless it may be replaced."""
    if not overwrite and os.path.lexists(path) and not os.path.isdir(path):
        raise errors.ExistingFile(f"'{os.fspath(path)}' is there already and is kept: overwrite=True replaces it")


def require_file(path, what):
    """Raises the system's error for a missing file."""
    if not os.path.lexists(path):
        raise errors.MissingFile(f"cannot read {what} '{os.fspath(path)}': {os.strerror(errno.ENOENT)}")


check(lib.whirl_version_check(*_OLDEST))
