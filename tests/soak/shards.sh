#!/bin/bash
# Shards of changing numbers, killed at random moments:  shards.sh WHIRL CASES N
# Each run begins a study of another kind in shards, two at a time, which are killed by SIGKILL and resumed with other
# numbers of shards, or as a whole, N kills in all. In the end all shards of some number are done and merged: the result
# is that of a run without kills, and nothing else is left.
set -uo pipefail
whirl=$(realpath "$1")
cases=$(realpath "$2")
kills=$3
tests=$(dirname "$(realpath "$0")")/../cli
python=$([ -x /usr/bin/python3 ] && echo /usr/bin/python3 || echo python3)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
seed=${KILLS_SEED:-$$}
RANDOM=$seed
fail() {
    echo "shards: FAILED: $* (seed $seed)"
    exit 1
}

. "$(dirname "$tests")/soak/kinds.sh"

done_kills=0
# A whirl command that is killed within so many milliseconds, if that is not 0; it may be refused where the journal of
# its shard is in use.
try() {
    local most=$1 job status ms
    shift
    "$whirl" "$@" >log-"$BASHPID" 2>&1 &
    job=$!
    if [ "$most" -gt 0 ]; then
        ms=$((RANDOM % most))
        sleep "$(printf '%d.%03d' $((ms / 1000)) $((ms % 1000)))"
        kill -KILL $job 2>/dev/null
    fi
    { wait $job; } 2>/dev/null
    status=$?
    case $status in
    0 | 137) ;;
    3) [ "$1" = merge ] || fail "exit status 3 of $*: $(cat log-"$BASHPID")" ;;
    *) fail "exit status $status of $*: $(cat log-"$BASHPID")" ;;
    esac
    return $status
}

# All shards of a number in turn, two at a time, or the whole where there are none; $1 as that of try.
compute() {
    local most=$1 count=$2 i status
    if [ "$count" = 0 ]; then
        try "$most" run $name.yaml -q $refine -o result.h5 $resume
        return
    fi
    for ((i = 1; i <= count; i += 2)); do
        # Streams of random numbers of their own.
        (RANDOM=$((seed + round * 100 + i)); try "$most" run $name.yaml -q $refine -o result.h5 --threads 1 \
            --shard $i/"$count" --resume) & local first=$!
        status=0
        [ $i = "$count" ] || try "$most" run $name.yaml -q $refine -o result.h5 --threads 1 --shard $((i + 1))/"$count" \
            --resume || status=$?
        [ $status != 137 ] || done_kills=$((done_kills + 1))
        { wait $first; } 2>/dev/null
        status=$?
        [ $status != 1 ] || exit 1
        [ $status != 137 ] || done_kills=$((done_kills + 1))
    done
}

runs=0 round=0
while [ $done_kills -lt "$kills" ] || [ $runs -lt ${#kinds[@]} ]; do
    name=${kinds[$((runs % ${#kinds[@]}))]}
    refine=$([ $name = refined ] && echo --refine=1e5)
    rm -f result.h5* result-records.csv result-datasheet.md
    for again in 1 2 3; do
        round=$((round + 1))
        resume=$(compgen -G 'result.h5.journal*' >/dev/null && echo --resume || echo --force)
        # A kill comes early enough for most shards; a study of one piece is all in one of them.
        compute $((span[$name] / 3 + 20)) $((RANDOM % 9))
        if [ $((RANDOM % 3)) = 0 ] && compgen -G 'result.h5.journal*' >/dev/null; then
            try 100 merge $name.yaml -q $refine -o result.h5
            [ $? != 137 ] || done_kills=$((done_kills + 1))
        fi
    done
    resume=--resume
    if ! compgen -G 'result.h5.journal*' >/dev/null; then resume=--force; rm -f result.h5 result-*; fi
    count=$((1 + RANDOM % 8))
    compute 0 $count
    "$whirl" merge $name.yaml -q $refine -o result.h5 >log 2>&1 || fail "$name in $count shards: $(cat log)"
    "$python" "$tests/same_data.py" whole-$name.h5 result.h5 >log 2>&1 || fail "$name has another result: $(cat log)"
    leftovers=$(find . -name 'result.h5.*')
    [ -z "$leftovers" ] || fail "this is left: $leftovers"
    runs=$((runs + 1))
done
echo "shards: $done_kills kills in $runs runs, nothing lost"
