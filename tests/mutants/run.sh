#!/bin/sh
# Mutation testing: inserts one fault of mutants.txt at a time into a copy of the project, builds
# the nearest tests, and runs them; at least one must fail. Run from any folder; the source tree is
# not changed.
#   run.sh [-j N] [--golden] [--again] [NAME...]   runs the named rows, or all; results for equal
#                                                  sources are reused
#   run.sh --check                                 reports stale rows, without building
#   -j N      uses N copies in parallel
#   --golden  also runs the goldens on surviving mutants; those that only goldens kill are counted
#             separately
#   --again   reruns rows that survived or did not build the last time, even if sources are equal
# Copies and results are in $MATC_MUTANTS, or else in build/mutants. Exit status: 0, all mutants
# were killed; 1, some survived; 2, a row is invalid.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
folder=${MATC_MUTANTS:-$root/build/mutants}
table=$here/mutants.txt
limit=${MATC_MUTANTS_LIMIT:-600} # seconds for a test: a mutant may hang
jobs=1
golden=
again=

rows() { awk -v act="$1" -v row="${2:-}" -v root="${3:-$root}" -f "$here/mutants.awk" "$table"; }

# sums FOLDER: checksum, size and path of every file of the project, without what is built from them
sums() {
    (cd "$1" && find . \( -name .git -o -type d -path './build*' \) -prune -o -type f -print0 | xargs -0 -r cksum | LC_ALL=C sort)
}

# source_of TEST: the path of its file, if it is a program of its own
source_of() { find "$root/tests" -name "$1.c"; }

# Tests that rows name and ctest does not know
unknown() {
    rows list | cut -f 3 | tr ' ' '\n' | sort -u | while read -r test; do
        [ -n "$(source_of "$test")" ] || grep -q "matc_test($test " "$root/cmake/tests.cmake" || echo "$test: no such test"
    done
}

# check: no row is stale, and the tests of all are there
check() {
    strange=$(unknown)
    [ -z "$strange" ] || echo "$strange" >&2
    rows check && [ -z "$strange" ]
}

# build targets of tests: a program of the same name, the feeder of a fuzzer's seeds, the goldens, or matc that a script runs
targets() {
    for test in "$@"; do
        case $test in
        test_*)
            echo "$test"
            ! grep -q MATC_PROGRAM "$(source_of "$test")" || echo matc
            ! grep -q MATVIEW_PROGRAM "$(source_of "$test")" || echo matview
            ;;
        fuzz_*_seeds) test=${test#fuzz_} && echo "feed_${test%_seeds}" ;;
        golden) echo golden ;;
        *) echo matc ;;
        esac
    done | sort -u
}

# copy N: the sources as they are now. What has changed is new to the build, whatever its time was
copy() {
    place=$folder/$1
    mkdir -p "$place/source"
    sums "$place/source" >"$place/before"
    LC_ALL=C comm -23 "$place/before" "$folder/sums" | cut -d ' ' -f 3- | (cd "$place/source" && tr '\n' '\0' | xargs -0 -r rm)
    LC_ALL=C comm -13 "$place/before" "$folder/sums" | cut -d ' ' -f 3- | (cd "$root" && tar -cf - -T -) | tar -xmf - -C "$place/source"
    [ -f "$place/build/build.ninja" ] && return
    set -- -DCMAKE_BUILD_TYPE=Release -DMATC_REFERENCE=OFF -DMATC_WERROR=OFF
    ! command -v ccache >/dev/null || set -- "$@" -DCMAKE_C_COMPILER_LAUNCHER=ccache
    ! command -v mold >/dev/null || set -- "$@" -DCMAKE_EXE_LINKER_FLAGS=-fuse-ld=mold
    cmake -G Ninja -S "$place/source" -B "$place/build" "$@" >"$place/log"
}

# passes PLACE TEST...: the tests pass there, one after the other; else $killer is the first that does not. 3: one does not build
passes() {
    at=$1
    shift
    killer=
    for test in "$@"; do
        # shellcheck disable=SC2046
        CCACHE_BASEDIR=$at cmake --build "$at/build" --target $(targets "$test") >"$at/log" 2>&1 || return 3
        ctest --test-dir "$at/build" -R "^$test\$" --timeout "$limit" --no-tests=error >"$at/log" 2>&1 && continue
        killer=$test
        return 1
    done
}

# put PLACE NAME FILE, and lift PLACE FILE: the fault is there, and is not
put() {
    cp "$1/source/$3" "$1/kept"
    rows apply "$2" "$1/source" >"$1/faulty"
    cp "$1/faulty" "$1/source/$3"
}
lift() { cp "$1/kept" "$1/source/$2"; }

# try PLACE KEY NAME FILE TEST...
try() {
    place=$1 key=$2 name=$3 file=$4
    shift 4
    put "$place" "$name" "$file"
    code=0
    passes "$place" "$@" || code=$?
    case $code in
    0) said=lives ;;
    3) said=unbuilt ;;
    *) said="killed by $killer" ;;
    esac
    if [ $code = 0 ] && [ -n "$golden" ]; then
        killer=golden
        passes "$place" golden || said=golden code=1
    fi
    lift "$place" "$file"
    [ $code != 1 ] || is_sound "$place" "$killer"
    echo "$key $name $said" >>"$folder/results"
    printf '%-24s %s\n' "$name" "$said"
}

# is_sound PLACE TEST: it passes where there is no fault, or it has killed nothing. Asked once
is_sound() {
    grep -qx "$2" "$1/sound" 2>/dev/null && return
    if ! passes "$1" "$2"; then
        echo "run.sh: $2 fails where there is no fault; see $1/log" >&2
        exit 2
    fi
    echo "$2" >>"$1/sound"
}

# work N: every row of its share, from $folder/todo
work() {
    place=$folder/$1
    copy "$1"
    rm -f "$place/sound"
    awk -v n="$1" -v jobs="$jobs" 'NR % jobs == n % jobs' "$folder/todo" >"$place/share"
    while IFS="$(printf '\t')" read -r key name file tests; do
        # shellcheck disable=SC2086
        try "$place" "$key" "$name" "$file" $tests </dev/null
    done <"$place/share"
}

# known KEY NAME: decided before
known() { grep -q "^$1 $2 " "$folder/results" && ! { [ -n "$golden" ] && grep -q "^$1 $2 lives" "$folder/results"; }; }
lived() { awk -v name="$1" '$2 == name { said = $3 } END { exit !(said != "killed") }' "$folder/results"; }

# Rows that are still to be run, with the checksum of the sources and of the row
plan() {
    sources=$(grep -v ' ./tests/mutants/' "$folder/sums" | cksum | cut -d ' ' -f 1)
    rows list | while IFS="$(printf '\t')" read -r name file tests fault; do
        [ $# = 0 ] || case " $* " in *" $name "*) ;; *) continue ;; esac
        key=$sources-$({ echo "$tests" && rows apply "$name"; } | cksum | cut -d ' ' -f 1)
        echo "$key $name" >>"$folder/asked"
        if [ -n "$again" ]; then
            lived "$name" || continue
        else
            ! known "$key" "$name" || continue
        fi
        printf '%s\t%s\t%s\t%s\n' "$key" "$name" "$file" "$tests"
    done
}

# The last word on every row that was asked for
summary() {
    awk -v asked="$folder/asked" '
        BEGIN { while ((getline line < asked) > 0) { split(line, part, " "); order[++rows] = part[2] } }
        { said[$2] = $3 }
        END {
            for (i = 1; i <= rows; i++) {
                count[said[order[i]]]++
                names[said[order[i]]] = names[said[order[i]]] " " order[i]
            }
            decided = rows - count["unbuilt"]
            printf "%d mutants: %d killed without goldens", rows, count["killed"]
            if (decided)
                printf " (%.0f %%)", 100 * count["killed"] / decided
            printf ", %d by goldens alone, %d live\n", count["golden"], count["lives"]
            if (count["golden"]) print "by goldens alone:" names["golden"]
            if (count["lives"]) print "live:" names["lives"]
            if (count["unbuilt"]) print "do not build:" names["unbuilt"]
            exit count["unbuilt"] ? 2 : count["lives"] || count["golden"] ? 1 : 0
        }' "$folder/results"
}

while [ $# -gt 0 ]; do
    case $1 in
    -j) jobs=$2 && shift ;;
    --golden) golden=yes ;;
    --again) again=yes ;;
    --check) check && exit 0 || exit 2 ;;
    -*) sed -n '2,9p' "$0" | cut -c3- && exit 2 ;;
    *) break ;;
    esac
    shift
done
check || exit 2
mkdir -p "$folder"
touch "$folder/results"
: >"$folder/asked"
cp "$table" "$folder/table" # it may change while this runs
table=$folder/table
sums "$root" >"$folder/sums"
plan "$@" >"$folder/todo"
failed=
pids=
i=1
while [ $i -le "$jobs" ]; do
    work $i &
    pids="$pids $!"
    i=$((i + 1))
done
for pid in $pids; do
    wait "$pid" || failed=yes
done
[ -z "$failed" ] || exit 2
summary
