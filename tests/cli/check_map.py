"""Every row of a map is the sweep of its first parameter at that value of the second, to the bit.
check_map.py MAP.h5 SWEEP.h5 ROW ..."""
import sys

import h5py
import numpy as np


def fields(group):
    found = {}
    group.visititems(lambda name, item: found.__setitem__(name, item[()]) if isinstance(item, h5py.Dataset) else None)
    return found


def shapes(table):
    """Every field has the dimensions that its attribute names."""
    for name in table.attrs["fields"]:
        field = table[name]
        repeat, rows, columns = (int(field.attrs[k]) for k in ("repeat", "rows", "columns"))
        size = {b"y": table["y"].size, b"x": table["x"].size, b"row": rows, b"column": columns}
        assert field.shape == tuple(size.get(word, repeat) for word in field.attrs["dimensions"]), field
        assert list(field.attrs["dimensions"][:2]) == [b"y", b"x"]


path, *rest = sys.argv[1:]
compared = 0
with h5py.File(path) as file:
    table = file["map"]
    across, count = int(table.attrs["row"]), int(table.attrs["points"])
    own = fields(table)
    assert own["values"].shape == (count // across, across)
    assert (own["values"] == own["x"]).all() and (own["map/second"] == own["y"][:, None]).all()
    shapes(table)
    for sweep_path, row in zip(rest[::2], map(int, rest[1::2])):
        with h5py.File(sweep_path) as other:
            sweep = fields(other["sweep"])
            for name, numbers in sweep.items():
                if name in ("point", "verdict/name", "verdict/reason"):
                    continue
                part = np.ascontiguousarray(own[name][row])
                assert part.tobytes() == np.ascontiguousarray(numbers).tobytes(), f"{name} of row {row} differs"
                compared += 1
    assert (np.diff(own["y"]) > 0).all()
print(f"{compared} fields of {count // across} rows, all the same")
