#!/usr/bin/python3
"""A result and its export have the same values, to the bit:  same_export.py RESULT.h5 FILE.mat"""

import re
import sys

import h5py
import numpy
import scipy.io

KEYWORDS = "break case catch classdef continue else elseif end for function global if otherwise parfor persistent " \
    "return spmd switch try while"


def texts(values):
    """Fixed-length texts of HDF5 as Python's."""
    return numpy.vectorize(lambda b: b.decode("utf-8"), otypes=[object])(numpy.asarray(values))


def plain(value):
    """Values of a dataset or an attribute: numbers as they are, texts decoded."""
    value = numpy.asarray(value)
    return texts(value) if value.dtype.kind in "SO" else value


def name(raw):
    """The name as MATLAB accepts it."""
    made = re.sub("[^A-Za-z0-9]", "_", ("" if re.match("[A-Za-z]", raw) else "x_") + raw[:58])
    return made + "_" if made in KEYWORDS.split() else made


def same(place, found, expected):
    found = numpy.asarray(found)
    assert found.shape == expected.shape, f"{place}: shape {found.shape}, expected {expected.shape}"
    if expected.dtype == object:
        assert (found.astype(object) == expected).all(), f"{place}: {found}, expected {expected}"
    else:
        assert found.dtype == expected.dtype, f"{place}: {found.dtype}, expected {expected.dtype}"
        assert found.tobytes() == expected.tobytes(), f"{place}: {found}, expected {expected}"


def cells(array):
    """Texts of a cell array; an empty one is an array without elements."""
    return numpy.vectorize(lambda t: str(t[0]) if numpy.size(t) else "", otypes=[object])(array)


def in_mat(place, found, expected):
    """MATLAB has no lists: they are columns; a single text is a row of characters, none of them beyond U+FFFF."""
    if expected.dtype == object:
        expected = numpy.vectorize(lambda t: re.sub("[^\\u0000-\\uffff]", "\ufffd", t), otypes=[object])(expected)
    if expected.dtype == object and expected.ndim == 0:
        assert (str(found[0]) if found.size else "") == expected[()], f"{place}: {found}, expected {expected}"
        return
    expected = expected.reshape(expected.shape + (1,) * (2 - expected.ndim))
    found = cells(found) if expected.dtype == object else numpy.ascontiguousarray(found)
    if expected.size == 0:
        assert found.size == 0, f"{place}: {found}, expected none"
    else:
        same(place, found, expected)


def compare(result, mat):
    count = 0

    def visit(path, thing):
        nonlocal count
        parts = [name(part) for part in path.split("/")]
        group = mat[parts[0]][0, 0]
        for part in parts[1:-1]:
            group = group[part][0, 0]
        if isinstance(thing, h5py.Dataset):
            in_mat(path, group[parts[-1]], plain(thing[()]))
            about = group["about"][0, 0][parts[-1]][0, 0] if len(thing.attrs) else None
            count += 1
        else:
            inner = group if len(parts) == 1 else group[parts[-1]][0, 0]
            about = inner["attributes"][0, 0] if len(thing.attrs) else None
        for key, value in thing.attrs.items():
            in_mat(f"{path}@{key}", about[name(key)], plain(value))
            count += 1

    result.visititems(visit)
    for key, value in result.attrs.items():
        in_mat(key, mat["attributes"][0, 0][name(key)], plain(value))
        count += 1
    return count


with h5py.File(sys.argv[1]) as result:
    print("compared", compare(result, scipy.io.loadmat(sys.argv[2])))
