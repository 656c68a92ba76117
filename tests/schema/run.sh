#!/bin/sh
# The schemas by a validator from npm, which is fetched into the build folder once: run.sh MATC BUILD_FOLDER. Run from the
# project's root. Status 77: skipped.
set -u
matc=$1
folder=$2/schema
if ! command -v node >/dev/null || ! command -v npm >/dev/null; then
    echo "SKIPPED: node or npm is not installed (./setup installs both), so no schema was checked"
    exit 77
fi
mkdir -p "$folder"
for file in package.json package-lock.json check.mjs; do
    cmp -s "tests/schema/$file" "$folder/$file" || {
        cp "tests/schema/$file" "$folder/$file"
        [ "$file" = check.mjs ] || rm -rf "$folder/node_modules"
    }
done
if [ ! -f "$folder/node_modules/.package-lock.json" ]; then
    (cd "$folder" && npm ci --silent --no-audit --no-fund --ignore-scripts) >"$folder/log" 2>&1 || {
        echo "FAILED: npm cannot fetch the validator:"
        tail -5 "$folder/log"
        exit 1
    }
fi
exec node "$folder/check.mjs" "$matc" . "$folder"
