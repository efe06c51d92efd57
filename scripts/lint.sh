#!/bin/bash
# Formats, long lines, clang-tidy and cppcheck, without changing anything:  scripts/lint.sh BUILD [--all]
#
# Formats are looked at in all files. The linters read all sources with --all; else those that have changed since the commit
# in .ci/linted, the last one of which all were read and found clean, and for a header that has changed the source of its
# name, or the first one that includes it.
set -euo pipefail
cd "$(dirname "$0")/.."
build=$1
files() { git ls-files --cached --others --exclude-standard "$@"; }

mapfile -t sources < <(files '*.c' '*.cc' '*.h')
printf '%s\n' "${sources[@]}" | xargs -P "$(nproc)" -n 64 clang-format --dry-run -Werror
files 'explorer/*.ts' 'explorer/*.mjs' | xargs explorer/node_modules/.bin/prettier --log-level warn --check
black --quiet --check bindings/python
scripts/long-lines.sh

# ---- which sources are read

base=$(cat .ci/linted)
if [ "${2:-}" = --all ] || ! git merge-base --is-ancestor "$base" HEAD 2>/dev/null; then
    chosen=("${sources[@]}")
    echo "lint: all sources"
else
    mapfile -t changed < <({
        git diff --name-only --diff-filter=d "$base"
        git ls-files --others --exclude-standard
    } | grep -E '\.(c|cc|h|inc)$' | sort -u)
    chosen=()
    for file in "${changed[@]}"; do
        case $file in
        *.c | *.cc) chosen+=("$file") ;;
        *)
            own=${file%.*}.c
            [ -e "$own" ] || own=$(git grep -lE "#include \"([^\"]*/)?$(basename "$file")\"" -- 'src/*.c' 'src/*.cc' 'cli/*.c' |
                head -n 1 || true)
            chosen+=("$own") # nothing where tests alone include it
            ;;
        esac
    done
    echo "lint: ${#changed[@]} sources and headers that have changed since ${base:0:8}"
fi
# Tests loop over doubles and call the shell, as the product must not.
mapfile -t units < <(printf '%s\n' "${chosen[@]}" | sort -u | grep -E '^(cli|src|examples)/.*\.cc?$|^explorer/core/[^nu][^/]*\.c$')
[ ${#units[@]} -gt 0 ] || exit 0

# ---- they are read

printf '%s\n' "${units[@]}" | xargs -P "$(nproc)" -n 4 clang-tidy -p "$build" --quiet --warnings-as-errors='*'
checks=(--quiet --enable=warning,performance,portability --inline-suppr --error-exitcode=1 --suppress=unmatchedSuppression)
# Each language by itself; the explorer's core is emscripten's.
mapfile -t c < <(printf '%s\n' "${units[@]}" | grep -E '^(cli|src|examples)/.*\.c$')
mapfile -t cc < <(printf '%s\n' "${units[@]}" | grep -E '\.cc$')
[ ${#c[@]} -eq 0 ] || cppcheck "${checks[@]}" --std=c11 --language=c --suppressions-list=scripts/cppcheck-suppressions.txt \
    "-DISA(name)=name" "-DEVERY_ISA(address, name)={0}" -I include -I "$build/include" -j "$(nproc)" "${c[@]}"
[ ${#cc[@]} -eq 0 ] || cppcheck "${checks[@]}" --std=c++17 --language=c++ "${cc[@]}"
# All have been read and found clean: what changes from here on is read next time.
if [ "${2:-}" = --all ] && [ -z "$(git status --porcelain)" ]; then git rev-parse HEAD >.ci/linted; fi
