#!/bin/bash
# Every file and folder that ARCHITECTURE, CONTRIBUTING and the README of a folder name exists:  documents_name_files.sh ROOT
# A name is a text in backticks that has a slash or the ending of a source file. It is looked for next to the document,
# at the root, in include/whirl/engine, and by its end among all files.
set -euo pipefail
cd "$1"
files=$(find src include cli bindings explorer tests cases scripts docs cmake bench -not -path '*/node_modules/*' | sort)
missing=0
for document in ARCHITECTURE.md CONTRIBUTING.md src/*/README.md explorer/README.md; do
    folder=$(dirname "$document")
    while read -r name; do
        [ -e "$folder/$name" ] || [ -e "$name" ] || [ -e "include/$name" ] || [ -e "include/whirl/engine/$name" ] ||
            grep -qE "(^|/)${name//./[.]}\$" <<<"$files" || {
            echo "$document names $name, which does not exist"
            missing=1
        }
    done < <(grep -oE '`[^` <>$*]+`' "$document" | tr -d '`' | grep -E '^[A-Za-z_./0-9-]+$' |
        grep -E '\.(c|cc|h|inc|ts|mjs|py|sh|md|txt|yaml|cmake|m)$|^(src|include|cli|bindings|explorer|tests|scripts|docs|cmake)/' |
        grep -vE '^(case|result)\.' | sort -u)
done
exit $missing
