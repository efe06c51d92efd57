#!/bin/bash
# One small run from case to result under valgrind's memcheck:  memcheck.sh WHIRL GOOD.yaml
set -euo pipefail
whirl=$(realpath "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp "$2" "$folder/good.yaml"
cd "$folder"
# One thread: libgomp keeps its pool of threads until the end, which would be reported as a leak.
valgrind --quiet --error-exitcode=9 --leak-check=full --show-leak-kinds=definite --errors-for-leak-kinds=definite \
    "$whirl" run good.yaml --quiet --threads 1 -o good.h5
valgrind --quiet --error-exitcode=9 --leak-check=full --show-leak-kinds=definite --errors-for-leak-kinds=definite \
    "$whirl" export good.h5 --csv tables
