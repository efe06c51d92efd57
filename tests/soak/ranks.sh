#!/bin/bash
# Ranks of MPI, killed at random moments:  ranks.sh WHIRL CASES N [KIND...]        (by tests/mpi.sh)
# Each run begins a study of another kind by some number of ranks, one of which is killed by SIGKILL, with which mpirun
# kills the others; other numbers of ranks continue it, as a shard or as a whole, N kills in all. In the end ranks
# of some number, or one run, do the rest: the result is that of a run without kills, and nothing else is left.
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
    echo "ranks: FAILED: $* (seed $seed)"
    exit 1
}
kinds=("${@:4}")
. "$(dirname "$tests")/soak/kinds.sh"

done_kills=0 stuck=0
# Gives the exit status of an mpirun. That of Open MPI 4.1 may wait for ever for a rank that was killed; then it is killed,
# too, with what is left of its ranks.
end_of() {
    local job=$1 tenths
    for ((tenths = 0; tenths < 600; tenths++)); do
        kill -0 "$job" 2>/dev/null || break
        sleep 0.1
    done
    if kill -0 "$job" 2>/dev/null; then
        stuck=$((stuck + 1))
        # shellcheck disable=SC2046
        kill -KILL $(pgrep -P "$job") "$job" 2>/dev/null
    fi
    { wait "$job"; } 2>/dev/null
}

# Ranks, one of which is killed in the time of a run, or a little later.
perturb() {
    local count=$((2 + RANDOM % 7)) job status ms=$((RANDOM % (span[$name] + 300))) before=$done_kills victim
    mpirun -n $count "$whirl-mpi" run $name.yaml -q $refine -o result.h5 --threads 1 "$resume" >log 2>&1 &
    job=$!
    # From when the last one has begun.
    while kill -0 $job 2>/dev/null && ! [ -e result.h5.journal.rank-$((count - 1))-of-$count ]; do sleep 0.01; done
    sleep "$(printf '%d.%03d' $((ms / 1000)) $((ms % 1000)))"
    victim=$(pgrep -P $job | shuf -n 1 --random-source=<(yes $RANDOM))
    if [ -n "$victim" ] && kill -KILL "$victim" 2>/dev/null; then done_kills=$((done_kills + 1)); fi
    end_of $job
    status=$?
    case $status in
    0) ;;
    *) [ $done_kills -gt $before ] || fail "exit status $status of $count ranks: $(cat log)" ;;
    esac
}

journals_are_there() { compgen -G 'result.h5.journal*' >/dev/null; }

runs=0
while [ $done_kills -lt "$kills" ] || [ $runs -lt ${#kinds[@]} ]; do
    name=${kinds[$((runs % ${#kinds[@]}))]}
    refine=$([ $name = refined ] && echo --refine=1e5)
    rm -f result.h5* result-records.csv result-datasheet.md
    for again in 1 2; do
        resume=$(journals_are_there && echo --resume || echo --force)
        perturb
        # A shard continues their journals.
        if [ $((RANDOM % 3)) = 0 ] && journals_are_there; then
            "$whirl" run $name.yaml -q $refine -o result.h5 --shard 1/2 --resume >log 2>&1 || fail "a shard of $name: $(cat log)"
        fi
    done
    resume=$(journals_are_there && echo --resume || echo --force)
    count=$((RANDOM % 9))
    if [ $count = 0 ]; then
        "$whirl" run $name.yaml -q $refine -o result.h5 "$resume" >log 2>&1 || fail "$name as a whole: $(cat log)"
    else
        timeout 300 mpirun -n $count "$whirl-mpi" run $name.yaml -q $refine -o result.h5 "$resume" >log 2>&1 ||
            fail "$name by $count ranks: $(cat log)"
    fi
    "$python" "$tests/same_data.py" whole-$name.h5 result.h5 >log 2>&1 || fail "$name has another result: $(cat log)"
    leftovers=$(find . -name 'result.h5.*')
    [ -z "$leftovers" ] || fail "this is left: $leftovers"
    runs=$((runs + 1))
done
echo "ranks: $done_kills kills in $runs runs, nothing lost; mpirun had to be killed, too, $stuck times"
