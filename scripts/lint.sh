#!/bin/bash
# Formats, long lines, clang-tidy and cppcheck of all sources, without changing anything:  scripts/lint.sh BUILD
set -euo pipefail
cd "$(dirname "$0")/.."
build=$1
files() { git ls-files --cached --others --exclude-standard "$@"; }

mapfile -t sources < <(files '*.c' '*.cc' '*.h')
printf '%s\n' "${sources[@]}" | xargs -P "$(nproc)" -n 64 clang-format --dry-run -Werror
files 'explorer/*.ts' 'explorer/*.mjs' | xargs explorer/node_modules/.bin/prettier --log-level warn --check
black --quiet --check bindings/python
scripts/long-lines.sh

# Only the product is linted: tests loop over doubles and call the shell, which these checks forbid.
mapfile -t units < <(printf '%s\n' "${sources[@]}" | grep -E '^(cli|src|examples)/.*\.cc?$|^explorer/core/[^nu][^/]*\.c$')
# The analyzer, which follows paths, is most of the work: it leaves a function after so many nodes of its graph.
tidy=(clang-tidy --quiet --warnings-as-errors='*')
for word in -analyzer-config "max-nodes=${LINT_NODES:-40000}"; do
    tidy+=(--extra-arg=-Xclang "--extra-arg=$word")
done
printf '%s\n' "${units[@]}" | grep -v '^explorer/' | xargs -P "$(nproc)" -n 4 "${tidy[@]}" -p "$build"
# The build does not compile the explorer's core, so its compile commands are given here.
printf '%s\n' "${units[@]}" | grep '^explorer/' |
    xargs -P "$(nproc)" -n 4 sh -c '"$@" -- -std=c17 -I include -I src/include -I "$0/include" -I src/study/kinds' "$build" "${tidy[@]}"
checks=(--quiet --enable=warning,performance,portability --inline-suppr --error-exitcode=1 --suppress=unmatchedSuppression)
# Each language by itself; the explorer's core is emscripten's.
mapfile -t c < <(printf '%s\n' "${units[@]}" | grep -E '^(cli|src|examples)/.*\.c$')
mapfile -t cc < <(printf '%s\n' "${units[@]}" | grep -E '\.cc$')
[ ${#c[@]} -eq 0 ] || cppcheck "${checks[@]}" --std=c11 --language=c --suppressions-list=scripts/cppcheck-suppressions.txt \
    "-DISA(name)=name" "-DEVERY_ISA(address, name)={0}" -I include -I src/include -I "$build/include" -j "$(nproc)" "${c[@]}"
[ ${#cc[@]} -eq 0 ] || cppcheck "${checks[@]}" --std=c++17 --language=c++ "${cc[@]}"
