"""libwhirl through cffi: the library is found and opened, and its failures become exceptions."""

import os
from pathlib import Path

from . import errors

try:
    from ._declarations import ffi  # made when the package was built: a tenth of a second less
except ImportError:
    from ._declare import declared

    ffi = declared()

# Values of enumerations of the stable interface, which stay.
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
    """Where the library may lie: as WHIRL_LIBRARY says, in the package, where the system has its libraries."""
    given = os.environ.get("WHIRL_LIBRARY")
    if given:
        return [given]
    own = Path(__file__).parent / "_native" / SONAME
    return [str(own)] if own.exists() else [SONAME]


def _open():
    for place in _places():
        try:
            library = ffi.dlopen(place)
        except OSError as failure:
            raise ImportError(
                f"{failure}; whirl needs libwhirl, version {'.'.join(map(str, _OLDEST))} or later: install the package "
                f"with 'pip install .', or say in WHIRL_LIBRARY where {SONAME} lies"
            ) from None
    return library


lib = _open()


def text(pointer):
    """The text at a ``const char *``, None for NULL."""
    return None if pointer == ffi.NULL else ffi.string(pointer).decode("utf-8", "replace")


def check(status):
    """Raises what a status says, if it is no success."""
    if status.code != OK:
        raise _EXCEPTIONS.get(status.code, errors.Error)(text(status.message))


def path_bytes(path):
    return os.fsencode(os.fspath(path))


check(lib.whirl_version_check(*_OLDEST))
