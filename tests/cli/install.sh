#!/bin/bash
# Installs into a fresh prefix, moves it, and builds and runs a program against it in every way that is offered:
#   install.sh BUILD
set -euo pipefail
build=$(realpath "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
cmake --install "$build" --prefix "$folder/first" >printed
# Parts that are not installed are listed, and no others.
for part in "bindings/octave/whirl_mex.mex Octave's gateway" "whirl-mpi whirl-mpi" "explorer/template.html the explorer's page"; do
    said=no there=no
    grep -q "Not installed: ${part#* }" printed && said=yes
    [ -e "$build/${part%% *}" ] && there=yes
    [ $said != $there ] || { echo "${part#* }: built: $there, said to be left out: $said"; exit 1; }
done
mv first prefix # nothing may hang on where it was put first
prefix=$folder/prefix

for file in bin/whirl include/whirl/whirl.h include/whirl/engine/case.h include/whirl/version.h share/man/man1/whirl.1 \
    share/bash-completion/completions/whirl share/whirl/cases/paper.yaml; do
    [ -e "$prefix/$file" ] || { echo "not installed: $file"; exit 1; }
done
library=$(dirname "$(find "$prefix" -name libwhirl.so)")
[ -e "$library/libwhirl.a" ] || { echo "not installed: libwhirl.a"; exit 1; }
"$prefix/bin/whirl" check "$prefix/share/whirl/cases/rigid-rotor.yaml" >/dev/null
if [ -e "$build/whirl-mpi" ]; then "$prefix/bin/whirl-mpi" --version >/dev/null; fi

cat >program.c <<'END'
#include <stdio.h>
#include <whirl/engine.h>

/* F0 = 1, journal at rest at e = 0.5: the film's force by Capone's formula. */
int main(void) {
    double force[2];
    whirl_film_force(0.5, 0.0, 0.0, 0.0, force);
    printf("%s %.6f %.6f %zu\n", WHIRL_VERSION, force[0], force[1], whirl_station_keys()->key_count);
    return 0;
}
END
# The numbers are those of case A2 of the validation manual.
expect() {
    case $("${@:2}") in
    *" -1.777778 2.418399 "*) echo "$1: good" ;;
    *) echo "$1: the program printed something else"; exit 1 ;;
    esac
}

export PKG_CONFIG_PATH=$library/pkgconfig
read -r -a flags < <(pkg-config --cflags --libs whirl)
cc -std=c17 -Wall -Werror program.c -o shared "${flags[@]}"
expect "pkg-config, shared" env LD_LIBRARY_PATH="$library" ./shared

read -r -a flags < <(pkg-config --static --cflags --libs whirl | sed "s,-lwhirl,$library/libwhirl.a,")
cc -std=c17 -Wall -Werror program.c -o static "${flags[@]}"
expect "pkg-config, static" ./static

cat >CMakeLists.txt <<'END'
cmake_minimum_required(VERSION 3.25)
project(consumer C)
find_package(whirl 0.2 REQUIRED COMPONENTS static)
add_executable(with_shared program.c)
target_link_libraries(with_shared PRIVATE whirl::whirl)
add_executable(with_static program.c)
target_link_libraries(with_static PRIVATE whirl::whirl_static)
END
if ! { cmake -S . -B consumer -DCMAKE_PREFIX_PATH="$prefix" && cmake --build consumer; } >log 2>&1; then
    cat log
    exit 1
fi
expect "find_package, shared" consumer/with_shared
expect "find_package, static" consumer/with_static

# The static library has to be asked for, and CMake says so.
mkdir without
cp program.c without
sed 's/ COMPONENTS static//' CMakeLists.txt >without/CMakeLists.txt
if cmake -S without -B without/build -DCMAKE_PREFIX_PATH="$prefix" >log 2>&1; then
    echo "find_package without COMPONENTS static gives whirl::whirl_static: mend the guide"
    exit 1
fi
tr -s ' \n' ' ' <log | grep -qE 'whirl::whirl_static .*not found|target was not found' || { cat log; exit 1; }
echo "find_package, static not asked for: refused"
