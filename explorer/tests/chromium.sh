#!/bin/bash
# Prints the Chromium that tests drive: $CHROMIUM, else the one that has no windows to draw, which costs half the time, or
# the one of the desktop. Exit status 1 where there is none.
for browser in "${CHROMIUM:-}" chromium-headless-shell chromium chromium-browser google-chrome; do
    [ -n "$browser" ] && command -v "$browser" && exit 0
done
exit 1
