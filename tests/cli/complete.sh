#!/bin/bash
# What bash offers for the last of these words, sorted, on one line:  complete.sh COMPLETION WORD...
source "$1"
shift
COMP_WORDS=("$@")
COMP_CWORD=$(($# - 1))
COMPREPLY=()
_whirl 2>/dev/null
printf '%s\n' "${COMPREPLY[@]}" | sort | tr '\n' ' '
echo
