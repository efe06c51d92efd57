#!/bin/bash
# Lines of TypeScript, scripts of the page, the packages for Python and Octave, and documents that are longer than 120
# columns. What cannot be broken may stay: rows of tables, pictures, addresses, and in documents what programs print
# (fenced blocks).
set -euo pipefail
cd "$(dirname "$0")/.."
export LC_ALL=C.UTF-8
git ls-files -z '*.md' '*.ts' '*.mjs' 'bindings/*.py' '*.m' | xargs -0 perl -CSD -ne '
    $fenced = 0 if $. == 1;
    $fenced = !$fenced if $ARGV =~ /\.md$/ && /^\s*```/;
    chomp;
    if (length > 120 && !$fenced && !/^\s*(\||!\[)/ && !m{https?://\S{60}}) { print "$ARGV:$.: longer than 120 columns\n"; $bad = 1 }
    close ARGV if eof;
    END { exit $bad // 0 }'
