#!/bin/bash
# Tests the documentation site:  site.sh ROOT BUILD site | tutorial NAME
#   site      builds without a warning, and every symbol of the headers has a comment; targets of links and pictures
#             exist, and pages load nothing from other computers (tutorials are built without their output)
#   tutorial  the code of docs/tutorials/NAME.md runs, and the claims of its text hold
# Skipped if packages are missing (scripts/install-dependencies.sh docs), but not in continuous integration.
set -euo pipefail
root=$(realpath "$1")
build=$(realpath "$2")

case $3 in
site) needs="sphinx, myst_parser, breathe, furo, nbformat, nbclient" programs="doxygen" ;;
tutorial) needs="nbformat, nbclient, ipykernel, matplotlib, h5py" programs="octave-cli" ;;
esac
missing=$(/usr/bin/python3 -c "import $needs" 2>&1 | tail -n 1)
for program in $programs; do
    command -v "$program" >/dev/null || missing="no $program"
done
if [ -n "$missing" ] && [ -z "${CI:-}" ]; then
    echo "skipped: $missing; 'scripts/install-dependencies.sh docs' installs what is needed"
    exit 77
fi

case $3 in
site)
    "$root/docs/site/build.py" "$build" --without-runs
    "$root/tests/docs/check_site.py" "$build/docs-quick/site"
    ;;
tutorial)
    cd "$root/docs/tutorials"
    "$root/docs/site/tutorials.py" "$build" "./$4.md"
    ;;
esac
