#!/bin/bash
# What a kill costs where points take long:  long_points.sh WHIRL GOOD.yaml KILLS
# A run with few long points, motions or one run-up, is killed again and again after 7 to 16 seconds and resumed. The
# result is that of an unperturbed run, and every kill has cost 10 seconds of work at most.
set -uo pipefail
whirl=$(realpath "$1")
good=$(realpath "$2")
fan=$(dirname "$(realpath "$0")")/../../cases/run-up.yaml
kills=$3
same=$(dirname "$(realpath "$0")")/../cli/same_data.py
python=$([ -x /usr/bin/python3 ] && echo /usr/bin/python3 || echo python3)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
fail() {
    echo "long points: FAILED: $*"
    exit 1
}
# Seconds of processor time of all children so far. `times` must not run in a shell of its own, which has no children.
measure() {
    times >times
    worked=$(tr ms '  ' <times | awk 'NR == 2 {print 60 * ($1 + $3) + $2 + $4}')
}

# Cases whose points are of that length: revolutions of a transient, seconds of a run-up.
motions() { sed "s/transient: 20, record: 10/transient: $1, record: 1000, settle: no/" "$good"; }
run_up() { sed "s/duration: .*/duration: $1 s/" "$fan"; }

# The unperturbed run of a case ($1) of a length ($2); $whole seconds of work.
unperturbed() {
    $1 "$2" >long.yaml
    measure
    before=$worked
    "$whirl" run long.yaml -q --threads 1 --force -o whole.h5 || fail "the unperturbed run"
    measure
    whole=$(awk "BEGIN {print $worked - $before}")
}

# Kills a case ($1), which is about as long as all kills together; $2: the length of a first try.
kill_often() {
    unperturbed "$1" "$2"
    unperturbed "$1" "$(awk "BEGIN {printf \"%d\", $2 * 6 * ($kills + 2) / $whole}")"
    rm -f result.h5
    measure
    before=$worked
    for ((i = 0; i < kills; ++i)); do
        resume=$([ -e result.h5.journal ] && echo --resume)
        "$whirl" run long.yaml -q --threads 1 --force -o result.h5 $resume 2>/dev/null &
        job=$!
        sleep $((7 + RANDOM % 10))
        kill -KILL $job 2>/dev/null
        { wait $job; } 2>/dev/null
        [ -e result.h5.journal ] || break
    done
    [ -e result.h5 ] || "$whirl" run long.yaml -q --threads 1 -o result.h5 --resume || fail "the last run"
    "$python" "$same" whole.h5 result.h5 >log 2>&1 || fail "another result: $(cat log)"
    [ -z "$(find . -name 'result.h5.*')" ] || fail "this is left: $(ls)"
    measure
    lost=$(awk "BEGIN {print ($worked - $before - $whole) / $i}")
    echo "long points, $1: $i kills of a run of $whole s, $lost s of work lost by each"
    awk "BEGIN {exit !($lost < 10)}" || fail "more than 10 s"
}

kill_often motions 100000
kill_often run_up 10
