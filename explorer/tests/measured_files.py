"""Writes the columns of a table of comma-separated values as files of other formats, with the same numbers.

    measured_files.py TABLE.csv    writes TABLE.mat (version 5, compressed), TABLE-7.3.mat, TABLE.h5, and TABLE.uff
                                   (58b: numbers of 8 bytes, uneven abscissas); TABLE-matrix.h5 has no vector
"""

import re
import sys
from pathlib import Path

import h5py
import numpy as np
import scipy.io

table = Path(sys.argv[1])
heading, *rows = table.read_text().splitlines()
columns = [re.fullmatch(r"\s*(.*?) \[(.*)\]", cell).groups() for cell in heading.split(",")]
numbers = np.array([[float(cell) for cell in row.split(",")] for row in rows])

# MAT: names have underscores, and texts give the units.
variables = {}
for (name, unit), values in zip(columns, numbers.T):
    variables[name.replace(" ", "_")] = values[:, np.newaxis]
    variables[name.replace(" ", "_") + "_unit"] = unit
scipy.io.savemat(table.with_suffix(".mat"), variables, do_compression=True)

# MAT 7.3: HDF5 behind 512 bytes, texts are numbers.
with h5py.File(table.with_name(table.stem + "-7.3.mat"), "w", userblock_size=512) as file:
    for name, values in variables.items():
        is_text = isinstance(values, str)
        one = np.array([[ord(letter)] for letter in values], np.uint16) if is_text else values.T
        file[name] = one
        file[name].attrs["MATLAB_class"] = np.bytes_("char" if is_text else "double")

# HDF5: in chunks, shuffled, compressed, with checksums.
with h5py.File(table.with_suffix(".h5"), "w") as file:
    for (name, unit), values in zip(columns, numbers.T):
        chunks = {"chunks": (5,), "compression": "gzip", "shuffle": True, "fletcher32": True}
        file.create_dataset(name, data=values, **chunks).attrs["unit"] = unit

# HDF5: a matrix with 2^32 + 2^20 numbers, more than 32 bits count, whose first part is there.
with h5py.File(table.with_name(table.stem + "-matrix.h5"), "w") as file:
    matrix = file.create_dataset("x", (1 << 20, 4097), np.uint8, chunks=(4096, 4097), compression="gzip")
    matrix[:4096] = 0

# Universal file: one record for each probe, complex where it has a lag. The first column is the abscissa.
(axis, axis_unit), *others = columns
probes = [(name, unit) for name, unit in others if not name.endswith(" lag")]
with open(table.with_suffix(".uff"), "wb") as file:
    for name, unit in probes:
        values = numbers[:, columns.index((name, unit))]
        lagging = (name + " lag", "deg") in columns
        if lagging:
            z = values * np.exp(-1j * np.radians(numbers[:, columns.index((name + " lag", "deg"))]))
            values = np.stack([z.real, z.imag], axis=1)
        content = np.column_stack([numbers[:, 0], values]).astype("<f8").tobytes()
        station, direction = name.split(" ")
        lines = [
            f"{'-1':>6}",
            f"{'58':>6}b{1:6d}{2:6d}{11:12d}{len(content):12d}{0:6d}{0:6d}{0:12d}{0:12d}",
            *["NONE"] * 5,
            f"{0:5d}{0:10d}{0:5d}{0:10d} {station:>10}{0:10d}{'xyz'.index(direction) + 1:4d} {'NONE':>10}{0:10d}{0:4d}",
            f"{6 if lagging else 4:10d}{len(rows):10d}{0:10d}{0:13.5e}{0:13.5e}{0:13.5e}",
            f"{0:10d}{0:5d}{0:5d}{0:5d} {axis:<20} {axis_unit:<20}",
            f"{8:10d}{0:5d}{0:5d}{0:5d} {'displacement':<20} {unit:<20}",
            *[f"{0:10d}{0:5d}{0:5d}{0:5d} {'NONE':<20} {'NONE':<20}"] * 2,
        ]
        file.write("".join(f"{line:<80}\n" for line in lines).encode() + content + f"\n{'-1':>6}\n".encode())
