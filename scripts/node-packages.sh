#!/bin/bash
# Fetches the explorer's node packages (explorer/package-lock.json) if they are missing or outdated.
set -euo pipefail
cd "$(dirname "$0")/../explorer"
have=node_modules/.package-lock.json
if [ ! -e $have ] || [ package-lock.json -nt $have ]; then
    # A registry that does not answer must not block the build.
    timeout 300 npm ci --no-audit --no-fund --silent --fetch-timeout=60000 --fetch-retry-mintimeout=1000 \
        --fetch-retry-maxtimeout=5000
    touch $have
fi
