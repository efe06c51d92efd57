#!/bin/bash
# Writes the tables of docs/verification-manual.md:  scripts/verification-table.sh BUILD [TEST...]
#
# Runs the validation tests of the build, all motions of the verdicts included, and shows which test of how many is
# running. With names (test_rub ...) only these run; for the others the last logs in BUILD/verification are used, unless
# they are older than the program. The logs have a line for every number compared,
#     A3 | what | expected | obtained | difference | tolerance
# and the text between `<!-- table A3 -->` and `<!-- end -->` in the manual is replaced by the lines of A3. If a test
# fails, or a log is incomplete or lacks a row of the manual, the script reports that and leaves the manual as it is.
set -euo pipefail
build=${1:-build}
[ $# -eq 0 ] || shift
manual=docs/verification-manual.md
logs=$build/verification
fresh=$(mktemp)
trap 'rm -f "$fresh"' EXIT

say() { echo "verification table: $*" >&2; }

program=$build/tests/validation
if ! [ -x "$program" ]; then
    say "$program is not built (make test)"
    exit 1
fi
mapfile -t tests < <("$program" | LC_ALL=C sort)
for name in "$@"; do
    [[ " ${tests[*]} " == *" $name "* ]] && continue
    say "$program has no tests $name"
    exit 1
done

# ---- the logs

failures=0
fail() {
    say "$*"
    failures=$((failures + 1))
}

show_progress() { # what the lines of the program's log begin with
    local line test=0 of='?'
    while IFS= read -r line; do
        if [[ $line =~ Running\ ([0-9]+)\ test ]]; then
            of=${BASH_REMATCH[1]}
        elif [[ $line == "[ RUN      ] "* ]]; then
            test=$((test + 1))
            echo "$1: test $test of $of, ${line#*] }, after $SECONDS s" >&2
        fi
    done
}

run_test() { # NAME LOG PLACE
    if ! WHIRL_SOAK=1 "$program" "$1" 2>"$2.errors" | tee "$2" | show_progress "$3"; then
        fail "$1 failed:"
        cat "$2.errors" >&2
        rm -f "$2"
    fi
    rm -f "$2.errors"
}

# Checks that a log is complete: as many tests ended as began, and something was compared.
check_log() { # NAME LOG
    local begun ended
    begun=$(sed -nE 's/^\[=+\].* ([0-9]+) test\(s\)\.$/\1/p' "$2" | head -1)
    ended=$(sed -nE 's/^\[=+\].* ([0-9]+) test\(s\) run\.$/\1/p' "$2" | head -1)
    if [ -z "$begun" ] || [ "$begun" != "$ended" ]; then
        fail "$2 ends early: ${ended:-0} of ${begun:-?} tests were run to their end"
    elif ! grep -q ' | ' "$2"; then
        fail "$2 has no row: $1 compared nothing"
    fi
}

mkdir -p "$logs"
place=0
for name in "${tests[@]}"; do
    log=$logs/$name.log
    place=$((place + 1))
    if [ $# -eq 0 ] || [[ " $* " == *" $name "* ]]; then
        run_test "$name" "$log" "$place of ${#tests[@]}, $name"
        [ -e "$log" ] || continue
    elif [ ! -e "$log" ] || [ "$log" -ot "$program" ]; then
        fail "$name has no log of this build: name it, too, or none"
        continue
    fi
    check_log "$name" "$log"
done
[ $failures -eq 0 ] || exit 1

# ---- the manual

for name in "${tests[@]}"; do cat "$logs/$name.log"; done | awk '
    function trim(text) { gsub(/^ +| +$/, "", text); return text }
    function complain(text) { print "verification table: " text > "/dev/stderr"; bad = 1 }
    function write_table(id) {
        print "\n| what | expected | obtained | difference | tolerance |"
        print "|---|---|---|---|---|"
        for (i = 1; i <= count[id]; i++) print rows[id, i]
        print ""
    }
    # A bar inside a quantity (|Q|) has no space on both of its sides.
    FILENAME == "-" {
        n = split($0, part, / \| ?/)
        if (n < 5) next
        id = trim(part[1])
        gsub(/\|/, "\\|", part[2])
        rows[id, ++count[id]] = "| " trim(part[2]) " | " trim(part[3]) " | " trim(part[4]) " | " trim(part[5]) " | " trim(part[6]) " |"
        found[id, trim(part[2])] = 1
        next
    }
    /^<!-- table .* -->$/ {
        print
        table = $3
        written[table] = 1
        if (table in count) write_table(table)
        else complain("nothing was compared for " table)
        next
    }
    /^<!-- end -->$/ { table = "" }
    table == "" { print; next }
    table in count && /^\| / && !/^\| what \| expected / {
        split(substr($0, 3), part, / \| /)
        if (!((table, part[1]) in found))
            complain("no log has this row of table " table ", take it out of the manual if it is no longer compared: " part[1])
    }
    END {
        for (id in count)
            if (!(id in written)) complain("the manual has no table " id)
        exit bad
    }
' - "$manual" >"$fresh"
cat "$fresh" >"$manual"
