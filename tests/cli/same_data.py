"""Compares result files bit for bit, all but the facts of the run (times, threads, command line)."""
import sys

import h5py

FACTS = "provenance"


def contents(path):
    """Every data set and attribute of the file as bytes."""
    found = {}

    def visit(name, item):
        if name.split("/")[0] == FACTS:
            return
        if isinstance(item, h5py.Dataset):
            value = item[()]
            found[name] = value.tobytes() if hasattr(value, "tobytes") else repr(value)
        for key in item.attrs:
            found[f"{name}@{key}"] = repr(item.attrs[key])

    with h5py.File(path) as file:
        file.visititems(visit)
    return found


first, *others = [contents(path) for path in sys.argv[1:]]
assert len(first) > 20, "there is hardly anything to compare"
for other in others:
    differing = sorted(name for name in first.keys() | other.keys() if first.get(name) != other.get(name))
    assert not differing, f"these differ: {differing}"
print(f"{len(first)} data sets, all the same")
