"""Every plane of a map is the map of its first two parameters at that value of the third, to the bit.
check_planes.py PLANES.h5 MAP.h5 ..., one for each plane."""
import sys

import h5py
import numpy as np


def fields(group):
    found = {}
    group.visititems(lambda name, item: found.__setitem__(name, item[()]) if isinstance(item, h5py.Dataset) else None)
    return found


path, *planes = sys.argv[1:]
compared = 0
with h5py.File(path) as file:
    table = file["map"]
    own = fields(table)
    assert own["values"].shape == (len(planes), own["y"].size, own["x"].size) and own["z"].size == len(planes)
    assert (own["map/third"] == own["z"][:, None, None]).all() and (np.diff(own["z"]) > 0).all()
    for name in table.attrs["fields"]:
        assert list(table[name].attrs["dimensions"][:3]) == [b"z", b"y", b"x"], name
    assert int(table.attrs["plane"]) == own["values"][0].size and table.attrs["third"] == b"e"
    for plane, other_path in enumerate(planes):
        with h5py.File(other_path) as other:
            for name, numbers in fields(other["map"]).items():
                if name in ("point", "x", "y"):
                    continue
                part = own[name][plane]
                same = part.tobytes() == numbers.tobytes() if numbers.dtype.kind != "S" else (part == numbers).all()
                assert same, f"{name} of plane {plane} differs"
                compared += 1
print(f"{compared} fields of {len(planes)} planes, all the same")
