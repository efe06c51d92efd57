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
#
# Use the shell's own functions: every further process takes time, and there are hundreds of these tests.
set -u
whirl=$1 CASES=$2 test=$3 TESTS=${0%/*}
for name in whirl CASES test TESTS; do
    case ${!name} in /*) ;; *) printf -v $name %s "$PWD/${!name}" ;; esac
done
# Debian's own Python is the one that Debian's h5py belongs to.
PYTHON=python3
[ ! -x /usr/bin/python3 ] || PYTHON=/usr/bin/python3
export CASES TESTS PYTHON
PATH=${whirl%/*}:$PATH

folder=${TMPDIR:-/tmp}/whirl-test.$$.$RANDOM
mkdir -m 700 "$folder" || exit 1
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/work" && cd "$folder/work" || exit 1

mapfile -t lines <"$test"
edits=() expected=0 checks=()
for ((n = 0; n < ${#lines[@]}; n++)); do
    line=${lines[n]}
    key=${line%%:*} value=${line#*:}
    value=${value# }
    case $line in
    '' | '#'*) ;;
    sanitized:*)
        if [ -n "${WHIRL_SANITIZED:-}" ]; then
            mapfile -t lines < <(printf '%s\n' "${lines[@]}" | sed -E "1,$((n + 1))b;$value")
        fi
        ;;
    edit:*) edits+=("$value") ;;
    run:*) printf '%s\n' "$value" >>"$folder/script" ;;
    status:*) expected=$value ;;
    stdout:* | stderr:* | stdout-not:* | stderr-not:* | stdout-lines:* | stderr-lines:*) checks+=("$key" "$value") ;;
    *)
        echo "$test: not understood: $line"
        exit 1
        ;;
    esac
done

IFS= read -r -d '' case <"$TESTS/good.yaml"
case=${case%$'\n'}
printf '%s\n' "$case" >good.yaml
for edit in "${edits[@]}"; do
    edited=$(sed -E "$edit" <<<"$case") || exit 1
    if [ "$edited" = "$case" ]; then
        echo "$test: '$edit' changes nothing"
        exit 1
    fi
    case=$edited
done
printf '%s\n' "$case" >case.yaml

bash -o pipefail "$folder/script" >"$folder/stdout" 2>"$folder/stderr" </dev/null
status=$?
mapfile -t stdout <"$folder/stdout"
mapfile -t stderr <"$folder/stderr"

failures=0
fail() {
    echo "FAILED: $*"
    failures=$((failures + 1))
}
like() { # PATTERN LINE...
    local pattern=$1 line
    shift
    [[ '' =~ $pattern ]]
    if [ $? = 2 ]; then fail "this is no extended regular expression: $pattern"; fi
    for line; do
        if [[ $line =~ $pattern ]]; then return 0; fi
    done
    return 1
}
[ "$status" = "$expected" ] || fail "exit status $status, expected $expected"
for ((n = 0; n < ${#checks[@]}; n += 2)); do
    stream=${checks[n]%%-*} pattern=${checks[n + 1]}
    printed=("${stdout[@]}")
    [ "$stream" = stdout ] || printed=("${stderr[@]}")
    case ${checks[n]} in
    *-not) ! like "$pattern" "${printed[@]}" || fail "$stream has a line like: $pattern" ;;
    *-lines) [ ${#printed[@]} = "$pattern" ] || fail "$stream has not $pattern lines" ;;
    *) like "$pattern" "${printed[@]}" || fail "$stream has no line like: $pattern" ;;
    esac
done
# A report of a sanitizer, or a crash, fails every test.
if grep -qaE 'Sanitizer|runtime error:|Segmentation fault|Aborted' "$folder/stderr"; then fail "the program crashed"; fi
if [ $failures -gt 0 ]; then
    for stream in stdout stderr; do
        echo "--- $stream"
        head -c 8000 "$folder/$stream"
    done
    exit 1
fi
