#!/bin/bash
# Every copy of the version is that of CMakeLists.txt:  versions.sh ROOT WHIRL
set -u
cd "$1" || exit 1
version=$(sed -n 's/^project(whirl VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
minor=${version%.*}
failures=0

says() { # FILE VERSION SED-EXPRESSION: all that it prints is the version
    local found
    found=$(sed -nE "$3" "$1" | sort -u)
    [ "$found" = "$2" ] && return
    echo "FAILED: $1 says '$found', expected $2"
    failures=$((failures + 1))
}
says CITATION.cff "$version" 's/^version: *//p'
says explorer/package.json "$version" 's/^ *"version": "(.*)",$/\1/p'
says <(head -12 explorer/package-lock.json) "$version" 's/^ *"version": "(.*)",$/\1/p'
says docs/whirl.1 "$version" 's/^\.TH WHIRL 1 "" "whirl ([^"]*)".*/\1/p'
says <(grep -m 1 '^## ' CHANGELOG.md) "$version" 's/^## ([0-9.]+).*/\1/p'
for document in docs/guide/*-library.md docs/elements.md; do
    says $document "$minor" 's/.*find_package\(whirl ([0-9.]+).*/\1/p'
done
says <(cat docs/guide/*.md) "$version" 's/.*\{"format": 1, "whirl": "([^"]*)".*/\1/p'
says debian/changelog "$version" '1s/.*\((.*)\).*/\1/p'
says debian/libwhirl1.symbols "$minor" 's/.*WHIRL_([0-9.]*\.[0-9.]*) .*/\1/p'
says <("$2" --version) "$version" 's/^whirl ([^ ]*).*/\1/p'
[ $failures -eq 0 ] && echo "version $version everywhere"
exit $((failures > 0))
