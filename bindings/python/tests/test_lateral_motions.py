"""Tests motions of the rotor of test_lateral.py against its responses to unbalances by rule."""

import subprocess

import numpy as np
from conftest import COMMAND
from test_lateral import CASE, TRIP

import whirl


def test_motions_with_unbalances_by_rule(tmp_path):
    """Tests that, with linear bearings, motions are the responses times the factor, at every condition."""
    text = CASE.replace("parameters: {{", "parameters: {{k: 20 MN/m, ").replace("{k} MN/m", "= k")
    text += """
  motions:
    - {{name: six, unbalance: unbalance, factor: 6, parameter: omega, values: [5000 rpm, 9000 rpm]}}
    - {{name: own, parameter: omega, values: [5000 rpm]}}
  conditions: {{soft: {{}}, stiff: {{k: 60 MN/m}}}}
  integrate: {{transient: 150, record: 20}}
  analyze: [poincare, regime, orbit, rub, spectrum]
"""
    own = "    - unbalance: {at: end, moment: 30 g.mm}"
    # Widen the gap, since the linear response has no contacts.
    text = text.replace("gap: 0.5 mm", "gap: 5 mm").replace("cxx: 5 kN s/m", "cxx: 60 kN s/m")
    text = text.format(rule=", antinodes_of: 1", unbalances=own, end=1.9, mass=20, trip=TRIP)
    result = whirl.run(whirl.Case(text=text), progress=False)
    for condition in ("soft", "stiff"):
        linear, motions = result["unbalance_" + condition], result["motions_six_" + condition]
        for point, at in ((0, 4), (1, 8)):  # 5000 and 9000 rpm of 1000 to 9000 rpm
            expected = 6 * linear["unbalance/amplitude"][at][:, :2]
            assert np.allclose(motions["spectrum/synchronous"][point][:, :2], expected, rtol=1e-6, atol=1e-12)
    result.save(tmp_path / "r.h5")
    summary = subprocess.run([COMMAND, "show", tmp_path / "r.h5"], capture_output=True, text=True, check=True).stdout
    lines = [line for line in summary.splitlines() if "come back every revolution" in line]
    assert len(lines) == 4
    assert "with unbalances by rule at the antinodes of forward mode 1, 6 times as large" in lines[0]
    assert summary.count("nearest to a wall at middle: ") == 4
    assert summary.count("rub at middle: never touches\n") == 4
    assert summary.count("other motions: not searched for (starts)\n") == 4
    assert "with the machine's own unbalances" in lines[2]
