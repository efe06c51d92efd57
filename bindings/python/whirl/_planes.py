"""The cells of a plane of two parameters, and which point stands for each."""

import numpy as np

from .fields import FIELD


def cover_of(table, plane=0):
    """The point that stands for each cell of a plane [rows][columns], -1 where none is there: of a refined map the
    first corner of the square around it (docs/result-file.md), of several starts one that goes where most do."""
    if len(table.shape) > 1:
        return np.arange(np.prod(table.shape)).reshape((-1, *table.grid))[plane]
    slot, (rows, row) = table.place, table.grid
    found = np.full((rows * table.planes, row), -1)
    width = table[FIELD.MAP_WIDTH].astype(int) if FIELD.MAP_WIDTH in table else np.ones(len(slot), int)
    for i in np.flatnonzero(width > 1):
        r, c = divmod(slot[i], row)
        ends = r + width[i] + (r + width[i] >= found.shape[0] - 1), c + width[i] + (c + width[i] >= row - 1)
        found[r : ends[0], c : ends[1]] = i
    order = np.arange(len(slot))
    if table.has_attractors and table.name != "basin":  # what most starts of the place lead to is put there last
        order = np.lexsort((-order, np.nan_to_num(table.shares, nan=-1.0)))
    found.flat[slot[order]] = order
    return found[plane * rows : (plane + 1) * rows]


def axis_of(values, cover, along):
    """Values along one axis of a grid, those that no point has between their neighbours."""
    if values.ndim > 1:
        plane = values.reshape((-1, *values.shape[-2:]))[0]
        return plane[0] if along == 0 else plane[:, 0]
    count = cover.shape[1] if along == 0 else cover.shape[0]
    known = np.full(count, np.nan)
    rows, columns = np.nonzero(cover >= 0)
    own = cover[rows, columns]
    first = np.unique(own, return_index=True)[1]  # a point lies at the first cell that it stands for
    known[(columns if along == 0 else rows)[first]] = values[own[first]]
    places = np.flatnonzero(np.isfinite(known))
    return np.interp(np.arange(count), places, known[places])


def spread(numbers, cover):
    return np.where(cover >= 0, numbers[cover], np.nan)
