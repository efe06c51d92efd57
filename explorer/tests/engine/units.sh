#!/bin/bash
# The units of the explorer's page against those of the command: the same numbers to the bit, the same sentences. The page has
# UDUNITS-2 from its source, with the database of that source; the command has the library of this machine:  units.sh BUILD
# Exit status 77, with one line, where something that it needs is missing.
set -euo pipefail
build=$(realpath "$1")
cd "$(dirname "$0")/../../.."

skip() {
    echo "the explorer's units are not tested: $*"
    exit 77
}
command -v node >/dev/null || skip "node is missing (scripts/install-dependencies.sh explorer)"
command -v emcc >/dev/null || skip "emscripten is missing (scripts/install-dependencies.sh explorer)"
objects=$build/explorer/objects
[ -f "$objects/core/unit_files.o" ] || skip "the explorer is not built (make explorer)"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sources=(explorer/tests/engine/units_probe.c src/case/{quantity,problem,tree,node,arena,source}.c src/base/{utf8,status,descriptor}.c)
options=(-std=c17 -O1 -ffp-contract=off -D_POSIX_C_SOURCE=200809L -D_XOPEN_SOURCE=700 -Isrc/case -Isrc/base -Iinclude)
${CC:-cc} "${options[@]}" -I"$build/include" "${sources[@]}" -o "$work/library" -ludunits2 -lyaml -lm
# What the page is linked of.
emcc "${options[@]}" explorer/tests/engine/units_probe.c "$objects"/case/{quantity,problem,tree,node,arena,source}.o \
    "$objects"/base/{utf8,status,descriptor}.o "$objects"/{udunits,expat,yaml}/*.o "$objects/core/unit_files.o" \
    -sNODERAWFS -sSINGLE_FILE -sENVIRONMENT=node -o "$work/page.cjs"
printf '#!/bin/sh\nexec node "%s/page.cjs"\n' "$work" >"$work/page"
chmod +x "$work/page"

database=/usr/share/xml/udunits
{
    grep -ohE '<(singular|plural|symbol)[^>]*>[^<]*<' $database/udunits2-{base,derived,accepted,common}.xml
    grep -ohE '<(value|name|symbol)[^>]*>[^<]*<' $database/udunits2-prefixes.xml
} | node explorer/tests/engine/units.mjs >"$work/quantities"
for program in library page; do "$work/$program" <"$work/quantities" >"$work/$program.txt"; done
count=$(wc -l <"$work/quantities")
accepted=$(grep -cE ': -?0x' "$work/library.txt")
[ "$count" -gt 50000 ] && [ "$accepted" -gt 10000 ] || { echo "only $accepted of $count quantities mean anything"; exit 1; }
if ! diff "$work/library.txt" "$work/page.txt" >"$work/difference"; then
    head -20 "$work/difference"
    exit 1
fi
echo "$count quantities, $accepted of them with a meaning, are read alike"
