#!/bin/bash
# Checks the rules of the architecture:  architecture.sh ROOT [LIBRARY]
# A layer includes the public headers, those of base and its own; outside libraries are met in one layer only; libwhirl.so
# exports nothing but whirl_*; every public function has a comment.
set -u
root=$(realpath "$1")
library=$(realpath "${2:-}" 2>/dev/null)
cd "$root" || exit 1
failures=0
fail() {
    echo "FAILED: $*"
    failures=$((failures + 1))
}

# ---- which shared headers (include/whirl, src/include) a layer may use: its own and those below it

base="status.h descriptor.h stop.h version.h watched.h" # everyone's
declare -A below=(
    [base]="input.h"
    [rotor]="system.h torsion.h running.h ensemble.h rotor.h model.h line.h bearing.h film_tables.h"
    [integrate]="system.h ensemble.h integrate.h"
    [linear]="system.h torsion.h integrate.h linear.h"
    [orbit]="system.h ensemble.h integrate.h linear.h orbit.h stable_orbits.h branch.h torus.h torus_branch.h"
    [analyze]="fit.h fit_columns.h system.h torsion.h running.h ensemble.h integrate.h linear.h orbit.h stable_orbits.h record.h analyze.h spectrum.h response_peaks.h signals.h balance.h sensors.h dataset.h tolerances.h"
    [study]="fit.h running.h film_tables.h bearing.h bearing_table.h system.h ensemble.h integrate.h linear.h orbit.h analyze.h result.h handles.h study.h study_try.h sensitivity.h verify.h shown.h tolerances.h spread.h sensors.h dataset.h"
    [case]="arrays.h csv.h measured.h fit.h running.h system.h ensemble.h rotor.h model.h line.h bearing.h bearing_table.h integrate.h linear.h analyze.h result.h study.h case.h claims.h job.h balance.h tolerances.h sensitivity.h spread.h sensors.h dataset.h signals.h"
    [user]="csv.h system.h integrate.h analyze.h result.h handles.h study.h case.h job.h user_system.h signals.h"
    [store]="arrays.h descriptor.h system.h integrate.h analyze.h result.h handles.h study.h journal.h shown.h tolerances.h dataset.h"
    [import]="system.h rotor.h case.h import.h"
    [report]="fit.h fit_columns.h torsion.h bearing.h bearing_table.h line.h linear.h system.h integrate.h analyze.h spectrum.h response_peaks.h result.h handles.h study.h verify.h case.h model.h claims.h job.h report.h figure.h findings.h shown.h balance.h tolerances.h sensitivity.h spread.h dataset.h"
)
for folder in src/*/; do
    layer=$(basename "$folder")
    [ "$layer" != include ] || continue # headers that layers and the command share
    [ -n "${below[$layer]+known}" ] || { fail "src/$layer is no layer that this test knows"; continue; }
    while IFS=: read -r file header; do
        case " $base ${below[$layer]} " in
        *" $header "*) ;;
        *) fail "$file includes the public header $header, which is not below $layer" ;;
        esac
    done < <(grep -roE '#include "whirl/[a-z_/]+\.h"' "$folder" | sed -E 's,#include "whirl/(engine/|internal/)?([^"]*)",\2,')
    declare -A seen=()
    for header in src/base/*.h src/base/*/*.h "$folder"*.h "$folder"*/*.h; do
        case $header in */kernels/* | */elements/*) ;; *) seen[${header##*/}]=yes ;; esac # these are of other rooms
    done
    while IFS=: read -r room header; do
        [ -n "${seen[$header]+yes}" ] || [ -e "$room$header" ] || [ -e "cmake/$header.in" ] ||
            grep -q "$header" CMakeLists.txt cmake/*.cmake || fail "a file of $room includes $header of another layer"
    done < <(grep -roE '#include "[^/"]+"' "$folder" | sed -E 's,[^/]*:#include "([^"]*)",:\1,' | sort -u)
    while IFS=: read -r file header; do
        [[ $(realpath -m "$(dirname "$file")/$header") == "$root/$folder"* ]] && continue
        [ "$layer $header" = "integrate ../../rotor/pair_kernel.h" ] || fail "$file includes $header of another layer"
    done < <(grep -roE '#include "\.\./[^"]+"' "$folder" | sed -E 's,#include "([^"]*)",\1,')
done

# ---- kinds of points and figures are registries: no code tests for a particular kind

while read -r line; do
    [ -n "$line" ] && fail "asks which kind of points it has to do with: $line"
done < <(grep -rnE 'whirl_analysis_kind\([^;]*->name|is_(resting|traced)\(' src cli --include=*.c --include=*.h |
    grep -v '^src/study/kinds/kinds.c')
# Code uses the role of a table; its name is only for people.
while read -r line; do
    [ -n "$line" ] && fail "asks by its name what a table is: $line"
done < <(grep -rnE 'strcmp\([^,]*name, "(sweep|map|basin|branch|curves|tori|motions|modes|unbalance|response|detail)"|whirl_result_table\([^,]+, "|find_batch\([^)]*"' \
    src cli --include=*.c --include=*.h)
figures=$(sed -n '/^#define FIGURE_KINDS/,/clang-format on/p' src/report/figures/figure_kinds.h | grep -oE 'kind\([a-z_]+\)' | sed -E 's/kind\((.*)\)/\1/')
[ -n "$figures" ] || fail "src/report/figures/figure_kinds.h lists no figure: mend this test"
for name in $figures; do
    while read -r line; do
        [ -n "$line" ] && fail "a renderer knows the figure $name: $line"
    done < <(grep -rnE "\"${name//_/-}[-\"]|${name}_figure" src/report/render)
done

# ---- outside libraries, each in one layer

only_in() { # LAYERS PATTERN
    while read -r file; do
        [ -n "$file" ] && fail "$file meets $2, which belongs in src/${1// / or src/}"
    done < <(grep -rlE "#include <($2)" include src cli examples | grep -vE "^src/(${1// /|})/")
    for layer in $1; do
        grep -rqE "#include <($2)" "src/$layer" || fail "src/$layer does not use $2 any more: mend this test"
    done
}
only_in store 'H5|hdf5'
only_in store 'matio'
only_in store 'zlib'
only_in case 'yaml\.h'
only_in case 'udunits2'
only_in case 'muParser'
only_in integrate 'cvode|nvector|sundials|sunmatrix|sunlinsol'
only_in 'report import' 'jansson'
only_in import 'toml'
only_in study 'omp\.h'
only_in base 'Eigen/'

# ---- the operating system: what is not of the C standard, each need in one place of the library (docs/portability.md)

system_only_in() { # HEADER FILE...: no other file of src includes it, and these do
    local header=$1 file
    shift
    while read -r file; do
        case " $* " in *" ${file#src/} "*) ;; *) fail "$file meets <$header>, which belongs in $*" ;; esac
    done < <(grep -rl "#include <$header>" src)
    for file in "$@"; do
        grep -q "#include <$header>" "src/$file" || fail "src/$file does not use <$header> any more: mend this test"
    done
}
files="store/files/atomic_file.c store/journal/journal_file.c report/report_file.c" # reading, writing, keeping
process="report/render/gnuplot.c report/render/print.c"
system_only_in pthread.h base/lock.h
system_only_in time.h base/clock.c
# shellcheck disable=SC2086 # they are several
system_only_in fcntl.h $files $process rotor/pads/pad_table_file.c base/input.c base/mapped.c
# shellcheck disable=SC2086
system_only_in sys/stat.h $files rotor/pads/pad_table_file.c base/input.c report/render/gnuplot.c
# shellcheck disable=SC2086
system_only_in unistd.h $files store/files/bytes.c $process rotor/pads/pad_table_file.c base/input.c store/journal/underway.c store/hdf5/h5driver.c base/mapped.c
system_only_in dirent.h rotor/pads/pad_table_file.c store/journal/underway.c report/report_file.c
system_only_in sys/file.h store/journal/journal_file.c
system_only_in sys/wait.h $process
system_only_in sys/mman.h base/mapped.c
system_only_in sys/utsname.h study/result/provenance.c
known='assert|complex|ctype|errno|float|inttypes|limits|math|setjmp|stdalign|stdarg|stdatomic|stdbool|stddef|stdint|stdio|stdlib|string'
known+='|pthread|time|fcntl|sys/stat|unistd|dirent|sys/file|sys/wait|sys/mman|sys/utsname|immintrin|emmintrin|omp|jansson|yaml|udunits2|muParserDLL|matio|zlib|zip'
while read -r line; do
    [ -n "$line" ] && fail "$line: a system header that this test does not know"
done < <(grep -rE '#include <[a-z0-9_A-Z/]+\.h>' src --include=*.c --include=*.h | grep -vE "<($known)\.h>|<(hdf5|H5[A-Za-z]*|cvodes/|nvector/|sun[a-z]*/)")

# ---- stable headers include only stable headers

while read -r line; do
    [ -n "$line" ] && fail "a stable header includes one that may change: $line"
done < <(grep -nE '#include "whirl/engine' include/whirl/*.h cmake/version.h.in | grep -v '^include/whirl/engine\.h:')
for header in include/whirl/*.h; do
    name=whirl/$(basename "$header")
    case $name in whirl/whirl.h | whirl/engine.h) continue ;; esac
    grep -q "\"$name\"" include/whirl/whirl.h || fail "whirl/whirl.h lacks the stable header $name"
done
for header in include/whirl/engine/*.h; do
    grep -q "\"whirl/engine/$(basename "$header")\"" include/whirl/engine.h || fail "whirl/engine.h lacks $header"
done

# ---- the library

while read -r header line text; do
    fail "$header:$line has no comment: $text"
done < <(awk '
    FNR == 1 { commented = 0; depth = 0 }
    { file = FILENAME; sub(".*/", "", file) }
    /^\/\/\// { commented = 1; next }
    # A declaration of a function starts at the margin; those that follow one another may share the comment above the
    # first. What is freed by a function is said where it is made.
    depth == 0 && /^[a-z].*whirl_[a-z_]+\(/ && !/^typedef/ && !/_free\(/ {
        if (!commented && $0 !~ /\/\/\/</) print file, FNR, $0
        commented = 1
    }
    /^$/ { commented = 0 }
    { depth += gsub(/\{/, "{") - gsub(/\}/, "}"); if (depth < 0 || /extern "C"/) depth = 0 }
' include/whirl/*.h include/whirl/engine/*.h src/include/whirl/internal/*.h cmake/version.h.in)

if [ -n "$library" ] && [ -e "$library" ]; then
    exported=$(nm -D --defined-only --without-symbol-versions "$library" | awk '$2 != "A" {print $3}')
    foreign=$(grep -v '^whirl_' <<<"$exported")
    [ -z "$foreign" ] || fail "libwhirl.so exports: $foreign"
    # The library exports the functions of the headers and no others.
    declared=$({
        sed -E 's,//.*,,' include/whirl/*.h include/whirl/engine/*.h cmake/version.h.in | grep -vE 'typedef|static inline' | grep -oE '\bwhirl_[a-z0-9_]+\(' | tr -d '('
        sed -nE 's/^#define [a-z_]+ (whirl_[a-z_]+)$/\1/p' src/rotor/assembly.h src/rotor/element.h
    } | sort -u)
    missing=$(comm -23 <(echo "$declared") <(sort -u <<<"$exported"))
    extra=$(comm -13 <(echo "$declared") <(sort -u <<<"$exported"))
    [ -z "$missing" ] || fail "declared and not in libwhirl.so: $missing"
    [ -z "$extra" ] || fail "in libwhirl.so and not declared: $extra"
fi
if grep -rnE '^(static )?[a-z_ ]*\bint main\(' src; then fail "a layer has a main"; fi
[ $failures -eq 0 ] && echo "the layers keep their rules"
exit $((failures > 0))
