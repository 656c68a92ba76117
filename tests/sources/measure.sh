#!/bin/sh
# Prints the measures of a codebase's style: files, lines, functions (universal-ctags), comments,
# wide lines and folders, for the hand-written C of compiler/ and runtime/.
# measure.sh [FOLDER...]. Run from the project's root.
set -eu
[ $# -gt 0 ] || set -- compiler runtime
command -v ctags >/dev/null || { echo "universal-ctags is not installed (Debian: universal-ctags)" && exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
find "$@" -name '*.c' | LC_ALL=C sort >"$work/c"
find "$@" -name '*.h' >"$work/h"

# spread: median and 90th percentile of the numbers in standard input, the greatest, their count
spread() { sort -n | awk '{ v[NR] = $1 } END { printf "median %d, p90 %d, greatest %d of %d\n", v[int((NR + 1) / 2)], v[int(NR * .9 + .5)], v[NR], NR }'; }

echo ".c / .h files: $(wc -l <"$work/c") / $(wc -l <"$work/h")"
echo "lines: $(cat "$work/c" "$work/h" | xargs cat | wc -l) of C, $(find "$@" -name '*.glsl' | xargs cat | wc -l) of GLSL, $(find "$@" -name '*.def' | xargs cat | wc -l) of tables"
echo "lines of a .c file: $(xargs wc -l <"$work/c" | grep -v ' total$' | awk '{ print $1 }' | spread)"
xargs ctags -x --c-kinds=f --_xformat='%n %{end} %{file}' <"$work/c" >"$work/functions"
echo "lines of a function: $(awk '$2 { print $2 - $1 + 1 }' "$work/functions" | spread)"
echo "functions of at most 60 lines: $(awk '$2 { n++; short += $2 - $1 < 60 } END { printf "%.1f %%", 100 * short / n }' "$work/functions")"
xargs ctags -x --c-kinds=f --_xformat='%P' <"$work/c" | awk '{ n++; own += /\^static/ } END { printf "static functions: %.0f %%\n", 100 * own / n }'
echo "local includes of a .c file: $(xargs grep -c '^#include "' <"$work/c" | sed 's/.*://' | spread)"
cat "$work/c" "$work/h" | xargs cat | awk '
    /^[ \t]*$/ { next }
    { lines++; if (inside || /^[ \t]*(\/\*|\/\/)/) comments++ }
    /\/\*/ { inside = 1 } /\*\// { inside = 0 }
    length($0) > 100 { wide++ }
    END { printf "comment lines: %.1f %%; lines over 100 columns: %d\n", 100 * comments / lines, wide }'
echo "files of a folder: $(cat "$work/c" "$work/h" | xargs -n 1 dirname | sort | uniq -c | awk '{ print $1 }' | spread)"
