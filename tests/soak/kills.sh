#!/bin/bash
# Real kills at random moments:  kills.sh WHIRL GOOD.yaml N
# Runs with many short points are killed by SIGKILL and resumed until they are done, N kills in all. After every kill the
# result, if there is one, can be read, and the journal has at least the points that it had before; at the end the result
# is that of a run without kills.
set -uo pipefail
whirl=$(realpath "$1")
good=$(realpath "$2")
kills=$3
same=$(dirname "$(realpath "$0")")/../cli/same_data.py
python=$([ -x /usr/bin/python3 ] && echo /usr/bin/python3 || echo python3)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
RANDOM=${KILLS_SEED:-$$}
fail() {
    echo "kills: FAILED: $* (seed ${KILLS_SEED:-$$})"
    exit 1
}

sed -e 's/points: 5/points: 2000/' -e 's/, spectrum//' "$good" >plain.yaml
sed -e 's/start: state/start: carry, direction: both/' -e 's/points: 2000/points: 1000/' plain.yaml >carry.yaml
declare -A span
for name in plain carry; do
    # The shortest of three: with other load on the computer kills would come too late.
    for try in 1 2 3; do
        before=$(date +%s%N)
        "$whirl" run $name.yaml -q --force -o whole-$name.h5 || fail "the unperturbed run"
        ms=$((($(date +%s%N) - before) / 1000000))
        if [ $try = 1 ] || [ $ms -lt "${span[$name]}" ]; then span[$name]=$ms; fi
    done
done

done_kills=0 runs=0 known=0
while [ $done_kills -lt "$kills" ]; do
    name=$([ $((RANDOM % 2)) = 0 ] && echo plain || echo carry)
    rm -f ./*.journal result.h5
    known=0
    for (( ; ; )); do
        resume=$([ -e result.h5.journal ] && echo --resume || echo --force)
        "$whirl" run $name.yaml -o result.h5 --threads $((1 + RANDOM % 3)) $resume >/dev/null 2>log &
        job=$!
        # A moment of the whole run, often an early one, at times beyond its end; none once there were enough kills.
        if [ $done_kills -lt "$kills" ]; then
            most=$((RANDOM % 2 ? span[$name] * 5 / 4 : span[$name] / 4))
            ms=$((RANDOM % (most + 2)))
            sleep "$(printf '%d.%03d' $((ms / 1000)) $((ms % 1000)))"
            kill -KILL $job 2>/dev/null
        fi
        { wait $job; } 2>/dev/null
        status=$?
        found=$(sed -n "s/.*journal': \([0-9]*\) of .*/\1/p" log)
        if [ -n "$found" ]; then
            [ "$found" -ge $known ] || fail "$found points are there, there were $known"
            known=$found
        fi
        [ $status = 0 ] && break
        [ $status = 137 ] || fail "exit status $status: $(cat log)"
        done_kills=$((done_kills + 1))
        if [ -e result.h5 ]; then
            "$whirl" export result.h5 --csv tables --force >/dev/null 2>log || fail "the result cannot be read: $(cat log)"
            # Killed between the last rename and the end.
            [ -e result.h5.journal ] || break
        fi
    done
    runs=$((runs + 1))
    "$python" "$same" whole-$name.h5 result.h5 >log 2>&1 || fail "another result: $(cat log)"
    leftovers=$(find . -name 'result.h5.*')
    [ -z "$leftovers" ] || fail "this is left: $leftovers"
done
echo "kills: $done_kills kills in $runs runs, nothing lost"
