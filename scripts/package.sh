#!/bin/bash
# Builds Debian packages of the committed sources (HEAD), in a folder of their own, and runs lintian on them:
#
#   scripts/package.sh OUT [EXPLORER.html]
#
# EXPLORER.html is the page that scripts/explorer.sh builds, which package builds cannot (debian/README.source). The
# packages are in OUT; scripts/package-check.sh installs and tries them.
set -euo pipefail
cd "$(dirname "$0")/.."
out=$(mkdir -p "$1" && realpath "$1")
page=${2:+$(realpath "$2")}
version=$(sed -nE '1s/.*\((.*)\).*/\1/p' debian/changelog)
# Build outside the repository, so that its revision and other files cannot be seen.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
git archive --prefix="whirl-$version/" HEAD | tar -x -C "$work"
if [ -n "$page" ]; then cp "$page" "$work/whirl-$version/debian/explorer.html"; fi

cd "$work/whirl-$version"
if ! DEB_BUILD_OPTIONS="parallel=${JOBS:-$(nproc)}" dpkg-buildpackage --no-sign >"$out/build.log" 2>&1; then
    tail -n 40 "$out/build.log" >&2
    echo "package: the build failed; all of its output is in $out/build.log" >&2
    exit 1
fi
rm -f "$out"/*.deb "$out"/whirl_*
find "$work" -maxdepth 1 -type f -exec mv -t "$out" {} +
cd "$out"
echo "package: $(echo ./*.deb)"
lintian --fail-on error,warning --tag-display-limit 0 ./whirl_*.changes
echo "package: lintian has nothing to say"
