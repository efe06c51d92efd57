#!/bin/bash
# Which quarter of the long tests runs now:  scripts/quarter.sh [--name | --others | --wide]
#
# The quarters, 1 to 4, take turns with the number of commits (tests/costs.txt says which test is in which). Of what is slow, and
# of units and commands, a third of a quarter runs, the next one four commits later. The variable QUARTER names a quarter that
# runs whole, or all. --others says what ctest -LE leaves out, --wide which instruction set the sanitized build has beside the
# portable ones.
set -euo pipefail
cd "$(dirname "$0")/.."
commits=$(git rev-list --count HEAD 2>/dev/null || echo 0)
quarter=${QUARTER:-$((1 + commits % 4))}
name="quarter $quarter" others="quarter-[^$quarter]" third=$((1 + commits / 4 % 3))
[ -n "${QUARTER:-}" ] || { name+=", third $third" others+="|third-[^$third]"; }
case $quarter in
[1-4]) ;;
all) name="all quarters" others=none ;;
*)
    echo "QUARTER is '$quarter', expected 1, 2, 3, 4 or all" >&2
    exit 2
    ;;
esac
case ${1:---name} in
--name) echo "$name" ;;
--others) echo "$others" ;;
--wide)
    wide=(none fma avx2 avx512 avx512)
    [ "$quarter" = all ] || echo "${wide[$quarter]}"
    ;;
*)
    echo "scripts/quarter.sh: '$1' is unknown, expected --name, --others or --wide" >&2
    exit 2
    ;;
esac
