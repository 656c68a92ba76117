#!/bin/sh
# Checks that the C sources are formatted as .clang-format says, and that C sources and tables keep
# to 100 columns.
# format.sh [--fix]. Run from the project's root. Status 77: skipped.
set -eu
sources() { git ls-files '*.c' '*.h' 2>/dev/null || find compiler runtime grammar tests examples -name '*.[ch]'; }
tables() { find compiler runtime grammar tests -name '*.def'; }

wide=$({ sources && tables; } | xargs awk 'length($0) > 100 { print FILENAME ":" FNR ": " length($0) " columns" }')
[ -z "$wide" ] || { echo "$wide" && exit 1; }

version=$(clang-format --version 2>/dev/null | sed -n 's/.*version \([0-9]*\).*/\1/p')
[ "$version" = 14 ] || {
    echo "SKIPPED: clang-format 14 is not installed (Debian: clang-format-14), so the format was not checked"
    exit 77
}
[ "${1:-}" = --fix ] && mode=-i || mode="--dry-run --Werror"
# shellcheck disable=SC2086
sources | xargs -P 2 -n 50 clang-format $mode
