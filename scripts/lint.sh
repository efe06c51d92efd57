#!/bin/bash
# clang-format, clang-tidy and cppcheck without changing anything:  scripts/lint.sh BUILD SOURCE...
set -euo pipefail
build=$1
shift
clang-format --dry-run -Werror "$@"
units=()
for source in "$@"; do
    # Tests loop over doubles and call the shell, as the product must not.
    case $source in cli/*.c | src/*.c | src/*.cc | examples/*.c | explorer/core/[!nu]*.c) units+=("$source") ;; esac
done
printf '%s\n' "${units[@]}" | xargs -P "$(nproc)" -n 4 clang-tidy -p "$build" --quiet --warnings-as-errors='*'
cppcheck --quiet --std=c11 --language=c --enable=warning,performance,portability --inline-suppr --error-exitcode=1 --suppress=unmatchedSuppression \
    --suppressions-list=scripts/cppcheck-suppressions.txt "-DISA(name)=name" "-DEVERY_ISA(address, name)={0}" \
    -I include -I "$build/include" -j "$(nproc)" $(printf -- '-i%s ' src/*/*.cc) cli src examples
cppcheck --quiet --std=c++17 --language=c++ --enable=warning,performance,portability --inline-suppr --error-exitcode=1 src/*/*.cc
