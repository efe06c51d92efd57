#!/bin/bash
# Prints the Chromium that tests drive: $CHROMIUM, else the headless shell, which takes half the time, else the
# desktop's Chromium. Exits with status 1 if there is none.
for browser in "${CHROMIUM:-}" chromium-headless-shell chromium chromium-browser google-chrome; do
    [ -n "$browser" ] && command -v "$browser" && exit 0
done
exit 1
