"""The points of a refined map have the bits of the whole one, and its squares make up the grid.
check_refined_map.py REFINED.h5 WHOLE.h5"""
import sys

import h5py
import numpy as np

refined_path, whole_path = sys.argv[1:]
with h5py.File(refined_path) as file, h5py.File(whole_path) as other:
    refined, whole = file["map"], other["map"]
    columns, grid = int(refined.attrs["row"]), int(refined.attrs["grid"])
    point = refined["point"][:] - 1
    assert 0 < point.size < grid == whole["values"].size and refined.attrs["points"] == point.size
    for name in whole.attrs["fields"]:
        numbers = whole[name][:].reshape((grid,) + whole[name].shape[2:])
        assert refined[name][:].tobytes() == np.ascontiguousarray(numbers[point]).tobytes(), f"{name} differs"

    # As docs/result-file.md tells a reader: squares first, then points themselves.
    of = np.full((grid // columns, columns), -1)
    width = refined["map/width"][:].astype(int)
    for i in np.flatnonzero(width > 1):
        row, column, w = point[i] // columns, point[i] % columns, width[i]
        last_row, last_column = row + w >= of.shape[0] - 1, column + w >= of.shape[1] - 1
        of[row : row + w + last_row, column : column + w + last_column] = i
    of.flat[point] = np.arange(point.size)
    assert (of >= 0).all()
    labels = [refined[f"regime/{name}"][:][of.ravel()] for name in ("code", "period")]
    wanted = [whole[f"regime/{name}"][:].ravel() for name in ("code", "period")]
    agree = int(np.logical_and(labels[0] == wanted[0], labels[1] == wanted[1]).sum())
    assert agree >= 0.97 * grid, f"{agree} of {grid} labels agree"
print(f"{point.size} of {grid} points have the same bits; {agree} of {grid} labels agree")
