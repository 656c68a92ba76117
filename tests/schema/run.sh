#!/bin/sh
# Validates matc's JSON files against its schemas with a validator from npm:
# run.sh MATC BUILD_FOLDER. Run from the project's root. Status 77: skipped.
set -u
. tests/npm.sh
matc=$1
folder=$2/schema
npm_fetch tests/schema "$folder" check.mjs
exec node "$folder/check.mjs" "$matc" . "$folder"
