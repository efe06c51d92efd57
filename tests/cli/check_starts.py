"""Checks a result with several starts: the first start of every place has the bits of the study without starts, all starts
lie in their ranges, and shares are counts: check_starts.py STARTS.h5 PLAIN.h5 TABLE COUNT"""
import sys

import h5py
import numpy

starts, plain = (h5py.File(name)[sys.argv[3]] for name in sys.argv[1:3])
count, places = int(sys.argv[4]), plain["values"].size
assert starts.attrs["starts"] == count and starts.attrs["points"] == count * places


def flat(table, name):
    data = table[name][()]
    return data.reshape(table["values"].size, -1)


fields = []
plain.visititems(lambda name, item: fields.append(name) if "extent" in item.attrs else None)
for name in fields:
    assert flat(starts, name)[:places].tobytes() == flat(plain, name).tobytes(), name
numbers = starts["starts/number"][()]
assert (numbers == numpy.repeat(numpy.arange(count) + 1, places)).all()
label, share, error = (starts[name][()] for name in ("attractor", "share", "share_error"))
for i in range(count * places):
    there = label[i % places :: places]
    if label[i]:
        part = numpy.mean(there == label[i])
        assert share[i] == part and abs(error[i] - numpy.sqrt(part * (1 - part) / count)) < 1e-15
    else:
        assert numpy.isnan(share[i])
state = starts["starts/state"][()].reshape(count, places, -1)
assert (state[:, 0] == state[:, places - 1]).all()
print(len(fields), "fields of", places, "places, all the same;", "states", state[:, 0, :].tolist())
