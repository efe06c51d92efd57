"""What the library refuses, as exceptions: each carries the library's own sentence."""

from __future__ import annotations

from collections.abc import Sequence

__all__ = ["Error", "BadInput", "OutOfMemory", "FileFailure", "NumericalFailure", "Stopped", "MissingProgram"]


class Error(Exception):
    """A call of libwhirl failed; ``str`` of it is one sentence that says where, what was found and what is expected."""


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


class OutOfMemory(Error, MemoryError):
    """The library could not allocate what it needs."""


class FileFailure(Error, OSError):
    """A file could not be read or written."""


class NumericalFailure(Error, ArithmeticError):
    """A solver gave up, for a reason that is not a diverging motion."""


class Stopped(Error):
    """A run was stopped before anything was finished."""


class MissingProgram(Error):
    """An outside program (gnuplot) is not installed."""
