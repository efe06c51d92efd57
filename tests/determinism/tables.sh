#!/bin/bash
# The same table for any number of threads and any load:  tables.sh WHIRL CASES RUNS LOOPS
set -euo pipefail
whirl=$(realpath "$1") cases=$(realpath "$2") runs=$3 loops=$4
folder=$(mktemp -d)
trap 'jobs -p | xargs -r kill 2>/dev/null; rm -rf "$folder"' EXIT
cd "$folder"
sed -e 's/points: 61/points: 31/' -e 's/points: 33/points: 13/' -e 's/transient: 1100, record: 100/transient: 130, watch: 50, record: 30/' \
    "$cases/paper-map.yaml" >map.yaml
for ((i = 0; i < loops; i++)); do
    while :; do :; done &
done
for ((run = 0; run < runs; run++)); do
    "$whirl" run map.yaml -o map.h5 --force -q --threads $((1 + run % 8))
    rm -rf csv
    "$whirl" export map.h5 --csv csv >/dev/null
    sha256sum <csv/map.csv
done | sort | uniq -c >hashes
cat hashes
[ "$(wc -l <csv/map.csv)" -gt 400 ] || { echo "tables: FAILED: the map has too few points"; exit 1; }
[ "$(wc -l <hashes)" = 1 ] || { echo "tables: FAILED: $(wc -l <hashes) different tables of $runs runs"; exit 1; }
