#!/bin/bash
# Runs a small threaded study under the thread sanitizer:  scripts/thread-check.sh BUILD
# LLVM's OpenMP is not instrumented; its tool libarcher tells the sanitizer about forks, joins and locks.
set -euo pipefail
build=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export OMP_TOOL_LIBRARIES=libarcher.so ARCHER_OPTIONS=verbose=1
export TSAN_OPTIONS="ignore_noninstrumented_modules=1 halt_on_error=1 exitcode=66"
sed -e 's/points: *[0-9]*/points: 16/' -e 's/steps_per_revolution: *[0-9]*/steps_per_revolution: 64/' \
    -e 's/transient: *[0-9]*/transient: 20/g' -e 's/record: *[0-9]*/record: 10/g' -e 's/waveform: *[0-9]*/waveform: 2/' \
    cases/jeffcott-rub.yaml >"$folder/case.yaml"
"$build/whirl" run "$folder/case.yaml" -o "$folder/case.h5" --threads 4 2>"$folder/log" || {
    cat "$folder/log" >&2
    exit 1
}
# Without the tool the sanitizer would see nothing of the threads' order: a pass would mean little.
grep -q 'Archer detected OpenMP application with TSan' "$folder/log" || {
    echo "thread check: libarcher was not loaded" >&2
    exit 1
}
echo "thread check: no data race in a study of 4 threads"
