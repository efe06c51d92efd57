#!/bin/bash
# Which quarter of the long tests runs now:  scripts/quarter.sh [--others | --others-sanitized | --wide]
#
# The quarters, 1 to 4, take turns with the number of commits (tests/costs.txt says which test is in which); the variable
# QUARTER names another one, or all. Prints its number; with --others what ctest -LE leaves out, with --others-sanitized what it
# does under the sanitizers, where a third of the quarter runs, the next one four commits later; with --wide the instruction
# set that the sanitized build has beside the portable ones.
set -euo pipefail
cd "$(dirname "$0")/.."
commits=$(git rev-list --count HEAD 2>/dev/null || echo 0)
quarter=${QUARTER:-$((1 + commits % 4))} third=$((1 + commits / 4 % 3))
case $quarter in
[1-4] | all) ;;
*)
    echo "QUARTER is '$quarter', expected 1, 2, 3, 4 or all" >&2
    exit 2
    ;;
esac
case ${1:-} in
--others) [ "$quarter" = all ] && echo none || echo "quarter-[^$quarter]" ;;
--others-sanitized) [ "$quarter" = all ] && echo none || echo "quarter-[^$quarter]|third-[^$third]" ;;
--wide)
    wide=(none fma avx2 avx512 avx512)
    [ "$quarter" = all ] || echo "${wide[$quarter]}"
    ;;
*) echo "$quarter" ;;
esac
