#!/bin/sh
# Tests the command line of matbench: matbench.sh MATBENCH. Run from the project's root.
set -u
matbench=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
. tests/check.sh
prints() { grep -q -- "$1" "$work/stdout"; }

# -- --help

check "--help" status 0 "$matbench" --help
check "lists the commands" prints '^  render '
for command in $(sed -n 's/^  \([a-z]*\) .*/\1/p' "$work/stdout"); do
    check "$command --help" status 0 "$matbench" $command --help
    check "is its usage" prints "^usage: matbench $command "
    check "and nothing is measured" test "$(grep -c 'pixels$' "$work/stdout")" = 0
done
"$matbench" render --help >"$work/stdout"
check "it names the tables" prints '\[materials\] \[lights\] \[objects\] \[passes\]'
check "and the options" prints '^  --size=WIDTHxHEIGHT  pixels of a frame$'

# -- options come in any order, with "=VALUE" or " VALUE"

check "--untimed behind another option" status 0 "$matbench" noise --gl=osmesa --untimed
check "leaves all times out" test "$(grep -c -- ' -  *-$' "$work/stdout")" -gt 1
check "a value of its own" status 0 "$matbench" noise --untimed --gl osmesa
check "the same" test "$(grep -c -- ' -  *-$' "$work/stdout")" -gt 1

# -- a fault quotes the wrong word and suggests another

for wrong in "rendr: render" "render --untimd: --untimed" "render light: lights" "render --gl=elg: egl"; do
    check "matbench ${wrong%:*}" status 2 "$matbench" ${wrong%:*}
    check "a guess" says "unknown .*; did you mean '${wrong#*: }'"
done
for wrong in "render --size=x" "render --size" "shadows --triangles=9" "cells --gl=egl" "cells x" "batch --count 0"; do
    check "matbench $wrong" status 2 "$matbench" $wrong
    check "points to --help" says "; see matbench ${wrong%% *} --help"
done

# -- rows are printed as they are measured: the first row of cells comes long before the last

"$matbench" cells >"$work/rows" &
process=$!
for _ in $(seq 300); do
    [ ! -s "$work/rows" ] || break
    sleep 0.1
done
check "the first row appears" test -s "$work/rows"
check "while the others are measured" kill -0 $process
kill $process
wait $process 2>/dev/null

echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
