#!/bin/bash
# Runs the examples of documents:  examples.sh ROOT BUILD DOCUMENT...
#
# It runs blocks of the user guide (guide:2-4, chapters of docs/guide) and of docs/elements.md (elements), in their
# order and in one fresh folder, with an installed whirl on the PATH:
#   ```yaml, c, cmake  with "tested: FILE" in the first line are written to FILE; a case must pass `whirl check`,
#                      unless ", refused" follows
#   ```sh              with "# tested" in the first line are run; the exit status must be 0, or the one given there:
#                      "# tested, exit status 2"
#   ```python, octave  with "tested" in the first line are run, Octave if it is installed, Python with the package
#                      whirl of the sources
#   ```text            is the output of the block before: each line must begin a line of it, with numbers within a
#                      tolerance (compare.py); "# tested, numbers vary" before it leaves these out
#   ```json            is the content of the last point.json
# Blocks whose first line says "needed later" are run for later chapters, too.
# Of README.md (readme): every command that starts with build/whirl, with shorter cases, and every case.
# Links of all documents to files of the repository (links) must lead somewhere.
set -u
script=$(realpath "$0")
root=$(realpath "$1")
build=$(realpath "$2")
# Debian's h5py works with Debian's own Python alone.
python=$([ -x /usr/bin/python3 ] && echo /usr/bin/python3 || echo python3)

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
prefix=$folder/prefix
cmake --install "$build" --prefix "$prefix" >"$folder/log" || { cat "$folder/log"; exit 1; }
PATH=$prefix/bin:$PATH
library=$(dirname "$(find "$prefix" -name whirl.pc)")
export PKG_CONFIG_PATH=$library
export LD_LIBRARY_PATH=${library%/pkgconfig}
export CMAKE_PREFIX_PATH=$prefix
export PYTHONPATH=$root/bindings/python WHIRL_LIBRARY=$LD_LIBRARY_PATH/libwhirl.so.1 PYTHONDONTWRITEBYTECODE=1
unset CMAKE_GENERATOR

failures=0
fail() {
    echo "FAILED: $*"
    failures=$((failures + 1))
}

# Writes blocks of a document to files NUMBER.LANGUAGE, numbered in their order: those of chapters, and those that
# chapters need.
extract() { # DOCUMENT FOLDER [FIRST-CHAPTER LAST-CHAPTER]
    awk -v folder="$2" -v first="${3:-0}" -v last="${4:-99}" '
        /^##? [0-9]+\. / && !inside { chapter = $2 + 0 }
        /^```/ && !inside { inside = 1; language = substr($0, 4); sub(/ .*/, "", language); begun = 0
                            file = sprintf("%s/%03d.%s", folder, ++count, language); next }
        /^```$/ && inside { inside = 0; close(file); next }
        inside && !begun  { begun = 1; wanted = chapter <= last && (chapter >= first || /tested.*, needed later/) }
        inside && wanted  { print >file }' <(cat "$root/docs/$1.md" 2>/dev/null || cat "$root/docs/$1"/[0-9]*.md)
}

# Checks that every line of the document begins a printed line.
compare() { # BLOCK OUTPUT FIRST-LINE-OF-THE-COMMANDS
    local differences
    differences=$(python3 "$(dirname "$script")/compare.py" "$1" "$2" "$3") || fail "${1##*/} $differences"
}

ran=0
run_block() { # FILE EXPECTED COMMAND...
    local block=$1 expected=$2 status
    shift 2
    "$@" >"$folder/output" 2>&1 </dev/null
    status=$?
    ran=$((ran + 1))
    [ "$status" -eq "$expected" ] && return
    fail "$block: exit status $status, expected $expected"
    cat "$block" "$folder/output"
}

write_block() { # FILE FIRST-LINE
    local name=${2##*tested: }
    local target=${name%%[, ]*}
    cp "$1" "$target"
    case $target:$2 in
    *", refused"* | *.c:* | *.h:* | *.txt:*) return ;;
    esac
    grep -q '^whirl:' "$target" && run_block "$1" 0 whirl check "$target"
}

page() { # NAME [FIRST-CHAPTER LAST-CHAPTER]
    mkdir "$folder/$1" "$folder/$1-work"
    extract "$1" "$folder/$1" "${@:2}"
    cd "$folder/$1-work" || exit 1
    local block first before=
    for block in "$folder/$1"/*; do
        first=$(head -n 1 "$block")
        case ${block##*.}:$first in
        text:*) [ -n "$before" ] && compare "$block" "$folder/output" "$(head -n 1 "$before")" ;;
        json:*) compare "$block" point.json "" ;;
        *:*"tested: "*) write_block "$block" "$first" ;;
        sh:"# tested, exit status "*) run_block "$block" "${first##* }" bash -uo pipefail "$block" ;;
        sh:"# tested"*) run_block "$block" 0 bash -euo pipefail "$block" ;;
        python:"# tested") run_block "$block" 0 "$python" "$block" ;;
        octave:"% tested")
            if ! command -v octave-cli >/dev/null; then
                echo "no octave-cli, ${block##*/} is not run"
                before=
                continue
            fi
            # Octave wants the ending .m.
            cp "$block" block.m
            run_block "$block" 0 octave-cli --no-gui --quiet block.m
            ;;
        esac
        before=
        case ${block##*.}:$first in *tested*) before=$block ;; esac
    done
}

readme() {
    mkdir "$folder/readme" "$folder/checkout" "$folder/checkout/build"
    extract ../README "$folder/readme"
    cd "$folder/checkout" || exit 1
    ln -s "$prefix/bin/whirl" build/whirl
    # The commands are shown, not the motions: a tenth of the revolutions will do.
    mkdir cases
    for case_file in "$root"/cases/*.yaml; do
        sed -E 's/(transient|record): ([0-9]+)0\>/\1: \2/g' "$case_file" >"cases/${case_file##*/}"
    done
    grep -h '^build/whirl' "$folder"/readme/*.sh >lines
    local line case_file
    while IFS= read -r line; do
        echo "$line" >line.sh
        run_block line.sh 0 bash line.sh
    done <lines
    for case_file in "$folder"/readme/*.yaml; do run_block "$case_file" 0 whirl check "$case_file"; done
}

links() {
    local document target
    for document in "$root"/*.md "$root"/docs/*.md "$root"/docs/*/*.md; do
        while IFS= read -r target; do
            case $target in http*:* | mailto:*) continue ;; esac
            target=${target%%#*}
            [ -z "$target" ] || [ -e "$(dirname "$document")/$target" ] || fail "$document: no file $target"
        done < <(grep -o '\](\([^)]*\))' "$document" | sed 's/^](//; s/)$//')
    done
}

for document in "${@:3}"; do
    before=$ran
    case $document in
    readme | links) "$document" ;;
    *:*-*) page "${document%:*}" $(sed 's/.*:\(.*\)-/\1 /' <<<"$document") ;;
    *) page "$document" ;;
    esac
    [ "$document" = links ] || [ "$ran" -gt "$before" ] || fail "$document has nothing that was run"
done
echo "$ran blocks were run, $failures failures"
[ "$failures" -eq 0 ]
