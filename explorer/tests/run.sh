#!/bin/bash
# Runs the tests of the explorer's page in real browsers:  run.sh WHIRL TEMPLATE [FILE.test.mjs...]
# Prints a line and exits with status 77 if something that the tests need is missing.
set -u
WHIRL=$(realpath "$1") || exit 1
TEMPLATE=$(realpath -m "$2") || exit 1
export WHIRL TEMPLATE
shift 2
cd "$(dirname "$0")/.." || exit 1

skip() {
    echo "the page is not tested: $*"
    exit 77
}
[ -f "$TEMPLATE" ] || skip "$TEMPLATE is not built (make explorer)"
command -v node >/dev/null || skip "node is missing (scripts/install-dependencies.sh explorer)"
[ -d node_modules/playwright-core ] || skip "playwright-core is missing (make explorer)"
CHROMIUM=$(tests/chromium.sh) || skip "Chromium is missing (scripts/install-dependencies.sh browser)"
export CHROMIUM
# Without Firefox, its tests report themselves as skipped.
for browser in "${FIREFOX:-}" firefox-esr firefox; do
    [ -n "$browser" ] && FIREFOX=$(command -v "$browser") && break
done
export FIREFOX
[ $# -gt 0 ] || set -- tests/page*.test.mjs
exec node --test "$@"
