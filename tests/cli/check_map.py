"""Every row of a map is the sweep of its first parameter at that value of the second, to the bit.
check_map.py MAP.h5 SWEEP.h5 ROW ..."""
import sys

import h5py
import numpy as np


def fields(group):
    found = {}
    group.visititems(lambda name, item: found.__setitem__(name, item[()]) if isinstance(item, h5py.Dataset) else None)
    return found


path, *rest = sys.argv[1:]
compared = 0
with h5py.File(path) as file:
    table = file["map"]
    across, count = int(table.attrs["row"]), int(table.attrs["points"])
    own = fields(table)
    assert count % across == 0 and len(own["values"]) == count
    for sweep_path, row in zip(rest[::2], map(int, rest[1::2])):
        with h5py.File(sweep_path) as other:
            sweep = fields(other["sweep"])
            for name, numbers in sweep.items():
                if name in ("point", "verdict/name", "verdict/reason"):
                    continue
                part = own[name][row * across:(row + 1) * across]
                assert part.tobytes() == np.ascontiguousarray(numbers).tobytes(), f"{name} of row {row} differs"
                compared += 1
    seconds = own["map/second"].reshape(-1, across)
    assert (seconds == seconds[:, :1]).all() and (np.diff(seconds[:, 0]) > 0).all()
print(f"{compared} fields of {count // across} rows, all the same")
