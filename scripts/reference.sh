#!/bin/bash
# Writes the reference of elements and keys from the output of `whirl describe`:  scripts/reference.sh [WHIRL [FILE]]
#
# WHIRL is the command (build/whirl), FILE the page that is written (docs/reference/keys.md).
set -euo pipefail
cd "$(dirname "$0")/.."
whirl=${1:-build/whirl}
file=${2:-docs/reference/keys.md}

overview=$(COLUMNS=1000 "$whirl" describe)

# Lists the parts and the names in each, as links.
list_parts() {
    while IFS= read -r line; do
        case $line in
        [a-z]*:) printf -- '- %s\n' "$line" ;;
        "  "*)
            read -r name _ <<<"$line"
            printf '  [%s](#%s)\n' "$name" "$name"
            ;;
        '') ;;
        *) break ;;
        esac
    done <<<"$overview"
}

# A name that stands in two parts (rub is an element and an analysis) is described once.
list_names() { sed -n 's/^  \([a-z][a-z0-9_-]*\) .*/\1/p' <<<"$overview" | awk '!seen[$0]++'; }

{
    cat <<'END'
# Elements and keys

This page lists all parts and keys of a case file, as `whirl describe NAME` prints them. `scripts/reference.sh` writes
it from the tables that the program reads cases with; a test compares the two. The [user guide](../guide/README.md)
explains the parts, and [cases/reference.yaml](../../cases/reference.yaml) shows them in a case.

A dash means no symbol, no unit (a name, a text, a list) or no default. A unit of 1 is a plain number.

END
    list_parts
    while read -r name; do
        printf '\n## %s\n\n```\n' "$name"
        COLUMNS=116 "$whirl" describe "$name"
        printf '```\n'
    done < <(list_names)
} >"$file.new"
mv "$file.new" "$file"
