#!/bin/sh
# Finds expressions that make IR nodes in an order that C leaves unspecified: two arguments of a
# call, two members of an initializer, or both operands of an operator that call functions with an
# `Ir *` or `Lower *` parameter. Functions that only read take a `const Ir *`. REFS
# (compiler/ir/build.h) or a local variable gives each node an order.
# order.sh [FILE...]. Run from the project's root. Status 77: skipped.
set -eu
command -v clang-query >/dev/null || {
    echo "SKIPPED: clang-query is not installed (Debian: clang-tools), so no order of evaluation was looked for"
    exit 77
}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# pairs MATCHER COUNT: two places of the first COUNT that both make nodes
pairs() {
    separator=""
    i=0
    while [ "$i" -lt "$2" ]; do
        k=$((i + 1))
        while [ "$k" -lt "$2" ]; do
            printf '%sallOf(%s(%d, maker), %s(%d, maker))' "$separator" "$1" "$i" "$1" "$k"
            separator=", "
            k=$((k + 1))
        done
        i=$((i + 1))
    done
}

{
    echo "set output diag"
    echo "set bind-root true"
    echo "set traversal AsIs"
    call='callExpr(callee(functionDecl(hasAnyParameter(anyOf(hasType(asString("Ir *")), hasType(asString("struct Ir *")), hasType(asString("Lower *")))))))'
    echo "let maker expr(anyOf($call, hasDescendant($call)))"
    here='unless(isExpansionInSystemHeader())'
    echo "match callExpr($here, anyOf($(pairs hasArgument 8)))"
    echo "match initListExpr($here, anyOf($(pairs hasInit 8)))"
    echo "match binaryOperator($here, unless(hasAnyOperatorName(\"&&\", \"||\", \",\")), hasLHS(maker), hasRHS(maker))"
} >"$work/query"

[ $# -gt 0 ] || set -- compiler/*.c compiler/*/*.c
# Sixteen at a time: to start takes it longer than to read one
printf '%s\n' "$@" | xargs -n 16 sh -c 'clang-query -f "$0" "$@" -- -std=c11 -D_GNU_SOURCE -I. -I/usr/include/cjson' "$work/query" >"$work/out" 2>&1 ||
    echo "error: clang-query failed" >>"$work/out"
! grep -A1 -E '"root" binds here|error:' "$work/out"
