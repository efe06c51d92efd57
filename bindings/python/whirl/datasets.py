"""Data sets: labelled records of machines with faults (the study ``dataset``), for diagnosis by learning.

>>> data = whirl.dataset("rub-records.yaml", "rub-records.h5")       # makes and opens; without a case: opens
>>> for signals, labels in data.train.batches(32, shuffle=True):
...     learn(signals, labels)

Signals stay in the files until they are used.
"""

from __future__ import annotations

import csv
import io
import os
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Union

import numpy as np

from ._library import check, ffi, keep_file, lib, taken, word_bytes
from ._memory import MemorySource
from .case import Case
from .errors import BadInput, FileFailure
from .fields import FIELD
from .result import Result
from .running import run

if TYPE_CHECKING:
    import pandas

__all__ = ["DataSet", "Signals", "dataset"]

Rows = Union[int, slice, Sequence[int], np.ndarray]

_TEXTS = ("split", "label", "verdict", "confidence")
_WHOLES = ("record", "machine", "seed")


def _text_of(result: MemorySource, what: str, name: str) -> str:
    out = ffi.new("char **")
    check(lib.whirl_result_dataset(result.handle, word_bytes(what), word_bytes(name), out))
    return taken(out)


def _records_of(result: Result) -> Any:
    """Returns the table of a data set's records, or None for the result of another study."""
    return next((table for table in result.tables.values() if table.role == "records"), None)


def _columns_of(text: str) -> dict[str, np.ndarray]:
    """Returns the columns of a table of records (CSV) by their names."""
    names, *rows = csv.reader(io.StringIO(text, newline=""))
    parameters = names.index("seed") + 1  # columns from here on are parameters, whatever their names
    columns: dict[str, np.ndarray] = {}
    for i, name in enumerate(names[1:], 1):
        words = [row[i] for row in rows]
        if i < parameters and name in _TEXTS:
            columns[name] = np.array(words, dtype=str)
        elif i < parameters and name in _WHOLES:
            columns[name] = np.array(words, dtype=np.int64)
        else:
            columns[f"parameter {name}" if name in columns else name] = np.array(
                [word or "nan" for word in words], float
            )
    return columns


class _File:
    """A file of records. Every process opens it when it first reads signals."""

    def __init__(self, path: str | os.PathLike) -> None:
        self.path = os.path.abspath(path)
        source = MemorySource.read(self.path)
        self.columns = _columns_of(_text_of(source, "index", Path(self.path).stem))
        self.sheet = _text_of(source, "datasheet", Path(self.path).stem)
        table = _records_of(Result(source))
        self.table = table.name
        self.options = {name[8:]: value for name, value in table.options.items() if name.startswith("dataset_")}
        self.case_text, self.case_name, self.title = source.case_text, source.case_name, source.title
        facts = source.facts()
        self.labels = [fact.partition(":")[0] for fact in _counted(facts, "label")]
        channels = [fact.partition(":")[0] for fact in _counted(facts, "channel")]
        self.channels = [name.rpartition(" [")[0] for name in channels]
        self.units = [name.rpartition(" [")[2].rstrip("]") for name in channels]
        self.parameters = _counted(facts, "parameter")
        self.shape = (len(self.columns["record"]), len(channels), int(self.options["samples"]))
        self._open: tuple[int, Any, Any] = (0, None, None)

    def signals(self) -> Any:
        process, _file, signals = self._open
        if process != os.getpid() or not signals:  # HDF5 must not share an open file with a forked process
            import h5py

            try:
                file = h5py.File(self.path, "r")
                signals = file[self.table][FIELD.DATASET_SIGNALS]
            except (OSError, KeyError) as failure:
                raise FileFailure(f"cannot read the signals of '{self.path}': {failure}") from None
            if signals.shape != self.shape:
                raise FileFailure(f"'{self.path}' was changed since it was opened: open it again")
            self._open = (os.getpid(), file, signals)
        return signals

    def close(self) -> None:
        process, file, _signals = self._open
        if file is not None and process == os.getpid():
            file.close()
        self._open = (0, None, None)

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_open": (0, None, None)}


def _counted(facts: Mapping[str, str], what: str) -> list[str]:
    """Returns the facts "dataset WHAT 1", "dataset WHAT 2", ..."""
    found = []
    while (key := f"dataset {what} {len(found) + 1}") in facts:
        found.append(facts[key])
    return found


class _Pool:
    """The records of all files, one after the other."""

    def __init__(self, files: list[_File]) -> None:
        first = files[0]
        for other in files[1:]:
            for what in ("channels", "units", "labels", "parameters"):
                mine, theirs = getattr(first, what), getattr(other, what)
                if mine != theirs:
                    raise BadInput(
                        f"'{other.path}' has the {what} {', '.join(theirs)}, expected {', '.join(mine)} as in "
                        f"'{first.path}'"
                    )
            for what in ("samples", "rate", "per_revolution"):
                mine, theirs = first.options[what], other.options[what]
                if mine != theirs:
                    raise BadInput(f"'{other.path}' has {what} {theirs:.9g}, expected {mine:.9g} as in '{first.path}'")
        self.files = files
        self.starts = np.cumsum([0, *(file.shape[0] for file in files)])
        self.columns = {name: np.concatenate([file.columns[name] for file in files]) for name in first.columns}
        if len(files) > 1:
            self._tell_apart()

    def _tell_apart(self) -> None:
        """Gives machines of different seeds different numbers, and rejects a record that occurs twice."""
        counts = [file.shape[0] for file in self.files]
        of = np.repeat(np.arange(len(self.files)), counts)
        seeds = np.array([int(file.options["seed"]) for file in self.files])[of]
        seen: dict[tuple[int, int], int] = {}
        for file, seed, record in zip(of.tolist(), seeds.tolist(), self.columns["record"].tolist()):
            other = seen.setdefault((seed, record), file)
            if other != file:
                both = f"'{self.files[other].path}' and in '{self.files[file].path}'"
                raise BadInput(f"record {record} of seed {seed} is in {both}: make each file with a seed of its own")
        machines = list(zip(seeds.tolist(), self.columns["machine"].tolist()))
        numbers = {machine: number for number, machine in enumerate(dict.fromkeys(machines), 1)}
        self.columns["machine"] = np.array([numbers[machine] for machine in machines], dtype=np.int64)
        self.columns["file"] = of

    def file_of(self, row: int) -> int:
        """Returns the number of the file that has a row."""
        return int(np.searchsorted(self.starts, row, "right")) - 1

    def read(self, rows: np.ndarray) -> np.ndarray:
        """Returns the signals of rows in any order; consecutive rows of a file are read at once."""
        order = np.argsort(rows, kind="stable")
        out = np.empty((len(rows), *self.files[0].shape[1:]), np.float32)
        begin = 0
        while begin < len(order):
            end, row = begin + 1, int(rows[order[begin]])
            file = self.file_of(row)
            last = int(self.starts[file + 1]) - 1
            while end < len(order) and rows[order[end]] == row + end - begin <= last:
                end += 1
            first = row - int(self.starts[file])
            out[order[begin:end]] = self.files[file].signals()[first : first + end - begin]
            begin = end
        return out


def _rows(key: Any, count: int) -> np.ndarray:
    """Returns the rows that a slice, a list, or an array of numbers or of True and False selects."""
    if isinstance(key, slice):
        return np.arange(count)[key]
    chosen = np.asarray(key)
    if chosen.dtype == bool:
        if chosen.shape != (count,):
            raise BadInput(f"records are chosen by {chosen.shape} of True and False, expected ({count},)")
        return np.flatnonzero(chosen)
    if chosen.ndim != 1 or (chosen.size and not np.issubdtype(chosen.dtype, np.integer)):
        raise BadInput(f"records are chosen by {key!r}, expected numbers of rows, a slice, or True and False")
    chosen = chosen.astype(np.int64)
    if chosen.size and not (-count <= chosen.min() and chosen.max() < count):
        raise IndexError(f"there are {count} records, numbered from 0, and none of number {chosen.max()}")
    return np.where(chosen < 0, chosen + count, chosen)


class Signals:
    """Signals in files, float32 [record][channel][sample]. An index reads its part, ``numpy.asarray`` reads all."""

    def __init__(self, pool: _Pool, rows: np.ndarray) -> None:
        self._pool, self._chosen = pool, rows
        self.shape = (len(rows), *pool.files[0].shape[1:])
        self.dtype, self.ndim = np.dtype(np.float32), 3

    def __len__(self) -> int:
        return self.shape[0]

    def __getitem__(self, key: Any) -> np.ndarray:
        key, *rest = key if isinstance(key, tuple) else (key,)
        if isinstance(key, (int, np.integer)):
            return self._pool.read(self._chosen[_rows([int(key)], len(self))])[(0, *rest)]
        return self._pool.read(self._chosen[_rows(key, len(self))])[(slice(None), *rest)]

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> np.ndarray:
        read = self[:]
        return read if dtype is None else read.astype(dtype)

    def __repr__(self) -> str:
        return f"<whirl signals {' x '.join(map(str, self.shape))}, float32>"


class DataSet:
    """Records with labels, in one file or several. ``data[i]`` is (signals [channel][sample], number of the label), as
    PyTorch's ``DataLoader`` takes data sets.

    Parts of a data set (``data.train``, ``data.select(...)``) are data sets, too; they share the files.
    """

    def __init__(self, pool: _Pool, rows: np.ndarray) -> None:
        first = pool.files[0]
        self._pool = pool
        self.rows = rows  #: rows of all files that this data set has
        self.title: str = first.title  #: title of the case
        self.channels: list[str] = list(first.channels)  #: names of the channels
        self.units: list[str] = list(first.units)  #: and the units of their signals
        self.labels: list[str] = list(first.labels)  #: names of the labels, by their numbers
        self.parameters: list[str] = list(first.parameters)  #: parameters that differ between records
        self.samples: int = first.shape[2]  #: samples of a channel
        self.rate = float(first.options["rate"])  #: samples a second; 0 if they are taken by the angle
        #: samples a revolution; 0 if they are taken in time
        self.samples_per_revolution = float(first.options["per_revolution"])
        self.signals = Signals(pool, rows)  #: the records' signals, read as they are asked for

    # ------------------------------------------------------------ columns

    def column(self, name: str) -> np.ndarray:
        """A column of the table of records: "label", "severity", "machine", "verdict", ..., or a parameter (SI)."""
        if name not in self._pool.columns:
            raise KeyError(f"records have no '{name}', expected one of: {', '.join(self._pool.columns)}")
        return self._pool.columns[name][self.rows]

    @property
    def index(self) -> pandas.DataFrame:
        """The table of records, one line each: record, machine, split, label, severity (NaN without a fault), verdict
        on the motion with its confidence, contact (share of the time), speed (rad/s), begin (angle of the shaft at the
        first sample, revolutions), seed, and every parameter that differs (SI). Records of runs have no verdict, and
        end_speed and rate (rad/s, at the last sample; rad/s2, at the first one) in addition."""
        import pandas

        return pandas.DataFrame(
            {name: self.column(name) for name in self._pool.columns}, index=pandas.Index(self.rows, name="row")
        )

    @property
    def targets(self) -> np.ndarray:
        """The number of every record's label, from 0."""
        number = {name: i for i, name in enumerate(self.labels)}
        return np.array([number[name] for name in self.column("label")], dtype=np.int64)

    @property
    def datasheet(self) -> str:
        """The data sheets of the files, in Markdown."""
        return "\n".join(file.sheet for file in self._pool.files)

    # ------------------------------------------------------------ parts

    def select(self, rows: Rows | None = None, /, **equal: Any) -> DataSet:
        """Selects records by their rows (numbers from 0 in this data set, a slice, or an array of True and False), and
        by their columns: ``data.select(label=["healthy", "rub"], verdict="P-1")``, ``data.select(data.index.severity >
        0.5)``.
        """
        chosen = np.ones(len(self), bool)
        for name, wanted in equal.items():
            several = isinstance(wanted, (list, tuple, set, np.ndarray))
            chosen &= np.isin(self.column(name), list(wanted) if several else [wanted])
        if rows is None:
            return DataSet(self._pool, self.rows[chosen])
        own = _rows([rows] if isinstance(rows, (int, np.integer)) else rows, len(self))
        return DataSet(self._pool, self.rows[own[chosen[own]]])

    @property
    def train(self) -> DataSet:
        """The records of machines for training."""
        return self.select(split="train")

    @property
    def validation(self) -> DataSet:
        """The records of machines for validation."""
        return self.select(split="validation")

    @property
    def test(self) -> DataSet:
        """The records of machines for testing."""
        return self.select(split="test")

    # ------------------------------------------------------------ records

    def __len__(self) -> int:
        return len(self.rows)

    def __getitem__(self, i: int) -> tuple[np.ndarray, int]:
        return self.signals[i], self.labels.index(str(self._pool.columns["label"][self.rows[i]]))

    def __getitems__(self, rows: Sequence[int]) -> list[tuple[np.ndarray, int]]:
        """Reads several records together, as PyTorch's loaders do for a batch."""
        return list(zip(self.signals[list(rows)], self.select(list(rows)).targets.tolist()))

    def batches(
        self, size: int, *, shuffle: bool = False, seed: int | None = None, whole: bool = False
    ) -> Iterator[tuple[np.ndarray, np.ndarray]]:
        """Yields batches (signals [size][channel][sample], numbers of labels [size]).

        Parameters
        ----------
        size : int
            Records of a batch. The last batch has the remaining records; with ``whole`` it is left out if it has fewer.
        shuffle : bool
            Takes records in a random order, by numpy's generator with this ``seed``.
        """
        if size < 1:
            raise BadInput(f"batches have {size} records, expected 1 or more")
        order = np.random.default_rng(seed).permutation(len(self)) if shuffle else np.arange(len(self))
        targets = self.targets
        for begin in range(0, len(order) - (size - 1 if whole else 0), size):
            own = order[begin : begin + size]
            yield self.signals[own], targets[own]

    def remake(self, i: int, *, threads: int = 1) -> np.ndarray:
        """Computes the signals of a record again from its case and its number: with the same bits on the same
        instruction set."""
        row = int(self.rows[i])
        file = self._pool.files[self._pool.file_of(row)]
        case = Case(text=file.case_text, name=file.case_name)
        case.set("dataset.only", int(self._pool.columns["record"][row]))
        result = run(case, threads=threads, progress=False)
        return np.array(_records_of(result)[FIELD.DATASET_SIGNALS][0])

    def close(self) -> None:
        """Closes the files; reading signals opens them again."""
        for file in self._pool.files:
            file.close()

    def __enter__(self) -> DataSet:
        return self

    def __exit__(self, *_exception: object) -> None:
        self.close()

    def __repr__(self) -> str:
        machines = len(np.unique(self.column("machine")))
        return (
            f"<whirl.DataSet {self.title!r}: {len(self)} records of {machines} machines, {len(self.labels)} labels, "
            f"{len(self.channels)} channels of {self.samples} samples>"
        )


def dataset(
    source: Case | dict | str | os.PathLike | Sequence[str | os.PathLike],
    path: str | os.PathLike | None = None,
    *,
    overwrite: bool = False,
    **options: Any,
) -> DataSet:
    """Opens a data set, or first computes it from a case with a study ``dataset``.

    Parameters
    ----------
    source : file, or list of files
        Files of ``whirl run`` or of this function. Several files with the same channels and labels, but different
        seeds, are one data set.
    source : Case, case file or dict, with ``path``
        The case, whose data set is computed and written to ``path``, with its table of records ("-records.csv" in the
        place of ".h5") and its data sheet ("-datasheet.md") next to it, as ``whirl run`` does.
    overwrite : bool
        Whether existing files are replaced.
    **options
        Options of :func:`whirl.run`: threads, progress, journal, resume.

    Raises
    ------
    BadInput
        For another study, and for files that do not belong together.
    """
    if path is None:
        if isinstance(source, (Case, Mapping)) or options:
            raise BadInput("a data set is made in a file, expected its name: whirl.dataset(case, 'records.h5')")
        several = not isinstance(source, (str, os.PathLike))
        files = [_File(name) for name in (source if several else [source])]
        if not files:
            raise BadInput("there is no file of records")
        pool = _Pool(files)
        return DataSet(pool, np.arange(pool.starts[-1]))
    case = source if isinstance(source, Case) else Case(source)
    if _records_of(case.outline()) is None:
        raise BadInput(f"the case {case.name} has no study 'dataset'")
    stem = os.fspath(path)
    stem = stem[:-3] if stem.endswith(".h5") else stem
    companions = {"index": f"{stem}-records.csv", "datasheet": f"{stem}-datasheet.md"}
    for name in (path, *companions.values()):
        keep_file(name, overwrite)
    made = run(case, **options)
    made.save(path, overwrite=overwrite)
    for what, name in companions.items():
        with open(name, "w", encoding="utf-8", newline="") as file:
            file.write(_text_of(made._source, what, os.path.basename(stem)))
    return dataset(path)
