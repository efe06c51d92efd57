"""whirl: nonlinear dynamics of rotating machines.

>>> import whirl
>>> result = whirl.run(whirl.Case("paper.yaml"))     # or whirl.open("paper.h5")
>>> result.plot.bifurcation()

Everything is computed by the library libwhirl; numbers are those of the command ``whirl``, bit for bit.
"""

from importlib import import_module

from . import _interpreter  # noqa: F401

TYPE_CHECKING = False  # replaces typing.TYPE_CHECKING without an import; type checkers know the name
if TYPE_CHECKING:
    from . import plot, signals, systems
    from .balancing import Balance, balance, readings
    from .bearings import Bearing, bearing
    from .case import Case
    from .datasets import DataSet, dataset
    from .errors import BadInput, Error, ExistingFile, FileFailure, MissingFile, MissingProgram, NumericalFailure
    from .errors import OutOfMemory, ReadOnlyCopy, Stopped
    from .findings import Column, Sheet, Statement, Statements
    from .fitting import Estimate, Fit, fit
    from .measured import read_measured
    from .result import Parameter, Result, Station, open, read
    from .running import run
    from .sampling import tolerances
    from .table import Field, Table

_HOMES = {
    "Case": "case",
    "Result": "result",
    "Table": "table",
    "Field": "table",
    "Station": "result",
    "Parameter": "result",
    "Statement": "findings",
    "Statements": "findings",
    "Sheet": "findings",
    "Column": "findings",
    "Bearing": "bearings",
    "bearing": "bearings",
    "open": "result",
    "read": "result",
    "run": "running",
    "read_measured": "measured",
    "fit": "fitting",
    "Fit": "fitting",
    "Estimate": "fitting",
    "tolerances": "sampling",
    "dataset": "datasets",
    "DataSet": "datasets",
    "Balance": "balancing",
    "balance": "balancing",
    "readings": "balancing",
    "Error": "errors",
    "BadInput": "errors",
    "MissingFile": "errors",
    "ReadOnlyCopy": "errors",
    "ExistingFile": "errors",
    "OutOfMemory": "errors",
    "FileFailure": "errors",
    "NumericalFailure": "errors",
    "MissingProgram": "errors",
    "Stopped": "errors",
}
_MODULES = ("plot", "signals", "systems")

__all__ = [*_HOMES, *_MODULES, "library_version"]
__version__ = "0.2.0"


def __getattr__(name: str) -> object:
    """Imports modules at their first use, so that ``import whirl`` is fast."""
    if name in _HOMES:
        value = getattr(import_module("." + _HOMES[name], __name__), name)
    elif name in _MODULES:
        value = import_module("." + name, __name__)
    else:
        raise AttributeError(f"module 'whirl' has no attribute '{name}'")
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])


def library_version() -> str:
    """Returns the version of the loaded libwhirl, such as "0.2.0"."""
    from ._library import lib, text

    return text(lib.whirl_version())
