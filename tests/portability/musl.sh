#!/bin/bash
# The core (rotors, integrators, linear analyses, orbits, analyses: C without files, threads or processes) compiles
# against musl, warnings being errors, and a program that is linked with it statically computes what it should:
#   musl.sh ROOT BUILD compile LAYER...    compiles layers, into BUILD/musl
#   musl.sh ROOT BUILD run                 links what was compiled, and runs it
# What needs libraries that are there for glibc alone stays out: C++ (matrix.cc), SUNDIALS, OpenMP and all that reads and
# writes files (docs/portability.md).
set -euo pipefail
root=$(realpath "$1")
build=$(realpath "$2")
if ! command -v musl-gcc >/dev/null; then
    echo "musl-gcc is missing (package musl-tools)${CI:-: skipped}"
    [ -z "${CI:-}" ] && exit 77
    exit 1
fi
mkdir -p "$build/musl"
cd "$build/musl"

compile() { # SOURCE INSTRUCTIONS [LAYER]
    local layer=${1#"$root/src/"}
    layer=${3:-${layer%%/*}}
    local rooms=("$root/src/base"/*/ "$root/src/$layer"/*/)
    musl-gcc -std=c17 -O1 -D_POSIX_C_SOURCE=200809L -D_XOPEN_SOURCE=700 -DWHIRL_PORTABLE -DVECTOR_ISA="$2" \
        -ffp-contract=off -fno-math-errno -fno-trapping-math -Wall -Wextra -Werror -I"$root/include" \
        -I"$build/include" -I"$root/src/base" -I"$root/src/$layer" "${rooms[@]/#/-I}" -c "$1" -o "$(tr / _ <<<"$1")_$2.o"
}
export -f compile
export root build
if [ "$3" = compile ]; then
    for layer in "${@:4}"; do
        rm -f ./*_src_"$layer"_*.o
        find "$root/src/$layer" -name '*.c' -not -path '*/kernels/*' -not -path '*/elements/*' -printf 'compile %p 0\n'
        find "$root/src/$layer" -name '*.c' \( -path '*/kernels/*' -o -path '*/elements/*' \) \
            -printf 'compile %p 0\ncompile %p 1\n'
        [ $layer != integrate ] || echo "compile $root/explorer/core/no_cvode.c 0 integrate"
    done | grep -v '/cvode.c ' | tr '\n' '\0' | xargs -0 -P "$(nproc)" -I {} bash -c '{}'
    exit
fi
rm -f libcore.a
ar rcs libcore.a ./*.o
musl-gcc -std=c17 -static -I"$root/include" -I"$build/include" "$root/tests/portability/core.c" -L. -lcore -lm -o core
file=$(readelf -d core 2>&1 || true)
if grep -q NEEDED <<<"$file"; then echo "the program is not static"; exit 1; fi
./core
echo "$(find . -name '*.o' | wc -l) files were compiled against musl"
