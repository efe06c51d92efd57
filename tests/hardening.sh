#!/bin/bash
# How binaries are linked:  hardening.sh CHECKED FOLDER...    CHECKED: copies and prints are checked by the C library
# No entry of a run path is empty or relative, which would be the folder in which a user calls whirl; programs may lie anywhere
# (PIE), their tables are read-only once loaded (full RELRO), and the stack is guarded. Shown by a library of a stranger, too.
set -u
checked=$1
shift
failures=0 seen=0
fail() {
    echo "FAILED: $*"
    failures=$((failures + 1))
}

look_at() { # BINARY
    local dynamic
    dynamic=$(readelf -dW "$1" 2>/dev/null) || return
    grep -q NEEDED <<<"$dynamic" || return
    seen=$((seen + 1))
    while IFS= read -r path; do
        case ":$path:" in *::*) fail "$1 has an empty entry in its run path '$path'" ;; esac
        while IFS= read -rd : entry; do
            case $entry in /* | '$ORIGIN'* | '') ;; *) fail "$1 has the relative entry '$entry' in its run path" ;; esac
        done <<<"$path:"
    done < <(sed -nE 's/.*\((RPATH|RUNPATH)\).*\[(.*)\]/\2/p' <<<"$dynamic")
    grep -qE 'BIND_NOW|Flags:.*NOW' <<<"$dynamic" || fail "$1 binds its functions late"
    readelf -lW "$1" | grep -q GNU_RELRO || fail "$1 keeps its tables writable"
    readelf -hW "$1" | grep -qE 'Type: +DYN' || fail "$1 is not position independent"
    case $1 in
    */whirl | */libwhirl.so*)
        local symbols
        symbols=$(readelf --dyn-syms -W "$1")
        grep -q __stack_chk_fail <<<"$symbols" || fail "$1 does not guard its stack"
        [ "$checked" != yes ] || grep -qE '__(memcpy|snprintf|vsnprintf)_chk' <<<"$symbols" ||
            fail "$1 does not check its copies"
        ;;
    esac
}
while IFS= read -r file; do look_at "$file"; done < <(
    find "$@" -type f \( -perm -u+x -o -name '*.so*' \) -not -path '*/CMakeFiles/*' \
        -not -path '*/sanitize/*' -not -path '*/threads/*' -not -path '*/clang/*' -not -path '*/explorer/*' |
        sort)
[ $seen -gt 0 ] || fail "no binary in $*"

# A stranger's library in the folder of a case is not loaded.
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
whirl=$(realpath "$1/whirl")
echo '#include <stdlib.h>
__attribute__((constructor)) static void loaded(void) { _Exit(99); }' >"$folder/stranger.c"
${CC:-cc} -shared -fPIC "$folder/stranger.c" -o "$folder/stranger.so" || fail "no stranger's library"
for name in $(readelf -dW "$whirl" | sed -nE 's/.*\(NEEDED\).*\[(.*)\]/\1/p'); do cp "$folder/stranger.so" "$folder/$name"; done
(cd "$folder" && "$whirl" --version >/dev/null 2>&1) || fail "libraries in the current folder are loaded"

[ $failures -eq 0 ] && echo "$seen binaries: no empty or relative run path, full RELRO, position independent"
exit $((failures > 0))
