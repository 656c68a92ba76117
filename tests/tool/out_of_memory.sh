#!/bin/sh
# Failed allocations: out_of_memory.sh MATC FAILING_MALLOC. Run from the project's root. Preloads an allocator whose n-th call,
# or each call from the n-th on, returns NULL. Each run then either succeeds, or ends with a message that names memory and
# leaves no output; no message prints NULL, and none blames the document.
set -u
matc=$1
failing=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
: >"$work/stderr"
. tests/check.sh

# run NUMBER AFTERWARDS COMMAND...: status in $got, messages in $work/stderr
run() {
    number=$1
    afterwards=$2
    shift 2
    rm -f "$work/out.frag"
    (FAIL_AT=$number FAIL_AFTERWARDS=$afterwards LD_PRELOAD=$failing "$@" >"$work/stdout" 2>"$work/stderr") 2>/dev/null
    got=$?
}

# Succeeds, or says why not: our own line, what C++ prints of its own failed allocation, or what the C library prints when it
# cannot even load the unwinder for that.
is_honest() {
    case $got in
    0) true ;;
    1 | 134) grep -q -e 'out of memory' -e 'bad_alloc' -e 'for unwinding to work' -e 'annot allocate memory' "$work/stderr" ;;
    *) false ;;
    esac
}
is_clean() { ! grep -q -a -e '(null)' -e 'not YAML' "$work/stderr"; }
has_no_output() { [ $got = 0 ] || [ ! -e "$work/out.frag" ]; }

# every COMMAND...: sixty places of a run, the first and the last twenty among them
every() {
    allocations=$(FAIL_COUNT=1 LD_PRELOAD=$failing "$@" 2>&1 >/dev/null | sed -n 's/^allocations //p')
    check "allocations are counted: $*" test "${allocations:-0}" -gt 4
    for number in $(seq 1 "$allocations" | awk -v all="$allocations" 'NR <= 20 || NR > all - 20 || NR % (1 + int(all / 20)) == 0'); do
        for afterwards in 0 1; do
            run "$number" $afterwards "$@"
            check "allocation $number of $*: a reason, status $got" is_honest
            check "allocation $number of $*: the right reason" is_clean
            check "allocation $number of $*: no half output" has_no_output
        done
    done
}

LC_ALL=C
export LC_ALL
every "$matc" examples/checker.yaml -o "$work/out.frag"
every "$matc" --eval "u=0.3 v=0.4" examples/checker.yaml
every "$matc" --list=maps
every "$matc" --explain Checker

echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
