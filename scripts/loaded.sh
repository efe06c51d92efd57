#!/bin/bash
# Runs the tests of a build on a loaded computer:  scripts/loaded.sh BUILD RUNS [LOOPS]
# All tests, long ones too, run RUNS times while LOOPS (4) busy loops run. A test that depends on the clock or on luck
# fails here. Each run prints its failures; the exit status is 1 if there were any.
set -euo pipefail
cd "$(dirname "$0")/.."
build=$1 runs=$2 loops=${3:-4}
trap 'jobs -p | xargs -r kill 2>/dev/null' EXIT
for ((i = 0; i < loops; i++)); do
    while :; do :; done &
done
failed=0
for ((run = 1; run <= runs; run++)); do
    log=$build/loaded-$run.log
    begun=$SECONDS
    ctest --test-dir "$build" -j "$(nproc)" --output-on-failure >"$log" 2>&1 || failed=1
    echo "run $run, $((SECONDS - begun)) s: $(grep -E 'tests passed' "$log" || echo "no summary in $log")"
    sed -n '/The following tests FAILED/,$p' "$log"
done
exit $failed
