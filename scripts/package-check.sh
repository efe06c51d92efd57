#!/bin/bash
# Installs the packages that scripts/package.sh has built into a fresh Debian 12 and runs debian/tests there:
#
#   scripts/package-check.sh OUT
#
# Needs mmdebstrap and a mirror ($MIRROR, else Debian's); leaves nothing behind. A few minutes, most of them apt's.
set -euo pipefail
cd "$(dirname "$0")/.."
out=$(realpath "$1")

mapfile -t tests < <(sed -n 's/^Tests: //p' debian/tests/control)
mapfile -t packages < <(find "$out" -name '*.deb' ! -name '*-dbgsym_*')
needed=$(sed -n 's/^Depends: //p' debian/tests/control | tr ',\n' '  ')
install="apt-get install -qq -y --no-install-recommends -o Dpkg::Use-Pty=0 /packages/*.deb $needed"
hooks=(
    # shellcheck disable=SC2016 # $1 is the folder of the system, which mmdebstrap passes.
    --customize-hook='mkdir "$1/packages" "$1/tests"'
    --customize-hook="copy-in ${packages[*]} /packages"
    --customize-hook="copy-in ${tests[*]/#/$PWD/debian/tests/} /tests"
    --customize-hook="chroot \"\$1\" env DEBIAN_FRONTEND=noninteractive sh -c '$install' >'$out/install.log' 2>&1"
)
for name in "${tests[@]}"; do hooks+=(--customize-hook="chroot \"\$1\" /tests/$name >'$out/$name.log' 2>&1"); done

if ! mmdebstrap --quiet --variant=apt "${hooks[@]}" bookworm /dev/null ${MIRROR:+"$MIRROR"}; then
    echo "package: what failed is in the last of $out/install.log ${tests[*]/%/.log}" >&2
    exit 1
fi
echo "package: installed in a fresh Debian 12; passed there: ${tests[*]}"
