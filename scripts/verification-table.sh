#!/bin/bash
# Writes the tables of docs/verification-manual.md:  scripts/verification-table.sh BUILD
# Runs the validation programs of the build, all motions of the verdicts included. Their logs have a line for every number compared,
#     A3 | what | expected | obtained | difference | tolerance
# and what stands between `<!-- table A3 -->` and `<!-- end -->` in the manual is replaced by the lines of A3.
set -euo pipefail
build=${1:-build}
manual=docs/verification-manual.md
log=$(mktemp) fresh=$(mktemp)
trap 'rm -f "$log" "$fresh"' EXIT

status=0
export WHIRL_SOAK=1
for program in "$build"/tests/validation_test_*; do
    [ -x "$program" ] || continue
    echo "running $(basename "$program")" >&2
    "$program" >>"$log" || status=1
done
if ! grep -q ' | ' "$log"; then
    echo "verification table: no validation program was found in $build/tests" >&2
    exit 1
fi

awk -v log_file="$log" '
    function write_table(id) {
        print "\n| what | expected | obtained | difference | tolerance |"
        print "|---|---|---|---|---|"
        for (i = 1; i <= count[id]; i++) print rows[id, i]
        print ""
    }
    function trim(text) { gsub(/^ +| +$/, "", text); return text }
    BEGIN {
        # A bar inside a quantity (|Q|) has no space on both of its sides.
        while ((getline line < log_file) > 0) {
            n = split(line, part, / \| ?/)
            if (n < 5) continue
            id = trim(part[1])
            gsub(/\|/, "\\|", part[2])
            rows[id, ++count[id]] = "| " trim(part[2]) " | " trim(part[3]) " | " trim(part[4]) " | " trim(part[5]) " | " trim(part[6]) " |"
        }
    }
    /^<!-- table .* -->$/ {
        print
        if (!($3 in count)) { print "verification table: nothing was compared for " $3 > "/dev/stderr"; exit 1 }
        write_table($3)
        skipping = 1
        next
    }
    /^<!-- end -->$/ { skipping = 0 }
    !skipping
' "$manual" >"$fresh"
cat "$fresh" >"$manual"
if [ $status -ne 0 ]; then
    echo "verification table: a comparison failed" >&2
fi
exit $status
