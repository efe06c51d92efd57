#!/bin/bash
# Tries documented make targets, each by itself in a fresh clone on a fresh Debian 12:
#
#   scripts/targets-check.sh [TARGET...]
#
# Without names it tries the targets that make something: the command, explorer, gallery, documents, benchmarks,
# installation, packages and the paper. Clones HEAD. Needs root, mmdebstrap and a mirror ($MIRROR, else Debian's).
# Certificates that $NODE_EXTRA_CA_CERTS names for npm are copied there. A log of each target is in build/targets. Each
# takes minutes, so this is no part of any test.
set -euo pipefail
cd "$(dirname "$0")/.."
targets=("$@")
[ $# -gt 0 ] || targets=(all explorer gallery docs bench install packages paper)
out=$(mkdir -p build/targets && realpath build/targets)
bundle=$out/whirl.bundle
git bundle create --quiet "$bundle" HEAD

# Prints the commands that a user types for a target.
commands_of() { # TARGET OPTIONS
    echo "set -e; cd /root; export HOME=/root DEBIAN_FRONTEND=noninteractive
git clone -q whirl.bundle whirl; cd whirl
scripts/install-dependencies.sh build
${certificates:+export NODE_EXTRA_CA_CERTS=/root/$(basename "$certificates")}
make $1 $2"
}

certificates=${NODE_EXTRA_CA_CERTS:-}
failed=0
for target in "${targets[@]}"; do
    # Meaningful benchmarks take an hour; short ones show in minutes that they run.
    commands_of "$target" "$([ "$target" != bench ] || echo BENCH_OPTIONS=\"--rounds=1 --study-rounds=1 --seconds=0.05\")" \
        >"$out/$target.sh"
    begun=$SECONDS
    # shellcheck disable=SC2016 # $1 is the folder of the system, which mmdebstrap passes.
    if mmdebstrap --quiet --variant=apt --include=make,git,ca-certificates \
        ${certificates:+--customize-hook="copy-in $certificates /root"} \
        --customize-hook="copy-in $bundle /root" --customize-hook="copy-in $out/$target.sh /root" \
        --customize-hook='chroot "$1" bash /root/'"$target.sh >'$out/$target.log' 2>&1" \
        bookworm /dev/null ${MIRROR:+"$MIRROR"} 2>>"$out/$target.log"; then
        echo "make $target: works, $((SECONDS - begun)) s"
    else
        echo "make $target: FAILED after $((SECONDS - begun)) s, see $out/$target.log"
        failed=1
    fi
done
exit $failed
