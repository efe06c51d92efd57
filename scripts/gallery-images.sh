#!/bin/bash
# Draws the pictures of docs/gallery.md from the example cases:  gallery-images.sh [WHIRL]
# WHIRL is the command (build/whirl); the pictures go to docs/images/gallery. Needs gnuplot. Some two minutes.
set -euo pipefail
cd "$(dirname "$0")/.."
whirl=$(realpath "${1:-build/whirl}")
cases=$PWD/cases
images=$PWD/docs/images/gallery
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$images"
cd "$folder"

picture() { # NAME FIGURE: one of the figures of NAME.h5
    "$whirl" report "$1.h5" -o report --quiet 2>/dev/null || [ -f "report/$1/$2.png" ]
    cp "report/$1/$2.png" "$images/$1.png"
}

# Runs a case with another study, whose lines come from standard input.
study() { # CASE NAME
    { sed '/^study:/,$d' "$cases/$1.yaml" && echo "study:" && cat; } >"$2.yaml"
    "$whirl" run "$2.yaml" --quiet
}

sweep() { # NAME STATION
    "$whirl" run "$cases/$1.yaml" --quiet
    picture "$1" "bifurcation-$2"
}

sweep jeffcott-rub disc
sweep rigid-rotor journal
sweep tilting-pad-table disc
sweep eccentric-damper rotor
study overhung-rotor overhung-rotor <<<'  modes: {parameter: omega, from: 500 rpm, to: 9000 rpm, points: 171}'
picture overhung-rotor campbell
study compressor compressor <<<'  unbalance: {parameter: speed, from: 300 rpm, to: 12000 rpm, points: 391}'
picture compressor unbalance-middle
study spindle spindle <<'END'
  modes: {parameter: speed, from: 1000 rpm, to: 15000 rpm, points: 281}
  initial: {pulley: {y: -8}, rear: {y: -6}, front: {y: -6}, wheel: {y: -8}}
END
picture spindle campbell
"$whirl" run "$cases/bearing-fault.yaml" --quiet
picture bearing-fault response-rotor
"$whirl" run "$cases/pump.yaml" --quiet
picture pump unbalance-stage_3-first_worn
# The runs over time, each with one figure.
while read -r case figure; do
    "$whirl" run "$cases/$case.yaml" --quiet -o "$case.h5"
    "$whirl" figure "$case.h5" "$figure" -o "$images/$case.png"
done <<'END'
rub-run-up runup-shaft
sommerfeld runup-shaft
run-up runup-fan
engine-run-up runup-shafts-core
motor-start runup-torques
gear-rattle bifurcation-wheel
END
