#!/bin/bash
# Runs a test in Octave:  run.sh WHIRL SOURCE BUILD TEST.m
# A fresh folder, whirl's functions on Octave's path, figures by gnuplot without a screen. 77: there is no Octave.
set -u
whirl=$(realpath "$1")
source=$(realpath "$2")
build=$(realpath "$3")
test=$(realpath "$4")
gateway=$build/bindings/octave
if ! command -v octave-cli >/dev/null || [ ! -e "$gateway/whirl_mex.mex" ]; then
    echo "there is no octave-cli or no mkoctfile: scripts/install-dependencies.sh octave"
    [ -z "${CI:-}" ] && exit 77
    exit 1
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
PYTHON=$([ -x /usr/bin/python3 ] && echo /usr/bin/python3 || echo python3)
export WHIRL=$whirl CASES=$source/cases TESTS=$source/tests PYTHON HOME=$folder TMPDIR=$folder
LD_LIBRARY_PATH=$(dirname "$whirl") octave-cli --no-init-file --no-history --quiet --path "$gateway" \
    --path "$source/bindings/octave" --path "$source/bindings/octave/examples" "$test" >out 2>&1
status=$?
cat out
[ $status -eq 0 ] && grep -q '^all well$' out || exit 1
mkdir "$folder/after" && [ -z "$(find "$folder" -name 'oct-*' -print -quit)" ] || { echo "temporary files were left"; exit 1; }
if [ -n "${KEEP_FIGURES:-}" ]; then find "$folder" -name "*.png" -exec cp {} "$KEEP_FIGURES" \;; fi
