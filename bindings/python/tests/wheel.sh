#!/bin/bash
# Tests that the wheel that pip makes contains the library, is below 10 MB, and computes without any other part of whirl:
#   wheel.sh PACKAGE LIBRARY ROOT
set -euo pipefail
package=$1 library=$2 root=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset WHIRL_LIBRARY PYTHONPATH

# Copy the sources, since pip builds in their folder.
cp -r "$package" "$work/package"
WHIRL_BUILT=$library WHIRL_EXPLORER=$work/none /usr/bin/python3 -m pip --quiet --disable-pip-version-check wheel \
    --no-build-isolation --no-deps --no-index -w "$work" "$work/package"
wheel=$(echo "$work"/whirl-*-py3-none-*.whl)
size=$(stat -c %s "$wheel")
[ "$size" -lt 10000000 ] || { echo "$wheel has $size bytes, expected less than 10 MB"; exit 1; }
/usr/bin/python3 -m pip --quiet --disable-pip-version-check install --no-deps --no-index --target "$work/installed" "$wheel"
cd "$work"
PYTHONPATH=$work/installed /usr/bin/python3 - "$root/tests/cli/good.yaml" <<'END'
import sys, whirl, whirl._declarations, whirl._library
assert whirl._library.ffi is whirl._declarations.ffi
assert "_native" in whirl._library._places()[0], whirl._library._places()
result = whirl.run(sys.argv[1], progress=False)
assert len(result["sweep"].values) == 5
END
echo "$(basename "$wheel"): $size bytes"
