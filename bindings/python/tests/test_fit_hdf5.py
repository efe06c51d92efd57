"""Fits read HDF5 files that h5py wrote, and records of data sets, through the library; what cannot be read is refused
with a sentence."""

import json
import subprocess

import h5py
import numpy as np
import pytest
from conftest import COMMAND
from test_fit import SPRING, TRUTH, bode, check_waveform, waveform

import whirl

#: ways in which h5py stores a dataset
STORED = [
    {},
    {"compression": "gzip", "shuffle": True, "fletcher32": True},
    {"compression": "lzf"},
    {"chunks": (7, 2), "maxshape": (None, None)},
    {"chunks": (7, 1), "maxshape": (None, 3), "compression": "gzip"},
]
HEADINGS = {"time [s]": "run/signals[:, 2]", "disc x [um]": "run/signals[:, 0]", "disc y [um]": "run/signals[:, 1]"}


@pytest.mark.parametrize("version", ["earliest", "latest"])
@pytest.mark.parametrize("how", STORED)
def test_columns_of_a_matrix(tmp_path, version, how):
    time, x, y = waveform()
    with h5py.File(tmp_path / "a.h5", "w", libver=version) as file:
        file.create_dataset("run/signals", data=np.column_stack([x, y, time]), **how)
    check_waveform({"file": tmp_path / "a.h5", "columns": HEADINGS})
    read = whirl.read_measured(tmp_path / "a.h5", HEADINGS)
    assert [list(read[name]) for name in HEADINGS] == [list(time), list(x), list(y)]


def test_units_are_attributes_or_in_headings(tmp_path):
    time, x, y = waveform()
    with h5py.File(tmp_path / "a.h5", "w") as file:
        for name, values, key, unit in (
            ("time", 1e3 * time, "units", "ms"),
            ("disc x", 1e-6 * x, "unit", np.bytes_("m")),
            ("disc y", 1e-3 * y, "unit", "mm"),
        ):
            file[name] = values
            file[name].attrs[key] = unit
    check_waveform(tmp_path / "a.h5")
    # Whole numbers: a converter's counts, whose unit the heading says.
    with h5py.File(tmp_path / "b.h5", "w") as file:
        file["t"], file["x"], file["y"] = time, np.round(1e3 * x).astype("i4"), np.round(1e3 * y).astype(">i4")
    check_waveform({"file": tmp_path / "b.h5", "columns": {"time [s]": "t", "disc x [nm]": "x", "disc y [nm]": "y"}})


def test_vectors_over_the_speed(tmp_path):
    with h5py.File(tmp_path / "bode.h5", "w") as file:
        for heading, values in bode().items():
            file[heading] = values  # a dataset may be named as a heading, with its unit
    found = whirl.fit(SPRING, tmp_path / "bode.h5", ["k", "c", "e"], tolerance=1e-10)
    for name, value in TRUTH.items():
        assert found[name].value == pytest.approx(value, rel=1e-9)


def test_what_cannot_be_read_is_refused(tmp_path):
    time, x, _ = waveform()
    path = tmp_path / "a.h5"
    with h5py.File(path, "w") as file:
        file["time"], file["disc"], file["pair"] = time, x, np.column_stack([x, x])
        file["words"], file["short"], file["cube"] = ["a", "b"], x[:-1], np.zeros((3, 4, 5))
        file["gap"] = np.where(np.arange(80) == 3, np.nan, x)
        file["unit"] = x
        file["unit"].attrs["unit"] = "mm"
        file.create_dataset("zipped", data=x, chunks=(80,), scaleoffset=3)

    def refused(words, **columns):
        headings = {"time [s]": "time", **{k.replace("_", " "): v for k, v in columns.items()}}
        with pytest.raises(whirl.BadInput, match=words):
            whirl.fit(SPRING, {"file": path, "columns": headings}, ["k"], at={"n": "100 rad/s"})

    refused("a.h5 has no dataset 'dics', did you mean 'disc'", **{"disc x [um]": "dics"})
    refused("pair has 80 x 2 numbers, expected a vector, or indices one of which is ':'", **{"disc x [um]": "pair"})
    refused(r"\[:, 2\] are no indices of pair, which has 80 x 2 numbers", **{"disc x [um]": "pair[:, 2]"})
    refused(r"\[0, 1\] are no indices of cube", **{"disc x [um]": "cube[0, 1]"})
    refused("words has texts, expected numbers", **{"disc x [um]": "words"})
    refused("short: it has 79 numbers, and time has 80, expected as many in all", **{"disc x [um]": "short"})
    refused("gap, number 4: it is no number", **{"disc x [um]": "gap"})
    refused("disc: it has no unit, expected an attribute unit, or a heading", **{"disc x": "disc"})
    refused(r"unit: its unit is 'mm', and \[um\] in its heading", **{"disc x [um]": "unit"})
    refused("zipped is compressed by scaleoffset", **{"disc x [um]": "zipped"})
    refused("is a list, expected the path of a dataset", **{"disc x [um]": ["a"]})
    with pytest.raises(whirl.BadInput, match="is no data set, which study: dataset makes"):
        whirl.fit(SPRING, {"file": path, "record": 1}, ["k"])
    (tmp_path / "cut.h5").write_bytes(path.read_bytes()[:-3])
    with pytest.raises(whirl.BadInput, match="cut.h5: is cut off: .* bytes, expected "):
        whirl.fit(SPRING, tmp_path / "cut.h5", ["k"])
    (tmp_path / "no.csv").write_text("time [s], disc x [um]\n0,1\n")
    with pytest.raises(whirl.BadInput, match="record: is given for a table of comma-separated values"):
        whirl.fit(SPRING, {"file": tmp_path / "no.csv", "record": 1}, ["k"])


RECORDS = {
    "parameters": {"n": "100 rad/s", "k": "30 kN/m", "c": "40 N s/m", "e": "50 um"},
    "rotor": {
        "speed": "= n",
        "length_scale": "1 mm",
        "stations": {"disc": {"mass": "3 kg", "damping": "= c", "eccentricity": "= e"}},
        "elements": [{"shaft": {"between": ["disc", "ground"], "k1": "= k"}}],
    },
}


@pytest.mark.parametrize(
    "sampling", [{"samples_per_revolution": 32, "revolutions": 8}, {"rate": "1 kHz", "samples": 400}]
)
def test_a_record_of_a_data_set_is_fitted_at_once(tmp_path, sampling):
    """Unknown parameters are found within what the sensors show; the others are those of the record."""
    dataset = {
        "machines": 2,
        "records": 1,
        **sampling,
        "vary": {"k": "+- 10 %"},
        "conditions": {"n": {"from": "60 rad/s", "to": "140 rad/s"}},
        "labels": {"healthy": None, "unbalance": {"grade": {"e": {"from": "60 um", "to": "90 um"}}}},
        "channels": [
            {"sensor": "proximity", "at": "disc", "sensitivity": "7.87 V/mm", "gap": "1.27 mm"},
            {"sensor": "accelerometer", "at": "disc"},
            {"sensor": "proximity", "at": "disc", "angle": "135 deg"},
        ],
    }
    study = {"dataset": dataset, "integrate": {"transient": 200, "rtol": 1e-11}}
    data = whirl.dataset(whirl.Case({**RECORDS, "study": study}), tmp_path / "records.h5")
    for number in (1, 4):
        row = data.index.iloc[number - 1]
        record = {"file": tmp_path / "records.h5", "record": number}
        found = whirl.fit({**RECORDS, "study": {"response": {}}}, record, ["k", "e"], tolerance=1e-10)
        # Signals are single precision, and the antialias filter is flat to 1e-4.
        assert found["k"].value == pytest.approx(row["k"], rel=2e-4)
        assert found["e"].value == pytest.approx(row["e"], rel=2e-3)
        assert len(found.numbers) == 2 * data.samples
    with pytest.raises(whirl.BadInput, match="has no record 5, but 4 others"):
        whirl.fit({**RECORDS, "study": {"response": {}}}, {"file": tmp_path / "records.h5", "record": 5}, ["k"])
    with pytest.raises(whirl.BadInput, match="is a result of whirl, expected `record`, or `columns`"):
        whirl.fit({**RECORDS, "study": {"response": {}}}, tmp_path / "records.h5", ["k"])


RUBS = """
whirl: 1
title: Rubs, as a noisy probe sees them
parameters: {omega: 3000 rpm, gap: 1 mm, k: 4 MN/m, mu: 0.1}
rotor:
  speed: = omega
  length_scale: 0.1 mm
  stations:
    disc: {mass: 30 kg, damping: 600 N s/m, eccentricity: 10 um}
  elements:
    - spring: {between: [disc, ground], stiffness: = k}
    - rub:    {at: disc, gap: = gap, stiffness: 20 MN/m, friction: = mu}
    - gravity: 9.81 m/s2
study:
  dataset:
    machines: 8
    records: 1
    samples_per_revolution: 32
    revolutions: 50
    vary: {k: +- 10 %}
    conditions: {omega: {from: 2500 rpm, to: 3000 rpm}}
    labels:
      rub: {grade: {gap: {from: 65 um, to: 50 um}}, vary: {mu: {from: 0.05, to: 0.2}}}
    channels:
      - {sensor: proximity, at: disc, sensitivity: 7.87 V/mm, gap: 1.27 mm, noise: 5 mV, bits: 16, full_scale: 24 V}
      - {sensor: proximity, at: disc, angle: 90 deg, sensitivity: 7.87 V/mm, gap: 1.27 mm, noise: 5 mV}
  integrate: {transient: 400}
  analyze: [orbit, rub, regime]
"""


def test_gap_and_friction_of_a_rub_are_found(tmp_path):
    """The gap and the friction of records in contact lie within four standard errors of what was found."""
    data = whirl.dataset(whirl.Case(text=RUBS, name="rubs.yaml"), tmp_path / "rubs.h5", progress=False)
    chosen = data.index[(data.index.verdict == "P-1") & (data.index.contact > 0.3)]
    assert len(chosen) >= 3
    for record, row in zip(chosen.record[:3], chosen.itertuples()):
        found = whirl.fit(
            whirl.Case(text=RUBS, name="rubs.yaml"),
            {"file": tmp_path / "rubs.h5", "record": int(record), "noise": "0.64 um"},
            {"gap": ("58 um", "40 um", "90 um"), "mu": (0.01, 0.4)},
        )
        for name in ("gap", "mu"):
            assert abs(found[name].value - getattr(row, name)) < 4.0 * found[name].error, (record, name)
            assert found[name].error < 0.2 * found[name].value


def test_numbers_of_a_result_are_fitted(tmp_path):
    """A sweep's amplitudes, in scales of the case in the file, are those of its machine."""
    study = {"sweep": {"parameter": "n", "from": "60 rad/s", "to": "140 rad/s", "points": 9}, "analyze": ["orbit"]}
    whirl.run(whirl.Case({**RECORDS, "study": study})).save(tmp_path / "sweep.h5")
    columns = {"n": "sweep/values", "disc x": "sweep/orbit/max_radius[:, 0]"}
    found = whirl.fit(
        {**RECORDS, "study": {"response": {}}},
        {"file": tmp_path / "sweep.h5", "columns": columns},
        {"k": (28e3, 35e3), "e": (30e-6, 70e-6)},
    )
    assert found["k"].value == pytest.approx(30e3, rel=1e-4)
    assert found["e"].value == pytest.approx(50e-6, rel=1e-4)


def test_figures_of_a_record_are_those_of_a_table(tmp_path):
    """A coast-down in HDF5 has the figures of the same one in a table."""
    time = np.arange(6001) / 2000
    angle = 2 * np.pi * (30 * time - 4 * time**2)
    columns = {
        "time [s]": time,
        "keyphasor [V]": np.sin(angle),
        "de x [um]": 20 * np.cos(angle),
        "de y [um]": 20 * np.sin(angle),
    }
    np.savetxt(
        tmp_path / "down.csv",
        np.column_stack(list(columns.values())),
        "%.17g",
        ",",
        header=",".join(columns),
        comments="",
    )
    with h5py.File(tmp_path / "down.h5", "w") as file:
        for heading, values in columns.items():
            name, unit = heading.rstrip("]").split(" [")
            file.create_dataset(name, data=values, compression="gzip").attrs["unit"] = unit

    def figure(name):
        done = subprocess.run(
            [COMMAND, "figure", name, "runup-de", "-o", "-"], cwd=tmp_path, check=True, capture_output=True, text=True
        )
        return json.loads(done.stdout.replace(name, ""))

    assert figure("down.h5") == figure("down.csv")
    one, other = (whirl.signals.load(tmp_path / name) for name in ("down.h5", "down.csv"))
    assert one.statements() == other.statements()
