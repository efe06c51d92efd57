#!/bin/bash
# Runs the phases of a proof of the project, and shows the time that each took:
#
#   scripts/phase.sh --begin            forgets earlier phases
#   scripts/phase.sh NAME COMMAND...    runs the command and notes its time; if it fails, prints the table
#   scripts/phase.sh --table            prints the phases so far, and the ten slowest tests of the last run of each build
#
# Notes are in the file $PHASES.
set -euo pipefail
phases=${PHASES:?}

print_table() {
    printf '\n%-44s %10s %10s\n' "phase" "clock s" "CPU s"
    awk -F '\t' '{ printf "%-44s %10.0f %10.0f\n", $1, $2, $3; clock += $2; spent += $3 }
                 END { printf "%-44s %10.0f %10.0f\n", "all", clock, spent }' "$phases"
    local log
    for log in "$(dirname "$phases")"/{,sanitize/}Testing/Temporary/LastTest.log; do
        [ "$log" -nt "$phases.begun" ] || continue
        printf '\n%-44s %10s\n' "slowest tests of $(dirname "${log%/Testing/*}/.")" "clock s"
        awk '/^[0-9]+\/[0-9]+ Test: / { name = $3 } /^Test time = / { print $4, name }' "$log" | sort -rn |
            awk 'NR <= 10 { printf "%-44s %10.1f\n", $2, $1 }'
    done
}

case $1 in
--begin)
    mkdir -p "$(dirname "$phases")"
    : >"$phases"
    touch "$phases.begun"
    exit
    ;;
--table)
    print_table
    exit
    ;;
esac
name=$1
shift
status=0
exec 3>&1 4>&2
TIMEFORMAT='%R %U %S'
spent=$({ time "$@" >&3 2>&4; } 2>&1) || status=$?
read -r clock user system <<<"$spent"
printf '%s\t%s\t%s\n' "$name" "$clock" "$(awk "BEGIN { print $user + $system }")" >>"$phases"
if [ $status -ne 0 ]; then
    print_table
    echo "FAILED: $name" >&2
fi
exit $status
