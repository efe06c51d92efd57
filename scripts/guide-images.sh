#!/bin/bash
# Draws the pictures of the user guide from the case that it shows:  guide-images.sh [WHIRL]
# WHIRL is the command (build/whirl); the pictures go to docs/images/guide. Needs gnuplot.
set -euo pipefail
cd "$(dirname "$0")/.."
whirl=$(realpath "${1:-build/whirl}")
root=$PWD
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
awk '/^# tested: rig.yaml/ { inside = 1; next } /^```/ { inside = 0 } inside' "$root"/docs/guide/*.md >rig.yaml
"$whirl" run rig.yaml --quiet
"$whirl" report rig.h5 -o report --quiet 2>/dev/null || [ -f report/rig/bifurcation-disc.png ]
mkdir -p "$root/docs/images/guide"
cp report/rig/bifurcation-disc.png report/rig/omega-8000rpm-disc.png "$root/docs/images/guide"
"$whirl" run "$root/cases/tolerances.yaml" --quiet -o tolerances.h5
"$whirl" figure tolerances.h5 tolerances-largest-response-at-wheel -o "$root/docs/images/guide/tolerances.png" --force
