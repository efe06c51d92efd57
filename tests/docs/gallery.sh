#!/bin/bash
# Checks that `make gallery` builds the page of every case of docs/gallery.md, and every page that documents name:
#   gallery.sh ROOT
set -euo pipefail
cd "$1"
built=$(
    sed -n '/^for name in/,/do$/p' scripts/gallery.sh | tr -s '\\; \n' '\n'
    sed -n 's/^linear \([a-z-]*\) .*/\1-linear/p' scripts/gallery.sh
)
named=$(
    grep -oh 'cases/[a-z-]*\.yaml' docs/gallery.md
    grep -oh 'build/gallery/[a-z-]*\.html' README.md docs/*.md docs/guide/*.md
)
for page in $named; do
    name=$(basename "${page%.*}")
    grep -qx -- "$name" <<<"$built" || { echo "make gallery builds no $name.html, which the documents name"; exit 1; }
done
[ "$(wc -w <<<"$named")" -ge 15 ] || { echo "only these pages are named: $named"; exit 1; }
