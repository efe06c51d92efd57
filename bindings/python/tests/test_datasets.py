"""Tests data sets from Python: signals, the table of records, sets divided by machine, records that are computed
again."""

import csv
import multiprocessing
import pickle

import h5py
import numpy as np
import pytest
from conftest import command

import whirl

CASE = """
whirl: 1
title: Records of a rotor with faults
parameters: {omega: 1 rad/s, e: 0.3 m, gap: 9 m, k: 1 N/m, speed: 0.2 N.s/m}
rotor:
  speed: = omega
  length_scale: 1 m
  stations:
    disc: {mass: 1 kg, damping: = speed, eccentricity: = e}
  elements:
    - shaft:   {between: [disc, ground], k1: = k, k2: = k}
    - rub:     {at: disc, gap: = gap, stiffness: 10 N/m, friction: 0.05}
    - gravity: 0.1 m/s2
study:
  dataset:
    machines: 9
    records: 2
    seed: SEED
    rate: 4 Hz
    samples: 100
    vary: {k: +- 10 %, speed: +- 20 %}
    conditions: {omega: {from: 0.7, to: 1.1}}
    labels:
      healthy:
      rub: {grade: {gap: {from: 0.8, to: 0.3}}}
      loose: {grade: {k: {from: 0.9, to: 0.5}}}
    channels:
      - {sensor: proximity, at: disc, sensitivity: 1 V/m, noise: 10 mV, bits: 16, full_scale: 10 V}
      - {sensor: accelerometer, at: disc, angle: 90 deg}
  integrate: {transient: 50}
  analyze: [orbit, rub, regime]
"""


def case(seed=1):
    return whirl.Case(text=CASE.replace("SEED", str(seed)), name="records.yaml")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("records")
    whirl.dataset(case(), folder / "one.h5", progress=False)
    whirl.dataset(case(2), folder / "two.h5", progress=False)
    return folder


@pytest.fixture(scope="module")
def data(folder):
    return whirl.dataset(folder / "one.h5")


def stored(path):
    with h5py.File(path) as file:
        return file["records/dataset/signals"][()]


def test_files_are_those_of_the_command(folder, tmp_path):
    (tmp_path / "records.yaml").write_text(CASE.replace("SEED", "1"))
    command("run", "records.yaml", "-o", "one.h5", "-q", cwd=tmp_path)
    assert stored(folder / "one.h5").tobytes() == stored(tmp_path / "one.h5").tobytes()
    for name in ("one-records.csv", "one-datasheet.md"):
        assert (folder / name).read_bytes() == (tmp_path / name).read_bytes()


def test_description(data):
    assert len(data) == 54 and data.channels == ["proximity disc 1", "accelerometer disc 2"]
    assert data.units == ["V", "m/s2"] and data.labels == ["healthy", "rub", "loose"]
    assert data.samples == 100 and data.rate == 4.0 and data.samples_per_revolution == 0.0
    assert data.parameters == ["k", "speed", "omega", "gap"]
    assert "54 records of 9 machines, 3 labels, 2 channels of 100 samples" in repr(data)
    assert data.datasheet.startswith("# Records of a rotor with faults")


def test_signals(data, folder):
    every = stored(folder / "one.h5")
    assert data.signals.shape == every.shape and data.signals.dtype == np.float32 and len(data.signals) == 54
    assert np.array_equal(np.asarray(data.signals), every)
    for key in (5, -1, slice(3, 30, 4), slice(None, None, -1), [7, 3, 3, 53, -54], every[:, 0, 0] > 0):
        assert np.array_equal(data.signals[key], every[key]), key
    assert np.array_equal(data.signals[[9, 2], 1, ::3], every[[9, 2], 1, ::3])
    assert np.array_equal(data.signals[4, 0], every[4, 0])
    with pytest.raises(IndexError, match="54 records"):
        data.signals[54]
    with pytest.raises(whirl.BadInput, match="True and False"):
        data.signals[[True, False]]


def test_table_of_records(data, folder):
    frame = data.index
    with open(folder / "one-records.csv", newline="") as file:
        names, *lines = csv.reader(file)
    assert len(frame) == len(lines) == 54 and list(frame.index) == list(range(54))
    assert names.count("speed") == 2  # the speed of the shaft, and a parameter of that name
    where = dict(zip(names[:12], range(12)))
    assert list(frame.label) == [line[where["label"]] for line in lines]
    assert list(frame.seed) == [int(line[where["seed"]]) for line in lines]
    assert np.array_equal(frame["parameter speed"], [float(line[names.index("speed", 12)]) for line in lines])
    assert np.allclose(frame.speed, frame.omega, rtol=1e-15)
    assert frame.severity[frame.label == "healthy"].isna().all()
    rub = frame[frame.label == "rub"]
    assert np.allclose(rub.gap, 0.8 - 0.5 * rub.severity, rtol=1e-14) and (rub.contact > 0).any()
    assert set(frame.confidence) <= {"low", "fair", "high"} and (frame.verdict == "P-1").any()
    assert np.array_equal(data.targets, [data.labels.index(name) for name in frame.label])
    # Machines keep their own parameters, whatever the label.
    healthy = frame[frame.label != "loose"].groupby("machine")
    assert (healthy.k.nunique() == 1).all() and frame[frame.label != "loose"].k.nunique() == 9
    with pytest.raises(KeyError, match="expected one of: record, machine"):
        data.column("nothing")


def test_sets_are_divided_by_machine(data):
    parts = [data.train, data.validation, data.test]
    assert sum(map(len, parts)) == len(data)
    machines = [set(part.column("machine")) for part in parts]
    assert not machines[0] & machines[1] and not machines[0] & machines[2] and not machines[1] & machines[2]
    assert np.array_equal(data.train.signals[2], data.signals[data.train.rows[2]])
    assert list(data.train.index.index) == list(data.train.rows)


def test_select(data):
    frame = data.index
    some = data.select(label=["healthy", "rub"], machine=3)
    assert len(some) == 4 and set(some.column("label")) == {"healthy", "rub"}
    severe = data.select(frame.severity > 0.5)
    assert (severe.index.severity > 0.5).all() and len(severe) == (frame.severity > 0.5).sum()
    assert list(severe.select([2, 0]).rows) == [severe.rows[2], severe.rows[0]]
    assert list(severe.select(-1).rows) == [severe.rows[-1]]


def test_batches(data):
    batches = list(data.train.batches(8))
    assert [len(labels) for _, labels in batches][:-1] == [8] * (len(batches) - 1)
    assert np.array_equal(np.concatenate([signals for signals, _ in batches]), data.train.signals[:])
    assert np.array_equal(np.concatenate([labels for _, labels in batches]), data.train.targets)
    mixed = list(data.batches(8, shuffle=True, seed=3, whole=True))
    assert len(mixed) == 54 // 8
    order = np.random.default_rng(3).permutation(54)
    assert np.array_equal(mixed[1][0], data.signals[order[8:16]])
    assert np.array_equal(mixed[1][1], data.targets[order[8:16]])
    with pytest.raises(whirl.BadInput, match="1 or more"):
        next(data.batches(0))


def fetch(data, rows):
    return data.__getitems__(rows) if hasattr(data, "__getitems__") else [data[i] for i in rows]


def test_protocol_of_pytorch(data):
    """Tests that a data set has what torch.utils.data.DataLoader requires of a map-style data set, also in worker
    processes."""
    assert len(data) == 54
    signals, label = data[20]
    assert signals.shape == (2, 100) and signals.dtype == np.float32 and type(label) is int
    assert data.labels[label] == data.index.label[20]
    assert sum(1 for _ in data) == 54  # iteration ends with IndexError
    rows = [40, 3, 17]
    expected = [(data.signals[i].tobytes(), int(data.targets[i])) for i in rows]
    for start in ("fork", "spawn"):
        with multiprocessing.get_context(start).Pool(1) as pool:
            got = pool.apply(fetch, (data, rows))
        assert [(signals.tobytes(), label) for signals, label in got] == expected
    again = pickle.loads(pickle.dumps(data.test))
    assert np.array_equal(again.signals[0], data.test.signals[0])


def test_fork_reads_with_a_file_of_its_own(data):
    data.signals[0]  # opens the file in this process
    with multiprocessing.get_context("fork").Pool(2) as pool:
        parts = pool.starmap(fetch, [(data, [i]) for i in range(20)])
    assert all(part[0][0].tobytes() == data.signals[i].tobytes() for i, part in enumerate(parts))


@pytest.mark.parametrize("row", [0, 3, 30])
def test_records_are_made_anew(data, row):
    again = data.remake(row)
    assert again.dtype == np.float32 and again.tobytes() == data.signals[row].tobytes()


def test_result_in_memory_has_signals(data):
    result = whirl.run(case(), progress=False)
    table = result["records"]
    assert table["dataset/signals"].dtype == np.float32
    assert np.array_equal(table["dataset/signals"], data.signals[:])
    field = table.fields["dataset/signals"]
    assert field.dimensions == ("channel", "sample") and field.columns == field.singles == 100
    assert not any("signals" in name for name in table.to_pandas())


def test_several_files(data, folder, tmp_path):
    both = whirl.dataset([folder / "one.h5", folder / "two.h5"])
    assert len(both) == 108 and both.column("file").tolist() == [0] * 54 + [1] * 54
    assert len(np.unique(both.column("machine"))) == 18
    other = stored(folder / "two.h5")
    assert np.array_equal(both.signals[[60, 1, 53, 54]], [other[6], data.signals[1], data.signals[53], other[0]])
    assert both.remake(60).tobytes() == other[6].tobytes()
    with pytest.raises(whirl.BadInput, match="record 1 of seed 1 is in .* seed of its own"):
        whirl.dataset([folder / "one.h5", folder / "one.h5"])
    shorter = whirl.Case(text=CASE.replace("SEED", "3").replace("samples: 100", "samples: 60"))
    whirl.dataset(shorter, tmp_path / "short.h5", progress=False)
    with pytest.raises(whirl.BadInput, match="samples 60, expected 100"):
        whirl.dataset([folder / "one.h5", tmp_path / "short.h5"])


def test_errors(folder, good_file, tmp_path):
    with pytest.raises(whirl.BadInput, match="is no data set"):
        whirl.dataset(good_file)
    with pytest.raises(whirl.BadInput, match="expected its name"):
        whirl.dataset(case())
    with pytest.raises(whirl.BadInput, match="no study 'dataset'"):
        whirl.dataset(whirl.Case(text=CASE[: CASE.index("  dataset:")] + "  response: {}\n"), tmp_path / "x.h5")
    with pytest.raises(whirl.ExistingFile):
        whirl.dataset(case(), folder / "one.h5")
    with pytest.raises(whirl.MissingFile):
        whirl.dataset(tmp_path / "none.h5")
    with pytest.raises(whirl.BadInput, match="no file of records"):
        whirl.dataset([])
