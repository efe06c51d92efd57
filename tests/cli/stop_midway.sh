#!/bin/bash
# Runs a command and sends it a signal as soon as a file has so many bytes; gives its exit status:
#   stop_midway.sh SIGNAL FILE BYTES COMMAND...
signal=$1 file=$2 bytes=$3
shift 3
# A job of a script ignores SIGINT unless it is told not to.
env --default-signal=INT "$@" &
job=$!
while kill -0 $job 2>/dev/null && [ "$(stat -c %s "$file" 2>/dev/null || echo 0)" -lt "$bytes" ]; do sleep 0.005; done
kill -s "$signal" $job
wait $job 2>/dev/null
