#!/usr/bin/env bash
# An allocation that succeeds may leave errno at ENOMEM, and memory has not run out:  errno.sh WHIRL FAILING_MALLOC CASES
# The modes of a shaft of finite elements are computed with such allocations from 64 KiB on; libraries make smaller ones.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
sed '/^study:/,$d' "$3/compressor.yaml" >"$folder/case.yaml"
echo 'study: {modes: {parameter: speed, from: 3600 rpm, to: 4600 rpm, points: 3}}' >>"$folder/case.yaml"
"$1" run "$folder/case.yaml" -q --json >"$folder/expected.json"
WHIRL_ENOMEM_FROM=65536 LD_PRELOAD=$2 "$1" run "$folder/case.yaml" -q --json >"$folder/obtained.json"
cmp "$folder/expected.json" "$folder/obtained.json"
