#!/bin/bash
# Builds the explorer: the C core for the browser, the program of its workers, and the page that `whirl report` fills.
#
#   scripts/explorer.sh [--if-possible] OUT
#
# OUT/whirl.wasm, OUT/worker.js, OUT/template.html. Needs emscripten, node with npm, and the sources of libyaml,
# muParser and zlib, which are fetched from Debian once. If something is missing it says so in one line and fails; with
# --if-possible it does not fail.
set -euo pipefail
cd "$(dirname "$0")/.."

required=true
if [ "${1:-}" = --if-possible ]; then
    required=false
    shift
fi
out=$(mkdir -p "$1" && cd "$1" && pwd)

missing() {
    echo "explorer: not built: $* (scripts/install-dependencies.sh explorer)" >&2
    $required && exit 1
    exit 0
}

for tool in emcc em++ node npm; do
    command -v "$tool" >/dev/null || missing "$tool is missing"
done
[ "$(node -p 'process.versions.node.split(".")[0] >= 18')" = true ] || missing "node is older than 18"
[ -f /usr/include/udunits2.h ] && [ -d /usr/share/xml/udunits ] || missing "libudunits2-dev is missing"

# ---- node's packages: they are waited for where they are needed

trap 'jobs -p | xargs -r kill 2>/dev/null' EXIT
scripts/node-packages.sh >"$out/npm.log" 2>&1 &
packages=$!

# ---- sources, by apt-get with a list of its own: the system's stay as they are

fetch() { # PACKAGE DIRECTORY
    [ -e "$out/sources/$2/.complete" ] && return
    command -v apt-get >/dev/null && command -v dpkg-source >/dev/null || missing "the source of $1 is fetched by Debian's apt-get and dpkg-dev"
    local work mirror
    work=$(mktemp -d "$out/fetch.XXXXXX")
    # shellcheck disable=SC2016 # $(...) is apt-get's.
    mirror=$(apt-get indextargets --format '$(REPO_URI) $(CODENAME)' 'Created-By: Packages' 'Component: main' 2>/dev/null |
        grep -vE -- '-(updates|security|backports)$|debian-security' | head -1)
    echo "deb-src ${mirror:-http://deb.debian.org/debian bookworm} main" >"$work/sources.list"
    mkdir -p "$work/lists/partial"
    local options=(-qq -o "Dir::Etc::sourcelist=$work/sources.list" -o Dir::Etc::sourceparts=/dev/null
        -o "Dir::State::lists=$work/lists" -o APT::Sandbox::User=root -o Acquire::Retries=3)
    if ! { apt-get "${options[@]}" update && cd "$work" && apt-get "${options[@]}" source "$1"; } >"$out/fetch.log" 2>&1; then
        rm -rf "$work"
        missing "the source of $1 cannot be fetched, see $out/fetch.log"
    fi
    cd - >/dev/null
    mkdir -p "$out/sources"
    rm -rf "${out:?}/sources/$2"
    mv "$work/$1"-*/ "$out/sources/$2"
    touch "$out/sources/$2/.complete"
    rm -rf "$work"
}
fetch libyaml libyaml
fetch muparser muparser
fetch zlib zlib

# ---- the core, then the program around it

make --no-print-directory -j "${JOBS:-$(nproc)}" -C explorer/core OUT="$out" &
core=$!
wait $packages || missing "npm cannot fetch the packages, see $out/npm.log"
explorer/node_modules/.bin/tsc --noEmit -p explorer
wait $core
node explorer/engine.mjs "$out"
node explorer/build.mjs --worker "$out/worker.js" --core "$out/whirl.wasm" "$out/template.html"
