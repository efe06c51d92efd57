"""Checks a result with starts from neighbours: each begins where a motion of the neighbour that it names ended, comes after
all others, and counts in no share: check_neighbours.py RESULT.h5 TABLE"""
import sys

import h5py
import numpy

table = h5py.File(sys.argv[1])[sys.argv[2]]
starts, places, row = (int(table.attrs.get(name, 0)) for name in ("starts", "places", "row"))
slot = table["point"][()] - 1
place, own = slot % places, slot < starts * places
assert own.sum() == starts * places and (numpy.diff(slot) > 0).all()
neighbour = table["starts/neighbour"][()]
assert (neighbour[own] == 0).all() and (table["starts/number"][()] == slot // places + 1).all()
state = table["starts/state"][()].reshape(slot.size, -1)
section = table["poincare/section"][()].reshape(slot.size, -1, table["poincare/section"].attrs["columns"])
verdict, label = table["regime/code"][()], table["attractor"][()]
for i in numpy.flatnonzero(~own):
    at = int(neighbour[i]) - 1
    apart = abs(at - place[i])
    assert apart == row if row and at % row == place[i] % row else apart == 1 and (not row or at // row == place[i] // row)
    ended = [section[k, -1, :2] for k in numpy.flatnonzero(place == at)]
    assert any((state[i, :2] == end).all() for end in ended), (i, state[i, :2], ended)
alone = 0
for p in range(places):
    here, there = label[(place == p) & own], label[place == p]
    for number in set(there) - {0}:
        share = table["share"][()][(place == p) & (label == number)]
        assert (share == (here == number).sum() / starts).all()
        alone += number not in here
print((~own).sum(), "from neighbours;", alone, "attractors found so alone")
