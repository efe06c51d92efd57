"""Tests the shipped data sets: compared with the healthy records of the same machine, every fault has the symptoms
known from diagnosis (Bently and Hatch, Fundamentals of Rotating Machinery Diagnostics, 2002; ISO 13373-3)."""

import numpy as np
import pytest
from conftest import ROOT

import whirl


class Shown:
    """Records of a shipped case with fewer machines; its methods return amplitudes of lines by label and channel."""

    def __init__(self, name, machines, folder):
        case = whirl.Case(ROOT / "cases" / f"{name}.yaml")
        case.set("dataset.machines", machines)
        self.data = whirl.dataset(case, folder / f"{name}.h5", progress=False)

    def signals(self, label, channel):
        return self.data.select(label=label).signals[:, self.data.channels.index(channel)].astype(float)

    def spectra(self, label, channel):
        signals = self.signals(label, channel)
        window = np.hanning(signals.shape[1])
        centred = signals - signals.mean(1, keepdims=True)
        return np.abs(np.fft.rfft(centred * window)) * 2 / window.sum()

    def line(self, label, channel, order):
        """Returns the amplitudes of all records at a whole order."""
        return self.spectra(label, channel)[:, order * self.turns()]

    def turns(self):
        return round(self.data.samples / self.data.samples_per_revolution)

    def growth(self, label, channel, order):
        """Returns the least ratio, over the machines, of a line to that of the healthy machine."""
        return np.min(self.line(label, channel, order) / self.line("healthy", channel, order))

    def below(self, label, channel):
        """Returns orders and amplitudes, over those of 1X, of the strongest lines from 0.3 to 0.7 times the speed."""
        spectra, turns = self.spectra(label, channel), self.turns()
        first = int(0.3 * turns)
        found = first + np.argmax(spectra[:, first : int(0.7 * turns)], axis=1)
        return found / turns, spectra[np.arange(len(spectra)), found] / spectra[:, turns]


@pytest.fixture(scope="module")
def rotor(tmp_path_factory):
    return Shown("fault-records", 2, tmp_path_factory.mktemp("rotor"))


@pytest.fixture(scope="module")
def line_of_shafts(tmp_path_factory):
    return Shown("misalignment-records", 1, tmp_path_factory.mktemp("shafts"))


def test_unbalance_and_bow_turn_with_the_shaft(rotor, line_of_shafts):
    assert rotor.growth("unbalance", "left 45", 1) > 1.5 and rotor.growth("bow", "left 45", 1) > 1.5
    assert line_of_shafts.growth("bow", "inner 45", 1) > 1.5


def test_crack_shows_at_multiples_and_not_at_the_speed(rotor):
    assert rotor.growth("crack", "right 45", 3) > 3
    assert rotor.growth("crack", "pedestal", 2) > 2.5
    assert 0.8 < rotor.growth("crack", "right 45", 1) < 1.5


def test_loose_seat_rattles(rotor):
    """Tests that a loose bearing seat, which lifts off and hits its support, excites all multiples of the speed."""
    for order in (3, 5, 7, 9):
        assert rotor.growth("looseness", "pedestal", order) > 4, order


def test_rub_shows_at_multiples(rotor):
    assert rotor.growth("rub", "pedestal", 3) > 3
    assert np.all(rotor.data.select(label="rub").column("contact") > 0)


def test_blades_touch_once_each(rotor):
    """Tests 7 blades, one of them longer: the largest multiple of the speed is twice that of the healthy machine."""
    healthy = rotor.spectra("healthy", "pedestal")[:, 2 * rotor.turns() :: rotor.turns()]
    blades = rotor.spectra("blade rub", "pedestal")[:, 2 * rotor.turns() :: rotor.turns()]
    assert np.all(blades.max(1) > 2 * healthy.max(1))
    assert np.all(rotor.data.select(label="blade rub").column("contact") > 0)


def test_unloaded_bearing_whirls_at_half_the_speed(rotor):
    order, amplitude = rotor.below("film whirl", "left 45")
    assert np.all((order > 0.45) & (order < 0.51)) and np.all(amplitude > 10)
    assert np.all(rotor.below("healthy", "left 45")[1] < 0.1)


def test_misalignment_in_three_senses(line_of_shafts):
    own = line_of_shafts
    # Offset shafts: a constant load moves the shaft in its bearing, and changes the 1X line by less than half.
    shift = own.signals("off line", "inner 45").mean(1) - own.signals("healthy", "inner 45").mean(1)
    assert np.all(np.abs(shift) > 4e-3)  # V; the noise is 5 mV in each of 2048 samples
    assert 0.5 < own.growth("off line", "inner 45", 1) < 1.5
    # A coupling face out of square excites 1X, a universal joint at an angle 2X.
    assert own.growth("face", "front", 1) > 5 and own.growth("face", "front", 2) < 3
    assert own.growth("angle", "front", 2) > 20 and 0.9 < own.growth("angle", "inner 45", 1) < 1.1


def test_seal_whirls_beyond_its_threshold(tmp_path):
    own = Shown("whirl-records", 8, tmp_path)
    severity = own.data.select(label="seal whirl").column("severity")
    order, amplitude = own.below("seal whirl", "left 45")
    assert np.all(amplitude[severity > 0.6] > 1) and np.all(amplitude[severity < 0.15] < 0.1)
    assert np.all((order > 0.4) & (order < 0.55) | (amplitude < 0.1))
    assert (severity > 0.6).any() and (severity < 0.15).any()
