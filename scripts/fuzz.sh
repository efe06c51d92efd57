#!/bin/bash
# Fuzzes the case reader:  scripts/fuzz.sh BUILD SECONDS
# The corpus is copied first, so that a run leaves the working tree as it was. What made it fail stays in BUILD/findings.
set -euo pipefail
build=$1
seconds=$2
program=$(find "$build" -name fuzz_case -type f -perm -u+x | head -n 1)
[ -n "$program" ] || { echo "fuzz: there is no fuzz_case in $build" >&2; exit 1; }

corpus=$(mktemp -d)
trap 'rm -rf "$corpus"' EXIT
cp -r tests/fuzz/corpus/. "$corpus"
mkdir -p "$build/findings"
log=$build/fuzz.log
if ! "$program" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -max_len=8192 -print_final_stats=1 \
    -artifact_prefix="$build/findings/" "$corpus" >"$log" 2>&1; then
    tail -n 60 "$log" >&2
    echo "fuzz: failed; the input is in $build/findings, the log is $log" >&2
    exit 1
fi
sed -n 's/^stat::number_of_executed_units: */fuzz: nothing found, executions: /p' "$log"
