#!/bin/bash
# Runs small threaded studies under the thread sanitizer:  scripts/thread-check.sh BUILD
# LLVM's OpenMP is not instrumented; its tool libarcher tells the sanitizer about forks, joins and locks.
set -euo pipefail
build=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
# The tool is named by its path, since programs have no run path to it.
archer=$(dirname "$(readlink -f "$(command -v clang)")")/../lib/libarcher.so
export OMP_TOOL_LIBRARIES=$archer ARCHER_OPTIONS=verbose=1
export TSAN_OPTIONS="ignore_noninstrumented_modules=1 halt_on_error=1 exitcode=66"

# A race on purpose must be found, else a pass would say nothing.
cat >"$folder/race.c" <<'END'
#include <stdio.h>

int main(void) {
    long sum = 0;
#pragma omp parallel for num_threads(4)
    for (int i = 0; i < 100000; i++) sum += i;
    printf("%ld\n", sum);
    return 0;
}
END
clang -g -O1 -fopenmp -fsanitize=thread "$folder/race.c" -o "$folder/race"
if "$folder/race" >"$folder/log" 2>&1 || ! grep -q 'ThreadSanitizer: data race' "$folder/log"; then
    cat "$folder/log" >&2
    echo "thread check: a race on purpose was not found" >&2
    exit 1
fi

small() { # CASE.yaml: less of the same
    sed -e 's/points: *[0-9]*/points: 16/' -e 's/steps_per_revolution: *[0-9]*/steps_per_revolution: 64/' \
        -e 's/transient: *[0-9]*/transient: 20/g' -e 's/record: *[0-9]*/record: 10/g' \
        -e 's/waveform: *[0-9]*/waveform: 2/' "$1"
}
small cases/jeffcott-rub.yaml >"$folder/jeffcott-rub.yaml"
small cases/rigid-rotor.yaml >"$folder/rigid-rotor.yaml"
# Branches, whose two directions go on threads of their own.
sed 's/to: 3.3, at: .*}/to: 1.7, at: [1.5], switches: 0}/' tests/cli/branch.yaml >"$folder/branch.yaml"
# A machine at rest, whose points are computed on several threads.
cp tests/cli/modes.yaml "$folder/modes.yaml"
# Tori, one after the other on threads of their own.
sed 's/rtol: [^,]*, /rtol: 1e-7, /; s/torus_accuracy: .*}/torus_accuracy: 1e-3, torus_points: 3}/' tests/cli/tori.yaml \
    >"$folder/tori.yaml"

for name in jeffcott-rub rigid-rotor branch modes tori; do
    if ! "$build/whirl" run "$folder/$name.yaml" -o "$folder/$name.h5" --threads 4 >"$folder/log" 2>&1; then
        cat "$folder/log" >&2
        exit 1
    fi
    if ! grep -q 'Archer detected OpenMP application with TSan' "$folder/log"; then
        echo "thread check: libarcher was not loaded" >&2
        exit 1
    fi
done
echo "thread check: no data race in studies of 4 threads"
