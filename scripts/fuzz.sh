#!/bin/bash
# Fuzzes everything that reads a file of the user's, all targets at once:  scripts/fuzz.sh BUILD SECONDS
# Inputs found on the way stay in BUILD/corpus; inputs that made a target fail are in BUILD/findings. The working tree
# stays as it is.
set -euo pipefail
build=$(realpath "$1")
seconds=$2
cd "$(dirname "$0")/.."
mkdir -p "$build/findings"

fuzz() { # TARGET
    local program=$build/tests/fuzz/fuzz_$1 log=$build/fuzz_$1.log
    mkdir -p "$build/corpus/$1"
    if ! "$program" -max_total_time="$seconds" -max_len=65536 -timeout=120 -rss_limit_mb=2048 -print_final_stats=1 \
        -dict=tests/fuzz/words.dict -artifact_prefix="$build/findings/$1-" \
        "$build/corpus/$1" "tests/fuzz/corpus/$1" cases tests/rotors >"$log" 2>&1; then
        tail -n 60 "$log" >&2
        echo "fuzz: $1 failed; the input is in $build/findings, the log is $log" >&2
        return 1
    fi
    sed -n "s/^stat::number_of_executed_units: */fuzz: nothing found in $1 after this many inputs: /p" "$log"
}

running=()
for target in tests/fuzz/fuzz_*.c; do
    name=$(basename "$target" .c)
    fuzz "${name#fuzz_}" &
    running+=($!)
done
failed=0
for one in "${running[@]}"; do wait "$one" || failed=1; done
exit $failed
