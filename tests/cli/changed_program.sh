#!/bin/bash
# A program of other sources does not continue the journal of this one:  changed_program.sh WHIRL SOURCE GOOD.yaml
# The hash of the sources depends on every one of them and is part of the program; a program with another hash refuses
# the journal.
set -u
whirl=$(realpath "$1")
source=$(realpath "$2")
good=$(realpath "$3")
stop=$(dirname "$(realpath "$0")")/stop_midway.sh
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
fail() {
    echo "FAILED: $*"
    exit 1
}

hash_of() { # FOLDER
    cmake -DSOURCE="$1" -DHEADER="$folder/header" -P "$source/cmake/build_info.cmake" || fail "the hash of $1"
    sed -n 's/#define BUILD_SOURCES "\(.*\)"/\1/p' header
}
mkdir copy
cp -r "$source/src" "$source/include" "$source/cmake" copy
was=$(hash_of "$source")
grep -q "$was" "$whirl" || fail "the program does not have the hash $was of its sources"
[ "$(hash_of "$folder/copy")" = "$was" ] || fail "the hash is another one in another folder"
for file in src/rotor/elements/films/film_kernel.h src/base/vector.h src/integrate/kernels/rk4_lanes.c include/whirl/engine/system.h cmake/layers.cmake cmake/whirlKernels.cmake; do
    echo >>"copy/$file"
    is=$(hash_of "$folder/copy")
    [ "$is" != "$was" ] || fail "the hash does not see a change of $file"
    was=$is
done

sed -e 's/points: 5/points: 20000/' -e 's/, spectrum//' "$good" >case.yaml
"$stop" KILL out.h5.journal 100000 "$whirl" run case.yaml -q -o out.h5
hash=$(hash_of "$source")
sed "s/$hash/${hash:1}0/" "$whirl" >changed && chmod +x changed
./changed run case.yaml -q -o out.h5 --resume 2>said && fail "a changed program went on"
grep -q "^whirl: out.h5.journal is of another study: sources of whirl was '$hash' and is '${hash:1}0'$" said ||
    fail "the refusal is '$(cat said)'"
[ -s out.h5.journal ] || fail "the journal is gone"
echo "another program does not go on with the journal"
