#!/bin/bash
# The gallery: explorers of the example cases, in BUILD/gallery:  gallery.sh BUILD
# BUILD is a path relative to the project's folder. Needs BUILD/whirl and BUILD/explorer/template.html (make explorer).
set -euo pipefail
cd "$(dirname "$0")/.."
build=$1

[ -f "$build/explorer/template.html" ] || { echo "the gallery needs the explorer's template: make explorer" >&2; exit 1; }
work=$build/gallery
mkdir -p "$work"

page() { # NAME RESULT...
    local name=$1
    shift
    # Only the page is wanted: the exit status is an error because no figures were drawn.
    "$build/whirl" report "$@" -o "$work/$name" -q --gnuplot true --explorer "$build/explorer/template.html" \
        2>/dev/null || [ -f "$work/$name/explorer.html" ]
    mv "$work/$name/explorer.html" "$work/$name.html"
    du -h "$work/$name.html"
}

# Modes and the response to unbalance of a case, whatever its own study is.
linear() { # NAME RANGE [INITIAL]
    local name=$1 range=$2 initial=${3:-} kind
    for kind in modes unbalance; do
        {
            sed '/^study:/,$d' "cases/$name.yaml"
            echo "study:"
            echo "  $kind: {$range}"
            if [ -n "$initial" ]; then echo "  initial: {$initial}"; fi
        } >"$work/$name-$kind.yaml"
        "$build/whirl" run "$work/$name-$kind.yaml" -o "$work/$name-$kind.h5" --force -q
    done
    page "$name-linear" "$work/$name-modes.h5" "$work/$name-unbalance.h5"
}

for name in paper paper-derived paper-literal jeffcott-rub rigid-rotor overhung-rotor compressor spindle bearing-fault \
    magnetic-drop misalignment ross-example pump tilting-pad-table flexible-rotor ring-whirl annular-rub dry-whip \
    eccentric-damper floating-ring paper-map run-up rub-run-up sommerfeld motor-start gear-rattle \
    engine-run-up; do
    "$build/whirl" run "cases/$name.yaml" -o "$work/$name.h5" --force -q
    page "$name" "$work/$name.h5"
done
linear overhung-rotor 'parameter: omega, from: 500 rpm, to: 9000 rpm, points: 171'
linear compressor 'parameter: speed, from: 300 rpm, to: 12000 rpm, points: 391'
# Searches for rest begin near where the balls carry the weight: inside their clearance the machine has no equilibrium.
linear spindle 'parameter: speed, from: 1000 rpm, to: 15000 rpm, points: 281' \
    'pulley: {y: -8}, rear: {y: -6}, front: {y: -6}, wheel: {y: -8}'
