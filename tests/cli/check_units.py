"""Every dataset of numbers of result files has a unit that UDUNITS knows, or one of the words of docs/result-file.md.
check_units.py FILE.h5 ..."""
import ctypes
import sys

import h5py

SCALED = {"length", "force", "order", "revolution", "1/revolution", "deg", "/parameters/unit"}
known, looked = {"1"}, 0
udunits = ctypes.CDLL("libudunits2.so.0")
for function in (udunits.ut_read_xml, udunits.ut_parse):
    function.restype = ctypes.c_void_p
udunits.ut_set_error_message_handler(udunits.ut_ignore)
system = ctypes.c_void_p(udunits.ut_read_xml(None))


def check(name, item):
    global looked
    if not isinstance(item, h5py.Dataset) or item.dtype.kind not in "fiu":
        return
    assert "unit" in item.attrs, f"{name} has no unit"
    for unit in {item.attrs["unit"].decode(), item.attrs.get("SI_unit", b"1").decode()} - SCALED - known:
        assert udunits.ut_parse(system, unit.encode(), 2), f"{name}: UDUNITS does not know the unit '{unit}'"
        known.add(unit)
    looked += 1


for path in sys.argv[1:]:
    with h5py.File(path) as file:
        file.visititems(check)
        for table in (item for item in file.values() if "parameter" in item.attrs):
            names = dict(zip(file["parameters/name"], file["parameters/unit"]))
            for dataset, axis in (("values", "parameter"), ("x", "parameter"), ("y", "second"), ("z", "third")):
                if dataset in table and table.attrs.get(axis):
                    assert table[dataset].attrs["unit"] == names[table.attrs[axis]], (path, dataset)
            for dataset, axis in (("map/second", "second"), ("map/third", "third")):
                if dataset in table:
                    assert table[dataset].attrs["SI_unit"] == names[table.attrs[axis]], (path, dataset)
print(f"{looked} datasets have units: {len(known)} of UDUNITS")
