"""A result in the memory of the library, accessed without copies."""

import numpy as np

from . import errors
from ._library import (
    CONTACTS,
    FACTS,
    PARAMETERS,
    STATIONS,
    TABLES,
    check,
    ensure_allowed,
    ffi,
    lib,
    path_bytes,
    require_file,
    text,
    word_bytes,
)

_STATION_NUMBERS = ("clearance", "gap", "position")
_STATION_WHOLES = ("x", "y", "vx", "vy", "shaft", "along_y", "twists", "clockwise")


class _Owner:
    """Lends memory of the library to NumPy. An array made from this object keeps it alive, and it keeps the result
    alive."""

    def __init__(self, handle, pointer, shape, strides, kind):
        self.handle = handle
        self.__array_interface__ = {
            "data": (int(ffi.cast("uintptr_t", pointer)), True),
            "shape": shape,
            "strides": strides,
            "typestr": kind,
            "version": 3,
        }


def _lend(handle, pointer, shape, strides=None, kind="<f8"):
    """Returns a read-only array of the library's memory."""
    if 0 in shape:
        return np.zeros(shape, kind)
    return np.asarray(_Owner(handle, pointer, shape, strides, kind))


class MemorySource:
    """A whirl_result, owned by this object and by the arrays that use its memory."""

    def __init__(self, handle, computed=True):
        self.handle = ffi.gc(handle, lib.whirl_result_free)
        self.computed = computed

    @classmethod
    def read(cls, path):
        """Reads a whole file, which the library checks."""
        return cls._from(path, "the result", lib.whirl_result_read)

    @classmethod
    def record(cls, path, columns=None):
        """Reads a measured record; columns: headings, each with its name in the file."""
        headings = [ffi.new("char[]", word_bytes(heading)) for heading in columns or ()]
        names = [ffi.new("char[]", word_bytes(name)) for name in (columns or {}).values()]

        def read(name, out):
            return lib.whirl_result_read_record_columns(name, headings, names, len(names), out)

        return cls._from(path, "the record", read)

    @classmethod
    def _from(cls, path, what, read):
        ensure_allowed()
        out, name = ffi.new("whirl_result **"), path_bytes(path)
        require_file(path, what)
        check(read(name, out))
        return cls(out[0])

    @classmethod
    def outline(cls, path):
        """Reads a file without the numbers of its points."""
        out = ffi.new("whirl_result **")
        check(lib.whirl_result_read_outline(path_bytes(path), out))
        return cls(out[0], computed=False)

    def _names(self, which):
        return [
            text(lib.whirl_result_name(self.handle, which, i))
            for i in range(lib.whirl_result_count(self.handle, which))
        ]

    def _number(self, which, index, what):
        return lib.whirl_result_number(self.handle, which, index, what.encode())

    def _text(self, which, index, what):
        return text(lib.whirl_result_text(self.handle, which, index, what.encode()))

    title = property(lambda self: text(lib.whirl_result_title(self.handle)))
    case_name = property(lambda self: text(lib.whirl_result_case_name(self.handle)))
    case_text = property(lambda self: text(lib.whirl_result_case_text(self.handle)))
    speed = property(lambda self: lib.whirl_result_speed(self.handle))
    force_scale = property(lambda self: lib.whirl_result_force_scale(self.handle))
    length_scale = property(lambda self: lib.whirl_result_length_scale(self.handle, ffi.NULL, 0))
    partial = property(lambda self: lib.whirl_result_is_partial(self.handle))

    def parameters(self):
        return [
            (
                name,
                self._number(PARAMETERS, i, "value"),
                self._text(PARAMETERS, i, "unit"),
                self._text(PARAMETERS, i, "text"),
            )
            for i, name in enumerate(self._names(PARAMETERS))
        ]

    def stations(self):
        return [
            dict(
                name=name,
                **{what: self._number(STATIONS, i, what) for what in _STATION_NUMBERS},
                **{what: int(self._number(STATIONS, i, what)) for what in _STATION_WHOLES},
            )
            for i, name in enumerate(self._names(STATIONS))
        ]

    def contacts(self):
        return self._names(CONTACTS)

    def facts(self):
        return {name: self._text(FACTS, i, "value") for i, name in enumerate(self._names(FACTS))}

    def show_in(self, units):
        """Chooses these units for figures."""
        check(lib.whirl_result_show_in(self.handle, word_bytes(units)))

    def tables(self):
        return {name: MemoryTable(self, name) for name in self._names(TABLES)}

    def write(self, path):
        check(lib.whirl_result_write(self.handle, path_bytes(path)))
        check(lib.whirl_result_verify(self.handle, path_bytes(path)))

    def bytes(self):
        """Returns the size of the numbers."""
        tables = (lib.whirl_result_table(self.handle, name.encode()) for name in self._names(TABLES))
        return sum(8 * lib.whirl_table_points(table) * _block_size(table) for table in tables)

    def outline_result(self):
        """Returns the handle of a result, which may lack the numbers of points."""
        return self.handle

    def library_result(self):
        """Returns the library's handle, for functions of whole results."""
        return self.handle


def _block_size(table):
    """Returns how many numbers a point has."""
    shape, stride = ffi.new("size_t[3]"), ffi.new("size_t *")
    lib.whirl_table_column(table, 0, shape, stride)
    return stride[0]


class MemoryTable:
    """A whirl_table of a result in memory. Points that are not computed are left out, as in files."""

    def __init__(self, source, name):
        self.result, self.computed = source.handle, source.computed
        self.handle = lib.whirl_result_table(self.result, name.encode())
        self.name = name
        self.parameter = text(lib.whirl_table_parameter(self.handle))
        self.second = text(lib.whirl_table_varied(self.handle))
        self.third = text(lib.whirl_table_stacked(self.handle))
        self.role = text(lib.whirl_table_role(self.handle))
        count = lib.whirl_table_points(self.handle)
        done = np.fromiter((lib.whirl_table_done(self.handle, i) for i in range(count)), bool, count)
        self._chosen = None if done.all() else np.flatnonzero(done)
        self._count = count
        rows = lib.whirl_table_rows(self.handle)
        self.planes = lib.whirl_table_planes(self.handle)
        self.grid = (rows, lib.whirl_table_places(self.handle) // (rows * self.planes)) if rows else None
        whole = lib.whirl_table_row(self.handle) > 0 and self._chosen is None
        if whole:
            self.shape = (self.planes,) * bool(self.third) + self.grid
        else:
            self.shape = (count if self._chosen is None else len(self._chosen),)

    def _pick(self, lent):
        """Selects the numbers of computed points, in the shape of the table."""
        picked = lent if self._chosen is None else lent[self._chosen]
        return picked if len(self.shape) == 1 else picked.reshape(self.shape + lent.shape[1:])

    def values(self):
        return self._pick(_lend(self.result, lib.whirl_table_values(self.handle), (self._count,)))

    def branch(self):
        return self._pick(_lend(self.result, lib.whirl_table_branch(self.handle), (self._count,), kind="<i4")).astype(
            np.int64
        )

    def point(self):
        slots = (lib.whirl_table_slot(self.handle, i) + 1 for i in range(self._count))
        return self._pick(np.fromiter(slots, np.int64, self._count))

    def place(self):
        places = (lib.whirl_table_place(self.handle, i) for i in range(self._count))
        return self._pick(np.fromiter(places, np.int64, self._count))

    def length_scale(self):
        scales = (lib.whirl_result_length_scale(self.result, self.handle, i) for i in range(self._count))
        return self._pick(np.fromiter(scales, float, self._count))

    def clock(self, _table, _fixed):
        clocks = (lib.whirl_table_clock(self.result, self.handle, i) for i in range(self._count))
        return self._pick(np.fromiter(clocks, float, self._count))

    def fields(self):
        return [self._field(i) for i in range(lib.whirl_table_field_count(self.handle))]

    def _field(self, i):
        shape, stride, si = ffi.new("size_t[3]"), ffi.new("size_t *"), ffi.new("char[64]")
        lib.whirl_table_column(self.handle, i, shape, stride)
        factor = lib.whirl_table_field_si(self.result, self.handle, i, si, 64)
        meaning = text(lib.whirl_table_field_meaning(self.handle, i))
        singles = lib.whirl_table_field_singles(self.handle, i)
        return dict(
            name=text(lib.whirl_table_field_name(self.handle, i)),
            unit=text(lib.whirl_table_field_unit(self.handle, i)),
            meaning=meaning,
            extent=text(lib.whirl_table_field_extent(self.handle, i)),
            repeat=shape[0],
            rows=shape[1],
            columns=singles or shape[2],
            singles=singles,
            has_rows=shape[1] != 1 or lib.whirl_field_has_rows(lib.whirl_table_field_name(self.handle, i)),
            si_factor=factor,
            si_unit=text(si),
            column_names=_column_names(meaning, shape[2]),
        )

    def numbers(self, index, field):
        shape, stride = ffi.new("size_t[3]"), ffi.new("size_t *")
        first = lib.whirl_table_column(self.handle, index, shape, stride)
        repeat, rows, columns = shape
        every = (self._count, repeat, rows, columns)
        if first == ffi.NULL and 0 not in every:
            if not self.computed:
                raise errors.BadInput(f"the table '{self.name}' of an outline has no numbers: run the case")
            lent = np.empty(every)
            check(lib.whirl_table_copy(self.handle, index, ffi.cast("double *", ffi.from_buffer(lent))))
            lent = lent.view("<f4") if field.singles else lent
        elif field.singles:
            every, strides = (*every[:3], field.singles), (8 * stride[0], 8 * rows * columns, 8 * columns, 4)
            lent = _lend(self.result, first, every, strides, "<f4")
        else:
            strides = (8 * stride[0], 8 * rows * columns, 8 * columns, 8)
            lent = _lend(self.result, first, every, strides)
        sizes = {field.extent: repeat, "row": rows, "column": columns, "channel": rows, "sample": field.singles}
        return self._pick(lent.reshape((self._count, *(sizes[name] for name in field.dimensions))))

    def words(self):
        name, reason = ffi.new("char[400]"), ffi.new("char[400]")
        names, reasons = [], []
        for i in range(self._count) if self._chosen is None else self._chosen:
            lib.whirl_table_words(self.handle, i, name, reason, 400)
            names.append(text(name))
            reasons.append(text(reason))
        return np.array(names, dtype=str).reshape(self.shape), np.array(reasons, dtype=str).reshape(self.shape)

    def attractors(self):
        if not self.computed:
            raise errors.BadInput(f"the table '{self.name}' of an outline has no attractors: run the case")
        numbers, shares, share_errors = np.zeros(self._count, np.uintp), np.zeros(self._count), np.zeros(self._count)
        check(
            lib.whirl_table_attractor_numbers(
                self.handle,
                ffi.cast("size_t *", ffi.from_buffer(numbers)),
                ffi.cast("double *", ffi.from_buffer(shares)),
                ffi.cast("double *", ffi.from_buffer(share_errors)),
            )
        )
        return self._pick(numbers.astype(np.int64)), self._pick(shares), self._pick(share_errors)

    def options(self):
        options, value = {}, ffi.new("char[64]")
        while True:
            name = lib.whirl_table_option(self.handle, len(options), value, 64)
            if name == ffi.NULL:
                return options
            options[text(name)] = _plain(text(value))


def _plain(word):
    """Converts a text to a number or a bool if it is one."""
    if word in ("true", "false"):
        return int(word == "true")
    for kind in (int, float):
        try:
            return kind(word)
        except ValueError:
            pass
    return word


def _column_names(meaning, columns):
    """Returns the names of columns, which are before the first bracket of a meaning, divided by commas."""
    names = [name.strip() for name in meaning.split("(")[0].split(",")]
    return names if columns > 1 and len(names) == columns and all(names) else []
