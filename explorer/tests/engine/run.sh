#!/bin/bash
# Tests the explorer's engine in node or Chromium, or the explorer's colours:  run.sh node|chromium|colours WHIRL BUILD
# Prints a line and exits with status 77 if something that the tests need is missing.
set -u
kind=$1
WHIRL=$(realpath "$2") && export WHIRL
WHIRL_BUILD=$(realpath "$3") && export WHIRL_BUILD
cd "$(dirname "$0")/../.." || exit 1

skip() {
    echo "the explorer's engine is not tested: $*"
    exit 77
}
command -v node >/dev/null || skip "node is missing (scripts/install-dependencies.sh explorer)"
[ "$kind" = colours ] && exec node --test tests/colours.test.mjs
[ -f "$WHIRL_BUILD/explorer/worker.js" ] && [ -d node_modules/esbuild ] || skip "it is not built (make explorer)"
if [ "$kind" = chromium ]; then
    CHROMIUM=$(tests/chromium.sh) || skip "Chromium is missing (scripts/install-dependencies.sh browser)"
    export CHROMIUM
    exec node --test tests/engine/chromium.test.mjs
fi
exec node --test tests/engine/engine.test.mjs
