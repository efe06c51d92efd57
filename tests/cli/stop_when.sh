#!/bin/bash
# Runs a command and sends it a signal as soon as a line of its standard error, which goes to FILE too, matches a pattern;
# gives its exit status:
#   stop_when.sh SIGNAL FILE PATTERN COMMAND...
signal=$1 file=$2 pattern=$3
shift 3
: >"$file"
# A job of a script ignores SIGINT unless it is told not to.
env --default-signal=INT "$@" 2>"$file" &
job=$!
while kill -0 $job 2>/dev/null && ! grep -q "$pattern" "$file"; do sleep 0.005; done
kill -s "$signal" $job
wait $job 2>/dev/null
status=$?
cat "$file" >&2
exit $status
