#!/bin/sh
# Runs the test suites of JSON and YAML, from npm: run.sh PROGRAM BUILD_FOLDER. Run from the
# project's root. Status 77: skipped.
set -u
. tests/npm.sh
npm_fetch tests/suites "$2/suites" check.mjs json.txt yaml.txt
exec node "$2/suites/check.mjs" "$1" "$2/suites"
