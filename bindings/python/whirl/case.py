"""Cases: one YAML text that describes a rotor, its parameters and a study."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from . import errors
from ._input import read_input
from ._library import BAD_INPUT, check, ensure_allowed, ffi, lib, path_bytes, require_file, text, word_bytes

if TYPE_CHECKING:
    from .result import Parameter, Result

__all__ = ["Case"]

_PROBLEMS = 1 << 16
_LONGEST = (1 << 20) + 4  # bytes: more than a case may have with a byte order mark, so that longer texts are rejected
_PLAIN = re.compile(r"[A-Za-z0-9_=][A-Za-z0-9_ .+*/()^=-]*\Z")


def _scalar(value):
    """Returns a YAML scalar: plain if that is safe, else in JSON quotes, which YAML reads too."""
    if isinstance(value, str):
        plain = _PLAIN.match(value) and value == value.strip()
        return value if plain else json.dumps(value, ensure_ascii=False)
    if hasattr(value, "item"):  # a number or a bool of NumPy
        value = value.item()
    if value is None:
        return "null"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, (int, float, np.floating)):  # .item() returns long doubles of NumPy as they are
        return repr(value if isinstance(value, int) else float(value))
    raise TypeError(f"{value!r} cannot stand in a case: expected a text, a number, a list or a dict")


def _flow(value):
    """Returns a value on one line."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{_scalar(str(key))}: {_flow(item)}" for key, item in value.items()) + "}"
    if isinstance(value, (list, tuple, range)) or getattr(value, "ndim", 0) == 1:  # a list, an array, a Series
        return "[" + ", ".join(_flow(item) for item in value) + "]"
    return _scalar(value)


def _block(mapping, indent=0):
    """Returns a mapping over several lines; short mappings are on one line."""
    lines = []
    for key, value in mapping.items():
        head = " " * indent + _scalar(str(key)) + ":"
        if isinstance(value, dict) and any(isinstance(item, (dict, list)) for item in value.values()):
            lines += [head, _block(value, indent + 2)]
        elif isinstance(value, list) and value and all(isinstance(item, dict) for item in value):
            lines += [head, *(" " * (indent + 2) + "- " + _item(item) for item in value)]
        else:
            lines.append(f"{head} {_flow(value)}")
    return "\n".join(lines)


def _item(mapping):
    """Returns an element of a list: {"shaft": {...}} becomes ``shaft: {...}``."""
    if len(mapping) == 1:
        ((key, value),) = mapping.items()
        return f"{_scalar(str(key))}: {_flow(value)}"
    return _flow(mapping)


def _encoded(text):
    try:
        return text.encode() if isinstance(text, str) else bytes(text)
    except UnicodeEncodeError as failure:
        raise errors.BadInput(f"the text of a case cannot be written as UTF-8: {failure.reason}") from None


def _document(source, key, name):
    """Returns the bytes of a file on balancing or on a bearing, or of a dict with its content (and a version under
    ``key``), and its name in messages."""
    if not isinstance(source, Mapping):
        name = name or str(source)
        path_bytes(source)
        require_file(source, "the file")
        try:
            return read_input(source, _LONGEST), name
        except (OSError, ValueError) as failure:
            raise errors.BadInput(f"cannot read {name}: {getattr(failure, 'strerror', None) or failure}") from None
    said = {own: value for own, value in source.items() if value is not None}
    try:
        return _encoded(_block({key: 1, **said}) + "\n"), name or key + ".yaml"
    except RecursionError:
        raise errors.BadInput(f"the dict of a {key} holds itself") from None


def _accept(status, problems):
    """Raises the error of a function of the library that read a text, with all problems."""
    if status.code == BAD_INPUT:
        found = text(problems).splitlines()
        raise errors.BadInput(text(status.message) if len(found) < 2 else "\n".join(found), found)
    check(status)


class Case:
    """A rotor, its parameters and a study, as a case file describes them.

    Parameters
    ----------
    source : str, path or dict, optional
        Name of a case file, or its content as a dict of dicts, lists, texts and numbers.
    text : str, optional
        The text of a case, in the place of ``source``.
    name : str, optional
        Name of the file in messages.

    Raises
    ------
    BadInput
        With the place, what was found and what is expected; ``problems`` lists all that is wrong.

    Examples
    --------
    >>> case = whirl.Case("paper.yaml")
    >>> case.set("omega", "600 rad/s")
    >>> result = whirl.run(case)
    """

    def __init__(
        self,
        source: str | os.PathLike | dict | None = None,
        *,
        text: str | bytes | None = None,
        name: str | None = None,
    ) -> None:
        if (source is None) == (text is None):
            raise TypeError("Case() takes a file, a dict, or text=..., one of them")
        if isinstance(source, dict):
            source = {key: value for key, value in source.items() if value is not None}
            try:
                text, name = _block({"whirl": 1, **source}) + "\n", name or "case.yaml"
            except RecursionError:
                raise errors.BadInput("the dict of a case holds itself") from None
        elif source is not None:
            if not isinstance(source, (str, os.PathLike)):
                raise TypeError(f"a case is {source!r}, expected the name of a file or a dict")
            name = name or str(source)
            path_bytes(source)
            require_file(source, "the case")
            try:
                text = read_input(source, _LONGEST)
            except OSError as failure:
                raise errors.BadInput(f"cannot read the case {name}: {failure.strerror}") from None
            if text.startswith(b"\x89HDF"):
                raise errors.BadInput(f"'{name}' is a result, expected a case: whirl.open() reads it")
        if not isinstance(text, (str, bytes, bytearray)):
            raise TypeError(f"the text of a case is {text!r}, expected a str")
        self._handle = self._check(_encoded(text), name or "case.yaml")
        self.name = name or "case.yaml"  #: name of the file in messages

    @staticmethod
    def _check(data, name):
        ensure_allowed()
        problems, out = ffi.new("char[]", _PROBLEMS), ffi.new("whirl_case **")
        status = lib.whirl_case_check(data, len(data), path_bytes(name), problems, _PROBLEMS, out)
        _accept(status, problems)
        return ffi.gc(out[0], lib.whirl_case_free)

    @property
    def text(self) -> str:
        """The text of the case, with the changes of :meth:`set`."""
        length = ffi.new("size_t *")
        found = lib.whirl_case_text(self._handle, length)
        return ffi.buffer(found, length[0])[:].decode("utf-8", "replace")

    @property
    def title(self) -> str:
        """The title of the case, or ""."""
        return text(lib.whirl_case_title(self._handle))

    @property
    def parameters(self) -> dict[str, Parameter]:
        """A copy of the parameters by name, with the values that a run would use; :meth:`set` changes them."""
        return self.outline().parameters

    @property
    def warnings(self) -> list[str]:
        """Warnings of ``whirl check``: values outside the range of a law, or unlike real machines."""
        return self.outline().warnings

    def set(self, name: str, value: str | float) -> Case:
        """Sets a parameter, or a key of the case by its path, as ``--set NAME=VALUE`` of the command does.

        Parameters
        ----------
        name : str
            "r_k", "disc.mass", "integrate.transient", "rotor.speed", ...
        value : str or number
            "6000 rpm", "= 2*c", or a plain number in SI.

        Raises
        ------
        BadInput
            If the name or the value is wrong; the case is unchanged.
        """
        value = value if isinstance(value, str) else _scalar(value)
        check(lib.whirl_case_set(self._handle, word_bytes(f"{name}={value}")))
        return self

    def spend(self, revolutions: float = 0.0, seconds: float = 0.0) -> Case:
        """Makes runs compute doubtful points again, within this number of revolutions or seconds; without a number,
        within as many revolutions as the study has (``--refine`` of the command)."""
        for what, number in (("revolutions", revolutions), ("seconds", seconds)):
            if isinstance(number, str) or not hasattr(number, "__float__"):
                raise errors.BadInput(f"the {what} to spend are {number!r}, expected a number")
        check(lib.whirl_case_spend(self._handle, float(revolutions), float(seconds)))
        return self

    def outline(self) -> Result:
        """The :class:`Result` before any point is computed: parameters, stations, the values of every table."""
        from .result import Result
        from ._memory import MemorySource

        out = ffi.new("whirl_result **")
        check(lib.whirl_case_outline(self._handle, out))
        return Result(MemorySource(out[0], computed=False))

    def copy(self) -> Case:
        """Returns another case with the same text."""
        return Case(text=self.text, name=self.name)

    __copy__ = copy

    def __deepcopy__(self, _memo):
        return self.copy()

    def __reduce__(self):
        return _case_of, (self.text, self.name)

    def __repr__(self) -> str:
        return f"<whirl.Case {self.name!r}: {self.title}>"


def _case_of(text, name):
    """Returns the case of a pickle."""
    return Case(text=text, name=name)
