#!/bin/bash
# gcc and clang give the same bits: compares the results of a release and of a build by the other compiler, every number of
# them, on an instruction set:
#   compilers.sh WHIRL OTHER_WHIRL SOURCE ISA
# Exit status 77 where a program is missing, or where the processor or one of them does not have the instruction set.
set -euo pipefail
whirl=$1 other=$2 source=$3
export WHIRL_ISA=$4
[ -x "$whirl" ] || { echo "$whirl is not built" && exit 77; }
python=$([ -x /usr/bin/python3 ] && echo /usr/bin/python3 || echo python3)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

compute() { # PROGRAM CASE RESULT
    "$1" run "$work/$2.yaml" -q --force -o "$work/$3" 2>"$work/log" || {
        grep -q "does not have" "$work/log" && echo "$WHIRL_ISA: not in $1 on this processor" && exit 77
        cat "$work/log"
        exit 1
    }
}

# The paper's rotor, of which the sweep has periodic, quasi-periodic and chaotic motions with and without rub.
sed -e 's/points: 512/points: 24/' -e 's/transient: 1100/transient: 60/' -e 's/record: 100/record: 20/' \
    -e 's/steps_per_revolution: 1024/steps_per_revolution: 256/' "$source/bench/t1.yaml" >"$work/short.yaml"
# All exponents by rk4 only: by the others they would take the motions out of their lanes.
sed -e 's/orbit, rub/orbit, rub, exponents/' "$work/short.yaml" >"$work/rk4.yaml"
sed -e 's/method: rk4/method: dop853/' -e 's/points: 24/points: 6/' "$work/short.yaml" >"$work/dop853.yaml"
sed -e 's/method: rk4/method: rodas5p/' -e 's/points: 24/points: 3/' "$work/short.yaml" >"$work/rodas5p.yaml"
# A shaft of finite elements, reduced.
sed -e 's/points: 16/points: 10/' -e 's/transient: 100, record: 64/transient: 5, record: 5/' \
    "$source/bench/overhung.yaml" >"$work/shaft.yaml"
for method in rk4 dop853 rodas5p shaft; do
    compute "$whirl" $method one.h5
    compute "$other" $method other.h5
    "$python" "$source/tests/cli/same_data.py" "$work/one.h5" "$work/other.h5" >/dev/null
    "$whirl" export "$work/one.h5" --csv "$work/tables" --force >/dev/null
    echo "$WHIRL_ISA, $method: $(cat "$work"/tables/sweep*.csv | sha256sum | cut -c 1-16)"
done
