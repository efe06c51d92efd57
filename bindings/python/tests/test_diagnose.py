"""Tests the claims of examples/diagnose.py: what classifiers learn from the shipped records, and how they mislead."""

import sys

import pytest
from conftest import ROOT

pytest.importorskip("sklearn", reason="scikit-learn is missing (python3-sklearn): the example needs it")


def test_claims(tmp_path, monkeypatch):
    monkeypatch.setattr(sys, "path", [str(ROOT / "examples"), *sys.path])
    import diagnose

    data, taken_for, found = diagnose.study(tmp_path, machines=8, others=3)  # half of what the example computes
    assert len(data) == 64
    same, windows = "other machines of the same kind", "second halves of the same records"
    for name, own in found.items():
        assert own[same] > 0.75, name
        assert own["machines of another kind"] < own[same] - 0.02, name
    assert found["forest"][windows] > found["forest"][same]
    lost = found["regression"]
    assert lost["trained without noise, tested with it"] < lost["trained and tested without noise"] - 0.1
    # A bow and an unbalance both turn with the shaft, so that at one speed they are often confused.
    number = {label: i for i, label in enumerate(data.labels)}
    both = {number["bow"], number["unbalance"]}
    mistaken = [{a, b} for a, b in zip(taken_for["forest"].tolist(), data.targets.tolist()) if a != b]
    assert mistaken.count(both) >= 0.3 * len(mistaken)
