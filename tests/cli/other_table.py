#!/usr/bin/env python3
"""Makes another film table of a cached one, with a right checksum:  other_table.py TABLE

All coefficients become 1e-9 larger: too little to be found out when the table is read (pad_table_confirm).
"""
import struct
import sys

COUNT_AT = 104  # of struct file_head: the number of coefficients, then the checksum

data = bytearray(open(sys.argv[1], "rb").read())
(count,) = struct.unpack_from("<Q", data, COUNT_AT)
start = COUNT_AT + 16
numbers = [x * (1 + 1e-9) for x in struct.unpack_from(f"<{count}d", data, start)]
struct.pack_into(f"<{count}d", data, start, *numbers)
checksum = 14695981039346656037
for (word,) in struct.iter_unpack("<Q", data[start:start + 8 * count]):
    checksum = (checksum ^ word) * 1099511628211 % 2**64
    checksum ^= checksum >> 29
struct.pack_into("<Q", data, COUNT_AT + 8, checksum)
open(sys.argv[1], "wb").write(data)
