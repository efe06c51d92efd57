#!/bin/bash
# Samples of tolerances and derivatives by parameters, in motion and at rest: the same bits by any number of threads, in
# shards that are merged, and in a run that was stopped and resumed:  tolerances.sh WHIRL
set -euo pipefail
whirl=$(realpath "$1")
tests=$(dirname "$(realpath "$0")")/../cli
python=$([ -x /usr/bin/python3 ] && echo /usr/bin/python3 || echo python3)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

cat >case.yaml <<'END'
whirl: 1
title: A rotor that rubs, as its drawing allows it
parameters: {omega: 1 rad/s, gap: 1 m, k: 1 N/m, mu: 0.05}
rotor:
  speed: = omega
  length_scale: = gap
  stations:
    disc: {mass: 1 kg, damping: 0.2 N.s/m, eccentricity: 0.9 m}
  elements:
    - shaft:   {between: [disc, ground], k1: = k, k2: = k}
    - rub:     {at: disc, gap: = gap, stiffness: 10 N/m, friction: = mu, law: paper}
    - gravity: 0.1 m/s2
study:
  sweep: {parameter: omega, from: 0.7, to: 1.3, points: 3}
  modes: {parameter: omega, from: 0.1, to: 2, points: 5}
  initial: {disc: {x: 0.1, y: -0.2}}
  integrate: {transient: 40, record: 10, steps_per_revolution: 64}
  tolerances:
    parameters:
      gap: 1 m +- 30 %
      k: {distribution: normal, deviation: 0.05 N/m, from: 0.8 N/m, to: 1.2 N/m}
      mu: +- 50 %
    samples: 64
    indices: yes
  sensitivity: {parameters: [gap, k, mu]}
END

for threads in 1 2 3 8; do "$whirl" run case.yaml -q --threads $threads -o threads-$threads.h5; done
for shard in 1 2 3; do "$whirl" run case.yaml -q --shard $shard/3 -o shards.h5; done
"$whirl" merge case.yaml -q -o shards.h5
# Stopped when the journal has a part of the points.
"$tests/stop_midway.sh" INT stopped.h5.journal 200000 "$whirl" run case.yaml -q --threads 1 -o stopped.h5 || [ $? = 3 ]
[ ! -e stopped.h5 ] || [ -e stopped.h5.journal ] || { echo "the run was not stopped" && exit 1; }
"$whirl" run case.yaml -q --resume -o stopped.h5 --force
"$python" "$tests/same_data.py" threads-1.h5 threads-2.h5 threads-3.h5 threads-8.h5 shards.h5 stopped.h5
# What is found is the same as well.
"$whirl" show threads-1.h5 >one
"$whirl" show stopped.h5 >other
cmp one other
