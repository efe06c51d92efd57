#!/bin/bash
# tests/long.txt names existing tests, each once:  long.sh ROOT BUILD
# Where a tool is missing so are its tests; in continuous integration none may be.
set -euo pipefail
listed=$(grep -v '^#' "$1/tests/long.txt" | awk '{ print $1 }' | sort)
there=$(ctest --test-dir "$2" -N | sed -nE 's/^ *Test +#[0-9]+: //p' | sort)
twice=$(uniq -d <<<"$listed")
gone=$(comm -23 <(uniq <<<"$listed") <(echo "$there"))
[ -z "$twice" ] || echo "tests/long.txt has twice: $twice"
[ -z "$gone" ] || echo "tests/long.txt knows tests that are not here: $gone"
[ -z "$twice" ] && { [ -z "$gone" ] || [ -z "${CI:-}" ]; }
