"""Checks a refined result: check_refined.py RESULT.h5 BUDGET. What was spent is what the points say, and not too much."""
import sys

import h5py

with h5py.File(sys.argv[1]) as result:
    sweep = result["sweep"]
    rounds, spent = sweep["refine/rounds"][:], sweep["refine/revolutions"][:]
    transient, steps = sweep["refine/transient"][:], sweep["refine/steps_per_revolution"][:]
    record, options = sweep.attrs["record"], sweep.attrs
    assert 0 < sum(spent) <= float(sys.argv[2]), sum(spent)
    for i, count in enumerate(rounds):
        if count == 0:
            assert spent[i] == 0 and transient[i] == options["transient"]
            continue
        # Of the last round alone; less where the motion settled or went astray.
        assert sweep["regime/revolutions"][i] <= transient[i] + record
        assert spent[i] >= sweep["regime/revolutions"][i] * steps[i] / options["steps_per_revolution"]
        assert transient[i] > options["transient"] or steps[i] > options["steps_per_revolution"]
    print(f"{sum(rounds > 0)} points refined within the budget")
