#!/bin/bash
# The functions run in MATLAB, too: they use no syntax that only Octave has.  dialect.sh SOURCE
cd "$1/bindings/octave" || exit 1
failures=0
code=$(for file in *.m private/*.m examples/*.m; do
    sed -E "s/'([^']|'')*'/T/g; s/%.*//" "$file" | grep -n "" | sed "s,^[0-9]*:,$file:& ,"
done)
forbid() { # WHAT PATTERN, in code without comments and without texts in single quotes
    while IFS= read -r line; do
        echo "FAILED: $1: $line"
        failures=$((failures + 1))
    done < <(grep -E -- "^[^:]*:[0-9]+:.*($2)" <<<"$code")
}
forbid 'double quotes' '"'
forbid 'comments by #' '#'
forbid 'an end of its own kind' '\b(endif|endfor|endwhile|endfunction|end_try_catch|end_unwind_protect|endswitch)\b'
forbid 'an operator of Octave' '(\+=|-=|\*=|/=|\+\+|!=|\*\*|(^|[^~=<>])!)'
forbid 'a function of Octave' '\b(printf|puts|unwind_protect|do|until *$|isargout|print_usage|rethrow_error)\b *\(?$'
forbid 'an index after a call' '\)\('
for file in whirl_*.m; do
    name=${file%.m}
    head -n 1 "$file" | grep -qE "^function .*\b$name\b" || { echo "FAILED: $file begins with another function"; failures=$((failures + 1)); }
    sed -n 2p "$file" | grep -q "^% ${name^^}  " || { echo "FAILED: $file has no help"; failures=$((failures + 1)); }
done
# The check itself finds such syntax.
[ "$(printf 'x += "a"; %% "b"\n' | sed -E "s/%.*//" | grep -cE '"|\+=')" = 1 ] || failures=$((failures + 1))
[ $failures -eq 0 ] && echo "the functions are of both languages"
exit $((failures > 0))
