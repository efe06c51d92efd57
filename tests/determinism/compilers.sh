#!/bin/bash
# gcc and clang give the same bits:
#   compilers.sh WHIRL SOURCE FOLDER build CC OPENMP TARGET...    compiles what computes the paper's rotor once more with
#       CC, in FOLDER (other/CMakeLists.txt; OPENMP is the library of the build): these targets of it
#   compilers.sh WHIRL SOURCE FOLDER compare ISA    compares the results of both, every number of them, on an instruction set
# Exit status 77 where the processor does not have that.
set -euo pipefail
whirl=$1 source=$2 folder=$3
build=$(dirname "$whirl")
python=$([ -x /usr/bin/python3 ] && echo /usr/bin/python3 || echo python3)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

compile() { # CC OPENMP TARGET...
    cmake -S "$source/tests/determinism/other" -B "$folder" -DCMAKE_C_COMPILER="$1" \
        -DCMAKE_CXX_COMPILER="${1/%gcc/g}++" \
        -DLIBRARY="$build/libwhirl.a" -DHEADERS="$build/include" -DOPENMP="$2" &&
        cmake --build "$folder" --parallel 2 --target "${@:3}"
}
if [ "$4" = build ]; then
    compile "${@:5}" >"$work/log" 2>&1 || { tail -30 "$work/log" && exit 1; }
    exit
fi
export WHIRL_ISA=$5

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
    "$whirl" run "$work/$method.yaml" -q --force -o "$work/one.h5" 2>"$work/log" || {
        grep -q "does not have" "$work/log" && echo "$WHIRL_ISA: not on this processor" && exit 77
        cat "$work/log"
        exit 1
    }
    "$folder/whirl" run "$work/$method.yaml" -q --force -o "$work/other.h5"
    "$python" "$source/tests/cli/same_data.py" "$work/one.h5" "$work/other.h5" >/dev/null
    "$whirl" export "$work/one.h5" --csv "$work/tables" --force >/dev/null
    echo "$WHIRL_ISA, $method: $(cat "$work"/tables/sweep*.csv | sha256sum | cut -c 1-16)"
done
