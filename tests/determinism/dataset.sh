#!/bin/bash
# Records of a data set: the same bits by any number of threads, in shards that are merged, in a run that was stopped and
# resumed, and of a record that is made alone:  dataset.sh WHIRL
set -euo pipefail
whirl=$(realpath "$1")
tests=$(dirname "$(realpath "$0")")/../cli
python=$([ -x /usr/bin/python3 ] && echo /usr/bin/python3 || echo python3)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

cat >case.yaml <<'END'
whirl: 1
title: Records of rotors with faults
parameters: {omega: 1 rad/s, e: 0.3 m, gap: 9 m, k: 1 N/m, mu: 0.05}
rotor:
  speed: = omega
  length_scale: 1 m
  stations:
    disc: {mass: 1 kg, damping: 0.2 N.s/m, eccentricity: = e}
  elements:
    - shaft:   {between: [disc, ground], k1: = k, k2: = k}
    - rub:     {at: disc, gap: = gap, stiffness: 10 N/m, friction: = mu}
    - gravity: 0.1 m/s2
study:
  dataset:
    machines: 40
    records: 3
    rate: 4 Hz
    samples: 600
    vary: {k: +- 10 %}
    conditions: {omega: {from: 0.7, to: 1.1}}
    labels:
      healthy:
      rub: {grade: {gap: {from: 0.8, to: 0.3}}, vary: {mu: {from: 0.02, to: 0.2}}}
    channels:
      - {sensor: proximity, at: disc, sensitivity: 1 V/m, noise: 10 mV, bits: 16, full_scale: 10 V}
      - {sensor: accelerometer, at: disc, angle: 90 deg}
      - {sensor: keyphasor, jitter: 1 deg}
  integrate: {transient: 100}
END

for threads in 1 2 3 8; do "$whirl" run case.yaml -q --threads $threads -o threads-$threads.h5; done
for shard in 1 2 3; do "$whirl" run case.yaml -q --shard $shard/3 -o shards.h5; done
"$whirl" merge case.yaml -q -o shards.h5
"$tests/stop_midway.sh" INT stopped.h5.journal 100000 "$whirl" run case.yaml -q --threads 1 -o stopped.h5 || [ $? = 3 ]
[ ! -e stopped.h5 ] || [ -e stopped.h5.journal ] || { echo "the run was not stopped" && exit 1; }
"$whirl" run case.yaml -q --resume -o stopped.h5 --force
"$python" "$tests/same_data.py" threads-1.h5 threads-2.h5 threads-3.h5 threads-8.h5 shards.h5 stopped.h5
cmp threads-1-records.csv shards-records.csv
# One record alone, as it is among the others.
"$whirl" run case.yaml -q --set dataset.only=41 -o alone.h5
"$python" - <<'END'
import csv

import h5py

many, alone = (h5py.File(name)["records"] for name in ("threads-1.h5", "alone.h5"))
for name in many["dataset"]:
    assert many["dataset"][name][40:41].tobytes() == alone["dataset"][name][()].tobytes(), name
assert many["dataset/signals"].shape == (240, 3, 600) and many["dataset/signals"].dtype == "float32"
rows = [list(csv.DictReader(open(name, newline=""))) for name in ("threads-1-records.csv", "alone-records.csv")]
assert {**rows[0][40], "row": "0"} == rows[1][0]
# No machine is in two sets.
sets = {}
for row in rows[0]:
    assert sets.setdefault(row["machine"], row["split"]) == row["split"]
assert abs(list(sets.values()).count("train") - 28) <= 1, sets
END

# Records of runs, likewise.
"$python" - <<'END'
text = open("case.yaml").read()
text = text.replace("omega: {from: 0.7, to: 1.1}", "omega: {from: 0.4, to: 0.6}").replace("machines: 40", "machines: 6")
text = text.replace("    labels:", "    runup: {speed_from: = omega, speed_to: 1.5, rate: 0.01, settle: 20}\n    labels:")
open("runs.yaml", "w").write(text.replace("  integrate: {transient: 100}\n", ""))
END
for threads in 1 3; do "$whirl" run runs.yaml -q --threads $threads -o runs-$threads.h5; done
for shard in 1 2; do "$whirl" run runs.yaml -q --shard $shard/2 -o run-shards.h5; done
"$whirl" merge runs.yaml -q -o run-shards.h5
"$tests/stop_midway.sh" INT run-stopped.h5.journal 20000 "$whirl" run runs.yaml -q --threads 1 -o run-stopped.h5 ||
  [ $? = 3 ]
"$whirl" run runs.yaml -q --resume -o run-stopped.h5 --force
"$python" "$tests/same_data.py" runs-1.h5 runs-3.h5 run-shards.h5 run-stopped.h5
cmp runs-1-records.csv run-shards-records.csv
"$whirl" run runs.yaml -q --set dataset.only=9 -o run-alone.h5
"$python" - <<'END'
import h5py

many, alone = (h5py.File(name)["records"] for name in ("runs-1.h5", "run-alone.h5"))
for part in ("dataset", "runup"):
    for name in many[part]:
        assert many[part][name][8:9].tobytes() == alone[part][name][()].tobytes(), name
END
