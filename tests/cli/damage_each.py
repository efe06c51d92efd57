"""Damages every dataset of a result by itself: each reader refuses the file by the dataset's name, and finds no fault in
what is left.
damage_each.py WHIRL RESULT.h5 ..."""
import subprocess
import sys

import h5py

BYTES = 8


def places(dataset):
    """Offsets and sizes of the data in the file, chunk by chunk."""
    of = dataset.id
    if of.get_create_plist().get_layout() == h5py.h5d.CHUNKED:
        return [
            (at.byte_offset, at.size)
            for at in map(of.get_chunk_info, range(of.get_num_chunks()))
        ]
    return (
        [(of.get_offset(), of.get_storage_size())]
        if of.get_offset() is not None
        else []
    )


whirl, *results = sys.argv[1:]
damaged = 0
for result in results:
    found = {}
    with h5py.File(result) as file:
        file.visititems(
            lambda name, item: found.update({name: places(item)})
            if isinstance(item, h5py.Dataset)
            else None
        )
    sound = open(result, "rb").read()
    for name, chunks in found.items():
        if not chunks or chunks[-1][1] == 0:
            continue
        at, size = chunks[-1]
        data = bytearray(sound)
        for i in range(at, at + min(size, BYTES)):
            data[i] ^= 0x5A
        with open("damaged.h5", "wb") as file:
            file.write(data)
        shown = subprocess.run(
            [whirl, "show", "damaged.h5"], capture_output=True, text=True
        )
        assert shown.returncode == 2, f"/{name} of {result}: status {shown.returncode}"
        assert shown.stderr.startswith(
            f"whirl: damaged.h5: /{name} cannot be read"
        ), shown.stderr
        damaged += 1
print(f"{damaged} datasets, each refused")
