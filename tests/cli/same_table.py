"""Compares the numbers of a table of one result, bit for bit, with those of a table of another one, in SI."""
import sys

import h5py
import numpy


def numbers(path, table):
    """Every data set of numbers of the table, lengths in m."""
    found = {}
    with h5py.File(path) as file:
        scale = numpy.asarray(file[table].get("length_scale", file.attrs.get("length_scale")))

        def visit(name, item):
            if isinstance(item, h5py.Dataset) and item.dtype.kind in "fiu" and name != "length_scale":
                found[name] = item[()]

        file[table].visititems(visit)
    return found, scale


one, other = (numbers(*sys.argv[i : i + 2]) for i in (1, 3))
assert len(one[0]) > 5, "there is hardly anything to compare"
assert one[0].keys() == other[0].keys(), one[0].keys() ^ other[0].keys()
assert (one[1] == other[1]).all(), (one[1], other[1])
for name, value in one[0].items():
    assert value.tobytes() == other[0][name].tobytes(), name
print(f"{sys.argv[2]} and {sys.argv[4]}: {len(one[0])} data sets, all the same")
