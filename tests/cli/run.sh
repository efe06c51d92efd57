#!/bin/bash
# Runs a command and compares what it prints:  run.sh WHIRL CASES FILE.test
#
# A test is a file of lines "key: value":
#   sanitized:  a sed expression for the lines below it, where the program is sanitized and many times slower: fewer points
#   edit:    a sed expression; what it makes of good.yaml is case.yaml (several are applied in turn)
#   run:     a command line (several are one script); it runs in a fresh folder with good.yaml and case.yaml; $CASES are the
#            project's cases, $TESTS the folder of this script, $PYTHON a Python with h5py
#   status:  the exit status expected, 0 where nothing is said
#   stdout:  an extended regular expression that a line of standard output must match; the same for stderr:
#   stdout-not:, stderr-not:  one that no line may match
#   stdout-lines:, stderr-lines:  how many lines there are
set -u
whirl=$(realpath "$1")
CASES=$(realpath "$2")
test=$(realpath "$3")
TESTS=$(dirname "$(realpath "$0")")
# Debian's own Python is the one that Debian's h5py belongs to.
PYTHON=$([ -x /usr/bin/python3 ] && echo /usr/bin/python3 || echo python3)
export CASES TESTS PYTHON

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/bin" "$folder/work"
ln -s "$whirl" "$folder/bin/whirl"
# Beside it, where it was built: what mpirun starts.
if [ -e "$whirl-mpi" ]; then ln -s "$whirl-mpi" "$folder/bin/whirl-mpi"; fi
PATH=$folder/bin:$PATH
cd "$folder/work" || exit 1

if [ -n "${WHIRL_SANITIZED:-}" ]; then
    sed -E "$(sed -n 's/^sanitized: //p' "$test")" "$test" >"$folder/test"
    test=$folder/test
fi
values() { sed -n "s/^$1: \{0,1\}//p" "$test"; }

unknown=$(grep -vE '^(#|$|(sanitized|edit|run|status|(stdout|stderr)(-not|-lines)?):)' "$test")
if [ -n "$unknown" ]; then
    echo "$test: not understood: $unknown"
    exit 1
fi

cp "$TESTS/good.yaml" good.yaml
cp good.yaml case.yaml
while IFS= read -r edit; do
    sed -E "$edit" case.yaml >edited.yaml || exit 1
    if cmp -s case.yaml edited.yaml; then
        echo "$test: '$edit' changes nothing"
        exit 1
    fi
    mv edited.yaml case.yaml
done < <(values edit)

values run >"$folder/script"
bash -o pipefail "$folder/script" >"$folder/stdout" 2>"$folder/stderr" </dev/null
status=$?

failures=0
fail() {
    echo "FAILED: $*"
    failures=$((failures + 1))
}
expected=$(values status)
[ "$status" = "${expected:-0}" ] || fail "exit status $status, expected ${expected:-0}"
for stream in stdout stderr; do
    while IFS= read -r pattern; do
        grep -qE -- "$pattern" "$folder/$stream" || fail "$stream has no line like: $pattern"
    done < <(values $stream)
    while IFS= read -r pattern; do
        if grep -qE -- "$pattern" "$folder/$stream"; then fail "$stream has a line like: $pattern"; fi
    done < <(values $stream-not)
    for count in $(values $stream-lines); do
        [ "$(wc -l <"$folder/$stream")" = "$count" ] || fail "$stream has not $count lines"
    done
done
# Whatever the outcome, a sanitizer or a crash has no place in it.
if grep -qE 'Sanitizer|runtime error:|Segmentation fault|Aborted' "$folder/stderr"; then fail "the program crashed"; fi
if [ $failures -gt 0 ]; then
    for stream in stdout stderr; do
        echo "--- $stream"
        head -c 8000 "$folder/$stream"
    done
    exit 1
fi
