#!/bin/bash
# Installs the Debian 12 packages that whirl needs and that are missing; does nothing when all is there.
#
#   scripts/install-dependencies.sh [--check] GROUP...
#
# Groups: build (library and command), report (figures), python (its package, with what its figures and tables need),
# test (all tests), explorer (the page), browser (its tests), docs (the site and its tutorials), octave (its tests
# and the gateway), lint, package (Debian packages), bench.
# --check only says what is missing, with exit status 1.
set -euo pipefail

declare -A packages=(
    # The unit database comes with libudunits2-dev (libudunits2-0 depends on libudunits2-data); libexpat is for programs
    # that link it statically.
    [build]="build-essential cmake ninja-build pkg-config git libsundials-dev libhdf5-dev libyaml-dev
             libudunits2-dev libexpat1-dev libmuparser-dev libjansson-dev libeigen3-dev
             libtomlplusplus-dev libmatio-dev zlib1g-dev"
    [report]="gnuplot-nox weasyprint"
    [python]="python3-cffi python3-numpy python3-h5py python3-matplotlib python3-pandas python3-xarray python3-tqdm
              python3-pip python3-setuptools python3-wheel python3-pytest python3-numba"
    # clang with its run time: the fuzz target, and a second compiler that must agree; libomp-dev is its OpenMP.
    # auto-07p, which needs gfortran, is a program with which tests compare; it is never linked.
    [test]="libcmocka-dev liblapacke-dev libopenblas-dev clang libclang-rt-14-dev lld libomp-dev valgrind
            python3-h5py python3-jsonschema python3-scipy python3-sklearn auto-07p gfortran libopenmpi-dev openmpi-bin"
    # dpkg-dev unpacks the sources of libyaml, muParser and zlib, which emscripten compiles.
    [explorer]="emscripten nodejs npm dpkg-dev"
    [browser]="chromium-headless-shell firefox-esr"
    # The tutorials, whose code the tests run too, are in Python and Octave.
    [docs]="python3-sphinx python3-myst-parser python3-breathe doxygen furo libjs-mathjax fonts-mathjax
            python3-nbformat python3-nbclient python3-ipykernel python3-matplotlib python3-h5py octave gnuplot-nox"
    # Tests draw figures with fonts of their own.
    [octave]="octave octave-dev fonts-freefont-otf gnuplot-nox"
    [lint]="clang-format clang-tidy cppcheck nodejs npm black"
    # What `make packages` builds Debian packages with; mmdebstrap makes the fresh system in which they are tried.
    [package]="debhelper dh-python dpkg-dev lintian mmdebstrap"
    # The programs whose speed is compared with whirl's; whirl itself needs none of them.
    [bench]="libgsl-dev libboost-dev octave python3 python3-numba python3-scipy"
)

say() { printf 'dependencies: %s\n' "$*" >&2; }

check_only=false
if [ "${1:-}" = --check ]; then
    check_only=true
    shift
fi
wanted=()
for group in "$@"; do
    if [ -z "${packages[$group]:-}" ]; then
        say "there is no group '$group', expected one of: build report python test explorer browser docs octave lint package bench"
        exit 2
    fi
    read -r -d '' -a names <<<"${packages[$group]}" || true
    wanted+=("${names[@]}")
done
if [ ${#wanted[@]} -eq 0 ]; then
    say "name at least one group: build report python test explorer browser docs octave lint package bench"
    exit 2
fi

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    # On another system the libraries have other names; CMake names those that it does not find.
    say "this is not a Debian system, so nothing is installed here; whirl needs what Debian 12 calls: ${wanted[*]}"
    exit 0
fi

# A node that was not installed from Debian's packages suffices if it has npm.
if command -v node >/dev/null && command -v npm >/dev/null; then
    for i in "${!wanted[@]}"; do
        case ${wanted[i]} in nodejs | npm) unset "wanted[i]" ;; esac
    done
fi

missing=()
# shellcheck disable=SC2016 # ${Package} is dpkg-query's, not the shell's.
# dpkg-query fails for a package that it has never heard of; that package is missing, which is no error here.
installed=" $({ dpkg-query -W -f '${db:Status-Status} ${Package}\n' "${wanted[@]}" 2>/dev/null || true; } |
    sed -n 's/^installed //p' | tr '\n' ' ') "
for name in "${wanted[@]}"; do
    case $installed in
    *" $name "*) ;;
    *) missing+=("$name") ;;
    esac
done
[ ${#missing[@]} -gt 0 ] || exit 0

say "missing: ${missing[*]}"
if $check_only; then
    say "'scripts/install-dependencies.sh $*' installs them (so do 'make test' and 'make paper')"
    exit 1
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
        say "neither root nor sudo: ask your administrator for 'apt-get install ${missing[*]}'"
        exit 1
    fi
    as_root=(sudo)
fi
apt() { "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o Acquire::Retries=3 "$@"; }

log=$(mktemp)
trap 'rm -f "$log"' EXIT
say "installing ${#missing[@]} packages and what they need with apt-get; this can take minutes"
# The package lists of a fresh system are empty, and those of an old one name files that no longer exist.
if ! { apt update -qq && apt install -y -qq --no-install-recommends -o Dpkg::Use-Pty=0 "${missing[@]}"; } >"$log" 2>&1; then
    tail -n 30 "$log" >&2
    say "apt-get could not install them; what it said is above"
    exit 1
fi
say "installed: ${missing[*]}"
