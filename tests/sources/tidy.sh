#!/bin/sh
# Runs clang-tidy, with the checks of .clang-tidy. Run from the project's root.
#   tidy.sh BUILD all     every C file of compiler, runtime, grammar and tests: an hour of one core
#   tidy.sh BUILD         under CI one file in 60, other ones with each commit (TESTS_SHARE counts
#                         commits), without the analyzer; elsewhere the files that differ from the
#                         commit, or else the last commit's
#   tidy.sh BUILD FILE... these files
# BUILD has compile_commands.json. Status 77: skipped.
set -eu
build=$1
shift
shares=60
command -v clang-tidy >/dev/null || {
    echo "SKIPPED: clang-tidy is not installed (Debian: clang-tidy), so it checked nothing"
    exit 77
}
known() { sed -n "s|^ *\"file\": \"$PWD/\(.*\.c\)\".*|\1|p" "$build/compile_commands.json" | grep -v '^build' | LC_ALL=C sort -u; }
changed() {
    git diff --name-only --diff-filter=d HEAD -- '*.c' | grep . ||
        git diff --name-only --diff-filter=d HEAD~1 -- '*.c' | grep . || true
}
chosen() {
    if [ "${1:-}" = all ]; then
        known
    elif [ $# -gt 0 ]; then
        printf '%s\n' "$@"
    elif [ -n "${TESTS_SHARE:-}" ]; then
        known | awk -v share="$TESTS_SHARE" -v shares=$shares '(NR + share) % shares == 0'
    else
        known >"$build/tidy.known"
        changed | grep -xFf "$build/tidy.known" || true
    fi
}
checks=
[ -z "${TESTS_SHARE:-}" ] || checks=--checks=-clang-analyzer-*
# shellcheck disable=SC2086
chosen "$@" | xargs -r -P 2 -n 4 clang-tidy -p "$build" --quiet $checks 2>/dev/null
