#!/bin/bash
# Tests that the explorer's units give the numbers of UDUNITS-2 to the bit, and the same error messages:  units.sh BUILD
# Prints a line and exits with status 77 if something that the test needs is missing.
set -euo pipefail
build=$(realpath "$1")
cd "$(dirname "$0")/../../.."

skip() {
    echo "the explorer's units are not tested: $*"
    exit 77
}
command -v node >/dev/null || skip "node is missing (scripts/install-dependencies.sh explorer)"
[ -f "$build/explorer/include/units.inc" ] || skip "the explorer is not built (make explorer)"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sources=(explorer/tests/engine/units_probe.c src/case/values/quantity.c src/case/yaml/{problem,node,tree,source}.c
    src/base/{arena,input,mapped,status}.c src/base/words/{utf8,number_text,name_list,descriptor}.c)
options=(-std=c17 -O1 -ffp-contract=off -D_POSIX_C_SOURCE=200809L -D_XOPEN_SOURCE=700 -Isrc/case/values -Isrc/case/yaml -Isrc/base
    -Isrc/base/words -Iinclude -Isrc/include
    -I"$build/include")
${CC:-cc} "${options[@]}" "${sources[@]}" -o "$work/library" -ludunits2 -lyaml -lm
${CC:-cc} "${options[@]}" -Iexplorer/core/include -I"$build/explorer/include" "${sources[@]}" explorer/core/units.c \
    -o "$work/own" -lyaml -lm

database=/usr/share/xml/udunits
{
    grep -ohE '<(singular|plural|symbol)[^>]*>[^<]*<' $database/udunits2-{base,derived,accepted,common}.xml
    grep -ohE '<(value|name|symbol)[^>]*>[^<]*<' $database/udunits2-prefixes.xml
} | node explorer/tests/engine/units.mjs >"$work/quantities"
for program in library own; do "$work/$program" <"$work/quantities" >"$work/$program.txt"; done
count=$(wc -l <"$work/quantities")
accepted=$(grep -cE ': -?0x' "$work/library.txt")
[ "$count" -gt 50000 ] && [ "$accepted" -gt 10000 ] || { echo "only $accepted of $count quantities mean anything"; exit 1; }
if ! diff "$work/library.txt" "$work/own.txt" >"$work/difference"; then
    head -20 "$work/difference"
    exit 1
fi
echo "$count quantities, $accepted of them with a meaning, are read alike"
