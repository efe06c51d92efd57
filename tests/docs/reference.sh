#!/bin/bash
# Checks that the reference of keys is the present output of the program:  reference.sh ROOT WHIRL
set -euo pipefail
root=$(realpath "$1")
whirl=$(realpath "$2")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$root/scripts/reference.sh" "$whirl" "$folder/keys.md"
if ! diff -u "$root/docs/reference/keys.md" "$folder/keys.md"; then
    echo "docs/reference/keys.md is not up to date: run 'scripts/reference.sh'"
    exit 1
fi
# Every name that the program lists must have a heading, so that an empty list cannot pass.
names=$(grep -c '^## ' "$folder/keys.md")
[ "$names" -ge 20 ] || { echo "only $names names are described"; exit 1; }
