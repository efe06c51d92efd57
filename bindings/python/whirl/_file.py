"""A result in a file, whose parts are read when they are used."""

import functools
import os
import shutil
import tempfile

import h5py
import numpy as np

from . import errors


def _word(value):
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)


def _words(dataset):
    return [_word(value) for value in dataset[()]]


def _plain(value):
    if isinstance(value, bytes):
        return _word(value)
    return value.item() if hasattr(value, "item") and np.ndim(value) == 0 else value


_FAILURES = (LookupError, TypeError, ValueError, AttributeError, ArithmeticError, RuntimeError, OSError)


def _guarded(own):
    """Decorates a class: its methods turn any error of h5py into a sentence that the file is not as expected."""

    def guard(method):
        @functools.wraps(method)
        def guarded(self, *arguments):
            try:
                return method(self, *arguments)
            except errors.Error:
                raise
            except _FAILURES as failure:
                if not (self.file if hasattr(self, "file") else self.group):  # closed handles of h5py are false
                    raise errors.BadInput(f"the result '{self.path}' was closed: open it again") from None
                raise errors.FileFailure(
                    f"the result '{self.path}' is damaged or was changed ({failure}): whirl.read() says what is wrong"
                ) from failure

        return guarded

    for name, member in list(vars(own).items()):
        if isinstance(member, property):
            setattr(own, name, property(guard(member.fget)))
        elif callable(member):
            setattr(own, name, guard(member))
    return own


@_guarded
class FileSource:
    """A file of `whirl run` through h5py. It stays open; `close` closes it."""

    def __init__(self, path):
        from ._input import open_input
        from ._library import path_bytes, require_file

        self.path, self.file = os.path.abspath(path), None
        path_bytes(path)
        require_file(path, "the result")
        try:
            os.close(open_input(path))
        except OSError as failure:
            raise errors.BadInput(f"cannot read the result '{self.path}': {failure.strerror}") from None
        try:
            self.file = h5py.File(path, "r")
        except OSError as failure:
            reason = (
                os.strerror(failure.errno)
                if failure.errno
                else "it is no HDF5 file, expected a result, which whirl.run() computes of a case"
            )
            raise errors.BadInput(f"cannot read the result '{self.path}': {reason}") from None
        if _word(self.file.attrs.get("format", b"")) != "whirl result":
            self.file.close()
            raise errors.BadInput(f"'{self.path}' is no result of whirl: its attribute 'format' is not 'whirl result'")
        version = int(self.file.attrs["format_version"])
        if version != 2:
            self.file.close()
            raise errors.BadInput(f"'{self.path}' has format {version} of results, expected 2: compute it again")

    title = property(lambda self: _word(self.file.attrs["title"]))
    case_name = property(lambda self: _word(self.file["case"].attrs["name"]))
    case_text = property(lambda self: _words(self.file["case/text"])[0])
    speed = property(lambda self: float(self.file["case"].attrs["speed"]))
    force_scale = property(lambda self: float(self.file["case"].attrs["force_scale"]))
    length_scale = property(lambda self: float(self.file["case"].attrs["length_scale"]))
    partial = property(lambda self: bool(self.file.attrs["partial"]))

    def parameters(self):
        group = self.file["parameters"]
        return list(
            zip(_words(group["name"]), group["value"][()].tolist(), _words(group["unit"]), _words(group["text"]))
        )

    def stations(self):
        group = self.file["stations"]
        names = _words(group["name"])
        columns = {what: group[what][()].tolist() for what in group if what != "name"}
        return [
            dict(name=name, **{what: column[i] for what, column in columns.items()}) for i, name in enumerate(names)
        ]

    def contacts(self):
        return _words(self.file["contacts/name"])

    def facts(self):
        return {name: _word(value) for name, value in self.file["provenance"].attrs.items()}

    @functools.cached_property
    def _outline(self):
        from ._memory import MemorySource

        return MemorySource.outline(self.path)

    def show_in(self, units):
        """Chooses units for the outline and rejects words that are not units; the file does not change."""
        self._outline.show_in(units)

    def outline_result(self):
        """Returns the handle of a result without the numbers of its points, for functions about its case."""
        return self._outline.handle

    def tables(self):
        return {name: FileTable(self.path, self.file[name], name) for name in map(_word, self.file.attrs["tables"])}

    def write(self, path):
        """Copies the file to a temporary name, and renames the copy."""
        path = os.fspath(path)
        if os.path.exists(path) and os.path.samefile(self.path, path):
            return
        folder, name = os.path.split(path)
        try:
            with tempfile.NamedTemporaryFile(dir=folder or ".", prefix=f".{name}.", delete=False) as copy:
                try:
                    shutil.copyfile(self.path, copy.name)
                    shutil.copymode(self.path, copy.name)
                    os.replace(copy.name, path)
                except OSError:
                    os.unlink(copy.name)
                    raise
        except (OSError, ValueError) as failure:
            raise errors.FileFailure(
                f"cannot write the result '{path}': {getattr(failure, 'strerror', failure)}"
            ) from None

    def close(self):
        self.file.close()

    def bytes(self):
        """Returns the size of the file."""
        return os.path.getsize(self.path)

    def library_result(self):
        """Returns a handle of the library, which reads and checks the whole file."""
        from ._memory import MemorySource

        return MemorySource.read(self.path).handle


@_guarded
class FileTable:
    """A table of a result file."""

    def __init__(self, path, group, name):
        self.path, self.group, self.name = path, group, name
        self.parameter = _word(group.attrs["parameter"])
        self.second = _word(group.attrs.get("second", b""))
        self.third = _word(group.attrs.get("third", b""))
        self.role = _word(group.attrs["role"])
        self.shape = group["values"].shape
        row = int(group.attrs.get("row", 0))
        self._places = self._count_places()
        plane = int(group.attrs.get("plane", self._places))
        self.grid = (plane // row, row) if row else None
        self.planes = self._places // plane if row else 0

    def _count_places(self):
        """Returns the number of places of the study (docs/result-file.md): of a refined map the points of its grid;
        several starts of a point have one place."""
        about = self.group.attrs
        for name in ("grid", "places"):
            if about.get(name):
                return int(about[name])
        return int(about["points"]) // int(about.get("starts", 1))

    def place(self):
        return (self.point() - 1) % self._places

    def values(self):
        return self.group["values"][()]

    def branch(self):
        return self.group["branch"][()]

    def point(self):
        return self.group["point"][()]

    def length_scale(self):
        return self.group["length_scale"][()]

    def clock(self, table, fixed):
        """Returns the rate of the clock at every point, rad/s, from the case's speed or the values of a parameter."""
        of, factor = int(self.group.attrs["clock_of"]), float(self.group.attrs["clock_factor"])
        if of == 0:
            return np.full(self.shape, fixed)
        if not 1 <= of <= 4:
            raise ValueError(f"clock_of is {of}")
        values = (None, table.values, table.second_values, table.third_values, None)[of]
        return np.full(self.shape, np.nan) if values is None else factor * values

    def fields(self):
        return [self._field(_word(name)) for name in self.group.attrs["fields"]]

    def _field(self, name):
        from ._library import lib, word_bytes

        about = self.group[name].attrs
        return dict(
            name=name,
            unit=_word(about["unit"]),
            meaning=_word(about["meaning"]),
            extent=_word(about["extent"]),
            repeat=int(about["repeat"]),
            rows=int(about["rows"]),
            columns=int(about.get("singles", about["columns"])),
            singles=int(about.get("singles", 0)),
            has_rows=int(about["rows"]) != 1 or lib.whirl_field_has_rows(word_bytes(name)),
            si_factor=float(about["SI_factor"]),
            si_unit=_word(about["SI_unit"]),
            column_names=[_word(column) for column in about.get("column_names", [])],
        )

    def dataset(self, field):
        """Returns the dataset of a field; slices of it are read from the file."""
        return self.group[field.name]

    def verdict_dataset(self):
        return self.group["verdict/name"]

    def numbers(self, _index, field):
        return field._shaped(self.group[field.name][()], len(self.shape))

    def words(self):
        if "verdict" not in self.group:
            return np.full(self.shape, ""), np.full(self.shape, "")
        return tuple(self.group["verdict"][what].asstr("utf-8")[()].astype(str) for what in ("name", "reason"))

    def attractors(self):
        return tuple(self.group[name][()] for name in ("attractor", "share", "share_error"))

    def options(self):
        axes = ("parameter", "second", "third", "row", "plane", "grid", "clock_of", "clock_factor")
        about = axes + ("points", "analyses", "fields", "refine", "role", "starts")
        return {name: _plain(value) for name, value in self.group.attrs.items() if name not in about}
