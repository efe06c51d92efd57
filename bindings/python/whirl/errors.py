"""Errors of the library as exceptions, each with the library's message."""

from __future__ import annotations

import errno
from collections.abc import Sequence

__all__ = [
    "Error",
    "BadInput",
    "MissingFile",
    "ReadOnlyCopy",
    "OutOfMemory",
    "FileFailure",
    "ExistingFile",
    "NumericalFailure",
    "Stopped",
    "MissingProgram",
]


class Error(Exception):
    """A call of libwhirl failed. The message is one sentence: where, what was found and what is expected."""


class BadInput(Error, ValueError):
    """The case, the options or the arguments are wrong.

    Attributes
    ----------
    problems : list of str
        All that is wrong with a case, "paper.yaml:12:7: rotor.stations.disc.mass: is -3 kg, expected ...".
    """

    def __init__(self, message: str, problems: Sequence[str] = ()) -> None:
        super().__init__(message)
        self.problems = list(problems)


class _OfFile:
    """Base of errors that are also OSErrors: their text is the library's message, their class gives ``errno``."""

    _errno: int

    def __init__(self, message: str) -> None:
        super().__init__(message)
        self.errno = self._errno

    def __str__(self) -> str:
        return self.args[0]


class MissingFile(_OfFile, BadInput, FileNotFoundError):
    """A case, a result or another file to be read does not exist."""

    _errno = errno.ENOENT


class ReadOnlyCopy(Error, TypeError):
    """A change of a dict that is a copy (``case.parameters``, ``result.facts``) would have no effect."""


class OutOfMemory(Error, MemoryError):
    """The library could not allocate what it needs."""


class FileFailure(Error, OSError):
    """A file could not be read or written."""


class ExistingFile(_OfFile, FileFailure, FileExistsError):
    """An existing file would be replaced; it is kept."""

    _errno = errno.EEXIST


class NumericalFailure(Error, ArithmeticError):
    """A solver failed for another reason than a diverging motion."""


class Stopped(Error):
    """A run was stopped before anything was finished."""


class MissingProgram(Error):
    """An outside program (gnuplot) is not installed."""
