#!/bin/bash
# The gallery: explorers of the example cases, in BUILD/gallery:  gallery.sh BUILD
# BUILD is a folder as seen from the project's. Needs BUILD/whirl and BUILD/explorer/template.html (make explorer).
set -euo pipefail
cd "$(dirname "$0")/.."
build=$1

[ -f "$build/explorer/template.html" ] || { echo "the gallery needs the explorer's template: make explorer" >&2; exit 1; }
work=$build/gallery
mkdir -p "$work"
for name in paper paper-derived paper-literal jeffcott-rub rigid-rotor overhung-rotor compressor spindle; do
    "$build/whirl" run "cases/$name.yaml" -o "$work/$name.h5" --force -q
    # Only the page is wanted: the exit status tells that no figures were drawn.
    "$build/whirl" report "$work/$name.h5" -o "$work/$name" -q --gnuplot true --explorer "$build/explorer/template.html" \
        2>/dev/null || [ -f "$work/$name/explorer.html" ]
    mv "$work/$name/explorer.html" "$work/$name.html"
    du -h "$work/$name.html"
done
