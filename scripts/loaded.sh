#!/bin/bash
# The tests of a build beside other work:  scripts/loaded.sh BUILD RUNS [LOOPS]
# Runs them so many times, the long ones too, with four busy loops beside them. A test that hangs on the clock or on luck
# fails here; each run prints its failures, and the status says whether there were any.
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
